// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws nodes with WebGL 2: points into a frame, then the frame with eye-dome lighting to the page.

import * as twgl from "./twgl.js";
import * as shaders from "./shaders.js";

const PICK = 15; // pixels around the mouse that are searched
const STRENGTH = 60; // of the lighting
const LOCATIONS = ["position", "value"];

export class Renderer {
  constructor(canvas) {
    const gl = canvas.getContext("webgl2", { antialias: false, alpha: false, powerPreference: "high-performance" });
    if (!gl) throw new Error("WebGL 2 is not available: use a current browser, with graphics acceleration on");
    this.gl = gl;
    const program = (vertex, fragment) =>
      twgl.createProgramInfo(gl, [vertex, fragment], { attribLocations: LOCATIONS });
    this.drawing = program(shaders.drawVertex, shaders.drawFragment);
    this.picking = program(shaders.pickVertex, shaders.pickFragment);
    this.lighting = program(shaders.screenVertex, shaders.lightFragment);
    this.attachments = attachments(gl, gl.RGBA8);
    this.frame = twgl.createFramebufferInfo(gl, this.attachments);
    this.pickFrame = twgl.createFramebufferInfo(gl, attachments(gl, gl.RGBA32UI), PICK, PICK);
    this.ramp = twgl.createTexture(gl, { src: new Uint8Array(1024), width: 256, height: 1, min: gl.NEAREST, mag: gl.NEAREST });
    this.palette = twgl.createTexture(gl, { src: new Uint8Array(4 * 4096), width: 64, min: gl.NEAREST, mag: gl.NEAREST });
    this.empty = gl.createVertexArray();
  }

  /** Sets the colours of the scale and of the categories: RGBA bytes. */
  setColours({ ramp, palette }) {
    const { gl } = this;
    const options = { format: gl.RGBA, min: gl.NEAREST, mag: gl.NEAREST };
    twgl.setTextureFromArray(gl, this.ramp, ramp, { ...options, width: 256, height: 1 });
    twgl.setTextureFromArray(gl, this.palette, palette, { ...options, width: 64, height: 64 });
  }

  /** Uploads the points of a node: 3 n numbers. */
  upload(node, points) {
    const { gl } = this;
    const drawn = { array: gl.createVertexArray(), position: gl.createBuffer(), value: gl.createBuffer(), key: null };
    gl.bindVertexArray(drawn.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, drawn.position);
    gl.bufferData(gl.ARRAY_BUFFER, points, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.bindVertexArray(null);
    node.drawn = drawn;
  }

  /** Uploads the values of a node; the key names what they are. */
  uploadValues(node, values, key) {
    const { gl } = this;
    gl.bindVertexArray(node.drawn.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, node.drawn.value);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribPointer(1, 1, gl.FLOAT, false, 0, 0);
    gl.bindVertexArray(null);
    node.drawn.key = key;
  }

  /** Draws nodes with a camera. options: pointSize, limits, mode, background, light, missing. */
  draw(nodes, camera, options) {
    const { gl } = this;
    const [width, height] = [gl.canvas.width, gl.canvas.height];
    if (this.frame.width !== width || this.frame.height !== height) {
      twgl.resizeFramebufferInfo(gl, this.frame, this.attachments, width, height);
    }
    twgl.bindFramebufferInfo(gl, this.frame);
    gl.enable(gl.DEPTH_TEST);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.drawNodes(this.drawing, nodes, camera.matrix, options);
    this.light(camera, options);
  }

  drawNodes(program, nodes, matrix, options) {
    const { gl } = this;
    gl.useProgram(program.program);
    twgl.setUniforms(program, { ...options, ramp: this.ramp, palette: this.palette });
    for (const node of nodes) {
      twgl.setUniforms(program, { matrix: shifted(matrix, node.corner), node: node.index + 1 });
      gl.bindVertexArray(node.drawn.array);
      gl.drawArrays(gl.POINTS, 0, node.count);
    }
    gl.bindVertexArray(null);
  }

  light(camera, { background, light, pointSize }) {
    const { gl } = this;
    twgl.bindFramebufferInfo(gl, null);
    gl.disable(gl.DEPTH_TEST);
    gl.useProgram(this.lighting.program);
    gl.bindVertexArray(this.empty);
    twgl.setUniforms(this.lighting, {
      colours: this.frame.attachments[0], depths: this.frame.attachments[1], background,
      range: [camera.near, camera.far], isParallel: camera.isParallel,
      strength: light ? STRENGTH : 0, radius: 1 + 0.5 * pointSize,
    });
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** The drawn point nearest to a pixel (from the top left): { node, point } or null. */
  pick(nodes, matrix, options) {
    const { gl } = this;
    twgl.bindFramebufferInfo(gl, this.pickFrame);
    gl.enable(gl.DEPTH_TEST);
    gl.clearBufferuiv(gl.COLOR, 0, new Uint32Array(4));
    gl.clear(gl.DEPTH_BUFFER_BIT);
    this.drawNodes(this.picking, nodes, matrix, options);
    const found = new Uint32Array(4 * PICK * PICK);
    gl.readPixels(0, 0, PICK, PICK, gl.RGBA_INTEGER, gl.UNSIGNED_INT, found);
    twgl.bindFramebufferInfo(gl, null);
    return nearest(found);
  }

  /** Waits for the graphics card, for measurements. */
  finish() {
    this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, new Uint8Array(4));
  }
}

/** Of a frame: a texture of a format, and one of depths. */
function attachments(gl, internalFormat) {
  const depth = { internalFormat: gl.DEPTH_COMPONENT24, format: gl.DEPTH_COMPONENT, type: gl.UNSIGNED_INT };
  return [{ internalFormat }, depth].map((texture) => ({ ...texture, minMag: gl.NEAREST }));
}

/** The clip matrix of a square of PICK pixels around a pixel of a frame. */
export function pickMatrix(matrix, x, y, width, height) {
  const [sx, sy] = [width / PICK, height / PICK];
  const [tx, ty] = [-sx * ((2 * x) / width - 1), -sy * (1 - (2 * y) / height)];
  return matrix.map((value, i) => {
    const row = i % 4;
    if (row === 0) return sx * value + tx * matrix[i + 3];
    return row === 1 ? sy * value + ty * matrix[i + 2] : value;
  });
}

/** A matrix times a translation, as float32. */
function shifted(m, [x, y, z]) {
  const moved = Float32Array.from(m);
  for (let r = 0; r < 4; r++) moved[12 + r] = m[r] * x + m[4 + r] * y + m[8 + r] * z + m[12 + r];
  return moved;
}

function nearest(found) {
  const middle = (PICK - 1) / 2;
  let best = null;
  for (let i = 0; i < PICK * PICK; i++) {
    if (found[4 * i] === 0) continue;
    const distance = Math.hypot((i % PICK) - middle, Math.floor(i / PICK) - middle);
    if (!best || distance < best.distance) best = { node: found[4 * i] - 1, point: found[4 * i + 1], distance };
  }
  return best;
}
