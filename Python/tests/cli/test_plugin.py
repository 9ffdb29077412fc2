# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line: plug-ins with echo detectors (--plugin)."""

import hashlib
import json
import pathlib
import shutil
import subprocess

import pytest

import vtkhelios
from vtkhelios.core.plugins import PluginError, load_plugin

from _command_line import expect_failure

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "examples/own_detector.py"


@pytest.fixture
def plugin(tmp_path):
    return pathlib.Path(shutil.copy(EXAMPLE, tmp_path / "own.py"))


@pytest.fixture
def survey(make_survey):
    """A survey that names the detector of the plug-in."""
    path = make_survey()
    text = path.read_text().replace("<leg>", '<FWFSettings echoDetector="largest"/>\n<leg>', 1)
    path.write_text(text)
    return path


def summary_of(folder):
    return json.loads((folder / "plane/run_summary.json").read_text())


def test_a_survey_uses_the_detector_of_a_plugin(survey, plugin, command_line, tmp_path):
    for threads in (1, 3):
        output = tmp_path / f"out{threads}"
        words = ["run", survey, "--plugin", plugin, "--output", output, "--threads", threads]
        done = command_line(*words)
        assert done.returncode == 0, done
    summary = summary_of(output)
    assert summary["totals"]["points"] > 1000
    sha = hashlib.sha256(plugin.read_bytes()).hexdigest()
    assert [each["sha256"] for each in summary["inputs"] if each["file"] == str(plugin)] == [sha]
    points = [tmp_path / f"out{threads}/plane/leg000_points.xyz" for threads in (1, 3)]
    assert points[0].read_bytes() == points[1].read_bytes()
    assert command_line("validate", survey, "--plugin", plugin).returncode == 0
    assert command_line("info", survey, "--plugin", plugin).returncode == 0
    done = command_line("run", survey, "--plugin", plugin, "--dry-run")
    assert done.returncode == 0, done


def test_without_the_plugin_a_survey_is_in_error(survey, command_line):
    done = command_line("run", survey)
    expect_failure(done, r"survey\.xml:\d+: .*echoDetector.*largest")
    assert command_line("validate", survey).returncode == 1


def test_options_name_the_detector_of_a_plugin(make_survey, plugin, command_line, tmp_path):
    words = ["--detector", "largest", "--plugin", plugin]  # in this order, too
    done = command_line("run", make_survey(), *words, "--waveforms", "--output", tmp_path / "out")
    assert done.returncode == 0, done
    assert summary_of(tmp_path / "out")["options"]["detector"] == "largest"
    waveforms = tmp_path / "out/plane/leg000_fullwave.txt"
    output = tmp_path / "again.xyz"
    words += ["-o", output, "--pulse-length", "5"]
    done = command_line("detect", waveforms, *words)
    assert done.returncode == 0, done
    assert len(output.read_text().splitlines()) > 1000


def test_a_run_does_not_resume_with_another_plugin(survey, plugin, command_line, tmp_path):
    words = ["run", survey, "--output", tmp_path / "out", "--plugin"]
    assert command_line(*words, plugin).returncode == 0
    moved = pathlib.Path(shutil.copy(plugin, tmp_path / "moved.py"))
    assert command_line(*words, moved, "--resume").returncode == 0  # the same bytes
    plugin.write_text(plugin.read_text() + "\n# edited\n")
    expect_failure(command_line(*words, plugin, "--resume"), "own.py has changed")
    moved.write_text(plugin.read_text())
    expect_failure(command_line(*words, moved, "--resume"), "moved.py is new")


def test_parts_are_joined_with_their_plugin(survey, plugin, command_line, tmp_path):
    options = ["survey.xml", "--plugin", "own.py", "--detector", "largest"]
    options += ["--pulses-per-block", "3000"]
    for more in (["--output", "whole"], ["--part", "1/2"], ["--part", "2/2"]):
        done = command_line("run", *options, *more, cwd=tmp_path)
        assert done.returncode == 0, done
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    words = ["join", tmp_path / "output/plane", "--output", tmp_path / "joined"]
    done = command_line(*words, cwd=elsewhere)
    assert done.returncode == 0, done
    points = "plane/leg000_points.xyz"
    assert (tmp_path / "joined" / points).read_bytes() == (tmp_path / "whole" / points).read_bytes()
    plugin.unlink()
    expect_failure(command_line(*words, "--overwrite", cwd=elsewhere), "own.py: no such file")


@pytest.mark.parametrize(
    "name, text, message",
    [
        ("none.py", None, "none.py: no such file; give a plug-in"),
        ("own.txt", "", r"own.txt: is no plug-in; give a file in Python \(.py\) or a library"),
        ("empty.py", "import vtkhelios\n", r"empty.py: registers no echo detector of vtkHelios \d"),
        ("a.py", "\n1 / 0\n", "a.py:2: ZeroDivisionError: division by zero"),
        ("b.py", "\n\ndef f(:\n", "b.py:3: SyntaxError: "),
        (
            "taken.py",
            'import vtkhelios\nvtkhelios.add_detector("peak", print)\n',
            "taken.py:2: ValueError: the name 'peak' of an echo detector is taken",
        ),
        ("text.so", "no library", "text.so: cannot be loaded: .*; build it for vtkHelios"),
    ],
)
def test_errors_of_files(name, text, message, survey, command_line, tmp_path):
    if text is not None:
        (tmp_path / name).write_text(text)
    for command in ("run", "validate"):
        done = command_line(command, survey, "--plugin", tmp_path / name)
        expect_failure(done, message)
    assert not (tmp_path / "output").exists()


def test_half_loaded_plugins_leave_nothing(tmp_path):
    path = tmp_path / "half.py"
    path.write_text('import vtkhelios\nvtkhelios.add_detector("half", print)\nhalt\n')
    with pytest.raises(PluginError, match="half.py:3: NameError"):
        load_plugin(path)
    assert vtkhelios.vtkHeliosEchoDetection.MakeDetector("half") is None


def compile_library(folder, name, code, *more):
    source = folder / f"{name}.c"
    source.write_text(code)
    path = folder / f"lib{name}.so"
    subprocess.run(["cc", "-shared", "-fPIC", source, "-o", path, *more], check=True)
    return path


def test_programs_without_python_load_libraries(tmp_path, plugin):
    load = vtkhelios.vtkHeliosEchoDetection.LoadPlugin
    assert load(str(tmp_path / "none.so")).endswith("none.so: no such file; give a plug-in")
    wanted = "own.py: is no library (.so), the plug-ins of this program; vtkhelios run loads those in Python"
    assert load(str(plugin)).endswith(wanted)


def test_errors_of_libraries(tmp_path):
    path = compile_library(tmp_path, "plain", "int answer(void) { return 42; }")
    with pytest.raises(PluginError, match=r'is no plug-in; give it extern "C" bool vtkhelios_reg'):
        load_plugin(path)
    code = "_Bool vtkhelios_register_plugin(void) { return %d; }"
    path = compile_library(tmp_path, "refused", code % 0)
    with pytest.raises(PluginError, match="a detector is taken, or not valid; known are peak, gau"):
        load_plugin(path)
    path = compile_library(tmp_path, "idle", code % 1)
    with pytest.raises(PluginError, match="libidle.so: registers no echo detector of vtkHelios"):
        load_plugin(path)


def test_a_library_for_another_version(tmp_path):
    soname = "libvtkHeliosScannerDetectors.so.0.0.1"
    old = compile_library(tmp_path, "old", "int old(void) { return 1; }", f"-Wl,-soname,{soname}")
    code = "int old(void); _Bool vtkhelios_register_plugin(void) { return old(); }"
    path = compile_library(tmp_path, "plugin", code, old)
    with pytest.raises(PluginError) as caught:
        load_plugin(path)
    version = vtkhelios.__version__
    assert f"{soname}: cannot open" in str(caught.value)
    assert str(caught.value).endswith(
        f"; build it for vtkHelios {version}, the version of this program"
    )
