// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Shaders: points into a frame with depth, points as numbers for picking, and eye-dome lighting.

const POINT = `
uniform mat4 matrix;
uniform float pointSize; // at the pivot [pixels]
uniform float pivotDepth; // 1 in parallel projection
uniform vec2 limits; // of the colour scale
uniform int mode; // 0: scale, 1: categories, 2: colours
uniform sampler2D ramp; // 256 x 1
uniform sampler2D palette; // 64 x 64; alpha 0: hidden
uniform vec3 missing;
in vec3 position;
in float value;
const float NONE = -1e30;

vec4 colourOf(float v) {
  if (v < 0.5 * NONE) return vec4(missing, 1.0);
  if (mode == 0) {
    float t = clamp((v - limits.x) / (limits.y - limits.x), 0.0, 1.0);
    return vec4(texture(ramp, vec2((t * 255.0 + 0.5) / 256.0, 0.5)).rgb, 1.0);
  }
  if (mode == 1) return texelFetch(palette, ivec2(int(v) % 64, int(v) / 64), 0);
  return vec4(floor(v / 65536.0), floor(mod(v, 65536.0) / 256.0), mod(v, 256.0), 255.0) / 255.0;
}

// Near points are larger, up to 3 times; hidden ones are outside of the frame.
float setPlace(vec4 colour) {
  gl_Position = colour.a > 0.0 ? matrix * vec4(position, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
  gl_PointSize = pointSize * clamp(pivotDepth / gl_Position.w, 0.8, 3.0);
  return gl_PointSize;
}
`;

const DISC = `
void keepDisc(float size) {
  vec2 offset = gl_PointCoord - 0.5;
  if (size > 3.0 && dot(offset, offset) > 0.25) discard;
}
`;

const HEAD = "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";

export const drawVertex = `${HEAD}${POINT}
flat out vec3 colour;
flat out float size;
void main() {
  vec4 found = colourOf(value);
  colour = found.rgb;
  size = setPlace(found);
}`;

export const drawFragment = `${HEAD}${DISC}
flat in float size;
flat in vec3 colour;
out vec4 shown;
void main() {
  keepDisc(size);
  shown = vec4(colour, 1.0);
}`;

export const pickVertex = `${HEAD}${POINT}
flat out uint point;
flat out float size;
void main() {
  size = setPlace(colourOf(value));
  point = uint(gl_VertexID);
}`;

export const pickFragment = `${HEAD}${DISC}
flat in float size;
uniform uint node; // from 1
flat in uint point;
out uvec4 found;
void main() {
  keepDisc(size);
  found = uvec4(node, point, 0u, 0u);
}`;

export const screenVertex = `${HEAD}
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}`;

// Boucheny 2009: a pixel is darkened by the neighbours that are nearer, in the logarithm of depth.
export const lightFragment = `${HEAD}
uniform sampler2D colours;
uniform sampler2D depths;
uniform vec3 background;
uniform vec2 range; // near and far
uniform bool isParallel;
uniform float strength; // 0: off
uniform float radius; // [pixels]
out vec4 shown;

float depthAt(ivec2 pixel) {
  float d = texelFetch(depths, clamp(pixel, ivec2(0), textureSize(depths, 0) - 1), 0).r;
  if (d >= 1.0) return -1.0;
  if (isParallel) return mix(range.x, range.y, d) - range.x + 0.1 * (range.y - range.x);
  return range.x * range.y / (range.y - d * (range.y - range.x));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = depthAt(pixel);
  if (depth < 0.0) { shown = vec4(background, 1.0); return; }
  float nearer = 0.0;
  if (strength > 0.0) {
    for (int i = 0; i < 8; i++) {
      float angle = 0.785398 * float(i);
      float other = depthAt(pixel + ivec2(round(radius * vec2(cos(angle), sin(angle)))));
      if (other > 0.0) nearer += min(0.05, max(0.0, log2(depth / other)));
    }
  }
  float shade = max(0.35, exp(-strength * nearer / 8.0));
  shown = vec4(shade * texelFetch(colours, pixel, 0).rgb, 1.0);
}`;
