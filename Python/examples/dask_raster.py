# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A survey on the workers of Dask: a raster of the highest points, made where the clouds are.

Each of two worker processes loads the scene once, and computes blocks of pulses and their rasters;
only rasters are sent. Run it with

    build/venv/bin/python Python/examples/dask_raster.py
"""

import pathlib
import tempfile

import dask
import numpy as np
from distributed import Client, LocalCluster

import vtkhelios

HALF, CELL = 50, 2.0  # m

SURVEY = """\
<document>
  <scene id="blocks">
    <part>
      <filter type="objloader"><param type="string" key="filepath" value="blocks.obj"/></filter>
    </part>
  </scene>
  <survey name="blocks" scene="#blocks" platform="platforms.xml#copter_linearpath"
    scanner="scanners.xml#copter_uls">
    <leg>
      <platformSettings x="-50" y="0" z="40" movePerSec_m="20"/>
      <scannerSettings pulseFreq_hz="100000" scanFreq_hz="50" scanAngle_deg="45"/>
    </leg>
    <leg>
      <platformSettings x="50" y="0" z="40"/>
      <scannerSettings active="false"/>
    </leg>
  </survey>
</document>
"""


def write_survey(folder):
    """Writes a scene and a survey of it, which the workers read, and returns the survey's path."""
    blocks = vtkhelios.vtkHeliosSyntheticScene(kind="blocks")
    writer = vtkhelios.vtkHeliosObjSceneWriter(file_name=str(folder / "blocks.obj"))
    blocks >> writer
    writer.Write()
    (folder / "survey.xml").write_text(SURVEY)
    return folder / "survey.xml"


def make_raster(cloud):
    """The highest point of every cell; runs on a worker."""
    raster = np.full((int(2 * HALF / CELL),) * 2, -np.inf)
    index = ((cloud.points[:, :2] + HALF) / CELL).astype(int)
    inside = ((index >= 0) & (index < raster.shape[0])).all(axis=1)
    np.maximum.at(raster, tuple(index[inside].T), cloud.points[inside, 2])
    return raster


def join(rasters):
    return np.max(rasters, axis=0)


def main(folder):
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0") as local:
        with Client(local):
            survey = vtkhelios.read_survey(write_survey(folder))
            clouds = survey.to_delayed(pulses=50_000, seed=1)
            rasters = [dask.delayed(make_raster)(cloud) for cloud in clouds]
            raster = dask.delayed(join)(rasters).compute()
    print(f"{len(clouds)} blocks, {np.isfinite(raster).mean():.1%} of the cells have a height")
    return raster, survey


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        main(pathlib.Path(folder))
