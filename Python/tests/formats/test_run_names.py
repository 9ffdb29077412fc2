# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of parts and materials beside the LAS files of runs."""

import json
import shutil

import pytest
from _small_run import write_survey

LAS_SURVEY = """\
<document>
  <survey name="v" scene="scene2.xml#v" platform="platforms.xml#tripod"
    scanner="scanners.xml#vz400_class_tls">
    <leg><platformSettings z="2" onGround="false"/>
      <scannerSettings pulseFreq_hz="100000" scanFreq_hz="100" verticalAngleMin_deg="-40"
        verticalAngleMax_deg="20" headRotatePerSec_deg="60" headRotateStop_deg="1"/></leg>
  </survey>
</document>
"""
LAS_SCENE = """\
<document><scene id="v"><part><filter type="lasloader"><param key="filepath" value="a.las"/>
<param key="voxelSize" value="0.5"/></filter></part></scene></document>
"""
NAMES = ["leg000_points.names.json", "leg001_points.names.json"]


@pytest.fixture
def run(tmp_path, command_line):
    write_survey(tmp_path)

    def call(output, *options):
        done = command_line("run", "survey.xml", "--output", output, *options, cwd=tmp_path)
        assert done.returncode == 0, done
        return tmp_path / output / "fence"

    return call


def names_in(folder):
    return sorted(path.name for path in folder.iterdir() if "names" in path.name)


def test_a_run_has_the_names_of_its_scene(run):
    folder = run("out", "--format", "las")
    assert names_in(folder) == NAMES
    names = json.loads((folder / NAMES[0]).read_text())
    summary = json.loads((folder / "run_summary.json").read_text())
    assert names["points"] == summary["legs"][0]["files"][0]["records"] > 0
    assert len(names["parts"]) == 1 and names["materials"]
    run("out", "--format", "xyz", "--overwrite")
    assert names_in(folder) == []


def test_joined_parts_have_the_names_of_the_run(run, command_line, tmp_path):
    whole = run("whole", "--format", "las", "--pulses-per-block", 3000)
    for part in ("1/2", "2/2"):
        run("parts", "--format", "las", "--pulses-per-block", 3000, "--part", part)
    done = command_line("join", "parts/fence", "--output", "joined", cwd=tmp_path)
    assert done.returncode == 0, done
    joined = next((tmp_path / "joined").rglob(NAMES[0])).parent
    for name in NAMES:
        assert (joined / name).read_bytes() == (whole / name).read_bytes()


def test_exports_have_the_names_as_those_of_vtk_files(run, command_line, tmp_path):
    for kind in ("las", "vtp"):
        folder = run(kind, "--format", kind)
        labels = tmp_path / "labels.json"
        labels.write_text(json.dumps({"materials": {"default": 71}}))
        done = command_line(
            "export", folder, tmp_path / f"{kind}-out", "--semantickitti", "--labels", labels
        )
        assert done.returncode == 0, done
    one, other = (sorted((tmp_path / f"{kind}-out").rglob("*.label")) for kind in ("las", "vtp"))
    assert len(one) == len(other) > 0
    assert [path.read_bytes() for path in one] == [path.read_bytes() for path in other]


def test_names_are_an_input_of_a_run(run, command_line, tmp_path):
    folder = run("out", "--format", "las")
    for ending in ("las", "names.json"):
        shutil.copy(folder / f"leg000_points.{ending}", tmp_path / f"a.{ending}")
    (tmp_path / "survey2.xml").write_text(LAS_SURVEY)
    (tmp_path / "scene2.xml").write_text(LAS_SCENE)
    done = command_line("run", "survey2.xml", "--output", "voxels", cwd=tmp_path)
    assert done.returncode == 0, done
    inputs = json.loads((tmp_path / "voxels/v/run_summary.json").read_text())["inputs"]
    assert {"a.las", "a.names.json"} <= {each["file"].rsplit("/")[-1] for each in inputs}
