# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Spots of a conical scanner, fitted by a smooth flight and a pattern.

Spots come from a qfit file (12 words) of NASA's Airborne Topographic Mapper, as documented by
PDAL's readers.qfit: time, latitude, longitude, height, scan azimuth, pitch and roll of a shot, but
neither its range nor the position of the aircraft. These are unknowns of the fit: a parabola in the
plane, a line in height, a heading that turns evenly, the phase and angle of the mirror, and the tilt
and yaw of the scanner on the aircraft.
"""

import pathlib

import numpy as np

from _georeference import to_ecef, to_local, turn

STEPS = np.array([1.0] * 8 + [1e-4] * 7)  # steps of the derivatives; m, then rad
X, V, A, Z, HEADING, ANGLE, PHASE, TILT, YAW = 0, 2, 4, 6, 8, 10, 11, 12, 14  # unknowns
PATTERN = [0, 1, 2, 3, Z, PHASE, YAW]  # fitted first
ALL = [0, 1, 2, 3, 4, 5, Z, Z + 1, HEADING + 1, ANGLE, PHASE, TILT, TILT + 1, YAW]


def read_qfit(path):
    """The shots: time [s], points east, north, up of the first [m], azimuth, pitch, roll [rad]."""
    words = np.frombuffer(pathlib.Path(path).read_bytes(), ">i4")
    if words[0] != 48:
        raise ValueError(f"{path} is not a qfit file of 12 words")
    records = words.reshape(-1, 12)
    shots = records[(records[:, 0] >= 0) & (records[:, 1] != 0)].astype(float)
    latitude, longitude = np.radians(shots[:, 1:3].T / 1e6)
    height = shots[:, 3] / 1e3
    points = to_local(to_ecef(latitude, longitude, height), (latitude[0], longitude[0], 0.0))
    azimuth, pitch, roll = np.radians(shots[:, 6:9].T / 1e3)
    return dict(time=shots[:, 0] / 1e3, points=points, azimuth=azimuth, pitch=pitch, roll=roll)


def palmer(wobble, phase):
    """Directions of a Palmer mirror, as vtkHeliosPalmerMirror: (n, 3), y along the axis."""
    sb, cb, sp, cp = np.sin(wobble), np.cos(wobble), np.sin(phase), np.cos(phase)
    return np.stack(
        [
            np.sin(2 * wobble) * sp - sb**2 * cp**2,
            cb**2 - sb**2 * sp**2,
            np.sqrt(2) * sb * cp * (cb + sb * sp),
        ],
        -1,
    )


def cone(angle, phase):
    """Directions of a cone of half the angle, as vtkHeliosConicMirror with twice it: (n, 3)."""
    s, c = np.sin(2 * angle), np.cos(2 * angle)
    return np.stack([s * np.sin(phase), c + 0 * phase, s * np.cos(phase)], -1)


def _place(unknowns, shots, times, pattern):
    """The spots in the plane: (n, 2). Time runs from -1 to 1 over the window."""
    u = unknowns
    position = np.stack(
        [u[X + k] + u[V + k] * times + u[A + k] * times**2 for k in range(2)]
        + [u[Z] + u[Z + 1] * times],
        -1,
    )
    d = pattern(u[ANGLE], shots["azimuth"] + u[PHASE])
    c, s = np.cos(u[YAW]), np.sin(u[YAW])
    body = np.stack([c * d[:, 0] - s * d[:, 2], s * d[:, 0] + c * d[:, 2], -d[:, 1]], -1)
    attitude = turn(
        shots["roll"] + u[TILT + 1],
        shots["pitch"] + u[TILT],
        u[HEADING] + u[HEADING + 1] * times,
    )
    beam = np.einsum("nij,nj->ni", attitude, body)
    fall = (shots["points"][:, 2] - position[:, 2]) / beam[:, 2]
    return position[:, :2] + fall[:, None] * beam[:, :2]


def _fit(unknowns, free, residual):
    """Levenberg-Marquardt of some of the unknowns."""
    found, damping = unknowns.copy(), 1e-3
    r = residual(found)
    for _ in range(200):
        ends = [STEPS * (np.arange(len(found)) == k) for k in free]
        jacobian = np.stack(
            [(residual(found + e) - residual(found - e)) / (2 * e.sum()) for e in ends], -1
        )
        normal = jacobian.T @ jacobian
        step = np.linalg.solve(normal + damping * np.diag(np.diag(normal)), -jacobian.T @ r)
        trial = found.copy()
        trial[free] += step
        new = residual(trial)
        if new @ new < r @ r:
            is_done = r @ r - new @ new < 1e-9 * (r @ r)
            found, r, damping = trial, new, damping / 5
            if is_done:
                break
        else:
            damping *= 5
            if damping > 1e12:
                break
    return found, r


def fit_pattern(shots, begin, end, kind):
    """Fits the shots of a time window [s] by "cone" or "palmer": residuals [m], speed [m/s] ..."""
    pattern = dict(cone=cone, palmer=palmer)[kind]
    inside = (shots["time"] >= begin) & (shots["time"] < end)
    window = {name: values[inside] for name, values in shots.items()}
    half = (end - begin) / 2
    times = (window["time"] - begin - half) / half
    points = window["points"]
    velocity, middle = np.polyfit(times, points[:, :2], 1)
    start = np.zeros(15)
    start[X : X + 2], start[V : V + 2] = middle, velocity
    start[HEADING] = np.arctan2(*velocity)
    start[ANGLE] = np.radians(7.5)
    radius = np.linalg.norm(points[:, :2] - middle - times[:, None] * velocity, axis=1).mean()
    start[Z] = points[:, 2].mean() + radius / np.tan(2 * start[ANGLE])

    def residual(unknowns):
        return (_place(unknowns, window, times, pattern) - points[:, :2]).ravel()

    # a cone has no yaw of its own: its phase has it
    first = [k for k in PATTERN if kind == "palmer" or k != YAW]
    whole = [k for k in ALL if kind == "palmer" or k != YAW]
    tries = []
    for phase in np.radians(np.arange(0, 360, 90)):
        start[PHASE] = phase
        tries.append(_fit(start, first, residual))
    best = min(tries, key=lambda found: found[1] @ found[1])
    found, r = _fit(best[0], whole, residual)
    return dict(
        shots=int(inside.sum()),
        rms=float(np.sqrt(np.mean(r**2))),
        median=float(np.median(np.abs(r))),
        speed=float(np.hypot(*found[V : V + 2]) / half),
        height=float(found[Z] - points[:, 2].mean()),
        angle=float(np.degrees(found[ANGLE])),
        phase=float(np.degrees(found[PHASE]) % 360),
        tilt=float(np.degrees(found[TILT])),
    )
