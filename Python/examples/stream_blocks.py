# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A cloud larger than memory, in blocks: a raster of the highest points of a survey.

Each block passes a custom pipeline: a function on data, then a VTK filter. Run it with

    build/venv/bin/python Python/examples/stream_blocks.py
"""

import numpy as np
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkCommonTransforms import vtkTransform

import vtkhelios

HALF, CELL = 50, 2.0  # m


@vtkhelios.filter
def strong(cloud, share=0.5):
    """Keeps the stronger first returns."""
    first = cloud["ReturnNumber"] == 1
    return first & (cloud["Amplitude"] > share * np.median(cloud["Amplitude"]))


def make_survey():
    """A multicopter over blocks, 40 m up."""
    scene = vtkhelios.vtkHeliosSyntheticScene(kind="blocks")
    way = [(x, y, 40) for y, ends in ((-25, (-50, 50)), (25, (50, -50))) for x in ends]
    return vtkhelios.make_survey(
        scene, way, "copter_uls", "copter_linearpath",
        speed=20, pulse_frequency=100_000, scan_frequency=50, scan_angle=45,
    )  # fmt: skip


def add_heights(raster, cloud):
    index = ((cloud.points[:, :2] + HALF) / CELL).astype(int)
    inside = ((index >= 0) & (index < raster.shape[0])).all(axis=1)
    np.maximum.at(raster, tuple(index[inside].T), cloud.points[inside, 2])


def main():
    survey = make_survey()
    local = vtkTransform()
    local.Translate(0, 0, -0.5)  # heights above the lowest ground
    shift = vtkTransformPolyDataFilter()
    shift.SetTransform(local)
    shift.SetOutputPointsPrecision(1)  # vtkAlgorithm::DOUBLE_PRECISION
    pipeline = strong(share=0.25) >> shift

    raster = np.full((int(2 * HALF / CELL),) * 2, -np.inf)
    points = 0
    for block in survey.blocks(pulses=200_000, seed=1):
        kept = vtkhelios.Cloud(pipeline(block))
        points += len(kept)
        add_heights(raster, kept)
    filled = np.isfinite(raster)
    print(
        f"{survey.number_of_pulses:,} pulses, {points:,} points kept, one block in memory at a time"
    )
    print(f"{filled.mean():.1%} of the cells have a height, the highest is {raster.max():.2f} m")
    return raster, survey


if __name__ == "__main__":
    main()
