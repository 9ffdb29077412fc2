# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line with closed or full standard streams: no traceback, no lost files."""

import os
import subprocess
import sys

import pytest

from vtkhelios import cli


@pytest.fixture
def shell():
    """Runs vtkhelios from a shell that redirects its streams."""

    def call(redirection, *arguments):
        words = " ".join(
            f"'{word}'" for word in [sys.executable, "-P", "-m", "vtkhelios", *arguments]
        )
        return subprocess.run(
            ["sh", "-c", f"{words} {redirection}"],
            capture_output=True,
            text=True,
            env={**os.environ, "PYTHONPATH": ":".join(sys.path)},
        )

    return call


def expect_run(folder):
    """Checks that the files of a run are complete."""
    names = {path.name for path in (folder / "plane").iterdir()}
    assert names >= {"leg000_points.xyz", "leg000_trajectory.txt", "run_summary.json"}
    assert not any(name.endswith(".part") for name in names)
    for line in (folder / "plane/leg000_points.xyz").read_text().splitlines():
        assert len([float(word) for word in line.split()]) == 11


@pytest.mark.parametrize(
    "redirection, reason",
    [
        (">/dev/full", "No space left on device"),
        (">&-", "it is closed"),
        (">&- <&-", "it is closed"),
    ],
)
@pytest.mark.parametrize("json", [False, True])
def test_no_standard_output(shell, make_survey, tmp_path, redirection, reason, json):
    out = tmp_path / "out"
    more = ["--json"] * json
    done = shell(redirection, "run", make_survey(), "--output", out, *more)
    assert done.returncode == 1
    assert done.stderr == (
        f"error: standard output: {reason}: the output is lost; "
        "the files that the command wrote are complete\n"
    )
    expect_run(out)


@pytest.mark.parametrize(
    "redirection", [">&-", ">/dev/full", ">&- 2>&- <&-", ">/dev/full 2>/dev/full"]
)
def test_nothing_to_print_succeeds(shell, make_survey, tmp_path, redirection):
    out = tmp_path / "out"
    done = shell(redirection, "run", make_survey(), "--output", out, "--quiet")
    assert (done.returncode, done.stderr) == (0, "")
    expect_run(out)


@pytest.mark.parametrize("redirection", ["2>&-", "2>/dev/full", "2>&- <&-"])
def test_no_standard_error(shell, make_survey, tmp_path, redirection):
    out = tmp_path / "out"
    survey = make_survey()
    done = shell(redirection, "run", survey, "--output", out)
    assert (done.returncode, done.stderr) == (0, "")
    assert "points   " in done.stdout
    expect_run(out)
    done = shell(redirection, "run", survey, "--output", out)  # already exists
    assert (done.returncode, done.stderr) == (1, "")
    assert "earlier run" not in done.stdout  # errors are not results
    done = shell(redirection, "run", "--nonsense")
    assert (done.returncode, done.stdout) == (2, "")


@pytest.mark.parametrize("command", [["--version"], ["--help"], ["schema"], ["run", "--help"]])
@pytest.mark.parametrize("redirection", [">&-", ">/dev/full"])
def test_output_that_is_only_printed(shell, command, redirection):
    done = shell(redirection, *command)
    assert done.returncode == 1
    assert done.stderr.startswith("error: standard output: ") and done.stderr.count("\n") == 1


def test_launcher_with_closed_streams(make_survey, tmp_path):
    from pathlib import Path

    import vtkhelios

    launcher = Path(vtkhelios.__file__).absolute().parents[4] / "bin/vtkhelios"
    if not launcher.is_file():
        pytest.skip("no launcher in this installation")
    command = (
        f"'{launcher}' run '{make_survey()}' --output '{tmp_path / 'out'}' --quiet >&- 2>&- <&-"
    )
    assert subprocess.run(["sh", "-c", command]).returncode == 0
    expect_run(tmp_path / "out")


def test_closed_pipe(shell, make_survey, tmp_path):
    done = shell("| true", "run", make_survey(), "--output", tmp_path / "out")
    assert done.stderr == ""
    expect_run(tmp_path / "out")


def test_main_removes_its_observers(make_survey, window, capsys):
    """Repeated calls in one process: streams, observers and display mode are restored."""
    window.SetDisplayModeToAlways()
    streams = sys.stdout, sys.stderr
    tags = []
    for _ in range(3):
        assert cli.main(["run", str(make_survey()), "--dry-run"]) == 0
        with pytest.raises(SystemExit):
            cli.main(["run"])
        assert not window.HasObserver("ErrorEvent") and not window.HasObserver("WarningEvent")
        tags.append((sys.stdout, sys.stderr) == streams)
    assert all(tags) and window.GetDisplayMode() == window.ALWAYS
    window.SetDisplayModeToDefault()
    assert "points   " in capsys.readouterr().out
