// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Frames: draws when something has changed, with fewer points while the camera moves, and loads nodes.

import { select } from "./selection.js";

const STILL = 4_000_000; // points of a still frame
const FEWEST = 30_000; // and of a moving one
const SLOW = 60; // frame times between which the budget stays [ms]
const FAST = 28;
const REST = 180; // after the last movement [ms]
const LOADING = 250; // least time of loading between two frames [ms]; longer if frames are slow
const AT_ONCE = 8; // nodes
const COVERED = 0.6; // fraction of the frame that points of automatic size cover

export class View {
  constructor(cloud, renderer, camera, canvas) {
    Object.assign(this, { cloud, renderer, camera, canvas });
    this.budget = 400_000; // while moving
    this.options = { pointScale: 1, light: true, background: [0, 0, 0], missing: [0.5, 0.5, 0.5] };
    this.colouring = null;
    this.drawn = { nodes: [], points: 0 };
    this.isMoving = this.isQueued = this.isLoading = false;
    this.onFrame = () => {};
  }

  /** The key of the values on the graphics card. */
  get key() {
    const { column, isLogarithmic } = this.colouring;
    return `${column.name}/${isLogarithmic}`;
  }

  moved() {
    if (!this.isMoving) this.lastFrame = 0;
    this.isMoving = true;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => { this.isMoving = false; this.request(); }, REST);
    this.request();
  }

  request() {
    if (this.isQueued) return;
    this.isQueued = true;
    const asked = performance.now();
    requestAnimationFrame((now) => {
      this.isQueued = false;
      this.delay = performance.now() - asked; // includes the time of the frame before
      this.frame(now);
    });
  }

  frame(now) {
    if (!this.colouring) return;
    this.adapt(now);
    this.drawNow(this.isMoving ? this.budget : STILL);
    this.load();
    this.onFrame();
  }

  /** Fits the budget of moving frames to the time they take. */
  adapt(now) {
    if (this.isMoving && this.lastFrame) {
      const time = now - this.lastFrame;
      if (time > SLOW) this.budget = Math.max(FEWEST, 0.75 * this.budget);
      else if (time < FAST) this.budget = Math.min(STILL, 1.1 * this.budget);
    }
    this.lastFrame = this.isMoving ? now : 0;
  }

  drawNow(budget) {
    this.resize();
    this.camera.update();
    const wanted = select(this.cloud, this.camera, this.canvas.height, budget);
    this.wanted = wanted.nodes;
    const nodes = wanted.nodes.filter((node) => node.drawn?.key === this.key);
    this.drawn = { nodes, points: nodes.reduce((sum, node) => sum + node.count, 0) };
    this.renderer.draw(nodes, this.camera, this.drawOptions());
  }

  resize() {
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight].map((n) => Math.max(1, Math.round(n * ratio)));
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    this.camera.aspect = width / height;
  }

  drawOptions() {
    const pixelRatio = window.devicePixelRatio || 1;
    const { mode } = this.colouring;
    return { ...this.options, mode, limits: this.colouring.shaderLimits(),
      pivotDepth: this.camera.isParallel ? 1 : this.camera.distance,
      pointSize: this.options.pointScale * this.automaticSize(pixelRatio) };
  }

  /** The size with which the drawn points cover a part of the frame [pixels]. */
  automaticSize(pixelRatio) {
    const area = (COVERED * this.canvas.width * this.canvas.height) / Math.max(1, this.drawn.points);
    return Math.min(6 * pixelRatio, Math.max(1.5 * pixelRatio, Math.sqrt(area)));
  }

  /** Loads some of the wanted nodes, the most important first, then asks for a frame. */
  async load() {
    if (this.isLoading) return;
    const missing = this.wanted.filter((node) => node.drawn?.key !== this.key);
    this.isComplete = missing.length === 0;
    if (this.isComplete) return;
    this.isLoading = true;
    const end = performance.now() + Math.max(LOADING, 2 * this.delay);
    while (missing.length && performance.now() < end) {
      await Promise.all(missing.splice(0, AT_ONCE).map((node) => this.loadNode(node)));
    }
    this.isLoading = false;
    this.request();
  }

  /** Changes the colouring, once the values of the drawn nodes are there. */
  async setColouring(colouring) {
    this.next = colouring;
    const nodes = [...this.drawn.nodes];
    const codes = await Promise.all(nodes.map((node) => this.cloud.readCodes(node, colouring.column)));
    if (this.next !== colouring) return;
    this.colouring = colouring;
    nodes.forEach((node, i) => this.renderer.uploadValues(node, colouring.convert(codes[i]), this.key));
  }

  async loadNode(node) {
    const { colouring, key } = this;
    const [points, codes] = await Promise.all([
      node.drawn ? null : this.cloud.readPoints(node), this.cloud.readCodes(node, colouring.column)]);
    if (points && !node.drawn) this.renderer.upload(node, points);
    if (colouring === this.colouring) this.renderer.uploadValues(node, colouring.convert(codes), key);
  }
}
