# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line: messages, output and exit codes."""

import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys

import numpy as np
import pytest
from vtkmodules.vtkIOXML import vtkXMLPPolyDataReader

import vtkhelios

from vtkhelios.cli import main, make_parser
from vtkhelios.reports.run import unresolved_lines

from _command_line import PULSES, expect_failure, start


# Invalid arguments.


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["run", "s.xml", "--sed", "3"], "unknown option --sed: did you mean --seed?"),
        (["run", "s.xml", "--asset=x"], "unknown option --asset: did you mean --assets?"),
        (["run", "--xyzzy"], "unknown option --xyzzy: vtkhelios run --help lists all options"),
        (["--versoin"], "unknown option --versoin: did you mean --version?"),
        (["rnu", "s.xml"], "unknown 'rnu': did you mean run?"),
        (["s.xml"], "a command is missing: vtkhelios run s.xml"),
        (["run"], "required: SURVEY.xml"),
        (["run", "s.xml", "t.xml"], "unrecognized arguments: t.xml"),
        (
            ["run", "s.xml", "--seed", "-1"],
            "'-1' is not a whole number from 0 to 4611686018427387904",
        ),
        (["run", "s.xml", "--seed", "1.5"], "'1.5' is not a whole number"),
        (["run", "s.xml", "--threads", "many"], "'many' is not a whole number from 0 to 4096"),
        (["run", "s.xml", "--format", "pcd"], "unknown 'pcd': known: xyz, las, laz, copc, vtp"),
        (["run", "s.xml", "--range-tolerance", "0"], "'0' is not a number from 1e-06 to 1"),
        (
            ["run", "s.xml", "--max-sub-rays", "9"],
            "'9' is not a whole number from 1024 to 16777216",
        ),
        (["run", "s.xml", "--energy-tolerance", "nan"], "'nan' is not a number from 0.0001 to 1"),
        (["run", "s.xml", "--sub-rays", "many"], "'many' is not a whole number from 0 to 65536"),
        (["run", "s.xml", "--detector", "gaus"], "unknown 'gaus': did you mean gaussian?"),
        (
            ["run", "s.xml", "--epoch", "first"],
            "'first' is not a whole number from 0 to 2147483647",
        ),
        (["run", "s.xml", "--resme"], "unknown option --resme: did you mean --resume?"),
        (
            ["run", "s.xml", "--resume", "--overwrite"],
            "argument --overwrite: not allowed with argument --resume",
        ),
        (
            ["run", "s.xml", "--pulses-per-block", "0"],
            "'0' is not a whole number from 1 to 16777216",
        ),
    ],
)
def test_wrong_usage(arguments, message, capsys):
    with pytest.raises(SystemExit) as stopped:
        main(arguments)
    assert stopped.value.code == 2
    assert message in capsys.readouterr().err


def test_check_all_is_for_resume(capsys):
    assert main(["run", "s.xml", "--check-all"]) == 2
    assert "error: --check-all needs --resume: give both" in capsys.readouterr().err


def test_sub_rays_or_a_tolerance(capsys):
    assert main(["run", "s.xml", "--sub-rays", "7", "--range-tolerance", "0.01"]) == 2
    assert "--sub-rays is a fixed number" in capsys.readouterr().err


def test_no_command_shows_help(capsys):
    assert main([]) == 2
    assert "examples:" in capsys.readouterr().err


def test_version(command_line):
    done = command_line("--version")
    assert (done.returncode, done.stdout) == (0, f"vtkhelios {vtkhelios.__version__}\n")


def test_help_has_examples(command_line):
    done = command_line("run", "--help")
    assert done.returncode == 0
    for word in (
        "examples:",
        "exit codes:",
        "[nW]",
        "--assets DIR",
        "--seed N",
        "beam sampling:",
        "interrupted runs:",
        "--dry-run loads",
        "run_summary.json",
    ):
        assert word in done.stdout


def test_every_command_has_a_summary():
    parser = make_parser()
    assert "run a survey" in parser.format_help()


# Errors.


def test_missing_survey(command_line, tmp_path):
    expect_failure(command_line("run", "nowhere.xml", cwd=tmp_path), "nowhere.xml")


def test_malformed_survey(command_line, tmp_path):
    (tmp_path / "bad.xml").write_text("<document>\n<survey name='a'\n</document>\n")
    expect_failure(command_line("run", "bad.xml", cwd=tmp_path), r"bad\.xml:[23]")


def test_missing_asset_folder(command_line, make_survey):
    expect_failure(
        command_line("run", make_survey(), "--assets", "nowhere"),
        "--assets nowhere: no such folder",
    )


def test_output_below_a_plain_file(command_line, make_survey, tmp_path):
    (tmp_path / "plain").write_text("")
    done = command_line("run", make_survey(), "--output", tmp_path / "plain/out")
    expect_failure(done, "plain")


def test_earlier_run_is_not_overwritten(command_line, make_survey, tmp_path):
    survey, output = make_survey(), tmp_path / "out"
    assert command_line("run", survey, "--output", output).returncode == 0
    cloud = output / "plane/leg000_points.xyz"
    cloud.write_text("mine")
    expect_failure(command_line("run", survey, "--output", output), "--overwrite|[Oo]verwrite")
    assert cloud.read_text() == "mine"
    assert command_line("run", survey, "--output", output, "--overwrite").returncode == 0
    assert cloud.stat().st_size > 1000


def test_no_points_is_a_failure(command_line, make_survey, tmp_path):
    done = command_line("run", make_survey(z=5000), "--output", tmp_path / "out")
    expect_failure(done, "No points: none of [0-9]+ pulses")


def test_quiet_prints_errors_only(command_line, make_survey, tmp_path):
    done = command_line("run", make_survey(), "--output", tmp_path / "out", "--quiet")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    expect_failure(command_line("run", "nowhere.xml", "--quiet", cwd=tmp_path), "nowhere.xml")


# Output and messages of a run.


@pytest.fixture
def columns():
    def read(folder):
        return np.loadtxt(
            folder / "plane/leg000_points.xyz", usecols=(0, 1, 2, 3, 4, 5, 6, 7), ndmin=2
        )

    return read


def test_run(command_line, make_survey, columns, tmp_path):
    done = command_line(
        "run", make_survey(), "--output", tmp_path / "out", "--no-noise", "--seed", 7
    )
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    rows = columns(tmp_path / "out")
    assert f"points   {len(rows):,} (" in done.stdout
    assert f"pulses   {PULSES:,}" in done.stdout
    assert "seed 7" in done.stdout and "M pulses/s" in done.stdout
    assert str(tmp_path / "out/plane/leg000_points.xyz") in done.stdout
    assert (tmp_path / "out/plane/leg000_trajectory.txt").is_file()
    near = np.hypot(rows[:, 0], rows[:, 1]) < 30  # grazing incidence far away
    assert near.mean() > 0.5
    assert np.abs(rows[near, 2]).max() < 1e-3
    assert not list((tmp_path / "out").rglob("*.part"))


def test_dry_run(command_line, make_survey, tmp_path):
    survey = make_survey(speed=10, stop=60)  # 600,000 pulse indices
    before = sorted(tmp_path.rglob("*"))
    done = command_line("run", survey, "--dry-run", "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    assert sorted(tmp_path.rglob("*")) == before
    for line in (r"legs +leg +start", r"points   [\d,]+\n", r"files    [\d.]+ MB\n"):
        assert re.search(line, done.stdout), done.stdout
    assert re.search(r"memory   [\d.]+ [MG]B\ntime     [\d.]+ (s|min) with \d+ thread", done.stdout)
    assert "nothing was written" in done.stdout

    done = command_line("run", survey, "--dry-run", "--json", "--output", tmp_path / "out")
    estimate = json.loads(done.stdout)
    assert estimate["totals"]["pulsesSampled"] < 0.6 * estimate["totals"]["pulses"]
    assert estimate["memory_bytes"] > 1e7 and estimate["run_s"] > 0 and estimate["load_s"] >= 0
    assert command_line("run", survey, "--output", tmp_path / "out").returncode == 0
    files = [path for path in (tmp_path / "out/plane").iterdir() if path.suffix != ".json"]
    assert estimate["totals"]["bytes"] == pytest.approx(
        sum(path.stat().st_size for path in files), rel=0.05
    )
    report = json.loads((tmp_path / "out/plane/run_summary.json").read_text())
    assert estimate["totals"]["pulses"] == report["totals"]["pulses"] == 600_000
    assert estimate["totals"]["points"] == pytest.approx(report["totals"]["points"], rel=0.05)


def test_summary(command_line, make_survey, tmp_path):
    survey = make_survey()
    done = command_line("run", survey, "--output", tmp_path / "out", "--json", "--seed", 7)
    assert done.returncode == 0, done.stderr
    report = json.loads(done.stdout)
    folder = tmp_path / "out/plane"
    assert report == json.loads((folder / "run_summary.json").read_text())
    assert report["versions"]["vtkHelios"] == vtkhelios.__version__
    digests = {pathlib.Path(entry["file"]).name: entry["sha256"] for entry in report["inputs"]}
    for name in ("survey.xml", "scene.xml", "plane.obj"):
        assert digests[name] == hashlib.sha256((tmp_path / name).read_bytes()).hexdigest()
    assert {"scanners.xml", "platforms.xml"} <= digests.keys()
    assert report["options"]["seed"] == 7 and report["options"]["noise"]
    (leg,) = report["legs"]
    assert leg["pulsesFired"] == report["totals"]["pulsesFired"] == PULSES
    for file in leg["files"]:
        assert (folder / file["name"]).stat().st_size == file["bytes"]
    assert leg["files"][0]["records"] == leg["points"] == report["totals"]["points"]
    assert report["timings"].keys() == {"load_s", "run_s", "legs_s", "accuracy_s", "threads"}
    again = command_line(
        "run",
        survey,
        "--output",
        tmp_path / "out",
        "--overwrite",
        "--seed",
        7,
        "--threads",
        1,
        "--verbose",
    )
    assert "ray caster" in again.stdout and "run_summary.json" in again.stdout
    timings = report.pop("timings")
    other = json.loads((folder / "run_summary.json").read_text())
    assert other.pop("timings")["threads"] == 1 and timings["run_s"] > 0
    assert other == report


def test_memory_does_not_grow_with_the_pulses(make_survey, tmp_path):
    def peak(speed):
        survey = make_survey(speed=speed, stop=60)
        child = start(survey, tmp_path / f"out{speed}", more=["--pulses-per-block", "32768"])
        _, code, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(code)
        assert child.returncode == 0
        return usage.ru_maxrss

    assert peak(speed=2) < 1.05 * peak(speed=16)  # 8 times the pulses: 3 million indices


def test_seed_and_threads(command_line, make_survey, tmp_path):
    survey = make_survey()

    def run(*arguments):
        assert (
            command_line(
                "run", survey, "--output", tmp_path / "out", "--overwrite", *arguments
            ).returncode
            == 0
        )
        return (tmp_path / "out/plane/leg000_points.xyz").read_bytes()

    assert run("--threads", 1) == run("--threads", 2)
    assert run("--seed", 1) != run("--seed", 2)
    assert run("--seed", 1, "--no-noise") == run("--seed", 2, "--no-noise")


def test_scan_flags_are_two_more_columns(command_line, make_survey, tmp_path):
    survey, found = make_survey(), {}
    text = survey.read_text().replace('verticalAngleMax_deg="60"', 'verticalAngleMax_deg="-10"')
    survey.write_text(text)  # all lines end on the ground
    for name, *options in (("plain",), ("flags", "--scan-flags")):
        words = ["run", survey, "--output", tmp_path / name, "--quiet", *options]
        assert command_line(*words).returncode == 0
        found[name] = (tmp_path / name / "plane/leg000_points.xyz").read_text().splitlines()
    assert [line.rsplit(" ", 2)[0] for line in found["flags"]] == found["plain"]
    flags = {tuple(line.split()[-2:]) for line in found["flags"]}
    assert flags == {("1", "0"), ("1", "1")}  # a polygon
    from vtkhelios import formats

    with formats.open_reader(tmp_path / "flags/plane/leg000_points.xyz") as reader:
        chunk = next(reader.chunks())
    assert not reader.notes
    assert chunk["EdgeOfFlightLine"].sum() == sum(line.endswith(" 1") for line in found["flags"])


def test_waveforms_in_points_needs_las_and_waveforms(command_line, make_survey, tmp_path):
    done = command_line("run", make_survey(), "--waveforms-in-points", "--waveforms")
    assert done.returncode == 2
    assert (
        "--waveforms-in-points needs --format las or laz, and --waveforms: give all three"
        in done.stderr
    )


def test_waveforms(command_line, make_survey, tmp_path):
    done = command_line("run", make_survey(), "--output", tmp_path / "out", "--waveforms")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out/plane/leg000_fullwave.txt").stat().st_size > 0


def test_sampling(command_line, make_survey, tmp_path):
    def run(*arguments):
        output = tmp_path / "out"
        done = command_line("run", make_survey(), "--output", output, "--overwrite", *arguments)
        assert done.returncode == 0, done.stderr
        return done.stdout

    tolerant = run("--range-tolerance", "0.001")
    assert "sampling adaptive, visible areas of surfaces\n" in tolerant
    assert re.search(rf"pulses   {PULSES:,} emitted, [\d,]+ with an echo \([\d.]+ %\)\n", tolerant)
    assert "planar" not in tolerant and "ray caster" not in tolerant
    fixed = run("--sub-rays", "7", "--verbose")
    assert "sampling fixed, 7 sub-rays per pulse" in fixed and "ray caster beam\n" in fixed
    assert re.search(r"[\d,]+ with a binned waveform.*; 7\.0 sub-rays per pulse", fixed)
    tolerant = run("--range-tolerance", "0.001", "--verbose")
    assert re.search(r"[\d,]+ with a planar footprint", tolerant) and "; waveform bin " in tolerant


def test_pulses_beyond_the_most_sub_rays_are_told(command_line, make_survey, tmp_path):
    survey = make_survey(stop=2)
    corners, faces = [], []
    for i in range(8000):  # fins of 0.05 mm at alternating depths fill the beams
        x, y = 5e-5 * (i - 4000), 10 + 0.4 * (i % 3)
        corners += [f"v {x:.6f} {y} -9", f"v {x + 5e-5:.6f} {y} -9", f"v {x:.6f} {y} 9"]
        faces.append(" ".join(str(3 * i + k) for k in (1, 2, 3)))
    (tmp_path / "plane.obj").write_text("\n".join(corners + [f"f {face}" for face in faces]))
    text = survey.read_text()
    survey.write_text(text.replace("<survey ", '<survey rangeTolerance_m="0.000001" ', 1))
    done = command_line(
        *("run", survey, "--output", tmp_path / "out", "--max-sub-rays", 1024, "--json"),
    )
    assert done.returncode == 0, done.stderr
    totals = json.loads(done.stdout)["totals"]
    assert 0 < totals["pulsesUnresolved"] <= totals["pulsesSampled"] <= totals["pulsesFired"]
    lines = "\n".join(unresolved_lines(totals))
    assert f"{totals['pulsesUnresolved']:,} of them" in lines and "give --max-sub-rays" in lines
    assert list(unresolved_lines({"pulsesFired": 5})) == []


def test_vtp(command_line, make_survey, tmp_path):
    done = command_line("run", make_survey(), "--output", tmp_path / "out", "--format", "vtp")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out/plane/leg000_points.pvtp").is_file()
    reader = vtkXMLPPolyDataReader()  # an independent one: VTK's own
    reader.SetFileName(str(tmp_path / "out/plane/leg000_trajectory.pvtp"))
    reader.Update()
    trajectory = reader.GetOutput()
    assert trajectory.GetNumberOfPoints() > 0
    assert trajectory.GetPointData().GetArray("GpsTime").GetValue(0) == 0.0
    assert trajectory.GetPointData().GetArray("Orientation").GetNumberOfComponents() == 4
    assert not (tmp_path / "out/plane/leg000_trajectory.txt").exists()


def test_output_of_a_closed_pipe(make_survey, tmp_path):
    command = (
        f"{sys.executable} -P -m vtkhelios run {make_survey()} --output {tmp_path / 'out'} | true"
    )
    environment = {**os.environ, "PYTHONPATH": ":".join(sys.path)}
    done = subprocess.run(command, shell=True, capture_output=True, text=True, env=environment)
    assert "Traceback" not in done.stderr and "Exception" not in done.stderr


def test_columns_are_written_as_vtp(command_line, make_survey, tmp_path):
    survey = make_survey(stop=2)
    text = survey.read_text().replace("scanners.xml#vz400_class_tls", "scanners.xml#velodyne_vlp16")
    text = text.replace('pulseFreq_hz="100000"', "").replace(
        'scanFreq_hz="100"', 'scanFreq_hz="10" maxDuration_s="0.1"'
    )
    survey.write_text(re.sub(r'(verticalAngle|headRotate)\w+="[^"]*"', "", text))
    done = command_line("run", survey, "--columns", "--output", tmp_path / "text")
    assert done.returncode == 2
    assert (
        "--columns needs --format vtp: files of the format xyz cannot have columns" in done.stderr
    )
    options = "--columns", "--pulses", "--format", "vtp", "--output", tmp_path / "vtp"
    done = command_line("run", survey, *options)
    assert done.returncode == 0, done.stderr
    for name in ("points", "pulse"):
        reader = vtkXMLPPolyDataReader()
        reader.SetFileName(str(next((tmp_path / "vtp").rglob(f"*_{name}.pvtp"))))
        reader.Update()
        arrays = vtkhelios.arrays(reader.GetOutput())
        assert np.array_equal(arrays["ColumnIds"], arrays["PulseIds"] // 16), name


def test_truth_is_written_as_vtp(command_line, make_survey, tmp_path):
    survey = make_survey(stop=2)
    done = command_line("run", survey, "--truth", "--output", tmp_path / "text")
    assert done.returncode == 2
    assert "--truth needs --format vtp: files of the format xyz cannot have points" in done.stderr
    options = "--truth", "--format", "vtp", "--output", tmp_path / "vtp"
    done = command_line("run", survey, *options)
    assert done.returncode == 0, done.stderr
    reader = vtkXMLPPolyDataReader()
    reader.SetFileName(str(next((tmp_path / "vtp").rglob("*_points.pvtp"))))
    reader.Update()
    arrays = vtkhelios.arrays(reader.GetOutput())
    assert np.abs(arrays["TruePoint"][:, 2]).max() < 1e-3
    assert np.allclose(arrays["Normal"], [0, 0, 1])
