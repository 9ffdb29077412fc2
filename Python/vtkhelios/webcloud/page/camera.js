// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A camera that orbits a target; lengths [m] from the corner of the cloud, z up.

import { m4 } from "./twgl.js";

m4.setDefaultType(Float64Array);

export const FIELD = (45 * Math.PI) / 180; // vertical
const FILLED = 0.94; // of the frame by the first view
const FITTING = 24; // steps

export class Camera {
  /** Of the box { low, high } of all points, and of points that the first view shows. */
  constructor(box, outline) {
    this.outline = outline;
    this.centre = box.low.map((low, a) => (low + box.high[a]) / 2);
    this.radius = Math.max(0.05, 0.5 * Math.hypot(...box.low.map((low, a) => box.high[a] - low)));
    this.isParallel = false;
    this.aspect = 1;
    this.setView(0.35 * Math.PI, (35 * Math.PI) / 180);
    this.fit();
  }

  /** Azimuth of the view direction, counterclockwise from x, and depression [rad]. */
  setView(azimuth, depression) {
    this.azimuth = azimuth + Math.PI; // of the eye from the target
    this.elevation = depression;
  }

  /** Places the camera so that the outline fills the frame. */
  fit() {
    const middle = (values) => (Math.min(...values) + Math.max(...values)) / 2;
    this.target = [0, 1, 2].map((a) => middle(this.outline.map((point) => point[a])));
    this.distance = 4 * this.radius;
    for (let i = 0; i < FITTING; i++) {
      this.update();
      this.fitOnce();
    }
    this.update();
  }

  /** Moves the outline to the middle of the frame, and scales it towards its size. */
  fitOnce() {
    const places = this.outline.map((point) => this.clip(point)).map(([x, y, , w]) => [x / w, y / w]);
    const [[left, right], [bottom, top]] = [0, 1].map((a) => {
      const values = places.map((place) => place[a]);
      return [Math.min(...values), Math.max(...values)];
    });
    const half = this.distance * Math.tan(FIELD / 2);
    const { right: toRight, up } = this.axes();
    const [dx, dy] = [(half * this.aspect * (left + right)) / 2, (half * (bottom + top)) / 2];
    this.target = this.target.map((value, a) => value + dx * toRight[a] + dy * up[a]);
    const scale = Math.max(right - left, top - bottom) / (2 * FILLED);
    this.distance = Math.max(this.distance * Math.min(1.5, Math.max(0.5, scale)), 0.002 * this.radius);
  }

  /** Homogeneous clip coordinates of a point. */
  clip([x, y, z]) {
    const m = this.matrix;
    return [0, 1, 2, 3].map((r) => m[r] * x + m[4 + r] * y + m[8 + r] * z + m[12 + r]);
  }

  /** Unit vectors of the frame: right, up, back (from target to eye). */
  axes() {
    const [ca, sa] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
    const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
    return { right: [-sa, ca, 0], up: [-se * ca, -se * sa, ce], back: [ce * ca, ce * sa, se] };
  }

  /** Metres per pixel at the target, for a height of the frame [pixels]. */
  pixelSize(height) {
    return (2 * this.distance * Math.tan(FIELD / 2)) / height;
  }

  update() {
    const { right, up, back } = this.axes();
    this.eye = this.target.map((t, a) => t + this.distance * back[a]);
    const world = new Float64Array([...right, 0, ...up, 0, ...back, 0, ...this.eye, 1]);
    this.setRange(back);
    const half = this.distance * Math.tan(FIELD / 2);
    this.projection = this.isParallel
      ? m4.ortho(-half * this.aspect, half * this.aspect, -half, half, this.near, this.far)
      : m4.perspective(FIELD, this.aspect, this.near, this.far);
    this.matrix = m4.multiply(this.projection, m4.inverse(world));
  }

  /** Near and far planes that hold the whole cloud. */
  setRange(back) {
    const depth = this.eye.reduce((sum, e, a) => sum + (e - this.centre[a]) * back[a], 0);
    const reach = 1.05 * this.radius;
    this.far = Math.max(depth + reach, 1e-6 * this.radius + 0.1 * this.distance);
    if (this.isParallel) this.near = Math.min(depth - reach, 0);
    else this.near = Math.max(depth - reach, Math.min(this.far / 5000, 0.02 * this.distance), this.far / 1e6);
  }
}
