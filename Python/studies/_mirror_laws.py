# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Laws of the scan angle of an oscillating mirror, fitted to recorded angles.

A triangle of a period has the odd harmonics 8 / (pi k)^2 cos(k x). A mirror follows its command like a
linear system, with the transfer function H: harmonic k is multiplied by H(i k).
"""

import numpy as np

HARMONICS = np.arange(1, 100, 2)


def triangle(phase, response):
    """A triangle between -1 and 1 through a linear system: response at HARMONICS, phase [rad]."""
    waves = np.exp(1j * np.outer(phase, HARMONICS)) * response
    return (8 / (np.pi * HARMONICS) ** 2 * waves.real).sum(axis=1)


def second_order(frequency, damping):
    """A driven mirror: 1 / (1 + 2 damping s + s^2), s = i k / frequency (of harmonics)."""
    s = 1j * HARMONICS / frequency
    return 1 / (1 + 2 * damping * s + s**2)


def smoothed(width):
    """A moving average over a width [rad of the period]; of a triangle: a rounded one."""
    return np.sinc(HARMONICS * width / (2 * np.pi))


LAWS = {  # words: response of further unknowns, their start
    "rounded triangle": (smoothed, [0.7]),
    "triangle through a second-order system": (second_order, [5.0, 0.8]),
    "rounded triangle through a second-order system": (
        lambda frequency, damping, width: second_order(frequency, damping) * smoothed(width),
        [7.5, 0.9, 0.5],
    ),
}


def minimize(residual, unknowns, steps=80):
    """Least squares by Levenberg and Marquardt: unknowns and their residual."""
    unknowns, lam = np.array(unknowns, float), 1e-3
    found = residual(unknowns)
    for _ in range(steps):
        sizes = 1e-5 * np.maximum(1, np.abs(unknowns))
        jacobian = np.stack(
            [
                (residual(unknowns + e) - residual(unknowns - e)) / (2 * e.sum())
                for e in np.diag(sizes)
            ],
            -1,
        )
        normal = jacobian.T @ jacobian
        damped = normal + lam * np.diag(np.diag(normal))
        step = unknowns - np.linalg.solve(damped, jacobian.T @ found)
        following = residual(step)
        if following @ following < found @ found:
            unknowns, found, lam = step, following, lam / 5
        else:
            lam *= 5
    return unknowns, found


def fit_law(name, time, angle, frequency):
    """Residual [deg] of a law with amplitude, frequency near one [Hz], phase, offset and its own
    unknowns, and the number of all."""
    response, own = LAWS[name]

    def residual(q):
        phase = 2 * np.pi * frequency * q[1] * time + q[2]
        return q[0] * triangle(phase, response(*q[4:])) + q[3] - angle

    start = np.pi - 2 * np.pi * frequency * time[np.argmin(angle)]  # a triangle is lowest at pi
    return minimize(residual, [17.0, 1.0, start, 0.0, *own])[1], 4 + len(own)


def fit_harmonics(highest, time, angle, frequency):
    """Residual [deg] of an offset and odd harmonics with free amplitudes and phases, of the best
    frequency within 4 %, and the number of unknowns."""
    orders = np.arange(1, highest + 1, 2)

    def residual(factor):
        phase = 2 * np.pi * frequency * factor * time
        waves = [wave(k * phase) for k in orders for wave in (np.cos, np.sin)]
        basis = np.stack([np.ones_like(time), *waves], -1)
        return basis @ np.linalg.lstsq(basis, angle, rcond=None)[0] - angle

    fits = [residual(factor) for factor in np.linspace(0.96, 1.04, 81)]
    return min(fits, key=lambda found: found @ found), 2 + 2 * len(orders)
