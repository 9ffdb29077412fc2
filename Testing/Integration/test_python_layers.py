# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The packages of vtkhelios use lower layers only; a made-up package proves that faults are found."""

import importlib.util
import pathlib

import pytest

HERE = pathlib.Path(__file__).resolve().parent

_spec = importlib.util.spec_from_file_location("python_layers", HERE / "python_layers.py")
layers = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(layers)


@pytest.fixture(scope="module")
def package():
    return layers.read_package(layers.ROOT / "Python/vtkhelios")


def test_packages_are_found(package):
    assert {"vtkhelios", "vtkhelios.core.files", "vtkhelios.cli.run"} < set(package.modules)
    edges = {(user, used) for user, used, *_ in package.imports}
    assert ("vtkhelios.plans.plan", "vtkhelios.scenes.scene") in edges
    assert ("vtkhelios.formats._records", "laspy") in edges


def test_every_package_has_a_layer(package):
    known = layers.LAYER.keys() | layers.PUBLIC | layers.TOP | {"", "vtkmodules"}
    assert {layers.package_of(name) for name in package.modules} == known


def test_imports_point_down(package):
    assert layers.find_edge_faults(package) == []


def test_imports_stand_at_the_top(package):
    assert layers.find_hidden_imports(package) == []


def test_exceptions_are_needed(package):
    assert layers.find_unused_exceptions(package) == []


@pytest.mark.parametrize("group", [str, layers.package_of])
def test_no_cycles(package, group):
    assert layers.find_cycles(package, group) == []


@pytest.fixture
def made_up(tmp_path):
    """A function that writes modules, given as name=text, and returns what read_package() reads."""

    def write(**texts):
        for name, text in texts.items():
            name = "__init__" if name == "root" else name.replace("__", "/")
            path = tmp_path / "vtkhelios" / f"{name}.py"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return layers.read_package(tmp_path / "vtkhelios")

    return write


def test_import_upwards_is_found(made_up):
    package = made_up(core__a="from ..plans import b", plans__b="from ..core import a")
    (fault,) = layers.find_edge_faults(package)
    assert fault == "a.py:1: vtkhelios.core.a imports vtkhelios.plans.b, which is not below it"


def test_import_beside_is_found(made_up):
    package = made_up(formats__a="import vtkhelios.exchange.b", exchange__b="")
    assert "which is not below it" in layers.find_edge_faults(package)[0]


def test_import_of_the_command_line_is_found(made_up):
    package = made_up(cli__run="", flight__a="def f():\n    from ..cli.run import main")
    (fault,) = layers.find_edge_faults(package)
    assert fault.startswith("a.py:2:") and fault.endswith("nothing imports the command line")


def test_import_of_public_names_is_found(made_up):
    package = made_up(survey="", plans__a="from ..survey import Survey")
    assert "a module of public names" in layers.find_edge_faults(package)[0]


def test_import_of_the_root_is_found(made_up):
    package = made_up(root="", formats__a="import vtkhelios", cli__b="import vtkhelios")
    (fault,) = layers.find_edge_faults(package)
    assert "vtkhelios.formats.a imports vtkhelios" in fault and "vtk_class()" in fault


def test_package_without_a_layer_is_found(made_up):
    package = made_up(extras__a="from ..core import b", core__b="", cli__c="from ..extras import a")
    assert len([f for f in layers.find_edge_faults(package) if "has no layer" in f]) == 2


@pytest.mark.parametrize("text", ["import json", "from ..core import b", "import vtk"])
def test_import_in_a_function_is_found(made_up, text):
    package = made_up(plans__a=f"class A:\n    def f(self):\n        {text}", core__b="")
    assert layers.find_hidden_imports(package)[0].startswith("a.py:3: a function of")


def test_optional_library_in_a_function_is_permitted(made_up):
    assert layers.find_hidden_imports(made_up(plans__a="def f():\n    import laspy.file")) == []


def test_import_by_name_is_found(made_up):
    package = made_up(plans__a="import importlib\nimportlib.import_module('json')")
    assert layers.find_hidden_imports(package) == ["a.py: vtkhelios.plans.a calls import_module()"]


def test_unused_exceptions_are_found(made_up):
    unused = layers.find_unused_exceptions(made_up(core__classes="", plans__files=""))
    assert "vtkhelios.core.classes does not call import_module()" in unused
    assert len(unused) == len(layers.LATE) + len(layers.BY_NAME)


def test_cycles_are_found(made_up):
    package = made_up(
        plans__a="from .b import x",
        plans__b="def f():\n    from ..core import c",
        core__c="from ..plans.a import y",
    )
    names = {"vtkhelios.plans.a", "vtkhelios.plans.b", "vtkhelios.core.c"}
    assert layers.find_cycles(package) == [names]
    assert layers.find_cycles(package, layers.package_of) == [{"plans", "core"}]
