// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Starts the page, and connects its parts.

import { Camera } from "./camera.js";
import { Cloud, nearestOf } from "./cloud.js";
import { Colouring } from "./colouring.js";
import { Controls } from "./controls.js";
import { Store } from "./decode.js";
import { byId } from "./dom.js";
import { listen } from "./keys.js";
import { showLegend } from "./legend.js";
import { distanceText, drawOverlay } from "./overlay.js";
import { showPicked } from "./panel.js";
import { pickMatrix, Renderer } from "./renderer.js";
import { select } from "./selection.js";
import { background, currentTheme, showArrays, showHelp, showTitle, switchTheme } from "./settings.js";
import { View } from "./view.js";
import { Waves } from "./waves.js";

class App {
  constructor(meta, text) {
    const store = new Store(text, meta.lengths);
    this.cloud = new Cloud(meta, store);
    this.waves = meta.waveforms && new Waves(meta.waveforms, store);
    this.canvas = byId("cloud");
    this.camera = new Camera(meta.box, meta.outline);
    this.renderer = new Renderer(this.canvas);
    this.view = new View(this.cloud, this.renderer, this.camera, this.canvas);
    this.view.onFrame = () => this.drawOverlay();
    this.colourings = this.cloud.columns.map((column) => new Colouring(column));
    this.picked = null;
    this.measured = []; // points [m] from the cloud's corner
    this.isMeasuring = false;
    this.connect();
    this.start(meta);
  }

  async start(meta) {
    const first = Math.max(0, this.cloud.columns.findIndex(({ name }) => name === meta.colourBy));
    showTitle(meta);
    showHelp(meta.licences);
    showArrays(this.cloud.columns, first, (index) => this.choose(index));
    this.view.resize();
    this.camera.fit();
    await this.choose(first);
  }

  connect() {
    const moved = () => this.view.moved();
    this.controls = new Controls(this.canvas, this.camera, { moved,
      clicked: (x, y) => this.click(x, y), doubleClicked: (x, y) => this.setPivot(x, y) });
    const look = (azimuth, depression) => () => { this.camera.setView(azimuth, depression); this.camera.fit(); moved(); };
    const actions = {
      turn: (a, e) => this.controls.turn(a, e), zoom: (factor) => this.controls.zoom(factor),
      fit: () => { this.camera.fit(); moved(); },
      top: look(Math.PI / 2, Math.PI / 2), south: look(Math.PI / 2, 0), east: look(Math.PI, 0),
      parallel: () => this.toggle("parallel"), light: () => this.toggle("light"),
      measure: () => this.setMeasuring(!this.isMeasuring), theme: () => { switchTheme(); this.recolour(); },
      help: () => (byId("help").open ? byId("help").close() : byId("help").showModal()),
      escape: () => this.escape(),
    };
    listen(actions);
    for (const name of ["fit", "top", "south", "east", "measure", "theme", "help"]) {
      byId(`do-${name}`).addEventListener("click", actions[name]);
    }
    byId("light").addEventListener("change", () => this.applySettings());
    byId("parallel").addEventListener("change", () => this.applySettings());
    byId("size").addEventListener("input", () => this.applySettings());
    new ResizeObserver(() => this.view.request()).observe(this.canvas);
    matchMedia("(prefers-color-scheme: light)").addEventListener("change", () => this.recolour());
  }

  toggle(id) {
    byId(id).checked = !byId(id).checked;
    this.applySettings();
  }

  applySettings() {
    this.view.options.light = byId("light").checked;
    this.view.options.pointScale = Number(byId("size").value);
    this.camera.isParallel = byId("parallel").checked;
    this.view.request();
  }

  /** Colours by a column. */
  async choose(index) {
    byId("array").value = String(index);
    await this.view.setColouring(this.colourings[index]);
    this.recolour();
  }

  recolour() {
    const theme = currentTheme();
    this.renderer.setColours(this.view.colouring.textures(theme));
    this.view.options.background = background();
    showLegend(this.view.colouring, theme, () => this.recolour());
    this.view.request();
  }

  /** The point drawn at a place of the canvas [CSS pixels], { node, point } or null. */
  find(x, y) {
    const { canvas, camera, renderer, view } = this;
    const ratio = canvas.width / canvas.clientWidth;
    const matrix = pickMatrix(camera.matrix, x * ratio, y * ratio, canvas.width, canvas.height);
    const { nodes } = select(this.cloud, { ...camera, matrix, pixelSize: (h) => camera.pixelSize(h) }, canvas.height, Infinity);
    const loaded = nodes.filter((node) => view.drawn.nodes.includes(node));
    const found = renderer.pick(loaded, matrix, view.drawOptions());
    return found && { node: this.cloud.nodes[found.node], point: found.point };
  }

  /** A found point [m] from the cloud's corner. */
  async placeOf({ node, point }) {
    const points = await this.cloud.readPoints(node);
    return [0, 1, 2].map((a) => points[3 * point + a] + node.corner[a]);
  }

  async click(x, y) {
    const found = this.find(x, y);
    if (this.isMeasuring) return found && this.measure(await this.placeOf(found));
    return this.pick(found);
  }

  async pick(found) {
    if (!found) {
      this.picked = null;
    } else {
      const { node, point } = found;
      const [place, coordinates, values] = await Promise.all([
        this.placeOf(found), this.cloud.coordinates(node, point), this.cloud.values(node, point)]);
      const pulse = values.find(({ column }) => column.name === "PulseIds")?.value;
      const wave = this.waves && pulse !== undefined ? await this.waves.find(pulse) : null;
      this.picked = { place, coordinates, values, wave, waves: this.waves?.description };
    }
    showPicked(this.picked, this.cloud.meta.step, { close: () => this.pick(null), pickWave: () => this.pickWave() });
    this.drawOverlay();
  }

  /** Picks the drawn point with a waveform that is nearest to the picked one. */
  async pickWave() {
    const pulses = await this.waves.pulses();
    const found = await nearestOf(this.cloud, this.view.drawn.nodes, this.picked.place, "PulseIds", pulses);
    if (found) await this.pick(found);
  }

  async setPivot(x, y) {
    const found = this.find(x, y);
    if (!found) return;
    const place = await this.placeOf(found);
    const depth = this.camera.axes().back.reduce((sum, b, a) => sum + b * (this.camera.eye[a] - place[a]), 0);
    this.camera.distance = Math.max(1e-4 * this.camera.radius, depth);
    this.camera.target = place;
    this.view.moved();
  }

  setMeasuring(on) {
    this.isMeasuring = on;
    this.measured = [];
    byId("do-measure").setAttribute("aria-pressed", on);
    this.showDistance(on ? "Click the first point." : "");
  }

  measure(place) {
    this.measured = this.measured.length === 1 ? [...this.measured, place] : [place];
    const isDone = this.measured.length === 2;
    this.showDistance(isDone ? distanceText(this.measured) : "Click the second point.");
  }

  showDistance(text) {
    byId("distance").textContent = text;
    byId("distance").hidden = !text;
    this.drawOverlay();
  }

  escape() {
    if (byId("help").open) byId("help").close();
    else if (this.isMeasuring) this.setMeasuring(false);
    else this.pick(null);
  }

  drawOverlay() {
    const { clientWidth, clientHeight } = this.canvas;
    drawOverlay(this.camera, clientWidth, clientHeight, { picked: this.picked?.place, measured: this.measured });
  }

  /** The state of the page, for scripts and tests. */
  state() {
    const { view, camera } = this;
    return { points: view.drawn.points, nodes: view.drawn.nodes.length, budget: view.budget, isComplete: Boolean(view.isComplete),
      isMoving: view.isMoving, colourBy: view.colouring.column.name, limits: view.colouring.limits, theme: currentTheme(),
      target: camera.target, distance: camera.distance, isParallel: camera.isParallel,
      pointSize: view.drawOptions().pointSize, picked: this.picked && { coordinates: this.picked.coordinates,
        values: Object.fromEntries(this.picked.values.map(({ column, value }) => [column.name, value])),
        wave: this.picked.wave && { ...this.picked.wave, samples: [...this.picked.wave.samples] } },
      measured: this.measured };
  }

  /** Time to draw a frame of at most so many points [ms]. */
  time(budget = Infinity) {
    this.renderer.finish();
    const start = performance.now();
    this.view.drawNow(budget);
    this.renderer.finish();
    return { ms: performance.now() - start, points: this.view.drawn.points };
  }
}

function begin() {
  try {
    const meta = JSON.parse(byId("meta").textContent);
    window.vtkhelios = new App(meta, byId("streams").textContent);
  } catch (error) {
    byId("problem").textContent = error.message;
    byId("problem").hidden = false;
  }
}

begin();
