# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs vtkHeliosPlantAreaDensity over scans, each added to the grid of those before."""

import difflib

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData

from ..array_names import CLASSIFICATION_IDS, LEAF_PROJECTION, MATERIAL_IDS, MATERIAL_NAME
from ..core.arrays import arrays, numpy_to_vtk
from ..core.classes import vtk_class
from ..core.pipeline import PipelineError, update
from ..formats import FormatError
from ..formats._base import Header
from .result import PlantArea

ESTIMATORS = (
    "contact-frequency", "beer-lambert", "beer-lambert-corrected", "maximum-likelihood",
    "maximum-likelihood-corrected",
)  # fmt: skip
LEAF_ANGLES = (
    "spherical", "uniform", "planophile", "erectophile", "plagiophile", "extremophile",
    "ellipsoidal", "horizontal", "vertical", "table", "incidence",
)  # fmt: skip
SHARES = ("equal", "first", "energy", "reflectance")
GROUND = 2  # class of LAS


class Settings:
    """The options of an estimate, checked."""

    def __init__(
        self,
        voxel=0.5,
        estimator="maximum-likelihood-corrected",
        leaf_angles="spherical",
        leaf_ratio=1.0,
        leaf_size=0.0,
        shares="energy",
        leaf_reflectance=0.5,
        classes=(),
        materials=(),
        bounds=None,
        minimum_beams=1.0,
        maximum_range=None,
    ):
        self.voxel = _check_number("voxel", voxel, 0.001, 10000.0)
        self.estimator = _check_name("estimator", estimator, ESTIMATORS)
        self.table = None
        if not isinstance(leaf_angles, str):
            self.table = np.asarray(leaf_angles, float)
            if self.table.ndim != 2 or self.table.shape[1] != 4:
                raise ValueError(
                    f"leaf_angles has the shape {self.table.shape}; give a name, or rows x y z G"
                )
            leaf_angles = "table"
        self.leaf_angles = _check_name("leaf_angles", leaf_angles, LEAF_ANGLES)
        if leaf_angles == "table" and self.table is None:
            raise ValueError("leaf_angles is table; give its rows x y z G instead of the name")
        self.leaf_ratio = _check_number("leaf_ratio", leaf_ratio, 0.01, 100.0)
        self.leaf_size = _check_number("leaf_size", leaf_size, 0.0, 100.0)
        self.shares = _check_name("shares", shares, SHARES)
        self.leaf_reflectance = _check_number("leaf_reflectance", leaf_reflectance, 0.001, 1.0)
        self.classes, self.materials = list(classes), list(materials)
        self.bounds = None if bounds is None else [float(x) for x in bounds]
        if self.bounds is not None and (
            len(self.bounds) != 6
            or not all(low < high for low, high in zip(self.bounds[::2], self.bounds[1::2]))
        ):
            raise ValueError(
                f"bounds is {bounds!r}; give six numbers: x, y and z from and to, each rising"
            )
        self.minimum_beams = _check_number("minimum_beams", minimum_beams, 1e-6, 1e6)
        self.maximum_range = maximum_range
        if maximum_range is not None:
            _check_number("maximum_range", maximum_range, 0.0, 1e300)

    def make_filter(self, material_ids):
        """Returns the filter with these settings."""
        found = vtk_class("vtkHeliosPlantAreaDensity")()
        found.SetVoxelSize(self.voxel)
        found.SetEstimator(ESTIMATORS.index(self.estimator))
        found.SetLeafAngleDistribution(LEAF_ANGLES.index(self.leaf_angles))
        found.SetEllipsoidRatio(self.leaf_ratio)
        found.SetElementArea(self.leaf_size)
        found.SetEchoShares(SHARES.index(self.shares))
        found.SetElementReflectance(self.leaf_reflectance)
        found.SetMinimumNumberOfBeams(self.minimum_beams)
        if self.maximum_range is not None:
            found.SetMaximumRange(self.maximum_range)
        for each in self.classes:
            found.AddCountedClass(int(each))
        for each in material_ids:
            found.AddCountedMaterial(int(each))
        return found

    def as_dict(self):
        return {
            "voxel_m": self.voxel,
            "estimator": self.estimator,
            "leafAngles": self.leaf_angles,
            "leafRatio": self.leaf_ratio,
            "leafSize_m2": self.leaf_size,
            "shares": self.shares,
            "classes": self.classes,
            "materials": self.materials,
            "leafReflectance": self.leaf_reflectance,
            "minimumBeams": self.minimum_beams,
            "maximumRange_m": self.maximum_range,
        }


def _check_number(name, value, low, high):
    if not (np.isscalar(value) and low <= value <= high):
        raise ValueError(f"{name} is {value!r}; give a number from {low:g} to {high:g}")
    return value


def _check_name(name, value, known):
    if value not in known:
        near = difflib.get_close_matches(str(value), known, 1, 0.4)
        hint = f"; did you mean {near[0]}?" if near else f"; give one of: {', '.join(known)}"
        raise ValueError(f"{name} is {value!r}{hint}")
    return value


def estimate(inputs, on_step=None, **options):
    """Estimates the plant area density of scans: an iterable that can be repeated."""
    try:
        settings = Settings(**options)
    except TypeError as error:
        raise ValueError(f"{str(error).rpartition('() ')[2]}; see Cloud.plant_area()") from None
    on_step = on_step or (lambda *_: None)
    bounds = settings.bounds or _find_bounds(inputs, settings)
    grid = make_grid(bounds, settings)
    ground, scans, pulses, knows = [], 0, 0, True
    for scan in inputs:
        on_step(f"beams of {scan.name}", 0.5)
        found = settings.make_filter(_find_materials(scan, settings))
        _connect(found, scan, grid)
        try:
            grid = _detached(update(found))
        except PipelineError as error:
            raise FormatError(f"{scan.name}: {_reason(error)}") from error
        ground.append(_ground_points(scan))
        scans, pulses = scans + 1, pulses + found.GetNumberOfBeams()
        knows = knows and scan.knows_misses
    notes = list(getattr(inputs, "notes", ()))
    name = getattr(inputs, "name", "cloud")
    facts = dict(scans=scans, pulses=pulses, knows_misses=knows)
    return PlantArea(name, grid, settings.as_dict(), np.concatenate(ground), facts, notes)


def _reason(error):
    return " ".join(str(error).split("): ")[-1].split())


def _connect(found, scan, grid):
    for port, data in enumerate((scan.echoes, scan.pulses, scan.hits, scan.trajectory, grid)):
        if data is not None:
            found.SetInputDataObject(port, data)
    if scan.origin is not None:
        found.SetBeamOrigin(*scan.origin)


def _detached(grid):
    copy = vtkImageData()
    copy.ShallowCopy(grid)
    return copy


def make_grid(bounds, settings):
    """Returns the empty grid: whole cells from the low corner."""
    low, high = np.array(bounds[::2]), np.array(bounds[1::2])
    count = np.maximum(np.ceil((high - low) / settings.voxel * (1 - 1e-12)), 1)
    if count.prod() > 1e8 or not np.isfinite(count).all():
        raise FormatError(
            f"the grid would have {' x '.join(f'{n:.0f}' for n in count)} voxels, more than 100 "
            "million; give larger voxels, or bounds"
        )
    grid = vtkImageData()
    grid.SetDimensions(*(int(n) + 1 for n in count))
    grid.SetOrigin(*low)
    grid.SetSpacing(*[settings.voxel] * 3)
    if settings.table is not None:
        table = numpy_to_vtk(np.ascontiguousarray(settings.table), deep=True)
        table.SetName(LEAF_PROJECTION)
        grid.GetFieldData().AddArray(table)
    return grid


def _find_bounds(inputs, settings):
    """Returns the bounds of the counted echoes, in multiples of the voxel's edge."""
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for scan in inputs:
        points = _columns(scan)["points"][_find_counted(scan, settings)]
        if len(points):
            low, high = np.minimum(low, points.min(axis=0)), np.maximum(high, points.max(axis=0))
    if not (low <= high).all():
        raise FormatError(
            f"{getattr(inputs, 'name', 'the cloud')}: no echo is of a plant that is counted; correct "
            "the classes and materials"
        )
    low = np.floor(low / settings.voxel)
    high = np.floor(high / settings.voxel) + 1
    return (settings.voxel * np.column_stack([low, high])).ravel()


def _columns(scan):
    return arrays(scan.echoes)


def _find_counted(scan, settings):
    columns = _columns(scan)
    counted = np.ones(len(columns["points"]), bool)
    if settings.materials:
        ids = _find_materials(scan, settings)
        counted &= np.isin(columns.get(MATERIAL_IDS, -1), ids)
    classes = columns.get(CLASSIFICATION_IDS)
    if settings.classes:
        counted &= np.isin(-1 if classes is None else classes, settings.classes)
    elif classes is not None and not settings.materials:
        is_plant = vtk_class("vtkHeliosPlantAreaDensity").IsPlantClass
        counted &= np.isin(classes, [each for each in np.unique(classes) if is_plant(int(each))])
    return counted


def _find_materials(scan, settings):
    """Returns the ids of the materials that are counted, by their names or numbers."""
    names = Header(scan.echoes.GetFieldData()).texts(MATERIAL_NAME)
    ids = []
    for wanted in settings.materials:
        if isinstance(wanted, (int, np.integer)):
            ids.append(int(wanted))
            continue
        found = [index for index, name in enumerate(names) if name == wanted]
        if not found:
            near = difflib.get_close_matches(wanted, names, 1, 0.5)
            hint = (
                f"did you mean {near[0]}?" if near else f"it has: {', '.join(names) or 'no names'}"
            )
            raise FormatError(f"{scan.name}: has no material {wanted}; {hint}")
        ids += found
    return ids


def _ground_points(scan):
    columns = _columns(scan)
    classes = columns.get(CLASSIFICATION_IDS)
    if classes is None:
        return np.empty((0, 3))
    return columns["points"][classes == GROUND]
