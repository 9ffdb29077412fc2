// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The keys, and the list of them that the help shows.

const HELP = [
  ["drag, arrow keys", "rotate about the pivot"],
  ["right drag, Shift and drag", "pan"],
  ["wheel, + and −", "zoom, to the mouse"],
  ["click", "pick a point: its values and its waveform"],
  ["double click", "set the pivot"],
  ["m, two clicks", "measure a distance"],
  ["f", "fit the cloud into the frame"],
  ["t, s, e", "view from the top, the south, the east"],
  ["p", "parallel or perspective projection"],
  ["l", "eye-dome lighting (depth shading)"],
  ["d", "dark or light theme"],
  ["Esc", "close, deselect"],
  ["h", "this help"],
];

export function helpRows() {
  return HELP;
}

const STEP = 0.09; // [rad]

/** Calls an action for each key. actions: turn, zoom, and one per letter. */
export function listen(actions) {
  const keys = {
    ArrowLeft: () => actions.turn(-STEP, 0), ArrowRight: () => actions.turn(STEP, 0),
    ArrowUp: () => actions.turn(0, STEP), ArrowDown: () => actions.turn(0, -STEP),
    "+": () => actions.zoom(0.8), "=": () => actions.zoom(0.8), "-": () => actions.zoom(1.25),
    m: actions.measure, f: actions.fit, t: actions.top, s: actions.south, e: actions.east,
    p: actions.parallel, l: actions.light, d: actions.theme, h: actions.help, "?": actions.help,
    Escape: actions.escape,
  };
  document.addEventListener("keydown", (event) => {
    const isTyping = event.target.matches("input[type=text], select");
    if (event.ctrlKey || event.metaKey || event.altKey || (isTyping && event.key !== "Escape")) return;
    const action = keys[event.key] ?? keys[event.key.toLowerCase()];
    if (!action) return;
    event.preventDefault();
    action();
  });
}
