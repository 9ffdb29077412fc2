// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Colour maps. The scale is viridis, perceptually uniform and readable with all colour deficiencies,
// without the end that vanishes on the background of the theme.

const VIRIDIS = // every fifth of 256
  "44015446085c471063481769481d6f482475472a7a46307e453781433d844142873f48893d4e8a"
  + "3a538b38598c355e8d33638d31688e2e6d8e2c718e2a768e297b8e27808e25848e23898e218e8d"
  + "20928c1f978b1e9c891fa18821a58524aa8328ae802eb37c35b7793dbc7446c06f50c46a5ac864"
  + "65cb5e70cf577cd25089d54895d840a2da37b0dd2fbddf26cae11fd8e219e5e419f1e51dfde725";

const ENDS = { dark: [0.15, 1], light: [0, 0.9] }; // part of the map that is used

// Okabe and Ito's colours without black, then others of different lightness.
const CATEGORIES = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442",
  "#8c6bb1", "#a6761d", "#66c2a5", "#b2b2b2", "#e78ac3"];

const CLASSES = { 0: "#8f979f", 1: "#b3bac1", 2: "#b5893c", 3: "#b7d96b", 4: "#5fb04f", 5: "#1f7f43",
  6: "#d55e00", 7: "#cc79a7", 9: "#3d8fd1", 10: "#8c6bb1", 11: "#6b7785", 13: "#f0e442", 14: "#f0e442",
  15: "#56b4e9", 17: "#a6761d" };

/** [r, g, b] in 0..255 of "#rrggbb". */
export function parse(hex) {
  return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
}

/** The colour of the map at t in 0..1. */
export function viridis(t) {
  const anchors = VIRIDIS.length / 6 - 1;
  const place = Math.min(Math.max(t, 0), 1) * anchors;
  const i = Math.min(Math.floor(place), anchors - 1);
  const [a, b] = [i, i + 1].map((n) => parse(`#${VIRIDIS.slice(6 * n, 6 * n + 6)}`));
  return a.map((from, c) => Math.round(from + (place - i) * (b[c] - from)));
}

/** 256 colours as RGBA bytes, for a theme. */
export function ramp(theme) {
  const [low, high] = ENDS[theme];
  const bytes = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; i++) bytes.set([...viridis(low + ((high - low) * i) / 255), 255], 4 * i);
  return bytes;
}

/** The colour of a category, by its place in the list; classes of LAS have their usual colours. */
export function categoryColour(column, index) {
  const value = column.categories[index][0];
  if (column.name === "ClassificationIds" && CLASSES[value]) return CLASSES[value];
  return CATEGORIES[index % CATEGORIES.length];
}

/** 4096 colours as RGBA bytes; hidden categories have alpha 0. */
export function palette(column, hidden) {
  const bytes = new Uint8Array(4 * 4096);
  column.categories.forEach(([value], i) =>
    bytes.set([...parse(categoryColour(column, i)), hidden.has(value) ? 0 : 255], 4 * i));
  return bytes;
}

export function toCss(bytes, i) {
  return `rgb(${bytes[4 * i]} ${bytes[4 * i + 1]} ${bytes[4 * i + 2]})`;
}
