// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The waveform of a pulse: received power over two-way time, with the picked echo.

import { draw } from "./dom.js";
import { linearTicks, plain, prefixed } from "./ticks.js";

const LIGHT = 0.299792458; // [m/ns]
const [WIDTH, HEIGHT] = [300, 170];
const [LEFT, RIGHT, TOP, BOTTOM] = [44, 8, 8, 34];

/** An SVG of a waveform { start, bin [ns], samples [W] }; range [m] of the picked echo, if known. */
export function makeChart(wave, range) {
  const peak = Math.max(...wave.samples);
  const [unit, factor] = prefixed("W", peak);
  const end = wave.start + wave.bin * Math.max(1, wave.samples.length - 1);
  const low = Math.min(0, ...wave.samples);
  const x = (t) => LEFT + ((WIDTH - LEFT - RIGHT) * (t - wave.start)) / (end - wave.start);
  const y = (p) => HEIGHT - BOTTOM - ((HEIGHT - TOP - BOTTOM) * (p - low)) / (1.05 * peak - low || 1);
  const points = Array.from(wave.samples, (p, i) => `${x(wave.start + i * wave.bin).toFixed(2)},${y(p).toFixed(2)}`);
  return draw("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: "chart", role: "img",
    "aria-label": `waveform of ${wave.samples.length} samples, peak ${plain(peak / factor, 4)} ${unit}` },
    ...timeAxis(wave.start, end, x), ...powerAxis(low, peak, factor, unit, y),
    ...marker(range, wave.start, end, x), draw("polyline", { points: points.join(" ") }));
}

function timeAxis(start, end, x) {
  const labels = linearTicks(start, end, 4).map((t) =>
    draw("text", { x: x(t), y: HEIGHT - BOTTOM + 14, "text-anchor": "middle" }, plain(t)));
  const title = draw("text", { x: (LEFT + WIDTH) / 2, y: HEIGHT - 4, "text-anchor": "middle" }, "two-way time [ns]");
  const line = draw("path", { class: "axis", d: `M${LEFT} ${TOP}V${HEIGHT - BOTTOM}H${WIDTH - RIGHT}` });
  return [line, ...labels, title];
}

function powerAxis(low, peak, factor, unit, y) {
  const labels = linearTicks(low / factor, peak / factor, 4).map((p) =>
    draw("text", { x: LEFT - 4, y: y(p * factor) + 4, "text-anchor": "end" }, plain(p)));
  return [...labels, draw("text", { x: LEFT + 4, y: TOP + 10 }, `power [${unit}]`)];
}

function marker(range, start, end, x) {
  const time = (2 * range) / LIGHT;
  if (!(time >= start && time <= end)) return [];
  return [draw("path", { class: "echo", d: `M${x(time)} ${TOP}V${HEIGHT - BOTTOM}` })];
}
