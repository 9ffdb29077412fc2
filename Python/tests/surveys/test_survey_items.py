# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Legs and parts as lists that can be changed, and surveys written to files."""

import os
import pathlib
import subprocess

import numpy as np
import pytest

import vtkhelios
from vtkhelios.example_surveys import KINDS, write_example

FLAT = "v -60 -60 0\nv 60 -60 0\nv 60 60 0\nv -60 60 0\nf 1 2 3 4\n"
TRIPOD = dict(scan_frequency=100, vertical=(-40, 60), head=(0, 30), head_speed=60)
ROOT = pathlib.Path(__file__).parents[3]
OTHERS = pathlib.Path(os.environ.get("HELIOS_DATA") or ROOT.parent / "shared/data") / "helios"


@pytest.fixture
def survey(tmp_path):
    (tmp_path / "ground.obj").write_text(FLAT)
    (tmp_path / "car.obj").write_text(FLAT.replace("60", "1"))
    car = {"file": tmp_path / "car.obj", "id": "car", "translate": (5, 0, 1), "dynStep": 5000}
    car["dmotion"] = [{"loop": 0, "motion": {"type": "translation", "vec": (0.1, 0, 0)}}]
    legs = [(0, 0, 2), dict(position=(4, 0), scan_frequency=50), (8, 0, 2)]
    return vtkhelios.make_survey([tmp_path / "ground.obj", car], legs, **TRIPOD)


def test_legs_are_changed(survey):
    assert [leg.scan_frequency for leg in survey.legs] == [100, 50, 100]
    survey.legs[0].scan_frequency = 60
    assert survey.legs[0].scan_frequency == 60 and survey.legs[0].head == (0, 30)
    survey.legs[0].head = (10, 50)
    survey.legs[0].position = (1, 2)
    assert survey.legs[0].headRotateStop_deg == 50 and survey.legs[0].on_ground
    survey.legs[-1].position = (1, 2, 3)
    assert survey.legs[2].position == (1, 2, 3) and not survey.legs[2].on_ground
    survey.legs[1].active = False
    assert [leg.index for leg in survey.legs if leg.active] == [0, 2]
    survey.legs[0].scan_frequency = None  # the default
    assert survey.legs[0].scanFreq_hz is None
    with pytest.raises(
        AttributeError,
        match="scan_freqency is not an attribute of a leg; did you mean scan_frequency?",
    ):
        survey.legs[0].scan_freqency = 5
    with pytest.raises(
        AttributeError, match="scanFrq_hz is not an attribute of a leg; did you mean scanFreq_hz?"
    ):
        survey.legs[0].scanFrq_hz
    with pytest.raises(vtkhelios.PipelineError, match='leg 0: scanFreq_hz="fast" is not a number'):
        survey.legs[0].scan_frequency = "fast"


def test_legs_are_a_list(survey):
    assert len(survey.legs) == 3
    leg = survey.legs.append((2, 3), scan_frequency=25, head=(0, 90))
    assert leg.index == 3 and survey.legs[3].scan_frequency == 25
    survey.legs.append({"position": (9, 9, 9)})
    survey.legs.move(3, 0)
    assert [leg.position[0] for leg in survey.legs] == [2, 0, 4, 8, 9]
    survey.legs.move(0, -1)
    assert [leg.position[0] for leg in survey.legs] == [0, 4, 8, 9, 2]
    del survey.legs[1]
    del survey.legs[2:]
    assert [leg.position[0] for leg in survey.legs] == [0, 8]
    with pytest.raises(IndexError):
        survey.legs[2]
    with pytest.raises(TypeError, match="headSpeed is not a setting of a leg"):
        survey.legs.append((0, 0), headSpeed=1)
    with pytest.raises(vtkhelios.PipelineError, match="headRotateStop_deg"):
        survey.legs.append((0, 0), head=(0, "x"))
    assert len(survey.legs) == 2
    with pytest.raises(vtkhelios.PipelineError, match="scanner 7 does not exist"):
        survey.legs.append((0, 0), scanner=7)


def test_parts_are_a_list(survey, tmp_path):
    assert [part.name for part in survey.parts] == ["0", "car"]
    car = survey.parts[1]
    assert car["translate/offset"] == "5;0;1" and car["dmotion/motion/vec"] == "0.1;0;0"
    tree = survey.parts.append(tmp_path / "car.obj", rotate=("z", 90), scale=2, classification=5)
    assert tree["scale/scale"] == 2 and tree.classification == 5
    assert survey.scene.GetNumberOfCells() == 6
    survey.parts[2].id = "tree"
    del survey.parts[1]
    assert [part.name for part in survey.parts] == ["0", "tree"]
    with pytest.raises(
        AttributeError,
        match="classificatoin is not an attribute of a part; did you mean classification?",
    ):
        survey.parts[0].classificatoin = 3
    with pytest.raises(vtkhelios.PipelineError, match="did you mean motion?"):
        survey.parts.append(
            tmp_path / "car.obj", dmotion={"loop": 0, "moton": {"type": "identity"}}
        )
    assert len(survey.parts) == 2
    with pytest.raises(ValueError, match="car.txt: is not a mesh of a known format"):
        survey.parts.append("car.txt")


def test_a_survey_of_parts_is_written(survey, tmp_path):
    survey.write(tmp_path / "written.xml")
    again = vtkhelios.read_survey(tmp_path / "written.xml")
    a, b = survey.run(), again.run()
    assert len(a) > 1000 and np.array_equal(a.points, b.points)
    assert np.array_equal(a["PartIds"], b["PartIds"])
    assert 'value="car.obj"' in (tmp_path / "written.xml").read_text()
    with pytest.raises(vtkhelios.PipelineError, match="car.obj cannot be created: Not a directory"):
        survey.write(tmp_path / "car.obj/written.xml")


def test_a_run_of_moving_parts_is_stopped(survey):
    def stop(share):
        if share > 0:
            raise KeyboardInterrupt

    survey.parts[1].dynStep = 1
    survey.legs[1].head = (0, 720)  # long enough for a sign of progress on any machine
    with pytest.raises(KeyboardInterrupt):
        survey.run(progress=stop)
    survey.parts[1].dynStep = 5000
    survey.legs[1].head = (0, 30)
    assert len(survey.run()) > 1000


def test_a_changed_file_is_written(make_survey, tmp_path):
    survey = vtkhelios.read_survey(make_survey())
    survey.legs[0].head = (0, 5)
    survey.vtk.SetScannerAttribute(0, "beamDivergence_rad", "0.001")
    survey.write(tmp_path / "other.xml")
    again = vtkhelios.read_survey(tmp_path / "other.xml")
    assert again.vtk.GetScannerAttribute(0, "beamDivergence_rad") == "0.001"
    assert np.array_equal(survey.run().points, again.run().points)


def test_surveys_of_others_are_written_as_they_are(tmp_path):
    """The C++ test compares all data that is read from each file before and after."""
    tests = ROOT / "build/bin/vtkHeliosScannerSurveyTests"
    if not tests.exists():
        pytest.skip(f"{tests} is not built")
    for kind in KINDS:
        write_example(kind, tmp_path / kind)
    for folder in [tmp_path, OTHERS]:
        if folder.is_dir():
            done = subprocess.run(
                [tests, "SurveyWritten: surveys of the tree and of HELIOS_SURVEYS"],
                env={**os.environ, "HELIOS_SURVEYS": str(folder)}, capture_output=True, text=True, check=False,
            )  # fmt: skip
            assert done.returncode == 0, done.stdout[-4000:]
