# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package: every class exists, can be created, and is documented."""

import pathlib
import subprocess
import sys

import pytest
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

import vtkhelios

ROOT = pathlib.Path(__file__).resolve().parents[2]
CLASSES = [name for name in vtkhelios.__all__ if name.startswith("vtkHelios")]


def header_of(name):
    return next(
        path for folder in ("Filters", "Scanner") for path in (ROOT / folder).rglob(f"{name}.h")
    )


# Contents of optional modules.
OPTIONAL = {
    "vtkHeliosFiltersPCL": "Filters/PCL",
    "vtkHeliosFiltersSimplify": "Filters/Simplify",
    "vtkHeliosScannerRayCastingCgal": "Scanner/RayCasting/Cgal",
    "vtkHeliosScannerRayCastingEmbree": "Scanner/RayCasting/Embree",
}


def test_every_class_with_a_header_is_wrapped():
    headers = {
        path.stem
        for folder in ("Filters", "Scanner")
        for path in (ROOT / folder).rglob("vtkHelios*.h")
    }
    built = {
        path.name.split(".")[0]
        for path in pathlib.Path(vtkhelios.__file__).parent.glob("vtkHelios*.so")
    }
    for module, folder in OPTIONAL.items():
        if module not in built:
            headers -= {path.stem for path in (ROOT / folder).glob("vtkHelios*.h")}
    headers -= {"vtkHeliosArrayNames", "vtkHeliosPCLArrayNames", "vtkHeliosRay"}
    headers -= {"vtkHeliosMPIRanks"}  # of a module that is imported by runs of several ranks only
    assert headers <= set(CLASSES)


@pytest.mark.parametrize("name", CLASSES)
def test_class(name):
    cls = getattr(vtkhelios, name)
    if not isinstance(cls, type) or not issubclass(cls, vtkObject):
        return  # a struct
    assert name in cls.__doc__
    try:
        made = cls()
    except TypeError:  # an abstract one has no New()
        assert f"static {name}* New()" not in header_of(name).read_text()
        return
    assert made.GetClassName() == name
    assert name in str(made)


def test_version():
    assert vtkhelios.__version__ == vtkhelios.vtkHeliosVersion.GetVersion()


def test_shares_a_process_with_stock_vtk():
    from vtkmodules.vtkFiltersCore import vtkTriangleFilter

    triangles = vtkTriangleFilter()
    transform = vtkhelios.vtkHeliosSceneTransform()
    transform.SetInputConnection(triangles.GetOutputPort())
    assert isinstance(transform, vtkAlgorithm)
    assert transform.GetInputAlgorithm() is triangles


def test_import_is_silent_and_loads_no_rendering():
    done = subprocess.run(
        [
            sys.executable,
            "-c",
            "import sys, vtkhelios; print([m for m in sys.modules if 'Rendering' in m])",
        ],
        capture_output=True,
        text=True,
        env={"PYTHONPATH": ":".join(sys.path)},
    )
    assert (done.stdout, done.stderr) == ("[]\n", "")
