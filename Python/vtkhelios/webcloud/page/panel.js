// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The values of the picked point.

import { makeChart } from "./chart.js";
import { byId, make } from "./dom.js";
import { decimals, plain, prefixed } from "./ticks.js";

/** A value of a column as text with its unit. */
export function textOf(column, value) {
  if (Number.isNaN(value)) return "no value";
  if (column.role === "category") {
    return column.categories.find(([known]) => known === value)?.[1] ?? String(value);
  }
  if (column.role === "colour") return `#${value.toString(16).padStart(6, "0")}`;
  if (column.kind === "float") {
    const [unit, factor] = prefixed(column.unit, value);
    return `${plain(value / factor, 5)} ${unit}`.trim();
  }
  return `${Number(value.toFixed(decimals(column.step)))} ${column.unit}`.trim();
}

/** Shows a picked point { coordinates, values, wave, waves }; null: nothing is picked.
    actions: close(), pickWave() picks the nearest point with a waveform. */
export function showPicked(picked, step, actions) {
  const panel = byId("picked");
  panel.hidden = !picked;
  if (!picked) return;
  const places = picked.coordinates.map((value, a) => ["xyz"[a], `${value.toFixed(decimals(step))} m`]);
  const rows = [...places, ...picked.values.map(({ column, value }) => [column.name, textOf(column, value)])];
  const table = make("table", {}, ...rows.map(([name, text]) => make("tr", {},
    make("th", { scope: "row" }, name), make("td", {}, text))));
  panel.replaceChildren(
    make("header", {}, make("b", {}, "Picked point"),
      make("button", { type: "button", title: "close (Esc)", "aria-label": "close", onclick: actions.close }, "×")),
    make("div", { class: "values" }, table), ...waveOf(picked, actions.pickWave));
}

function waveOf({ wave, waves, values }, pickWave) {
  if (!waves) return [];
  if (!wave) return noWave(waves, pickWave);
  const range = values.find(({ column }) => column.name === "Range")?.value;
  return [make("div", { class: "title" }, "Waveform"), makeChart(wave, range)];
}

function noWave({ count, of }, pickWave) {
  const share = `The page has the waveforms of ${count.toLocaleString("en-US")} of ${of.toLocaleString("en-US")} pulses, not of this one.`;
  return [make("p", { class: "note" }, share),
    make("button", { type: "button", id: "pick-wave", onclick: pickWave }, "Nearest point with a waveform")];
}
