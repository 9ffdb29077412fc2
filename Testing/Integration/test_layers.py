# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""No module uses a higher one, and the check can fail."""

import importlib.util
import pathlib

import pytest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]

_spec = importlib.util.spec_from_file_location("layers", HERE / "layers.py")
layers = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(layers)


def test_edges_go_down():
    modules = layers.find_modules(ROOT)
    assert {"FiltersCore", "ScannerCore", "ScannerSurvey"} <= set(modules)
    assert layers.find_edge_faults(modules) == []


def test_includes_are_declared():
    assert layers.find_include_faults(layers.find_modules(ROOT)) == []


def test_files_that_are_opened_are_inputs():
    modules = layers.find_modules(ROOT)
    assert layers.find_unchecked_files(modules) == []
    units = {path.stem for _, folder in modules.values() for path in layers.sources_of(folder)}
    assert set(layers.READ_NO_INPUTS) <= units


def test_an_unchecked_file_is_found(made_up):
    opens = "std::ifstream file(path);\n"
    made_up("Scanner/Survey", "ScannerSurvey", "", opens)
    modules = made_up("Filters/IO", "FiltersIO", "", f"CheckInputFile(path);\n{opens}")
    (unit,) = layers.find_unchecked_files(modules)
    assert "Survey" in unit


MODULES = {name: folder for name, (_, folder) in layers.find_modules(ROOT).items()}
MODULES["Viewer"] = ROOT / "Apps/Viewer"


@pytest.mark.parametrize("name", MODULES)
def test_folders_have_no_cycles(name):
    assert layers.find_folder_cycles(MODULES[name]) == []


def test_units_have_no_cycles():
    assert layers.find_unit_cycles(MODULES.values()) == []


def test_cycles_are_found(tmp_path):
    for folder, other in (("A", "B"), ("B", "A")):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / f"helios{folder}.h").write_text(f'#include "helios{other}.h"\n')
    (cycle,) = layers.find_folder_cycles(tmp_path)
    assert set(cycle) == {"A", "B"}


def test_unit_cycles_are_found(tmp_path):
    for name, other in (("A", "B"), ("B", "C"), ("C", "A"), ("D", "A")):
        (tmp_path / f"helios{name}.h").write_text("")
        (tmp_path / f"helios{name}.cxx").write_text(
            f'#include "helios{name}.h"\n#include "helios{other}.h"\n'
        )
    assert layers.find_unit_cycles([tmp_path]) == [{"heliosA", "heliosB", "heliosC"}]


@pytest.fixture
def made_up(tmp_path):
    """Makes a module below tmp_path and returns all modules there."""

    def make(folder, name, uses, source=""):
        path = tmp_path / folder
        path.mkdir(parents=True)
        path.joinpath("vtk.module").write_text(
            f"NAME\n  vtkHelios::{name}\nDEPENDS\n  VTK::CommonCore\nPRIVATE_DEPENDS\n  {uses}\n"
        )
        path.joinpath(f"vtkHelios{name}.h").write_text(source)
        return layers.find_modules(tmp_path)

    return make


@pytest.mark.parametrize(
    "name, uses, fault",
    [
        (
            "FiltersScene",
            "vtkHelios::ScannerCore",
            "FiltersScene uses ScannerCore, which is not below",
        ),
        ("FiltersScene", "vtkHelios::FiltersIO", "FiltersScene uses FiltersIO, which is not below"),
        ("ScannerOptics", "vtkHelios::ScannerPlatforms", "which is not below it"),
        ("ScannerCore", "vtkHelios::Unheard", "ScannerCore uses Unheard, which is not below"),
        ("ScannerCore", "VTK::RenderingCore", "rendering belongs to"),
        ("Unheard", "vtkHelios::FiltersCore", "Unheard has no layer"),
    ],
)
def test_upward_edge_is_found(made_up, name, uses, fault):
    faults = layers.find_edge_faults(made_up("Filters/Made", name, uses))
    assert len(faults) == 1 and fault in faults[0]


def test_undeclared_include_is_found(made_up):
    made_up("Scanner/Core", "ScannerCore", "VTK::CommonMath")
    modules = made_up(
        "Filters/Scene", "FiltersScene", "VTK::CommonMath", '#include "vtkHeliosScannerCore.h"\n'
    )
    faults = layers.find_include_faults(modules)
    assert len(faults) == 1 and "FiltersScene does not use" in faults[0]


def test_library_outside_its_module_is_found(made_up):
    modules = made_up("Scanner/Core", "ScannerCore", "VTK::CommonMath", "#include <pugixml.hpp>\n")
    assert layers.find_include_faults(modules) == [
        "vtkHeliosScannerCore.h includes pugixml.hpp, whose home is ScannerSurvey"
    ]


def test_library_in_public_header_is_found(made_up):
    modules = made_up(
        "Scanner/Survey", "ScannerSurvey", "VTK::CommonMath", "#include <pugixml.hpp>\n"
    )
    assert layers.find_include_faults(modules) == [
        "vtkHeliosScannerSurvey.h is public and includes pugixml.hpp"
    ]
