# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the table in Testing/Cxx/TestRisleyPrisms.cxx: beams through wedge prisms to 40 digits.

    python3 make_risley_reference.py

Needs mpmath. Settings are exact doubles, phases are fractions of integers, and Snell's law is
applied to the component of a beam in the face, which scales with the ratio of the indices: not the
formula of the class.
"""

from fractions import Fraction

from mpmath import cos, mp, mpf, nstr, pi, sin, sqrt

mp.dps = 40

# Per case: pulse frequency, air, incident beam, prisms (wedge in degrees, index, revolutions/s).
CASES = [
    (100000.0, 1.0, (0, 1, 0), [(18.0, 1.51, -121.5666), (18.0, 1.51, 77.7333)]),
    (1e6, 1.0, (0, 1, 0), [(-29.7, 1.5095, -77.7333), (29.7, 1.5095, 121.5666)]),
    (
        1e6,
        1.00027,
        (-0.0625, 1, 0.03125),
        [(20.5, 1.51, -131.5), (-19.5, 1.62, 40.8), (3.25, 1.45, 213.1)],
    ),
]
PULSES = [0, 1, 777, 12345678, 86399999999, 86400000000]


def exact(number):
    """The exact value of a double or a fraction."""
    number = Fraction(number)
    return mpf(number.numerator) / mpf(number.denominator)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def bend(beam, onwards, ratio):
    """The beam behind a face whose unit normal points forward."""
    square = dot(beam, onwards)
    within = [ratio * (b - square * n) for b, n in zip(beam, onwards)]
    rest = 1 - dot(within, within)
    if square <= 0 or rest <= 0:
        raise SystemExit("a beam is reflected: choose other settings")
    return [w + sqrt(rest) * n for w, n in zip(within, onwards)]


def trace(case, pulse):
    rate, air, incident, prisms = case
    beam = [exact(x) for x in incident]
    beam = [x / sqrt(dot(beam, beam)) for x in beam]
    for wedge, index, turns in prisms:
        psi = 2 * pi * exact(pulse * Fraction(turns) / Fraction(rate) % 1)
        tilt = exact(wedge) * pi / 180
        inclined = [-sin(psi) * sin(tilt), cos(tilt), -cos(psi) * sin(tilt)]
        faces = [inclined, [0, 1, 0]] if wedge > 0 else [[0, 1, 0], inclined]
        for face, ratio in zip(faces, (exact(air) / exact(index), exact(index) / exact(air))):
            beam = bend(beam, face, ratio)
    return beam


for number, case in enumerate(CASES):
    for pulse in PULSES:
        beam = ", ".join(nstr(x, 20, strip_zeros=False) for x in trace(case, pulse))
        print(f"  {{ {number}, {pulse}LL, {{ {beam} }} }},")
