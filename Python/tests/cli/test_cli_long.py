# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line: runs that are long, interrupted, or have several epochs."""

import contextlib
import json
import os
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

import vtkhelios
from vtkhelios import _native
from vtkhelios.core.start import is_command
from vtkhelios.cli._messages import Messages
from vtkhelios.core.reading import make_reader
from vtkhelios.cli.run import run_epoch

from _command_line import PULSES, expect_failure, start

LONG = dict(speed=0.01, stop=60)  # 600 million pulses: longer than any test


def wait_for_points(output, seconds=60):
    """Waits for written output."""
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
    assert re.search(rb"pulses, [\d.,]+( M)? pulses/s.*points.*left", shown, re.S)


def test_progress_elsewhere_is_lines(make_survey, tmp_path):
    run = start(
        make_survey(**LONG),
        tmp_path / "out",
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    lines = iter(run.stderr.readline, "")
    line = next(each for each in lines if not each.startswith("price  "))
    run.send_signal(signal.SIGINT)
    run.communicate(timeout=60)
    assert re.match(
        r" *\d+ % leg 1 of 1, [\d.,]+( M)? pulses, [\d.,]+( M)? pulses/s, "
        r"[\d,]+ points, \d+:\d\d left\n",
        line,
    )


# A survey with several epochs.

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
def make_epochs(make_survey):
    def make(**how):
        survey = make_survey(**how)
        (survey.parent / "scene.xml").write_text(SWAPS)
        return survey

    return make


def height(folder):
    rows = np.loadtxt(folder / "leg000_points.xyz", usecols=(0, 1, 2), max_rows=5000)
    return np.median(rows[np.hypot(rows[:, 0], rows[:, 1]) < 20, 2])


def test_epochs(command_line, make_epochs, tmp_path):
    survey, folder = make_epochs(), tmp_path / "out/plane"
    arguments = ["run", survey, "--output", tmp_path / "out", "--no-noise"]
    alone = command_line(*arguments, "--epoch", 2)
    assert alone.returncode == 0, alone.stderr
    assert [path.name for path in folder.iterdir()] == ["epoch002"]
    only = (folder / "epoch002/leg000_points.xyz").read_bytes()
    done = command_line(*arguments)
    expect_failure(done, "epoch002: holds the files of an earlier run.*--resume.*--overwrite")
    assert [path.name for path in folder.iterdir()] == [
        "epoch002"
    ]  # reported before the first epoch
    expect_failure(
        command_line(*arguments, "--epoch", 3), "Epoch is 3, but the survey has 3 epochs"
    )

    done = command_line(*arguments, "--overwrite")
    assert done.returncode == 0, done.stderr
    for epoch in range(3):
        assert f"epoch    {epoch} of 3, counted from 0\n" in done.stdout
        assert height(folder / f"epoch00{epoch}") == pytest.approx(HEIGHTS[epoch], abs=1e-3)
    assert (folder / "epoch002/leg000_points.xyz").read_bytes() == only
    assert f"epochs   3, of the same legs\npulses   {3 * PULSES:,}\n" in done.stdout

    done = command_line(*arguments, "--resume", "--json")  # nothing is left to do
    report = json.loads(done.stdout)
    assert [each["epoch"] for each in report["epochs"]] == [0, 1, 2]
    assert [each["options"]["epoch"] for each in report["epochs"]] == [0, 1, 2]
    assert report["totals"]["pulsesFired"] == 3 * PULSES
    points = sum(each["totals"]["points"] for each in report["epochs"])
    assert report["totals"]["points"] == points > 0


def test_survey_runs_the_given_epoch(make_epochs):
    survey = vtkhelios.read_survey(make_epochs())
    for epoch, expected in enumerate(HEIGHTS):
        points = survey.run(noise=False, epoch=epoch).points
        near = np.hypot(points[:, 0], points[:, 1]) < 20
        assert np.median(points[near, 2]) == pytest.approx(expected, abs=1e-3)
    with pytest.raises(vtkhelios.PipelineError, match="Epoch is 3, but the survey has 3 epochs"):
        survey.run(epoch=3)


def test_dry_run_of_epochs(command_line, make_epochs, tmp_path):
    arguments = ["run", make_epochs(), "--dry-run", "--output", tmp_path / "out"]
    done = command_line(*arguments)
    assert done.returncode == 0, done.stderr
    assert re.search(
        rf"epochs   3.*\npulses   {3 * PULSES:,}\npoints .*\nfiles .*\nmemory", done.stdout
    )
    report = json.loads(command_line(*arguments, "--json").stdout)
    assert report["totals"]["pulsesFired"] == 3 * PULSES
    assert report["memory_bytes"] == max(each["memory_bytes"] for each in report["epochs"])
    assert report["timings"]["run_s"] == pytest.approx(sum(e["run_s"] for e in report["epochs"]))
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGINT])
def test_interrupted_epochs(number, command_line, make_epochs, tmp_path):
    survey = make_epochs(speed=8, stop=120)  # 1,500,000 pulse indices per epoch
    more = ["--pulses-per-block", "2048"]
    folder = tmp_path / "out/plane"
    for _ in range(10):  # on a busy machine an epoch may end before the signal arrives
        shutil.rmtree(tmp_path / "out", ignore_errors=True)
        run = start(survey, tmp_path / "out", more, stderr=subprocess.PIPE, text=True)
        until = time.monotonic() + 60
        while not list(folder.glob("epoch001/*points*")) and time.monotonic() < until:
            time.sleep(0.01)
        wait_for_points(folder / "epoch001")
        run.send_signal(number)
        _, errors = run.communicate(timeout=60)
        if (folder / "epoch001/run.journal").exists() and not (folder / "epoch002").exists():
            break
    assert run.returncode == (-9 if number == signal.SIGKILL else 130), errors
    assert (folder / "epoch001/run.journal").exists() and not (folder / "epoch002").exists()

    done = command_line("run", survey, "--output", tmp_path / "out", "--resume", *more)
    assert done.returncode == 0, done.stderr
    assert "Nothing is left to do" in done.stdout  # run of the first epoch
    whole = command_line("run", survey, "--output", tmp_path / "whole", "--epoch", 1, *more)
    assert whole.returncode == 0, whole.stderr
    name = "plane/epoch001/leg000_points.xyz"
    assert (tmp_path / "out" / name).read_bytes() == (tmp_path / "whole" / name).read_bytes()
    assert height(folder / "epoch002") == pytest.approx(HEIGHTS[2], abs=0.02)  # was started


def test_interrupt_between_epochs(make_epochs, capsys):
    with Messages() as messages:
        request = types.SimpleNamespace(signal=signal.SIGINT)
        assert run_epoch(None, None, 2, messages, request, []) == 130
    assert "interrupted before epoch 2: --resume continues with it" in capsys.readouterr().err


# Signals before anything is written.


def open_files(pid):
    """Names of the files that a process has open; some close while they are listed."""
    for entry in os.scandir(f"/proc/{pid}/fd"):
        with contextlib.suppress(FileNotFoundError):
            yield os.readlink(entry.path)


def start_loading(make_survey, tmp_path):
    """A run of a survey whose scene is slow to read, while it reads."""
    survey = make_survey(**LONG)
    with open(tmp_path / "plane.obj", "ab") as file:
        for _ in range(600):  # reads for many seconds, with little memory
            file.write(b"vn 0.123456789 0.234567891 0.345678912\n" * 25_000)
    run = start(survey, tmp_path / "out", stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    until = time.monotonic() + 60
    while time.monotonic() < until:
        if any(name.endswith("plane.obj") for name in open_files(run.pid)):
            return run
        time.sleep(0.01)
    raise AssertionError("the scene was not opened")


@pytest.mark.parametrize("number, code", [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_interrupt_while_the_scene_is_read(number, code, make_survey, tmp_path):
    run = start_loading(make_survey, tmp_path)
    begin = time.monotonic()
    run.send_signal(number)
    _, errors = run.communicate(timeout=60)
    assert run.returncode == code
    assert time.monotonic() - begin < 2.0  # all of it takes longer
    assert "interrupted at 0 %: no points yet" in errors.decode()
    assert "reading was aborted" not in errors.decode()
    assert not list((tmp_path / "out").rglob("*points*"))


def test_reading_stops_before_the_end_of_a_file(make_survey, tmp_path):
    """A run stopped within a file reports nothing about the file."""
    survey = make_survey()
    with open(tmp_path / "plane.obj", "ab") as file:
        file.write(b"vn 0.123456789 0.234567891 0.345678912\n" * 5_000_000)
    reader = make_reader(str(survey), [])
    assert reader.Read()
    player = vtkhelios.vtkHeliosSurveyPlayer()
    player.SetSurvey(reader.GetSurvey())
    player.SetOutputDirectory(str(tmp_path / "out"))
    told, errors = [], []

    def stop_at_second(*_):
        told.append(player.GetMessage())
        if told[-2:] == [f"reading {tmp_path / 'plane.obj'}"] * 2:  # within the file
            player.Abort()

    player.AddObserver("ProgressEvent", stop_at_second)
    player.AddObserver("ErrorEvent", lambda *_: errors.append(1))
    assert not player.Run()
    assert told[-1].startswith("reading ")
    assert player.GetMessage() == "Stopped while the scene was loaded; nothing was written."
    assert not errors and not list((tmp_path / "out").rglob("*points*"))


DEAF = """
from vtkhelios.cli._stopping import Stopping, set_outcome
from vtkhelios.core.unfinished import set_unfinished
with Stopping():
    set_outcome("a.txt was not written")
    set_unfinished("a.txt.part")
    open("a.txt.part", "w").close()
    print("ready", flush=True)
    sum(range(10**12))  # Python's handlers do not run meanwhile
"""


@pytest.fixture
def deaf(tmp_path):
    """A process that does not respond to signals, and has an unfinished file."""
    process = subprocess.Popen(
        [sys.executable, "-c", DEAF], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}, cwd=tmp_path,
    )  # fmt: skip
    assert process.stdout.readline() == "ready\n"
    assert (tmp_path / "a.txt.part").exists()
    time.sleep(0.5)  # until it sums
    yield process
    process.kill()
    process.communicate()


def check_end(process, number, folder):
    _, errors = process.communicate(timeout=20)
    assert process.returncode == 128 + number
    assert errors == "error: interrupted; a.txt was not written\n"
    assert list(folder.iterdir()) == []


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_what_does_not_respond(deaf, number, tmp_path):
    deaf.send_signal(number)
    with pytest.raises(subprocess.TimeoutExpired):
        deaf.wait(timeout=0.1)
    check_end(deaf, number, tmp_path)


@pytest.mark.parametrize("first", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("second", [signal.SIGINT, signal.SIGTERM])
def test_a_second_signal_ends_at_once(deaf, first, second, tmp_path):
    deaf.send_signal(first)
    time.sleep(0.1)
    deaf.send_signal(second)
    check_end(deaf, second, tmp_path)


@pytest.mark.parametrize(
    "arguments, error, message",
    [
        (([70], 1.0), ValueError, "70 is not a signal number"),
        (([0], 1.0), ValueError, "0 is not a signal number"),
        (([signal.SIGINT], -1.0), ValueError, "seconds is not within 0 and 3600"),
        ((3, 1.0), TypeError, "signals is not a sequence of signal numbers"),
        ((["x"], 1.0), TypeError, "integer"),
        (([signal.SIGKILL], 1.0), OSError, "Invalid argument"),
    ],
)
def test_end_after_is_checked(arguments, error, message):
    with pytest.raises(error, match=message):
        _native.end_after(*arguments)


@pytest.mark.parametrize(
    "argv, words, expected",
    [
        (["-m"], ["python3", "-P", "-m", "vtkhelios", "run"], True),
        (["-m"], ["python3", "-m", "pytest"], False),
        (["/usr/bin/vtkhelios", "run"], ["python3", "/usr/bin/vtkhelios", "run"], True),
        (["/home/a/script.py"], ["python3", "/home/a/script.py"], False),
        ([], [], False),
    ],
)
def test_who_is_the_command(argv, words, expected):
    assert is_command(argv, words) is expected
