# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A few thousand damaged files over all targets; Testing/run.sh --fuzz runs 100,000."""

import os
import subprocess
import sys

import fuzz
import pytest
from fuzzing import target as target_module
from fuzzing.targets import ALL

CASES = 3000
PROGRAM = fuzz.__file__


@pytest.fixture(scope="module")
def campaign(tmp_path_factory):
    """The results of all cases: failures by target, and the table."""
    failures = tmp_path_factory.mktemp("failures")
    done = call("--cases", CASES, "--quiet", "--failures", failures, "--hang", 60)  # busy machines
    assert done.returncode in (0, 1), done.stderr
    told = {}
    for part in done.stdout.split("\nFAILED ")[1:]:
        told.setdefault(part.split()[0], []).append(part.split("\n\n")[0])
    return told, done.stdout


def call(*arguments):
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    return subprocess.run(
        [sys.executable, PROGRAM, *map(str, arguments)],
        capture_output=True, text=True, env=environment, timeout=1500, errors="replace",
    )  # fmt: skip


@pytest.mark.parametrize("name", ALL)
def test_damaged_files(name, campaign):
    if missing := ALL[name].missing():
        pytest.skip(f"{missing} is not installed")
    told, table = campaign
    assert f"\n{name} " in table
    assert not told.get(name), "\n".join(told[name])


def test_table_has_totals(campaign):
    lines = campaign[1].splitlines()
    row = next(line.split() for line in lines if line.startswith("all "))
    counts = [int(each.replace(",", "")) for each in row[1:9]]
    assert counts[0] == sum(counts[1:])
    assert counts[0] > 0.9 * CASES
    assert counts[1] > 0.1 * counts[0] and counts[2] > 0.1 * counts[0]  # both occur


def test_a_failure_is_saved_with_its_command(tmp_path, monkeypatch, capsys):
    class Broken(target_module.Target):
        name = "broken"
        weight = 1.0

        def make_seeds(self, folder):
            return [target_module.Seed("sub/a.txt", b"good")]

        def run(self, path, data):
            if data != b"good":
                raise KeyError(data)

    import fuzzing.targets

    monkeypatch.setattr(fuzzing.targets, "ALL", {"broken": Broken()})
    folder = tmp_path / "failures"
    assert fuzz.main(["--cases", "1", "--quiet", "--failures", str(folder)]) == 1
    told = capsys.readouterr().out
    saved = folder / "broken" / "sub%a.txt~0"
    assert f"--target broken --input '{saved}'" in told and "KeyError" in told
    assert saved.read_bytes() != b"good"
    assert fuzz.main(["--quiet", "--target", "broken", "--input", str(saved)]) == 1
    saved.write_bytes(b"good")
    assert fuzz.main(["--quiet", "--target", "broken", "--input", str(saved)]) == 0


def test_targets_are_listed():
    done = call("--list")
    assert done.returncode == 0
    assert [line.split()[0] for line in done.stdout.splitlines()] == list(ALL)
    assert all(len(line.split()) > 1 for line in done.stdout.splitlines())


def test_markdown_is_a_table():
    done = call("--target", "vox", "--cases", 5, "--markdown", "--quiet")
    rows = [line for line in done.stdout.splitlines() if line.startswith("|")]
    assert len(rows) == 4 and len({row.count("|") for row in rows}) == 1
    assert done.returncode == 0


@pytest.mark.parametrize(
    "words, message",
    [
        (["--target", "nowhere"], "no target is called nowhere"),
        (["--case", "3"], "--input and --case need one --target"),
        (["--target", "obj", "--input", "nowhere"], "--input nowhere: no such file"),
    ],
)
def test_wrong_usage(words, message):
    done = call(*words)
    assert done.returncode == 2 and message in done.stderr


def test_help_has_examples():
    done = call("--help")
    for words in ("what a case is", "silent", "examples:", "exit codes"):
        assert words in done.stdout
