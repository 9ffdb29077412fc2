# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line: parts of a run, and vtkhelios join."""

import hashlib
import json
import shutil
import signal

import pytest

import vtkhelios
from vtkhelios.core.reading import make_reader
from vtkhelios.reports.run import epochs_lines, join_reports
from vtkhelios.cli.join import read_part

from _command_line import expect_failure, start

OPTIONS = ["--waveforms", "--pulses", "--pulses-per-block", "3000", "--seed", "7"]


def digests(folder):
    """The SHA-256 of every file of a run; the summary's without its timings."""
    found = {}
    for path in sorted(path for path in folder.iterdir() if path.is_file()):
        data = path.read_bytes()
        if path.name == "run_summary.json":
            summary = json.loads(data)
            del summary["timings"]
            data = json.dumps(summary).encode()
        found[path.name] = hashlib.sha256(data).hexdigest()
    return found


@pytest.fixture
def run_parts(command_line, make_survey, tmp_path):
    """Runs a survey whole and in parts; relative names, from its own folder."""
    make_survey()

    def run(count, *options):
        runs = [["--output", "whole"], *(["--part", f"{k}/{count}"] for k in range(1, count + 1))]
        for more in runs:
            done = command_line("run", "survey.xml", *OPTIONS, *options, *more, cwd=tmp_path)
            assert done.returncode == 0, done
        return tmp_path / "output/plane"

    return run


@pytest.mark.parametrize("kind", ["xyz", "las", "vtp"])
def test_joined_parts_are_the_run(kind, run_parts, command_line, tmp_path):
    parts = run_parts(3, "--format", kind)
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    done = command_line("join", parts, "--json", "--output", "joined", cwd=elsewhere)
    assert done.returncode == 0, done
    report = json.loads(done.stdout)
    assert "accuracy" in report and "part" not in report
    # the names of the inputs are those that this process reads
    here = command_line("join", "output/plane", cwd=tmp_path)
    assert here.returncode == 0 and "points" in here.stdout, here
    whole = digests(tmp_path / "whole/plane")
    assert len(whole) > 4
    assert digests(parts) == whole
    joined = digests(elsewhere / "joined/plane")
    assert {**joined, "run_summary.json": whole["run_summary.json"]} == whole


def test_the_time_is_that_of_the_parts(run_parts, command_line, tmp_path):
    """join computes nothing: no rates of it, in the terminal and on the report page."""
    parts = run_parts(2)
    done = command_line("join", parts, cwd=tmp_path)
    timings = json.loads((parts / "run_summary.json").read_text())["timings"]
    spent = [
        json.loads((parts / name / "run_summary.json").read_text())["timings"]["run_s"]
        for name in ("part001of002", "part002of002")
    ]
    assert timings["parts_s"] == pytest.approx(sum(spent))
    assert f"time     {sum(spent):.2f} s in the parts, " in done.stdout
    assert "pulses/s" not in done.stdout.split("time ")[1]
    pytest.importorskip("matplotlib")
    assert command_line("report", parts, "--cloud-points", "0").returncode == 0
    page = (parts / "report.html").read_text()
    assert "run time of the parts" in page and "pulses/s" not in page and "in parts" in page
    legs = {"points": 1, "pulses": 1, "pulsesFired": 1}
    both = join_reports([0, 1], [{"totals": legs, "timings": timings}] * 2)
    assert any(f"{2 * sum(spent):.2f} s in the parts" in line for line in epochs_lines(both))


def test_a_killed_part_is_resumed(run_parts, command_line, make_survey, tmp_path):
    parts = run_parts(2)
    more = [*OPTIONS, "--part", "2/2"]
    shutil.rmtree(parts / "part002of002")
    run = start("survey.xml", "output", [*more, "--pulses-per-block", "500"], cwd=tmp_path)
    journal = parts / "part002of002/run.journal"
    while run.poll() is None and not (journal.exists() and journal.read_bytes().count(b"\n") > 3):
        pass
    run.send_signal(signal.SIGKILL)
    run.wait()
    shutil.rmtree(parts / "part001of002")
    small = [*OPTIONS, "--pulses-per-block", "500", "--resume"]
    for part in ("1/2", "2/2"):  # the first one starts
        done = command_line("run", "survey.xml", *small, "--part", part, cwd=tmp_path)
        assert done.returncode == 0, done
    assert command_line("join", "output/plane", cwd=tmp_path).returncode == 0
    found, whole = digests(parts), digests(tmp_path / "whole/plane")
    assert {**found, "run_summary.json": ""} == {**whole, "run_summary.json": ""}


def test_finished_parts_and_runs_are_left_as_they_are(run_parts, command_line, tmp_path):
    parts = run_parts(2)
    part = command_line("run", "survey.xml", *OPTIONS, "--part", "1/2", "--resume", cwd=tmp_path)
    assert part.returncode == 0 and "Nothing is left to do" in part.stdout, part
    first = command_line("join", "output/plane", cwd=tmp_path)
    assert first.returncode == 0, first
    expect_failure(
        command_line("join", "output/plane", cwd=tmp_path), "holds the files of an earlier"
    )
    again = command_line("join", "output/plane", "--resume", cwd=tmp_path)
    assert again.returncode == 0 and "Nothing is left to do" in again.stdout, again
    info = command_line("info", parts / "part001of002")
    assert info.returncode == 0, info


def test_parts_of_epochs(command_line, make_survey, tmp_path):
    make_survey()
    scene = (tmp_path / "scene.xml").read_text()
    swap = '<swap><filter type="translate"><param type="vec3" key="offset" value="0;0;1"/></filter></swap>'
    (tmp_path / "scene.xml").write_text(scene.replace("</part>", f"{swap}</part>"))
    for more in (["--output", "whole"], ["--part", "1/2"], ["--part", "2/2"]):
        done = command_line("run", "survey.xml", *OPTIONS, *more, cwd=tmp_path)
        assert done.returncode == 0, done
    done = command_line("join", "output/plane", "--json", cwd=tmp_path)
    assert done.returncode == 0, done
    assert len(json.loads(done.stdout)["epochs"]) == 2
    for epoch in ("epoch000", "epoch001"):
        assert digests(tmp_path / "output/plane" / epoch) == digests(
            tmp_path / "whole/plane" / epoch
        )


def test_survey_that_was_moved(run_parts, command_line, tmp_path):
    run_parts(1)
    here = tmp_path / "here"
    here.mkdir()
    for name in ("survey.xml", "scene.xml", "plane.obj"):
        shutil.move(tmp_path / name, here / name)
    parts = tmp_path / "output/plane/part001of001"
    expect_failure(command_line("join", parts), r"survey.xml: no such file; give .* by --survey")
    done = command_line("join", parts, "--survey", here / "survey.xml", "--assets", here)
    assert done.returncode == 0, done


def test_parts_that_cannot_be_joined(run_parts, command_line, tmp_path):
    parts = run_parts(2)
    expect_failure(
        command_line("join", tmp_path / "x"), "x: has no parts of a run; give the folders"
    )
    expect_failure(
        command_line("join", parts / "part002of002"), "part 1/2 is missing; give all folders"
    )
    shutil.copytree(parts / "part001of002", tmp_path / "copy/part001of002")
    both = [parts / "part002of002", tmp_path / "copy/part001of002"]
    expect_failure(
        command_line("join", *both), r"the parts are in several folders .*; give --output"
    )
    assert command_line("join", *both, "--output", tmp_path / "joined").returncode == 0
    journal = parts / "part001of002/run.journal"
    journal.write_text("{}\n")
    expect_failure(command_line("join", parts), "run.journal: is not the journal of a part; run it")
    journal.unlink()
    expect_failure(command_line("join", parts), "run.journal: cannot be read: No such file")


def test_part_of_another_program(make_survey, command_line, tmp_path):
    reader = make_reader(str(make_survey()), [])
    assert reader.Read()
    player = vtkhelios.vtkHeliosSurveyPlayer(
        survey=reader.GetSurvey(), output_directory=str(tmp_path / "out"), number_of_parts=1
    )
    assert player.Run()
    part = tmp_path / "out/plane/part001of001"
    assert read_part(part)["part"] == {"number": 1, "count": 1, "command": ""}
    expect_failure(command_line("join", part), "was not run by the command line; join it with")


@pytest.mark.parametrize(
    "command, message",
    [
        (["run", "survey.xml", "--part", "3/2"], "'3/2' is not a part; expected K/N with K from 1"),
        (["run", "survey.xml", "--part", "0/2"], "'0/2' is not a part"),
        (["run", "survey.xml", "--part", "2"], "'2' is not a part"),
        (["run", "survey.xml", "--part", "1/2", "--dry-run"], "--dry-run estimates the whole run"),
        (["join", "x", "--check-all"], "--check-all needs --resume: give both"),
    ],
)
def test_wrong_usage(command, message, command_line):
    done = command_line(*command)
    assert done.returncode == 2 and message in done.stderr, done
    assert "Traceback" not in done.stderr
