// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Streams of the page: base64, zlib, and columns of whole numbers (see _pack.py).

/** The bytes of a base64 text of a zlib stream of a given length. */
export async function inflate(text, length) {
  const raw = atob(text);
  const bytes = new Uint8Array(length);
  for (let i = 0; i < length; i++) bytes[i] = raw.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Reads columns one after the other. */
export class ColumnReader {
  constructor(bytes) {
    this.bytes = bytes;
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.place = 0;
  }

  /** The next column of n whole numbers. */
  read(n) {
    const flags = this.bytes[this.place];
    const base = this.view.getFloat64(this.place + 1, true);
    const values = this.readPlanes(this.place + 9, flags & 127, n);
    this.place += 9 + (flags & 127) * n;
    return flags & 128 ? addDifferences(values, base) : addBase(values, base);
  }

  readPlanes(place, width, n) {
    const values = new Float64Array(n);
    for (let plane = 0, weight = 1; plane < width; plane++, weight *= 256, place += n) {
      for (let i = 0; i < n; i++) values[i] += weight * this.bytes[place + i];
    }
    return values;
  }
}

function addBase(values, base) {
  for (let i = 0; i < values.length; i++) values[i] += base;
  return values;
}

function addDifferences(values, base) {
  let last = base;
  for (let i = 0; i < values.length; i++) {
    const folded = values[i];
    last += folded % 2 ? -(folded + 1) / 2 : folded / 2;
    values[i] = last;
  }
  return values;
}

/** The streams of the page, decompressed when they are used. */
export class Store {
  constructor(text, lengths) {
    this.text = text;
    this.lengths = lengths;
    this.places = new Float64Array(lengths.length + 1);
    lengths.forEach((length, i) => (this.places[i + 1] = this.places[i] + 4 * Math.ceil(length / 3)));
  }

  async open(index) {
    const text = this.text.slice(this.places[index], this.places[index + 1]);
    return new ColumnReader(await inflate(text, this.lengths[index]));
  }
}
