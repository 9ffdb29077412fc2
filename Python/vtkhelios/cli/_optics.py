# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The optics of a scene's materials in words."""

from vtkmodules.util.numpy_support import vtk_to_numpy

from ..array_names import (
    MATERIAL_ATTENUATION, MATERIAL_BACKSCATTER, MATERIAL_DISPERSION, MATERIAL_MEAN_SQUARE_SLOPE,
    MATERIAL_MIRROR_REFLECTANCE, MATERIAL_NAME, MATERIAL_OPTICS, MATERIAL_REFRACTIVE_INDEX,
    MATERIAL_RETROREFLECTION, MATERIAL_THICKNESS, MATERIAL_TRANSMITTANCE,
)  # fmt: skip
from ..scenes.scene import DISPERSIONS

COLUMNS = {
    "reflectance": MATERIAL_MIRROR_REFLECTANCE, "index": MATERIAL_REFRACTIVE_INDEX,
    "thickness": MATERIAL_THICKNESS, "attenuation": MATERIAL_ATTENUATION,
    "backscatter": MATERIAL_BACKSCATTER, "transmittance": MATERIAL_TRANSMITTANCE,
    "retroreflection": MATERIAL_RETROREFLECTION, "slope": MATERIAL_MEAN_SQUARE_SLOPE,
}  # fmt: skip
KINDS = {
    1: "a mirror that reflects {reflectance:.3g}",
    2: "a pane {thickness:.3g} m thick, of {index}",
    3: "a transparent body of {index}",
    4: "water of {index}",
    5: "leaves that transmit {transmittance:.3g}",
    6: "a retroreflector of {retroreflection:.4g} cd/(lx m2)",
}
MEDIA = (3, 4)  # kinds with a column
DISPERSION_NAMES = {number: name for name, number in DISPERSIONS.items()}


def describe_optics(scene):
    """Returns a line for each material of a scene (vtkDataObject) with optics: its name, and what
    light does."""
    fields = scene.GetFieldData()
    if not fields.HasArray(MATERIAL_OPTICS):
        return []
    kinds = vtk_to_numpy(fields.GetArray(MATERIAL_OPTICS))
    media = vtk_to_numpy(fields.GetArray(MATERIAL_DISPERSION))
    names = fields.GetAbstractArray(MATERIAL_NAME)
    numbers = {key: vtk_to_numpy(fields.GetArray(name)) for key, name in COLUMNS.items()}
    return [
        f"{names.GetValue(row)}: "
        + _describe(kind, media[row], {key: of[row] for key, of in numbers.items()})
        for row, kind in enumerate(kinds)
        if kind in KINDS
    ]


def _describe(kind, medium, numbers):
    index = (
        f"the index of {DISPERSION_NAMES[medium]}" if medium else f"index {numbers['index']:.4g}"
    )
    text = KINDS[kind].format(**{**numbers, "index": index})
    if kind in MEDIA and numbers["attenuation"] > 0:
        text += ", attenuation {attenuation:.4g} 1/m".format(**numbers)
        if kind == 4:
            text += " at 532 nm"
    if kind in MEDIA and numbers["backscatter"] > 0:
        text += ", backscatter {backscatter:.3g} 1/(m sr)".format(**numbers)
    if numbers["slope"] > 0:
        text += ", rough: mean square slope {slope:.3g}".format(**numbers)
    return text
