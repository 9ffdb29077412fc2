// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Round numbers for scales, and numbers as text.

const PREFIXES = [["G", 1e9], ["M", 1e6], ["k", 1e3], ["", 1], ["m", 1e-3], ["µ", 1e-6],
  ["n", 1e-9], ["p", 1e-12], ["f", 1e-15], ["a", 1e-18]];
const PREFIXED = new Set(["W", "J", "Hz"]);

/** The unit with the prefix that suits a value, and its factor: ["nW", 1e-9]. */
export function prefixed(unit, value) {
  if (!PREFIXED.has(unit) || !Number.isFinite(value) || value === 0) return [unit, 1];
  const [prefix, factor] = PREFIXES.find(([, size]) => Math.abs(value) >= 0.9995 * size) ?? PREFIXES.at(-1);
  return [prefix + unit, factor];
}

/** 1, 2 or 5 times a power of ten, at most a value. */
export function roundDown(value) {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-12);
  const digit = [5, 2, 1].find((d) => d * power <= value * (1 + 1e-9)) ?? 1;
  return digit * power;
}

/** Round values from low to high, about n of them. */
export function linearTicks(low, high, n = 5) {
  if (!(high > low)) return [low];
  const step = [1, 2, 2.5, 5, 10].map((m) => m * roundPower((high - low) / n))
    .find((s) => (high - low) / s <= n + 1e-9);
  const first = Math.ceil(low / step - 1e-9);
  const last = Math.floor(high / step + 1e-9);
  const inverse = Math.round(1 / step);
  const exact = step < 1 && Math.abs(inverse * step - 1) < 1e-9;
  return Array.from({ length: Math.max(0, last - first + 1) },
    (_, i) => (exact ? (first + i) / inverse : (first + i) * step));
}

function roundPower(value) {
  return 10 ** Math.floor(Math.log10(value) + 1e-12);
}

/** 1, 2, 5 ... of each decade, or the powers of ten of a long range. */
export function logTicks(low, high) {
  const digits = Math.log10(high / low) > 2.5 ? [1] : [1, 2, 5];
  const ticks = [];
  for (let p = Math.floor(Math.log10(low)); p <= Math.ceil(Math.log10(high)); p++) {
    for (const digit of digits) {
      const tick = Number(`${digit}e${p}`);
      if (tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9)) ticks.push(tick);
    }
  }
  return ticks;
}

/** A number with at most this many significant digits, without trailing zeros. */
export function plain(value, digits = 6) {
  if (!Number.isFinite(value)) return "no value";
  const text = String(Number(value.toPrecision(digits)));
  return text.replace("-", "−");
}

/** Decimals that show a step: 0.001 gives 3. */
export function decimals(step) {
  return Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
}
