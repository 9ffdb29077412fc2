// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Mouse, touch and wheel move the camera; a click picks.

const TURN = 0.006; // [rad/pixel]
const CLICK = 4; // pixels that a click may move
const ZOOM = 0.0015; // per unit of the wheel

export class Controls {
  /** actions: moved(), clicked(x, y), doubleClicked(x, y), in pixels of the element. */
  constructor(element, camera, actions) {
    Object.assign(this, { element, camera, actions, pointers: new Map(), path: 0, mayClick: false });
    element.addEventListener("pointerdown", (event) => this.press(event));
    element.addEventListener("pointermove", (event) => this.move(event));
    for (const name of ["pointerup", "pointercancel"]) element.addEventListener(name, (event) => this.release(event));
    element.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    element.addEventListener("dblclick", (event) => actions.doubleClicked(event.offsetX, event.offsetY));
    element.addEventListener("contextmenu", (event) => event.preventDefault());
  }

  press(event) {
    this.element.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
    this.path = 0;
    this.mayClick = event.button === 0 && this.pointers.size === 1;
    this.isPanning = event.button !== 0 || event.shiftKey;
  }

  move(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const now = [event.offsetX, event.offsetY];
    const [dx, dy] = now.map((value, i) => value - before[i]);
    this.path += Math.hypot(dx, dy);
    if (this.pointers.size === 2) this.pinch(event.pointerId, before, now);
    else if (this.path > CLICK) this.drag(dx, dy);
    this.pointers.set(event.pointerId, now);
  }

  release(event) {
    const isKnown = this.pointers.delete(event.pointerId);
    if (isKnown && this.mayClick && this.path <= CLICK && event.type === "pointerup") {
      this.actions.clicked(event.offsetX, event.offsetY);
    }
    if (this.pointers.size) this.mayClick = false;
  }

  drag(dx, dy) {
    if (this.isPanning) this.pan(dx, dy);
    else this.turn(-TURN * dx, TURN * dy);
  }

  /** Two fingers: their middle pans, their distance zooms. */
  pinch(id, before, now) {
    const other = [...this.pointers].find(([key]) => key !== id)[1];
    const span = (p) => Math.max(1, Math.hypot(p[0] - other[0], p[1] - other[1]));
    this.pan((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
    this.zoom(span(before) / span(now), (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
  }

  wheel(event) {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 33 : 1;
    this.zoom(Math.exp(ZOOM * lines * event.deltaY), event.offsetX, event.offsetY);
  }

  turn(azimuth, elevation) {
    const { camera } = this;
    camera.azimuth += azimuth;
    camera.elevation = Math.min(Math.PI / 2, Math.max(-Math.PI / 2, camera.elevation + elevation));
    this.actions.moved();
  }

  /** Moves the target with the mouse [pixels]. */
  pan(dx, dy) {
    const { camera } = this;
    const { right, up } = camera.axes();
    const pixel = camera.pixelSize(this.element.clientHeight);
    camera.target = camera.target.map((value, a) => value + pixel * (-dx * right[a] + dy * up[a]));
    this.actions.moved();
  }

  /** Changes the distance by a factor; the point under a pixel, at the depth of the target, stays. */
  zoom(factor, x = this.element.clientWidth / 2, y = this.element.clientHeight / 2) {
    const { camera, element } = this;
    const before = camera.distance;
    camera.distance = Math.min(100 * camera.radius, Math.max(1e-4 * camera.radius, before * factor));
    const share = 1 - camera.distance / before;
    const pixel = (camera.pixelSize(element.clientHeight) * before) / camera.distance;
    const { right, up } = camera.axes();
    const [ox, oy] = [x - element.clientWidth / 2, element.clientHeight / 2 - y];
    camera.target = camera.target.map((value, a) => value + share * pixel * (ox * right[a] + oy * up[a]));
    this.actions.moved();
  }
}
