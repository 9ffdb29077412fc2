// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Level of detail: the nodes to draw, the largest on the screen first, within a budget of points.

import { FIELD } from "./camera.js";

const GRID = 128; // points along the side of a node
const FINEST = 0.8; // spacing of points below which nodes are not refined [pixels]

/** The six planes of a clip matrix. */
export function planesOf(m) {
  const row = (r) => [m[r], m[4 + r], m[8 + r], m[12 + r]];
  const w = row(3);
  return [0, 1, 2].flatMap((r) => [w.map((v, i) => v + row(r)[i]), w.map((v, i) => v - row(r)[i])]);
}

/** Whether some of a node may be inside the planes. */
export function isInside(node, planes) {
  return planes.every(([a, b, c, d]) => {
    const x = node.corner[0] + (a > 0 ? node.size : 0);
    const y = node.corner[1] + (b > 0 ? node.size : 0);
    const z = node.corner[2] + (c > 0 ? node.size : 0);
    return a * x + b * y + c * z + d >= 0;
  });
}

/** The size of a node on the screen [pixels]. */
function sizeOnScreen(node, camera, height) {
  if (camera.isParallel) return node.size / camera.pixelSize(height);
  const offset = node.corner.map((corner, a) => corner + node.size / 2 - camera.eye[a]);
  const distance = Math.max(camera.near, Math.hypot(...offset) - 0.87 * node.size);
  return (node.size * height) / (2 * distance * Math.tan(FIELD / 2));
}

/** The nodes to draw, and the number of their points. */
export function select(cloud, camera, height, budget) {
  const planes = planesOf(camera.matrix);
  const chosen = [];
  let points = 0;
  const front = isInside(cloud.nodes[0], planes) ? [{ node: cloud.nodes[0], size: Infinity }] : [];
  while (front.length) {
    let best = 0;
    for (let i = 1; i < front.length; i++) if (front[i].size > front[best].size) best = i;
    const { node } = front.splice(best, 1)[0];
    if (chosen.length && points + node.count > budget) break;
    chosen.push(node);
    points += node.count;
    for (const child of node.children) {
      const size = sizeOnScreen(child, camera, height);
      if (size / GRID > FINEST / 2 && isInside(child, planes)) front.push({ node: child, size });
    }
  }
  return { nodes: chosen, points };
}
