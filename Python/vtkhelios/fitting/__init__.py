# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Finds what an airborne cloud shows of its instrument: frequencies, mirror, flight, noise.

>>> result = vtkhelios.fit("real.laz")
>>> result["pulse frequency"]
Value(name='pulse frequency', unit='Hz', value=..., uncertainty=..., how=...)
>>> result.write("fitted", scene="scene.xml#city")
"""

from ..core.watching import Progress
from ._fit import fit_watched
from .result import Fit, Strip, Value

__all__ = ["Fit", "Strip", "Value", "fit"]

POINTS = 20_000_000  # default


def fit(*clouds, unit=None, points=POINTS, progress=None) -> Fit:
    """Finds what a cloud shows of its instrument, and returns a Fit.

    clouds
        of one flight, with GpsTime, and ScanAngle or pulses of several returns: each a file or
        the folder of a run, or a folder of files; or a Cloud or a vtkPolyData.
    unit
        of the coordinates [m], from 1e-6 to 1e6: 0.3048 for feet. Default: the coordinate system's, else 1.
    points
        maximum number of points, 1000 or more. Default: 20,000,000.
    progress
        True for a line on standard error, or a function of the fraction done. Default: none.

    Times identify the pulses. Of each strip the trajectory is found, as the points in which the
    beams meet: the lines through the first and the last return of a pulse (Gatziolis and McGaughey
    2019, Remote Sensing 11, 2258); without such pulses by the scan angles. The mirror follows from
    the angles at which the points are seen from there. See Docs/fit.md.

    Raises FormatError (a ValueError) for files that cannot be read and clouds from which nothing
    can be found: without points, times or angles, or with too few pulses; ValueError for settings
    outside their range.
    """
    with Progress(progress) as watched:
        report = watched.callback or (lambda *_: None)
        return fit_watched(clouds, lambda _name, share: report(None, share), unit, points)
