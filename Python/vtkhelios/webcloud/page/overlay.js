// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What is drawn above the points: scale bar, axes with north, the picked point, the measured distance.

import { byId, draw } from "./dom.js";
import { plain, roundDown } from "./ticks.js";

const LONGEST = 160; // of the scale bar [pixels]
const AXES = [["x", [1, 0, 0]], ["y N", [0, 1, 0]], ["z", [0, 0, 1]]];
const ARM = 30; // of the axes [pixels]

/** A length as text: 0.02 m, 20 m, 2 km. */
export function lengthText(metres) {
  return metres >= 1000 ? `${plain(metres / 1000)} km` : `${plain(metres)} m`;
}

/** The scale bar of a frame: its length [m] and [pixels]. */
export function scaleBar(camera, height) {
  const pixel = camera.pixelSize(height);
  const length = roundDown(LONGEST * pixel);
  return { length, pixels: length / pixel };
}

/** A place on the page [pixels] of a point; null: behind the eye. */
export function project(camera, point, width, height) {
  const [x, y, , w] = camera.clip(point);
  return w > 0 ? [(0.5 + (0.5 * x) / w) * width, (0.5 - (0.5 * y) / w) * height] : null;
}

export function drawOverlay(camera, width, height, { picked, measured }) {
  const { length, pixels } = scaleBar(camera, height);
  byId("bar").style.width = `${pixels}px`;
  byId("bar-text").textContent = lengthText(length) + (camera.isParallel ? "" : " at the pivot");
  byId("axes").replaceChildren(...axes(camera));
  const marks = byId("marks");
  marks.setAttribute("viewBox", `0 0 ${width} ${height}`);
  const at = (point) => project(camera, point, width, height);
  marks.replaceChildren(...pickedMark(picked && at(picked)), ...measuredMarks(measured.map(at), measured));
}

function axes(camera) {
  const { right, up, back } = camera.axes();
  const dot = (a, b) => a.reduce((sum, v, i) => sum + v * b[i], 0);
  return AXES.map(([name, axis]) => ({ name, x: dot(axis, right), y: -dot(axis, up), z: dot(axis, back) }))
    .sort((a, b) => a.z - b.z)
    .flatMap(({ name, x, y }) => [
      draw("path", { class: `axis-${name[0]}`, d: `M0 0L${ARM * x} ${ARM * y}` }),
      draw("text", { x: 1.35 * ARM * x, y: 1.35 * ARM * y + 4, "text-anchor": "middle" }, name),
    ]);
}

function pickedMark(place) {
  return place ? [draw("circle", { class: "picked", cx: place[0], cy: place[1], r: 7 })] : [];
}

function measuredMarks(places, points) {
  const dots = places.filter(Boolean).map(([x, y]) => draw("circle", { class: "end", cx: x, cy: y, r: 4 }));
  if (points.length < 2 || !places[0] || !places[1]) return dots;
  const [[ax, ay], [bx, by]] = places;
  return [...dots, draw("path", { class: "distance", d: `M${ax} ${ay}L${bx} ${by}` })];
}

/** The distance of two points as text, with its parts. */
export function distanceText([a, b]) {
  const [dx, dy, dz] = a.map((value, i) => b[i] - value);
  const metres = (value) => `${plain(value, 6)} m`;
  return `${metres(Math.hypot(dx, dy, dz))} (horizontal ${metres(Math.hypot(dx, dy))}, vertical ${metres(dz)})`;
}
