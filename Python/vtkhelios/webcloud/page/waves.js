// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Waveforms by pulse, decoded in groups. See _waveforms.py.

const bits = new DataView(new ArrayBuffer(4));

function toFloat(code) {
  bits.setUint32(0, code);
  return bits.getFloat32(0);
}

export class Waves {
  constructor(description, store) {
    this.description = description;
    this.store = store;
  }

  /** { start [ns], bin [ns], samples [W] } of a pulse, or null. */
  async find(pulse) {
    const group = this.groupOf(pulse);
    if (group < 0) return null;
    const { firstStream, timeStep, full } = this.description;
    const reader = await this.store.open(firstStream + group);
    const count = this.sizeOf(group);
    const [pulses, starts, bins, peaks, sizes] = [0, 1, 2, 3, 4].map(() => reader.read(count));
    const samples = reader.read(sizes.reduce((a, b) => a + b, 0));
    const row = pulses.indexOf(pulse);
    if (row < 0) return null;
    const first = sizes.slice(0, row).reduce((a, b) => a + b, 0);
    const scale = toFloat(peaks[row]) / full;
    return { start: starts[row] * timeStep, bin: bins[row] * timeStep,
      samples: samples.slice(first, first + sizes[row]).map((code) => code * scale) };
  }

  /** The pulses that have a waveform, as a set. */
  async pulses() {
    const reader = await this.store.open(this.description.pulses);
    return new Set(reader.read(this.description.count));
  }

  groupOf(pulse) {
    const firsts = this.description.firstPulses;
    let low = 0;
    let high = firsts.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (firsts[middle] <= pulse) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  sizeOf(group) {
    const { group: size, count, firstPulses } = this.description;
    return group < firstPulses.length - 1 ? size : count - size * group;
  }
}
