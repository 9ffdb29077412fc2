# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares two clouds by metrics that do not hang on their density, each with a confidence interval.

>>> result = vtkhelios.compare("real.laz", "output/simulated")
>>> result["returns per pulse"].difference
Estimate(value=..., lower=..., upper=...)
>>> pandas.DataFrame(result.table.rows)
"""

from ..core.watching import Progress
from ._compare import compare_watched
from .result import Comparison, Histogram, Row

__all__ = ["Comparison", "Histogram", "Row", "compare"]

POINTS, SAMPLE = 5_000_000, 20_000  # defaults


def compare(
    a,
    b,
    mesh=None,
    cell=None,
    points=POINTS,
    sample=SAMPLE,
    seed=0,
    progress=None,
    height_unit=None,
) -> Comparison:
    """Measures two clouds and returns a Comparison.

    a, b
        a file or the folder of a run, or a folder of files and runs; or a Cloud, a vtkPolyData
        or an array of (n, 3) [m]. Clouds in feet are converted to metres, those in degrees
        refused.
    mesh
        triangles, to which distances are measured: an OBJ or GeoTIFF file, a Scene or a
        vtkPolyData. Default: none.
    cell
        side of the cells in which planes and occlusion are found [m], above 0. Default: the
        smallest power of two with 16 points in the median cell of either cloud.
    points
        maximum points of a cloud in memory, 1000 or more: of larger clouds a random part of
        the tiles is compared, the same of both. Default: 5,000,000.
    sample
        points of a cloud whose distances and spacing are measured, 10 or more. Default: 20,000.
    seed
        of tiles, samples and intervals, 0 or more; equal seeds give equal results. Default: 0.
    progress
        True for a line on standard error, or a function of the fraction done. Default: none.
    height_unit
        unit of the heights of both [m], above 0. Default: as their coordinate systems state, else
        the unit of x and y.

    Raises FormatError (a ValueError) for files that cannot be read, clouds without points and
    different coordinate systems, ValueError for settings outside their range.
    """
    settings = {"mesh": mesh, "cell": cell, "points": points, "sample": sample, "seed": seed}
    settings["height_unit"] = height_unit
    with Progress(progress) as watched:
        report = watched.callback or (lambda *_: None)
        return compare_watched(a, b, lambda _name, share: report(None, share), **settings)
