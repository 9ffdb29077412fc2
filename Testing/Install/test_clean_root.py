# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments and errors of clean_root.sh, readme.sh and release.sh, and the packages of each release of Debian."""

import pathlib
import subprocess

import pytest

HERE = pathlib.Path(__file__).resolve().parent
APPS = HERE.parents[1] / "Apps"


def run(*command, **options):
    """The exit code of a command and all that it prints."""
    done = subprocess.run(
        [str(word) for word in command],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        **options,
    )
    return done.returncode, done.stdout


def bash(code, *arguments, **options):
    return run("bash", "-c", "set -euo pipefail\n" + code, "bash", *arguments, **options)


@pytest.mark.parametrize(
    "arguments, message",
    [
        ([], "no release is given: bookworm or trixie"),
        (["buster"], "buster is not an option, nor a release: bookworm or trixie"),
        (["trixie", "--fast"], "--fast is not an option"),
        (["trixie", "--folder"], "--folder needs a folder"),
        (["trixie", "--mirror"], "--mirror needs an address"),
    ],
)
def test_wrong_arguments(arguments, message):
    code, text = run(HERE / "clean_root.sh", *arguments)
    assert code != 0
    assert message in text


def test_usage():
    code, text = run(HERE / "clean_root.sh", "--help")
    assert code == 0
    assert "--tests           ./Testing/run.sh" in text
    code, text = run(HERE / "readme.sh")
    assert code == 2
    assert "--here [FOLDER]" in text


def make_folder(folder, release):
    """Makes a folder that helios_make_root accepts as a finished Debian."""
    (folder / "usr/bin").mkdir(parents=True)
    (folder / "usr/bin/apt-get").touch(mode=0o755)
    (folder / "etc").mkdir()
    (folder / "etc/os-release").write_text(f"VERSION_CODENAME={release}\n")


def test_folder_of_another_release(tmp_path):
    make_folder(tmp_path, "bookworm")
    code, text = bash('. "$1"; helios_make_root trixie "$2"', APPS / "debian_root.sh", tmp_path)
    assert code == 1
    assert text == f"{tmp_path} is not a Debian trixie; name another folder\n"


def test_failed_step_is_reported():
    code, text = bash(
        '. "$1"; f() { false; echo went on; }; helios_time one f; helios_time two true; '
        "helios_print_times; ! $helios_failed",
        HERE / "times.sh",
    )
    assert code == 1
    assert "went on" not in text
    assert "FAILED (1)   one" in text
    assert "ok           two" in text


def test_build_keeps_whether_warnings_are_errors(tmp_path):
    def warnings(value):
        code = '. "$1"; cd "$2"; helios_warnings "$3"'
        return bash(code, APPS / "setup.sh", tmp_path, value)[1].split("=")[-1].strip()

    assert warnings("ON") == "ON"
    (tmp_path / "build").mkdir()
    (tmp_path / "build/CMakeCache.txt").write_text("VTKHELIOS_WARNINGS_AS_ERRORS:BOOL=OFF\n")
    assert warnings("ON") == "OFF"


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["--fast"], "--fast is not an option"),
        (["--only", "debian,rpm"], "rpm is not a part of a release"),
        (["--release", "buster"], "buster is not a release: bookworm or trixie"),
        (["--python", "python2.0"], "python2.0 is no CPython with headers"),
        (["--folder"], "--folder needs a folder"),
    ],
)
def test_wrong_arguments_of_a_release(arguments, message):
    code, text = run(HERE / "release.sh", *arguments)
    assert code != 0
    assert message in text


def test_list_of_a_release():
    code, text = run(
        HERE / "release.sh", "--list", "--only", "debian,wheels", "--release", "trixie"
    )
    assert code == 0
    lines = [line for line in text.splitlines() if not line.endswith("no wheel for it")]
    assert lines[:2] == ["Debian packages for trixie", "wheel for CPython 3.11"]
    assert all(line.startswith("wheel for ") for line in lines[2:])
    assert run(HERE / "release.sh", "--list", "--only", "sources") == (0, "sources\n")
    code, text = run(HERE / "release.sh", "--help")
    assert code == 0
    assert "CCACHE_DIR if this is set" in text and "set -euo" not in text
    assert "--no-test         build without trying" in text
