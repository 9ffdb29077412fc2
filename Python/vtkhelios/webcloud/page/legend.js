// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The scale of the colours with round ticks, or the list of the categories.

import { categoryColour, ramp, toCss } from "./colours.js";
import { byId, make } from "./dom.js";
import { linearTicks, logTicks, plain, prefixed } from "./ticks.js";

const MOST = 16; // categories shown

/** Shows the colouring; calls changed() after a category is hidden or limits are edited. */
export function showLegend(colouring, theme, changed) {
  const { column } = colouring;
  if (column.role === "colour") byId("legend").replaceChildren();
  else if (column.role === "category") byId("legend").replaceChildren(...categories(colouring, changed));
  else byId("legend").replaceChildren(...scale(colouring, theme, changed));
}

/** Positions in 0..1 and texts of the ticks of a scale, and its unit. */
export function ticksOf({ column, limits: [low, high], isLogarithmic }) {
  const [unit, factor] = prefixed(column.unit, Math.max(Math.abs(low), Math.abs(high)));
  const shown = isLogarithmic ? logTicks(low / factor, high / factor) : linearTicks(low / factor, high / factor);
  const at = isLogarithmic
    ? (v) => Math.log(v * factor / low) / Math.log(high / low)
    : (v) => (v * factor - low) / (high - low || 1);
  return { unit, ticks: shown.map((value) => ({ place: at(value), text: plain(value, 9) })) };
}

function scale(colouring, theme, changed) {
  const { unit, ticks } = ticksOf(colouring);
  const bytes = ramp(theme);
  const stops = Array.from({ length: 17 }, (_, i) => toCss(bytes, Math.round((255 * i) / 16)));
  const bar = make("div", { class: "bar", style: `background: linear-gradient(to top, ${stops.join(",")})` });
  const labels = ticks.map(({ place, text }) =>
    make("span", { class: "tick", style: `bottom: ${100 * place}%` }, text));
  const title = make("div", { class: "title" }, colouring.column.name + (unit ? ` [${unit}]` : ""));
  return [title, make("div", { class: "scale" }, bar, ...labels), limitsOf(colouring, changed)];
}

function limitsOf(colouring, changed) {
  const { column } = colouring;
  const [unit, factor] = prefixed(column.unit, Math.max(...colouring.limits.map(Math.abs)));
  const input = (index, label) => make("input", { type: "text", inputmode: "decimal", "aria-label": `${label} of the scale [${unit}]`,
    value: String(Number((colouring.limits[index] / factor).toPrecision(4))),
    onchange: (event) => setLimit(colouring, index, Number(event.target.value) * factor, changed) });
  const reset = make("button", { type: "button", title: "2 % to 98 % of the points",
    onclick: () => { colouring.limits = [...column.limits]; changed(); } }, "reset");
  return make("div", { class: "limits" }, input(0, "minimum"), "to", input(1, "maximum"), reset);
}

function setLimit(colouring, index, value, changed) {
  const limits = [...colouring.limits];
  limits[index] = value;
  const valid = Number.isFinite(value) && limits[1] > limits[0] && (!colouring.isLogarithmic || limits[0] > 0);
  if (valid) colouring.limits = limits;
  changed();
}

function categories(colouring, changed) {
  const { column, hidden } = colouring;
  const rows = column.categories.map(([value, label, count], i) => ({ value, label, count, i }))
    .sort((a, b) => b.count - a.count);
  const shown = rows.slice(0, MOST).sort((a, b) => a.i - b.i);
  const list = shown.map(({ value, label, count, i }) => make("label", { class: "category" },
    make("input", { type: "checkbox", checked: !hidden.has(value), onchange: (event) => {
      if (event.target.checked) hidden.delete(value);
      else hidden.add(value);
      changed();
    } }),
    make("i", { style: `background: ${categoryColour(column, i)}` }),
    make("span", {}, label), make("small", {}, count.toLocaleString("en-US"))));
  const more = rows.length - shown.length;
  const rest = more > 0 ? [make("small", {}, `and ${more} more`)] : [];
  return [make("div", { class: "title" }, column.name), ...list, ...rest];
}
