# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios completion: the shells themselves complete command lines."""

import re
import shutil
import subprocess

import pytest

from vtkhelios import cli
from vtkhelios.cli.completion import SHELLS
from vtkhelios.cli.completion._describe import describe_commands

BASH = """\
source ./script
complete_line() {
  COMP_WORDS=("$@")
  COMP_CWORD=$(($# - 1))
  _vtkhelios
  printf '%s\\n' "${COMPREPLY[@]}"
}
complete_line "$@"
"""


@pytest.fixture(scope="module")
def commands():
    return {command.name: command for command in describe_commands()}


@pytest.fixture
def scripts(tmp_path, commands, monkeypatch):
    """A folder with a file and a folder, and the script of a shell."""
    (tmp_path / "a survey.xml").write_text("")
    (tmp_path / "assets").mkdir()
    for name in ("b.las", "b.LAZ", "b c.vrt", "b.py", "b.las.bak"):
        (tmp_path / name).write_text("")
    monkeypatch.chdir(tmp_path)

    def write(shell):
        if not shutil.which(shell):
            pytest.skip(f"{shell} is not installed")
        (tmp_path / "script").write_text(SHELLS[shell](list(commands.values())))

    return write


def test_all_commands_are_described(commands):
    assert list(commands) == cli.command_names()
    options = {name for option in commands["run"].options for name in option.names}
    assert {"--format", "--assets", "--help", "-h"} <= options
    kinds = {name: option.value for option in commands["run"].options for name in option.names}
    assert kinds["--format"].words == ("xyz", "las", "laz", "copc", "vtp")
    assert kinds["--assets"].kind == kinds["--output"].kind == "folder"
    assert kinds["--seed"].kind == "number"
    assert kinds["--quiet"].kind == "flag"
    assert commands["run"].arguments[0].kind == "file"
    assert commands["completion"].arguments[0].words == ("bash", "zsh", "fish")
    assert commands["run"].arguments[0].endings == ()  # any
    assert {".las", ".vrt", ".xml"} <= set(commands["info"].arguments[0].endings)
    assert ".las" not in commands["plan"].arguments[0].endings


@pytest.mark.parametrize(
    "line, expected",
    [
        ("ru", {"run"}),
        ("run --form", {"--format"}),
        ("run --format ", {"xyz", "las", "laz", "copc", "vtp"}),
        ("run --format = l", {"las", "laz"}),
        ("run --assets a", {"assets"}),
        ("run a", {"a survey.xml", "assets"}),
        ("run --seed a", {""}),
        ("convert x --format l", {"las", "laz"}),
        ("help vali", {"validate"}),
        ("list s", {"scanners", "scenes"}),
        ("new x --kind f", {"forest"}),
        ("info b", {"b.las", "b.LAZ", "b c.vrt"}),  # by the list of endings
        ("compare b", {"b.las", "b.LAZ"}),
        ("plan b", {"b c.vrt"}),
        ("info a", {"a survey.xml", "assets"}),
    ],
)
def test_bash(line, expected, scripts):
    scripts("bash")
    words = ["vtkhelios", *line.split(" ")]
    done = subprocess.run(
        ["bash", "-c", BASH, "test", *words], capture_output=True, text=True, check=True
    )
    assert set(done.stdout.splitlines()) == expected, done.stderr


@pytest.mark.parametrize(
    "line, expected",
    [
        ("ru", {"run"}),
        ("run --form", {"--format"}),
        ("run --format ", {"copc", "las", "laz", "vtp", "xyz"}),
        ("run --assets a", {"assets/"}),
        ("run a", {"a survey.xml", "assets/"}),
        ("help vali", {"validate"}),
        ("list s", {"scanners", "scenes"}),
        ("info b", {"b.las", "b.LAZ", "b c.vrt"}),  # by the list of endings
        ("compare b", {"b.las", "b.LAZ"}),
        ("info a", {"a survey.xml", "assets/"}),
    ],
)
def test_fish(line, expected, scripts):
    scripts("fish")
    done = subprocess.run(
        ["fish", "--private", "-c", f"source ./script; complete -C 'vtkhelios {line}'"],
        capture_output=True,
        text=True,
    )
    found = {row.split("\t")[0] for row in done.stdout.splitlines()}
    if fish_version() >= 4:  # it also finds options that have the word within
        found = {row for row in found if row.startswith(line.split(" ")[-1])}
    assert found == expected, done.stderr


def fish_version():
    said = subprocess.run(["fish", "--version"], capture_output=True, text=True).stdout
    return int(re.search(r"(\d+)\.", said)[1])


def test_zsh_reads_the_script(scripts):
    scripts("zsh")
    done = subprocess.run(
        [
            "zsh",
            "-f",
            "-c",
            "autoload -Uz compinit; compinit -u -D; source ./script; whence -w _vtkhelios",
        ],
        capture_output=True,
        text=True,
    )
    assert done.stdout == "_vtkhelios: function\n" and done.stderr == ""


ZSH = """\
zmodload zsh/zpty
zpty -b shell zsh -f -i
zpty -w shell "PS1='> '; autoload -Uz compinit; compinit -u -D; source ./script; print REA''DY"
zpty -r -m shell text '*READY*'
zpty -w -n shell "vtkhelios compare b"$'\\t\\t'
zpty -r -m shell text '*b.las*compare*'
print -r -- $text
zpty -d shell
"""


def test_zsh_offers_files_by_the_list_of_endings(scripts):
    scripts("zsh")
    done = subprocess.run(["zsh", "-f", "-c", ZSH], capture_output=True, text=True, timeout=60)
    assert "b.LAZ" in done.stdout and "b.las" in done.stdout, done.stderr
    assert "b.py" not in done.stdout and "b.las.bak" not in done.stdout


def test_an_unknown_shell_has_a_hint(capsys):
    with pytest.raises(SystemExit) as end:
        cli.main(["completion", "tcsh"])
    assert end.value.code == 2
    assert "unknown 'tcsh': known: bash, zsh, fish" in capsys.readouterr().err
