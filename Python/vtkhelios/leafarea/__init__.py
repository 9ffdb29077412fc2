# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plant area density found again from scans: of runs, of clouds in memory, of real scans.

>>> found = vtkhelios.plant_area("output/stand", voxel=0.5)
>>> found.lai
>>> found.write("stand.vox")

See Docs/forests.md.
"""

from ._estimate import ESTIMATORS, LEAF_ANGLES, SHARES, estimate
from ._inputs import read_inputs, scan_of_cloud
from ._scans import Scan
from .result import PlantArea

__all__ = [
    "ESTIMATORS", "LEAF_ANGLES", "SHARES", "PlantArea", "Scan", "estimate", "plant_area", "scan_of_cloud",
]  # fmt: skip


def plant_area(*clouds, trajectory=None, origin=None, spacing=None, on_step=None, **options):
    """Estimates the plant area density in the voxels of a grid, and returns a PlantArea.

    clouds
        of one place: each the folder of a run (best with ``--pulses``, which tells the pulses that
        hit nothing), a Cloud, or a file of points, of one scan position or with scans that have
        positions (PTX, E57).
    trajectory
        of points with GpsTime: a file of text or SBET, as ``vtkhelios fit`` writes it; or several,
        each of the points of its times.
    origin
        x y z where all beams of a file begin [m].
    spacing
        of the pulses of the scan pattern in azimuth and elevation [deg]: directions without a point
        are pulses that hit nothing. PTX and E57 with such pulses need it not.
    on_step
        a function of a text and the fraction done, called during the work; it may raise.

    The other options are those of ``Cloud.plant_area()``. Raises FormatError (a ValueError) for what
    cannot be read or inverted, with the reason; ValueError for options outside their range.
    """
    inputs = read_inputs(clouds, trajectory, origin, spacing, on_step or (lambda *_: None))
    return estimate(inputs, on_step=on_step, **options)
