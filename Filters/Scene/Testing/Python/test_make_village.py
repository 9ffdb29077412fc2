# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The village of Data/Scenes/make_village.py, and its surveys."""

import importlib.util
import math
import os
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

import vtkhelios

DATA = vtkhelios.data_directory()
PACKAGE_DIR = pathlib.Path(vtkhelios.__file__).absolute().parents[1]
PROGRAM = DATA / "Scenes" / "make_village.py"


@pytest.fixture(scope="module")
def program():
    spec = importlib.util.spec_from_file_location("make_village", PROGRAM)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def village(program, tmp_path_factory):
    folder = tmp_path_factory.mktemp("village")
    return folder, program.make_village(folder)


def read(file):
    reader = vtkhelios.vtkHeliosObjSceneReader()
    reader.SetFileName(str(file))
    scene = vtkhelios.update(reader)
    assert reader.GetNumberOfDroppedTriangles() == 0
    return scene


def get_parts(folder):
    scene = ElementTree.parse(folder / "village_scene.xml").getroot().find("scene")
    assert scene.get("id") == "village"
    return scene.findall("part")


def get_file(part):
    return part.find("filter[@type='objloader']/param[@key='filepath']").get("value")


def test_every_part_can_be_read(village):
    folder, count = village
    parts = get_parts(folder)
    names = [part.get("id") for part in parts]
    assert len(set(names)) == len(names)
    triangles = {file: read(folder / file).GetNumberOfCells() for file in set(map(get_file, parts))}
    named = sum(triangles[get_file(part)] for part in parts)
    assert count == named - triangles["lane.obj"] - triangles["street.obj"]
    assert count >= 500_000


def test_trees_stand_on_the_ground_beside_houses_and_lane(program, village):
    houses = program.place_houses(program.Ground())
    plants = [part for part in get_parts(village[0]) if part.get("id").startswith("tree")]
    assert len(plants) >= 60
    for part in plants:
        translate = part.find("filter[@type='translate']")
        assert translate.find("param[@key='onGround']").get("value") == "-1"
        x, y, _ = map(float, translate.find("param[@key='offset']").get("value").split(";"))
        assert program.is_free(x, y, houses)


def test_houses_stand_on_level_ground(program):
    ground = program.Ground()
    for house in program.place_houses(ground):
        reach = 0.3 * house.length
        for turn in np.arange(0.0, 2 * math.pi, 0.5):
            x, y = house.x + reach * math.cos(turn), house.y + reach * math.sin(turn)
            assert ground.get_height(x, y) == pytest.approx(house.z, abs=1e-9)


def test_byte_identical_output(program, village, tmp_path):
    program.make_village(tmp_path)
    files = [file for file in sorted(village[0].rglob("*")) if file.is_file()]
    assert len(files) > 15
    for file in files:
        assert file.read_bytes() == (tmp_path / file.relative_to(village[0])).read_bytes()


@pytest.mark.parametrize("survey", ["village_tls", "village_als"])
def test_surveys_name_existing_files(survey):
    root = ElementTree.parse(DATA / "Surveys" / f"{survey}.xml").getroot()
    head = root.find("survey")
    assert head.get("name") == survey
    assert head.get("scene") == "village_scene.xml#village"
    for tag in ("scanner", "platform"):
        file, _, name = head.get(tag).partition("#")
        asset = ElementTree.parse(DATA / file).getroot().find(f"{tag}[@id='{name}']")
        assert asset is not None
    for settings in root.iter("platformSettings"):
        assert settings.get("onGround") == "true" or survey == "village_als"


def test_error_names_the_folder(tmp_path):
    (tmp_path / "file").touch()
    run = subprocess.run(
        [sys.executable, str(PROGRAM), str(tmp_path / "file" / "x")],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": str(PACKAGE_DIR)},
    )
    assert run.returncode == 1
    assert "Not a directory" in run.stderr and "Traceback" not in run.stderr
