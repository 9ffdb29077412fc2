# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""compare(): reads, lays the tiles, measures."""

import pathlib

import numpy as np

from ..core.systems import find_difference
from ..core.views import data_of
from ..formats import FormatError
from ..scenes.scene import Scene, flatten
from ._blocks import DRAWS
from ._ground import Ground, choose_cell, choose_tile, draw_tiles
from ._inputs import Source, is_path
from ._measure import Measurement
from .result import Comparison


def compare_watched(a, b, on_step, mesh, cell, points, sample, seed, height_unit=None):
    """Compares like compare(); on_step(name, fraction done) is called during all work, and may
    raise."""
    _check_settings(cell, points, sample, seed)
    mesh = None if mesh is None else read_mesh(mesh)
    sources = [Source(each, points, on_step, height_unit) for each in (a, b)]
    sides = [source.read() for source in sources]
    if problem := find_difference(*(source.crs or "" for source in sources)):
        raise FormatError(
            f"{sources[1].name}: the coordinate systems of the clouds differ: {problem}"
        )
    share = min(1.0, *(points / source.total for source in sources))
    tile = None
    if None in sides:
        tile = _tile_of_sources(sources, cell)
        accepts = draw_tiles(tile, share, seed)
        sides = [source.read(accepts) for source in sources]
        for side in sides:
            if not len(side):
                raise FormatError(
                    f"{side.name}: no point is in the tiles of {tile:g} m drawn; give more points "
                    "in memory, or another seed"
                )
    cell = cell or choose_cell([side.points for side in sides])
    if tile is None:
        tile = choose_tile(*_box(sides), cell)
    ground = Ground(*sides, cell, max(tile, cell))
    ground.restrict(sides)
    work = Measurement(sides, ground, seed, sample, on_step)
    work.run(mesh)
    settings = {
        "cell_m": cell, "tile_m": ground.tile, "tiles": ground.tiles,
        "commonTiles": int(ground.common.sum()), "sampledShare": share, "seed": seed,
        "draws": DRAWS, "sample": sample,
    }  # fmt: skip
    return Comparison(
        *(_describe(side) for side in sides), settings, _registration(work, sides, ground),
        work.shift, work.rows, work.histograms, work.absent, _notes(sides),
    )  # fmt: skip


def _check_settings(cell, points, sample, seed):
    for name, value, lowest in (
        ("points", points, 1000),
        ("sample", sample, 10),
        ("seed", seed, 0),
    ):
        if not (isinstance(value, (int, np.integer)) and lowest <= value < 2**63):
            raise ValueError(f"{name} is {value!r}; give a whole number, {lowest} or more")
    if cell is not None and not 0 < cell < 1e6:
        raise ValueError(f"cell is {cell!r}; give a length above 0 [m]")


def _box(sides):
    """Low and high corner of the common part of the boxes, of both if they have none."""
    lows = np.array([side.points.min(axis=0) for side in sides])
    highs = np.array([side.points.max(axis=0) for side in sides])
    low, high = lows.max(axis=0), highs.min(axis=0)
    if (low < high)[:2].all():
        return low, high
    return lows.min(axis=0), highs.max(axis=0)


def _tile_of_sources(sources, cell):
    """The tile of clouds whose points are not known yet [m]."""
    low = np.min([source.low for source in sources], axis=0)
    high = np.max([source.high for source in sources], axis=0)
    return choose_tile(low, high, cell or float(np.ptp([low, high], axis=0)[:2].max()) / 1e5)


def _describe(side):
    return {
        "name": side.name, "points": side.total, "compared": len(side),
        "coordinateSystem": side.crs,
    }  # fmt: skip


def _registration(work, sides, ground):
    text = work.registration
    if ground.is_shared:
        centres = [side.points.mean(axis=0) for side in sides]
        apart = ", ".join(f"{value:+.3f}" for value in centres[1] - centres[0])
        text += f"; centres of the points are apart by ({apart}) m"
    return text


def _notes(sides):
    notes = [note for side in sides for note in side.notes]
    if not all(side.crs for side in sides):
        unknown = next(side.name for side in sides if not side.crs)
        notes.append(f"{unknown}: has no coordinate system; it is taken to be that of the other")
    return list(dict.fromkeys(notes))


def read_mesh(given):
    """Returns the triangles of a file, a Scene or a vtkPolyData, as vtkPolyData."""
    if is_path(given):
        return _read_file(pathlib.Path(given))
    data = data_of(given)
    if not (hasattr(data, "IsA") and data.IsA("vtkPolyData")):
        raise TypeError(f"a mesh is a path, a Scene or a vtkPolyData, not {type(given).__name__}")
    return _check_mesh(flatten(data), "the mesh")


def _read_file(path):
    if not path.is_file():
        raise FormatError(f"{path}: no such file; check the name of the mesh")
    try:
        return _check_mesh(Scene.read(path).polydata, path)
    except ValueError as error:
        raise FormatError(str(error)) from error


def _check_mesh(data, name):
    if data.GetNumberOfPolys() + data.GetNumberOfStrips() == 0:
        raise FormatError(f"{name}: has no triangles; give a mesh")
    return data
