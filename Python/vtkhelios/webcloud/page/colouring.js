// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How a column becomes colours: the numbers of the points on the graphics card, and the limits.

import { valueOf } from "./cloud.js";
import { palette, ramp } from "./colours.js";

const NONE = -1e30; // of shaders.js: no value
const MODES = { continuous: 0, category: 1, colour: 2 };

export class Colouring {
  constructor(column) {
    this.column = column;
    this.isLogarithmic = column.log;
    this.limits = [...column.limits];
    this.hidden = new Set(); // values of categories
    this.places = new Map(column.categories.map(([value], i) => [value, i]));
  }

  get mode() {
    return MODES[this.column.role];
  }

  /** Values for the shader, as float32: relative to the smallest value, or logarithms. */
  convert(codes) {
    return Float32Array.from(codes, (code) => this.number(valueOf(this.column, code)));
  }

  number(value) {
    if (Number.isNaN(value)) return NONE;
    if (this.column.role === "category") return this.places.get(value) ?? NONE;
    if (this.column.role === "colour") return value;
    if (this.isLogarithmic) return value > 0 ? Math.log10(value) : NONE;
    return value - this.column.extremes[0];
  }

  /** The limits in numbers of the shader. */
  shaderLimits() {
    const [low, high] = this.limits.map((limit) => this.number(limit));
    return [low, high > low ? high : low + 1e-6];
  }

  textures(theme) {
    return { ramp: ramp(theme), palette: palette(this.column, this.hidden) };
  }
}
