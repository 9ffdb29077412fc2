// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The panel of the settings, the theme, and the help.

import { byId, make } from "./dom.js";
import { helpRows } from "./keys.js";

export function showTitle(meta) {
  const share = meta.shown < meta.total
    ? `${meta.shown.toLocaleString("en-US")} of ${meta.total.toLocaleString("en-US")} points`
    : `${meta.total.toLocaleString("en-US")} points`;
  byId("name").textContent = meta.title;
  byId("count").textContent = [share, meta.crs].filter(Boolean).join(", ");
}

/** Fills the list of arrays; choose(index) is called for another one. */
export function showArrays(columns, chosen, choose) {
  const options = columns.map((column, i) =>
    make("option", { value: i, selected: i === chosen }, column.name + (column.unit ? ` [${column.unit}]` : "")));
  byId("array").replaceChildren(...options);
  byId("array").onchange = (event) => choose(Number(event.target.value));
}

export function showHelp(licences) {
  const rows = helpRows().map(([keys, text]) => make("tr", {}, make("th", {}, keys), make("td", {}, text)));
  byId("keys").replaceChildren(...rows);
  byId("licences").textContent = licences;
}

/** The theme of the system, unless one is set on the page. */
export function currentTheme() {
  const set = document.documentElement.dataset.theme;
  return set ?? (matchMedia("(prefers-color-scheme: light)").matches ? "light" : "dark");
}

export function switchTheme() {
  document.documentElement.dataset.theme = currentTheme() === "dark" ? "light" : "dark";
}

/** The background of the theme as three numbers in 0..1. */
export function background() {
  const text = getComputedStyle(byId("cloud")).backgroundColor;
  return text.match(/\d+/g).slice(0, 3).map((value) => Number(value) / 255);
}
