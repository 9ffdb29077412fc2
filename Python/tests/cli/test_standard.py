# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Standard input and output as files, results as JSON, --output, and errors of usage in one line."""

import io
import json
import pathlib
import subprocess
import sys
import types

import numpy as np
import pytest

import vtkhelios
from vtkhelios.cli import command_names, commands, main, make_parser

TEXT = "1 2 3\n4 5 6\n"


def run_vtkhelios(*words, data=b""):
    program = [sys.executable, "-m", "vtkhelios", *map(str, words)]
    path = ":".join(each for each in sys.path if each)
    return subprocess.run(program, input=data, capture_output=True, env={"PYTHONPATH": path})


def give(monkeypatch, data):
    """Sets standard input."""
    monkeypatch.setattr(sys, "stdin", types.SimpleNamespace(buffer=io.BytesIO(data)))


def test_points_pass_through_a_pipe(tmp_path):
    made = run_vtkhelios("convert", "-", tmp_path / "a.las", data=TEXT.encode())
    assert made.returncode == 0 and b"input    -: text, 3 columns, 2 points" in made.stdout, made
    las = (tmp_path / "a.las").read_bytes()
    done = run_vtkhelios("convert", "-", "-", "--from", "las", "--format", "xyz", data=las)
    assert done.returncode == 0 and b"error" not in done.stderr
    assert np.loadtxt(io.BytesIO(done.stdout))[:, :3].tolist() == [[1, 2, 3], [4, 5, 6]]
    done = run_vtkhelios("convert", tmp_path / "a.las", "-")
    lines = done.stdout.decode().splitlines()
    assert lines[0].startswith("X,Y,Z,") and lines[1].startswith("1.0,2.0,3.0,") and len(lines) == 3
    done = run_vtkhelios("convert", tmp_path / "a.las", "-o", "-", "--format", "ply")
    assert done.stdout.startswith(b"ply\nformat binary")


def test_a_closed_pipe_is_no_error_message(tmp_path):
    vtkhelios.Cloud.from_arrays(np.random.default_rng(1).random((100_000, 3))).write(
        tmp_path / "a.vtp"
    )
    program = [sys.executable, "-m", "vtkhelios", "convert", str(tmp_path / "a.vtp"), "-"]
    path = ":".join(each for each in sys.path if each)
    with subprocess.Popen(program, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          env={"PYTHONPATH": path}) as process:  # fmt: skip
        assert process.stdout.readline() == b"X,Y,Z\n"
        process.stdout.close()
        assert b"error" not in process.stderr.read() and process.wait() == 1


def test_errors_of_standard_input_name_it(tmp_path, capsys, monkeypatch):
    give(monkeypatch, b"")
    assert main(["convert", "-", str(tmp_path / "a.las")]) == 1
    err = capsys.readouterr().err
    assert err.startswith("error: -: ") and "standard-input" not in err
    assert main(["convert", "-", "-", "-o", str(tmp_path / "a.las"), "--merge"]) == 1
    assert "-: standard input is one file; give it once" in capsys.readouterr().err
    assert main(["convert", "a.las", "-", "--json"]) == 1
    assert "standard output has the points; leave --json out" in capsys.readouterr().err


@pytest.mark.parametrize(
    "words",
    ["detect - -o a.xyz", "compare - a.las", "compare a.las -", "fit -", "leafarea -", "plan -", "report -",
     "export - a --kitti", "run -", "run a.xml --output -", "validate -", "tradeoff -", "join -",
     "instrument a.json -o -"],
)  # fmt: skip
def test_what_takes_no_standard_input_or_output_says_so(words, capsys):
    assert main(words.split()) == 2
    out, err = capsys.readouterr()
    command = words.split()[0]
    assert out == "" and err == (
        f"error: -: vtkhelios {command} does not take standard input or output there; give the "
        "name of a file\n"
    )


def test_metadata_of_a_sensor_from_standard_input(capsys, monkeypatch):
    give(monkeypatch, b"[]")
    assert main(["instrument", "-"]) == 1
    assert capsys.readouterr().err.startswith("error: ")


@pytest.fixture
def fence(make_survey, tmp_path):
    """The folder of a run with waveforms."""
    survey = vtkhelios.read_survey(make_survey())
    return survey.run_to(tmp_path / "out", waveforms=True)["folder"]


def print_json(capsys, *words):
    assert main([*map(str, words), "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_results_as_json(fence, tmp_path, capsys):
    points = len(vtkhelios.read(fence))
    (made,) = print_json(capsys, "convert", fence, "-o", tmp_path / "a.ply")
    assert made["points"] == made["inputs"][0]["points"] == points
    assert made["bytes"] == (tmp_path / "a.ply").stat().st_size and "waveforms" in made["dropped"]
    (document,) = print_json(capsys, "convert", tmp_path / "survey.xml", tmp_path / "survey.yaml")
    assert document["file"].endswith("survey.yaml")
    found = print_json(
        capsys,
        "detect",
        fence / "leg000_fullwave.txt",
        "-o",
        tmp_path / "b.xyz",
        "--pulse-length",
        4,
    )
    assert found["points"] == len((tmp_path / "b.xyz").read_text().splitlines())
    written = print_json(capsys, "export", fence, "-o", tmp_path / "kitti", "--kitti")
    assert written["points"] == points and written["layout"] == "kitti" and written["scans"] > 0
    new = print_json(capsys, "new", tmp_path / "yard")
    assert new["survey"] in new["files"] and pathlib.Path(new["folder"]).is_dir()


def test_every_command_that_writes_has_output():
    """--output says where the results are, and so does -o."""
    parsers = make_parser()._subparsers._group_actions[0].choices
    without = {"completion", "doctor", "help", "info", "list", "new", "validate", "view"}
    for name in command_names():
        known = parsers[name]._option_string_actions
        assert ("-o" in known) == ("--output" in known) == (name not in without), name
        if "-o" in known:
            assert known["-o"] is known["--output"]


def test_every_command_that_reports_has_json():
    parsers = make_parser()._subparsers._group_actions[0].choices
    without = {"completion", "help", "instrument", "schema", "view"}  # their results are texts
    reporting = {name for name, module in commands().items() if hasattr(module, "run")}
    for name in reporting - without:
        assert "--json" in parsers[name]._option_string_actions, name


@pytest.mark.parametrize(
    "words, message",
    [
        ("run", "the following arguments are required: SURVEY.xml; see vtkhelios run --help"),
        ("run a.xml --sed 3", "unknown option --sed: did you mean --seed?"),
        ("rnu", "argument COMMAND: unknown 'rnu': did you mean run?"),
        ("plan x --grid -3", "argument --grid: '-3' is not a number from 1e-06 to 1e+06; see vtkh"),
        (
            "export a b",
            "one of the arguments --kitti --semantickitti --kitti-objects --nuscenes --s3dis --mcap --rosbag is required; see",
        ),
    ],
)
def test_errors_of_usage_are_one_line_with_one_hint(words, message, capsys):
    with pytest.raises(SystemExit) as ended:
        main(words.split())
    out, err = capsys.readouterr()
    assert ended.value.code == 2 and out == "" and err.startswith(f"error: {message}")
    assert err.count("\n") == 1 and err.count("did you mean") + err.count("--help") == 1


@pytest.mark.parametrize(
    "words, message",
    [("convert a.las", "OUTPUT is missing: the only file is a.las"),
     ("export a --kitti", "OUT is missing: give the name of a new folder")],
)  # fmt: skip
def test_a_missing_output(words, message, capsys):
    assert main(words.split()) == 2
    assert f"error: {message}" in capsys.readouterr().err


def test_info_of_standard_input():
    done = run_vtkhelios("info", "-", data=TEXT.encode())
    assert done.returncode == 0, done.stderr
    assert b"points     2" in done.stdout
    done = run_vtkhelios("info", "-", "--from", "las", "--json", data=b"no LAS")
    assert done.returncode == 1
    assert b"error: -: is not a LAS file" in done.stderr and b"/tmp" not in done.stderr
    done = run_vtkhelios("info", "-", "--json", data=TEXT.encode())
    assert json.loads(done.stdout)["file"] == "-"
    done = run_vtkhelios("info", "-", data=b"LASF\x00\x00")
    assert done.returncode == 1
    assert (
        done.stderr == b"error: -: begins as LAS, LAZ or COPC; give --from las, laz or copc.laz\n"
    )


def test_echoes_to_standard_output(make_survey, tmp_path):
    survey = make_survey(stop=2)
    run_vtkhelios("run", survey, "--waveforms", "--quiet", "--output", tmp_path / "out")
    fullwave = tmp_path / "out/plane/leg000_fullwave.txt"
    options = ("detect", fullwave, "--pulse-length", "3", "-o")
    assert run_vtkhelios(*options, tmp_path / "a.xyz").returncode == 0
    done = run_vtkhelios(*options, "-")
    assert done.returncode == 0, done.stderr
    assert done.stdout == (tmp_path / "a.xyz").read_bytes() and len(done.stdout) > 1000
    done = run_vtkhelios(*options, "-", "--json")
    assert done.returncode == 2
    assert b"error: -: standard output has the points; leave --json out" in done.stderr
