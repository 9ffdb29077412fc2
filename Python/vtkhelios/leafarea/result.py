# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Result of plant_area(): the grid, its sums and its profile."""

import json
import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from ..array_names import (
    CELL_STATE, DENSITY_ERROR, FREE_PATH, GROUND_DISTANCE, INTERCEPTED_ENERGY, PAD,
)  # fmt: skip
from ..core.arrays import numpy_to_vtk
from ..core.words import counted
from ._write import write

NO_BEAM, SEEN, SHADOWED, SATURATED = range(4)  # states of voxels


class PlantArea:
    """The plant area density in the voxels of a grid.

    grid
        the vtkImageData, with the cell arrays of vtkHeliosPlantAreaDensity.
    settings, scans, pulses, notes
        options of the estimate, numbers of scans and pulses, and what to know of the inputs.
    knows_misses
        whether the pulses that hit nothing are known of all scans.

    ``found["DensityError"]`` is a cell array with the shape of the grid, x y z.
    """

    def __init__(self, name, grid, settings, ground, facts, notes):
        self.name, self.grid, self.settings = name, grid, settings
        self.scans, self.pulses = facts["scans"], facts["pulses"]
        self.knows_misses, self.notes = facts["knows_misses"], notes
        self.voxel = grid.GetSpacing()[2]
        self.shape = tuple(n - 1 for n in grid.GetDimensions())
        self.corner = tuple(grid.GetOrigin())
        self._add_ground(ground)

    def __getitem__(self, name):
        array = self.grid.GetCellData().GetArray(name)
        if array is None:
            data = self.grid.GetCellData()
            names = ", ".join(data.GetArrayName(i) for i in range(data.GetNumberOfArrays()))
            raise KeyError(f"the grid has no cell array {name}; it has: {names}")
        return vtk_to_numpy(array).reshape(self.shape[::-1]).transpose(2, 1, 0)

    @property
    def pad(self):
        """The plant area density [m2/m3]; NaN where it is not known."""
        return self[PAD]

    @property
    def cell_area(self):
        """The ground area of a voxel [m2]."""
        return self.grid.GetSpacing()[0] * self.grid.GetSpacing()[1]

    @property
    def cell_volume(self):
        """The volume of a voxel [m3]."""
        return self.cell_area * self.voxel

    @property
    def ground_area(self):
        """The ground area of the columns that beams are aimed at [m2]."""
        return self.cell_area * int((self[CELL_STATE] != NO_BEAM).any(axis=2).sum())

    @property
    def area(self):
        """The plant area in the voxels that are seen, above the ground where it is known [m2]."""
        return float(np.nansum(self.pad[self._find_used()]) * self.cell_volume)

    @property
    def area_error(self):
        """Its standard error [m2]: voxels add up in quadrature."""
        return float(np.sqrt(self._variances()[self._find_used()].sum()) * self.cell_volume)

    def _find_used(self):
        """Returns a mask of the voxels of columns with beams, whose centres are not below ground."""
        used = np.broadcast_to(
            (self[CELL_STATE] != NO_BEAM).any(axis=2)[:, :, None], self.shape
        ).copy()
        return used & (self[GROUND_DISTANCE] > 0) if self.has_ground else used

    def _variances(self):
        """Returns the variances of densities that are added; 0: not known. Voxels without a hit have
        that of the mean density at their z: their own error is the one of a hit."""
        pad = self.pad
        known = np.isfinite(pad)
        sums = np.where(known, pad, 0).sum(axis=(0, 1))
        layers = sums / np.maximum(known.sum(axis=(0, 1)), 1)
        with np.errstate(divide="ignore", invalid="ignore"):
            expected = layers / self[FREE_PATH]
        variances = np.where(self[INTERCEPTED_ENERGY] > 0, self[DENSITY_ERROR] ** 2, expected)
        return np.where(known & np.isfinite(variances), variances, 0.0)

    @property
    def lai(self):
        """Plant area over ground area [m2/m2]; voxels that are not seen have the mean of those at
        their height."""
        return float(sum(row["pai"] for row in self.profile()))

    @property
    def lai_error(self):
        """Its standard error [m2/m2], by the beams."""
        return math.sqrt(sum(row["pai_error"] ** 2 for row in self.profile()))

    @property
    def lai_seen(self):
        """Plant area in the voxels that are seen over ground area [m2/m2]."""
        return self.area / self.ground_area if self.ground_area else math.nan

    @property
    def has_ground(self):
        """Whether heights are above the ground, the echoes of class 2; else they are z."""
        return self.grid.GetCellData().GetArray(GROUND_DISTANCE) is not None

    def heights(self):
        """Returns the heights of the centres of the voxels [m]: above the ground, or z."""
        if self.has_ground:
            return self[GROUND_DISTANCE]
        z = self.corner[2] + self.voxel * (np.arange(self.shape[2]) + 0.5)
        return np.broadcast_to(z, self.shape)

    def profile(self):
        """Returns a row for each layer, from below: a dict of

        height
            of its centre [m], above the ground where it is known, else z;
        pad, pad_error
            mean of the voxels that are seen, and its standard error [m2/m3];
        pai, pai_error
            plant area over ground area in the layer [m2/m2];
        seen, shadowed
            shares of its voxels that beams are aimed at.

        Voxels whose centres are below the ground are left out.
        """
        heights, state, pad = self.heights(), self[CELL_STATE], self.pad
        used = self._find_used()
        if not used.any():
            return []
        base = 0.0 if self.has_ground else self.corner[2]
        layer = np.floor((heights[used] - base) / self.voxel + 1e-9).astype(int)
        count = layer.max() + 1
        known = np.isfinite(pad[used])
        cells = np.bincount(layer, minlength=count)
        seen = np.bincount(layer, known, count)
        total = np.bincount(layer, np.where(known, pad[used], 0), count)
        squares = np.bincount(layer, self._variances()[used], count)
        shadowed = np.bincount(layer, state[used] == SHADOWED, count)
        rows = []
        for k in range(count):
            mean = total[k] / seen[k] if seen[k] else math.nan
            error = math.sqrt(squares[k]) / seen[k] if seen[k] else math.nan
            part = cells[k] * self.cell_volume / self.ground_area
            rows.append({
                "height": base + (k + 0.5) * self.voxel,
                "pad": float(mean), "pad_error": float(error),
                "pai": float(np.nan_to_num(mean) * part),
                "pai_error": float(np.nan_to_num(error) * part),
                "seen": float(seen[k] / cells[k]) if cells[k] else 0.0,
                "shadowed": float(shadowed[k] / cells[k]) if cells[k] else 0.0,
            })  # fmt: skip
        while rows and not rows[-1]["pai"] and rows[-1]["seen"]:
            rows.pop()  # the sky above the plants
        return rows

    def as_dict(self):
        """Plain values: what ``vtkhelios leafarea --json`` prints; what is not known is None."""
        state = self[CELL_STATE]
        facts = {
            "input": self.name,
            "settings": self.settings,
            "scans": self.scans,
            "pulses": int(self.pulses),
            "knowsMisses": self.knows_misses,
            "grid": {"corner_m": self.corner, "voxel_m": self.voxel, "cells": self.shape},
            "voxels": {
                "seen": int((state == SEEN).sum()),
                "shadowed": int((state == SHADOWED).sum()),
                "saturated": int((state == SATURATED).sum()),
                "noBeam": int((state == NO_BEAM).sum()),
            },
            "plantArea_m2": self.area,
            "plantAreaError_m2": self.area_error,
            "groundArea_m2": self.ground_area,
            "lai": self.lai,
            "laiError": self.lai_error,
            "laiSeen": self.lai_seen,
            "heights": "above ground" if self.has_ground else "z",
            "profile": self.profile(),
            "notes": self.notes,
        }
        return _plain(facts)

    def to_json(self):
        """Returns as_dict() as text."""
        return json.dumps(self.as_dict(), indent=2)

    def write(self, path):
        """Writes a file by its ending: .vti (all arrays), .vox (AMAPVox; turbid voxels of scenes),
        .csv (profile) or .json.

        Raises ValueError for other endings, OSError and PipelineError if it cannot be written.
        """
        write(self, path)

    def _add_ground(self, points):
        """Adds the height of the centres of voxels above the mean ground of their column."""
        inside = self._columns_of(points)
        if not len(inside):
            return
        count = self.shape[0] * self.shape[1]
        found = np.bincount(inside[:, 0].astype(int), minlength=count)
        with np.errstate(invalid="ignore"):
            level = np.bincount(inside[:, 0].astype(int), inside[:, 1], count) / found
        level = _fill(level.reshape(self.shape[:2]))
        z = self.corner[2] + self.voxel * (np.arange(self.shape[2]) + 0.5)
        distance = z - level[:, :, None]
        array = numpy_to_vtk(np.ascontiguousarray(distance.transpose(2, 1, 0)).ravel(), deep=True)
        array.SetName(GROUND_DISTANCE)
        self.grid.GetCellData().AddArray(array)

    def _columns_of(self, points):
        """Returns rows of the column and the height of points in the columns of the grid."""
        if not len(points):
            return np.empty((0, 2))
        place = (points[:, :2] - self.corner[:2]) / self.grid.GetSpacing()[:2]
        inside = ((place >= 0) & (place < self.shape[:2])).all(axis=1)
        place = place[inside].astype(int)
        return np.column_stack([place[:, 0] * self.shape[1] + place[:, 1], points[inside, 2]])

    def __repr__(self):
        return (
            f"PlantArea({self.area:.4g} ± {self.area_error:.2g} m², LAI {self.lai:.3g} ± "
            f"{self.lai_error:.2g}; {' x '.join(map(str, self.shape))} voxels of {self.voxel:g} m, "
            f"{counted(self.scans, 'scan')}, {counted(int(self.pulses), 'pulse')})"
        )


def _fill(level):
    """Returns a raster whose empty cells have the mean of their nearest neighbours, step by step."""
    level = level.copy()
    while np.isnan(level).any():
        padded = np.pad(level, 1, constant_values=np.nan)
        around = np.stack([
            padded[1 + i : padded.shape[0] - 1 + i, 1 + j : padded.shape[1] - 1 + j]
            for i, j in ((-1, 0), (1, 0), (0, -1), (0, 1))
        ])  # fmt: skip
        known = np.isfinite(around)
        sums = np.where(known, around, 0).sum(axis=0)
        new = np.isnan(level) & known.any(axis=0)
        if not new.any():
            break
        level[new] = sums[new] / known.sum(axis=0)[new]
    return level


def _plain(value):
    if isinstance(value, dict):
        return {key: _plain(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(each) for each in value]
    if isinstance(value, np.generic):
        value = value.item()
    return None if isinstance(value, float) and not math.isfinite(value) else value
