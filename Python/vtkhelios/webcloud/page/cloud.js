// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The cloud of the page: an octree of nodes, whose points and values are decoded when they are used.

const scratch = new DataView(new ArrayBuffer(4));

/** The value of a code of a column; NaN: missing. See _quantise.py. */
export function valueOf(column, code) {
  if (code === column.missing) return NaN;
  if (column.kind === "float") {
    scratch.setUint32(0, code * 256);
    return scratch.getFloat32(0);
  }
  return inSteps(column.base + code, column.step);
}

/** A number of steps of a power of ten; division by the inverse gives the nearest double. */
export function inSteps(count, step) {
  return step < 1 ? count / Math.round(1 / step) : count * step;
}

export class Cloud {
  constructor(meta, store) {
    this.meta = meta;
    this.store = store;
    this.columns = [heightColumn(meta), ...meta.columns];
    this.nodes = meta.nodes.map((node, index) => this.makeNode(node, index));
    this.link();
  }

  makeNode([level, i, j, k, count], index) {
    const size = 2 ** (this.meta.bits - level); // in steps
    const steps = [i * size, j * size, k * size];
    const corner = steps.map((s) => inSteps(s, this.meta.step)); // [m], from the cloud's corner
    return { index, level, key: `${level}/${i}/${j}/${k}`, place: [i, j, k], count, steps, corner,
      size: inSteps(size, this.meta.step), children: [], points: null, drawn: null };
  }

  /** Sets the children of all nodes. */
  link() {
    const byKey = new Map(this.nodes.map((node) => [node.key, node]));
    for (const node of this.nodes.slice(1)) {
      const [i, j, k] = node.place.map((axis) => Math.floor(axis / 2));
      byKey.get(`${node.level - 1}/${i}/${j}/${k}`).children.push(node);
    }
  }

  streamOf(node, part) {
    return node.index * (1 + this.meta.columns.length) + part;
  }

  /** Points of a node in steps from its corner: three arrays. */
  async readSteps(node) {
    const reader = await this.store.open(this.streamOf(node, 0));
    return [0, 1, 2].map(() => reader.read(node.count));
  }

  /** Points of a node [m] from its corner, as float32 for drawing. */
  async readPoints(node) {
    const axes = await this.readSteps(node);
    const points = new Float32Array(3 * node.count);
    axes.forEach((axis, a) => {
      for (let i = 0; i < node.count; i++) points[3 * i + a] = inSteps(axis[i], this.meta.step);
    });
    return points;
  }

  /** Codes of a column of a node; heights are steps from the cloud's corner. */
  async readCodes(node, column) {
    if (column.source === "z") {
      const z = (await this.readSteps(node))[2];
      return z.map((value) => value + node.steps[2]);
    }
    const reader = await this.store.open(this.streamOf(node, this.columns.indexOf(column)));
    return reader.read(node.count);
  }

  /** Coordinates of a point as in the file [m]. */
  async coordinates(node, point) {
    const axes = await this.readSteps(node);
    return axes.map((axis, a) =>
      inSteps(this.meta.corner[a] + node.steps[a] + axis[point], this.meta.step));
  }

  /** The values of all columns at a point, by name; categories and colours as their codes' values. */
  async values(node, point) {
    const columns = this.columns.slice(1);
    const codes = await Promise.all(columns.map((column) => this.readCodes(node, column)));
    return columns.map((column, i) => ({ column, value: valueOf(column, codes[i][point]) }));
  }
}

/** The point of some nodes nearest to a place, of those with a value of a column in a set; or null. */
export async function nearestOf(cloud, nodes, place, name, wanted) {
  const column = cloud.columns.find((each) => each.name === name);
  let best = null;
  for (const node of nodes) {
    const [points, codes] = await Promise.all([cloud.readPoints(node), cloud.readCodes(node, column)]);
    for (let i = 0; i < node.count; i++) {
      const [x, y, z] = [0, 1, 2].map((a) => points[3 * i + a] + node.corner[a] - place[a]);
      const distance = x * x + y * y + z * z;
      if (distance < (best?.distance ?? Infinity) && wanted.has(valueOf(column, codes[i]))) {
        best = { node, point: i, distance };
      }
    }
  }
  return best;
}

function heightColumn(meta) {
  return { name: "Height", unit: "m", role: "continuous", source: "z", kind: "fixed",
    base: meta.corner[2], step: meta.step, missing: null, log: false, categories: [],
    limits: meta.heights.limits, extremes: meta.heights.extremes };
}
