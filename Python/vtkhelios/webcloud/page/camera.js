// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A camera that orbits a target; lengths [m] from the corner of the cloud, z up.

import { m4 } from "./twgl.js";

m4.setDefaultType(Float64Array);

export const FIELD = (45 * Math.PI) / 180; // vertical, at 800 pixels

export class Camera {
  /** Of the box of all points, and of the box that the first view shows: { low, high }. */
  constructor(box, mainBox) {
    this.mainBox = mainBox;
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

  /** Places the camera so that the main box fills the frame. */
  fit() {
    const { low, high } = this.mainBox;
    this.target = low.map((value, a) => (value + high[a]) / 2);
    this.distance = this.radius;
    for (let i = 0; i < 12; i++) { // the size of the box in the frame, until it is 1
      this.update();
      let extent = 0;
      const corners = [...Array(8).keys()].map((n) => [0, 1, 2].map((a) => ((n >> a) & 1 ? high : low)[a]));
      for (const corner of corners) {
        const [x, y, , w] = this.clip(corner);
        if (w <= 0) extent = Math.max(extent, 2);
        else extent = Math.max(extent, Math.abs(x / w), Math.abs(y / w));
      }
      this.distance *= Math.max(0.3, Math.min(3, extent / 0.92));
    }
    this.distance = Math.max(this.distance, 0.002 * this.radius);
    this.update();
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
