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
    headers = {name for name in headers if not name.endswith("ArrayNames")} - {
        "vtkHeliosRay",
        "vtkHeliosInstrumentData",
    }
    # class of a module that is imported by runs of several ranks only
    headers -= {"vtkHeliosMPIRanks"}
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


def do(code):
    """The output of a program in a process of its own."""
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        env={"PYTHONPATH": ":".join(sys.path)},
    )
    return done.stdout + done.stderr


def test_import_is_silent_and_loads_no_rendering():
    code = "import sys, vtkhelios; vtkhelios.Cloud; print([m for m in sys.modules if 'Rendering' in m])"
    assert do(code) == "[]\n"


def test_a_run_starts_without_what_it_does_not_use():
    code = (
        "import sys, vtkhelios.cli.run; slow = {'numpy', 'rich', 'vtkhelios.core.classes'};"
        "libraries = open('/proc/self/maps').read();"
        "print(slow & set(sys.modules), 'libgdal' in libraries, 'libpcl' in libraries)"
    )
    assert do(code) == "set() False False\n"


@pytest.mark.parametrize(
    "code",
    [
        "import vtkhelios; print('vtkHeliosScanner' in dir(vtkhelios))",
        "from vtkhelios import *; print(vtkHeliosScanner(range_max=600).range_max == 600)",
        "from vtkhelios import Cloud, vtkHeliosScanner; print(Cloud.__name__ == 'Cloud')",
        "import vtkhelios; vtkhelios.Cloud; print(vtkhelios.cloud.Cloud is vtkhelios.Cloud)",
        "import vtkhelios; print(vtkhelios.cloud.Cloud is vtkhelios.Cloud)",
        "from vtkhelios import catalogue; print(catalogue.__name__ == 'vtkhelios.catalogue')",
        "import vtkhelios.cli.run; print(hasattr(vtkhelios, 'vtkHeliosScanner'))",
    ],
)
def test_names_are_there_when_they_are_used(code):
    assert do(code) == "True\n"


@pytest.mark.parametrize("name", ["vtkHeliosScaner", "_scanner"])
def test_unknown_names_are_errors(name):
    with pytest.raises(AttributeError, match=f"module 'vtkhelios' has no attribute '{name}'"):
        getattr(vtkhelios, name)
