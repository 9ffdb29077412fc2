# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line: what it says, what it writes, how it exits."""

import hashlib
import json
import os
import pathlib
import pty
import re
import shutil
import signal
import subprocess
import sys
import time
import types

import numpy as np
import pytest
from vtkmodules.vtkIOXML import vtkXMLPPolyDataReader

import vtkhelios

from vtkhelios.cli import main, make_parser
from vtkhelios.cli._messages import Messages
from vtkhelios.cli.run import run_play

PULSES = 20_850  # 0.5 s at 100 kHz, of which the mirror lets out 100 of 240 degrees
LONG = dict(speed=0.01, stop=60)  # 600 million pulses: longer than any test waits


# What is typed wrong.


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["run", "s.xml", "--sed", "3"], "unknown option --sed: did you mean --seed?"),
        (["run", "s.xml", "--asset=x"], "unknown option --asset: did you mean --assets?"),
        (["run", "--xyzzy"], "unknown option --xyzzy: vtkhelios run --help lists the known ones"),
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
        (["run", "s.xml", "--format", "pcd"], "unknown 'pcd': known: xyz, las, vtp"),
        (["run", "s.xml", "--range-tolerance", "0"], "'0' is not a number from 1e-06 to 1"),
        (["run", "s.xml", "--energy-tolerance", "nan"], "'nan' is not a number from 0.0001 to 1"),
        (["run", "s.xml", "--sub-rays", "many"], "'many' is not a whole number from 0 to 65536"),
        (["run", "s.xml", "--detector", "gaus"], "unknown 'gaus': did you mean gaussian?"),
        (["run", "s.xml", "--play", "first"], "'first' is not a whole number from 0 to 2147483647"),
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


def test_sub_rays_or_a_tolerance(capsys):
    assert main(["run", "s.xml", "--sub-rays", "7", "--range-tolerance", "0.01"]) == 2
    assert "--sub-rays is always that many" in capsys.readouterr().err


def test_no_command_shows_help(capsys):
    assert main([]) == 2
    assert "examples:" in capsys.readouterr().err


def test_version(command_line):
    done = command_line("--version")
    assert (done.returncode, done.stdout) == (0, f"vtkhelios {vtkhelios.__version__}\n")


def test_help_teaches(command_line):
    done = command_line("run", "--help")
    assert done.returncode == 0
    for word in (
        "examples:",
        "exit codes:",
        "[nW]",
        "--assets DIR",
        "default: 0",
        "how the beam",
        "how a run survives",
        "how long it will take",
        "run_summary.json",
    ):
        assert word in done.stdout


def test_every_command_has_a_summary():
    parser = make_parser()
    assert "run a survey" in parser.format_help()


# What goes wrong.


def expect_failure(done, message):
    assert done.returncode == 1, done
    assert re.search(message, done.stderr), done.stderr
    assert done.stderr.startswith("error: ") or "\nerror: " in done.stderr
    assert "Traceback" not in done.stderr and "0x" not in done.stderr


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


def test_earlier_run_is_kept(command_line, make_survey, tmp_path):
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


# What a run writes and says.


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
    near = np.hypot(rows[:, 0], rows[:, 1]) < 30  # far away the beam grazes the plane
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
    assert re.search(r"memory   [\d.]+ [MG]B\ntime     \d+:\d\d \([\d.]+ minutes\)", done.stdout)
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
    assert report["timings"].keys() == {"load_s", "run_s", "legs_s", "threads"}
    again = command_line(
        "run", survey, "--output", tmp_path / "out", "--overwrite", "--seed", 7, "--threads", 1
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
    assert re.search(rf"pulses   {PULSES:,}: [\d,]+ on one plane", tolerant)
    fixed = run("--sub-rays", "7")
    assert "sub-rays 7 sub-rays a pulse, always" in fixed
    assert re.search(r"[\d,]+ binned.*; 7\.0 rays a pulse", fixed)


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


# A run that takes its time.


def start(survey, output, more=(), **options):
    environment = {**os.environ, "PYTHONPATH": ":".join(sys.path)}
    return subprocess.Popen(
        [
            sys.executable,
            "-P",
            "-m",
            "vtkhelios",
            "run",
            str(survey),
            "--output",
            str(output),
            *more,
        ],
        env=environment,
        **options,
    )


def wait_for_points(output, seconds=60):
    """Waits until something was written."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        if any(path.stat().st_size > 100_000 for path in output.rglob("*points*")):
            return
        time.sleep(0.05)
    raise AssertionError("nothing was written")


@pytest.mark.parametrize("number, code", [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_interrupt_keeps_valid_files(number, code, make_survey, tmp_path):
    run = start(
        make_survey(**LONG),
        tmp_path / "out",
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    wait_for_points(tmp_path / "out")
    run.send_signal(number)
    _, errors = run.communicate(timeout=60)
    assert run.returncode == code
    assert "interrupted at" in errors and "are kept in" in errors and "Traceback" not in errors
    cloud = next((tmp_path / "out/plane").glob("leg000_points.xyz*"))
    lines = cloud.read_text().splitlines()
    kept = int(re.search(r"the ([\d,]+) points", errors).group(1).replace(",", ""))
    assert len(lines) == kept
    assert all(len(line.split()) == 11 for line in (lines[0], lines[-1]))


# A survey that is played several times.

SWAPS = """\
<document>
  <scene id="plane">
    <part id="ground">
      <filter type="objloader"><param type="string" key="filepath" value="plane.obj"/></filter>
      <swap>
        <filter type="translate"><param type="vec3" key="offset" value="0;0;-1"/></filter>
      </swap>
      <swap>
        <filter type="translate"><param type="vec3" key="offset" value="0;0;0.5"/></filter>
      </swap>
    </part>
  </scene>
</document>
"""
HEIGHTS = [0.0, -1.0, 0.5]


@pytest.fixture
def make_plays(make_survey):
    def make(**how):
        survey = make_survey(**how)
        (survey.parent / "scene.xml").write_text(SWAPS)
        return survey

    return make


def height(folder):
    rows = np.loadtxt(folder / "leg000_points.xyz", usecols=(0, 1, 2), max_rows=5000)
    return np.median(rows[np.hypot(rows[:, 0], rows[:, 1]) < 20, 2])


def test_plays(command_line, make_plays, tmp_path):
    survey, folder = make_plays(), tmp_path / "out/plane"
    arguments = ["run", survey, "--output", tmp_path / "out", "--no-noise"]
    alone = command_line(*arguments, "--play", 2)
    assert alone.returncode == 0, alone.stderr
    assert [path.name for path in folder.iterdir()] == ["play002"]
    only = (folder / "play002/leg000_points.xyz").read_bytes()
    done = command_line(*arguments)
    expect_failure(done, "play002: holds the files of an earlier run.*--resume.*--overwrite")
    assert [path.name for path in folder.iterdir()] == ["play002"]  # said before the first play
    expect_failure(command_line(*arguments, "--play", 3), "Play is 3, and the survey has 3 plays")

    done = command_line(*arguments, "--overwrite")
    assert done.returncode == 0, done.stderr
    for play in range(3):
        assert f"play     {play}, of 3 from 0\n" in done.stdout
        assert height(folder / f"play00{play}") == pytest.approx(HEIGHTS[play], abs=1e-3)
    assert (folder / "play002/leg000_points.xyz").read_bytes() == only
    assert f"plays    3, of the same legs\npulses   {3 * PULSES:,}\n" in done.stdout

    done = command_line(*arguments, "--resume", "--json")  # nothing is left to do
    report = json.loads(done.stdout)
    assert [each["play"] for each in report["plays"]] == [0, 1, 2]
    assert [each["options"]["play"] for each in report["plays"]] == [0, 1, 2]
    assert report["totals"]["pulsesFired"] == 3 * PULSES
    points = sum(each["totals"]["points"] for each in report["plays"])
    assert report["totals"]["points"] == points > 0


def test_dry_run_of_plays(command_line, make_plays, tmp_path):
    arguments = ["run", make_plays(), "--dry-run", "--output", tmp_path / "out"]
    done = command_line(*arguments)
    assert done.returncode == 0, done.stderr
    assert re.search(
        rf"plays    3.*\npulses   {3 * PULSES:,}\npoints .*\nfiles .*\nmemory", done.stdout
    )
    report = json.loads(command_line(*arguments, "--json").stdout)
    assert report["totals"]["pulsesFired"] == 3 * PULSES
    assert report["memory_bytes"] == max(each["memory_bytes"] for each in report["plays"])
    assert report["timings"]["run_s"] == pytest.approx(sum(e["run_s"] for e in report["plays"]))
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGINT])
def test_plays_that_are_broken_off(number, command_line, make_plays, tmp_path):
    survey = make_plays(speed=8, stop=60)  # 750,000 pulse indices a play
    more = ["--pulses-per-block", "4096"]
    folder = tmp_path / "out/plane"
    for _ in range(10):  # where the machine is busy a play may be over before the signal comes
        shutil.rmtree(tmp_path / "out", ignore_errors=True)
        run = start(survey, tmp_path / "out", more, stderr=subprocess.PIPE, text=True)
        until = time.monotonic() + 60
        while not list(folder.glob("play001/*points*")) and time.monotonic() < until:
            time.sleep(0.01)
        wait_for_points(folder / "play001")
        run.send_signal(number)
        _, errors = run.communicate(timeout=60)
        if not (folder / "play002").exists():
            break
    assert run.returncode == (-9 if number == signal.SIGKILL else 130), errors
    assert (folder / "play001/run.journal").exists() and not (folder / "play002").exists()

    done = command_line("run", survey, "--output", tmp_path / "out", "--resume", *more)
    assert done.returncode == 0, done.stderr
    assert "Nothing is left to do" in done.stdout  # of the first play
    whole = command_line("run", survey, "--output", tmp_path / "whole", "--play", 1, *more)
    assert whole.returncode == 0, whole.stderr
    name = "plane/play001/leg000_points.xyz"
    assert (tmp_path / "out" / name).read_bytes() == (tmp_path / "whole" / name).read_bytes()
    assert height(folder / "play002") == pytest.approx(HEIGHTS[2], abs=0.02)  # was begun


def test_interrupt_between_plays(make_plays, capsys):
    with Messages() as messages:
        interrupt = types.SimpleNamespace(signal=signal.SIGINT)
        assert run_play(None, None, 2, messages, interrupt, []) == 130
    assert "interrupted before play 2: --resume goes on with it" in capsys.readouterr().err


def test_progress_on_a_terminal(make_survey, tmp_path):
    try:
        leader, follower = pty.openpty()
    except OSError:
        pytest.skip("there are no pseudo-terminals here")
    run = start(make_survey(**LONG), tmp_path / "out", stdout=subprocess.DEVNULL, stderr=follower)
    os.close(follower)
    shown = b""
    while b"left" not in shown:
        shown += os.read(leader, 4096)
    run.send_signal(signal.SIGINT)
    assert run.wait(timeout=60) == 130
    os.close(leader)
    assert re.search(rb"M pulses/s.*points.*left", shown, re.S)


def test_progress_elsewhere_is_lines(make_survey, tmp_path):
    run = start(
        make_survey(**LONG),
        tmp_path / "out",
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    line = run.stderr.readline()
    run.send_signal(signal.SIGINT)
    run.communicate(timeout=60)
    assert re.match(
        r" *\d+ % leg 1 of 1, [\d.]+ M pulses, [\d.]+ M pulses/s, "
        r"[\d,]+ points, \d+:\d\d left\n",
        line,
    )
