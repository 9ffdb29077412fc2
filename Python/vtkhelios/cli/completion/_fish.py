# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The script for fish."""

from ._describe import FILE, FLAG, FOLDER, NUMBER, WORDS

_HEAD = """\
# Completion of vtkhelios in fish, made by: vtkhelios completion fish
function __vtkhelios_command
    set -l words (commandline -opc)
    test (count $words) -ge 2; and test $words[2] = $argv[1]
end
function __vtkhelios_no_command
    test (count (commandline -opc)) -eq 1
end
function __vtkhelios_files
    for file in (__fish_complete_path (commandline -ct))
        set -l name (string lower -- (string split -f 1 \\t -- $file))
        if string match -q -- '*/' $name
            echo $file
        else
            for ending in $argv
                string match -q -- "*$ending" $name; and echo $file; and break
            end
        end
    end
end
complete -c vtkhelios -f
"""


def write_script(commands):
    """Returns the script, as text."""
    lines = []
    for command in commands:
        about = _quote(command.help)
        lines.append(
            f"complete -c vtkhelios -n __vtkhelios_no_command -a {command.name} -d {about}"
        )
    for command in commands:
        start = f"complete -c vtkhelios -n '__vtkhelios_command {command.name}'"
        if command.arguments:
            lines.append(f"{start} {_values(command.arguments[0])}")
        for option in command.options:
            names = " ".join(
                f"-l {name[2:]}" if name.startswith("--") else f"-s {name[1:]}"
                for name in option.names
            )
            lines.append(f"{start} {names} {_values(option.value, 'r')}-d {_quote(option.help)}")
    return _HEAD + "\n".join(lines) + "\n"


def _values(value, required=""):
    """Returns the words to complete; for options, a value is required unless it is a flag."""
    exclusive = "-x " if required else ""
    if value.endings:
        return f"-a '(__vtkhelios_files {' '.join(value.endings)})'"
    return {
        FLAG: "",
        FILE: "-r -F " if required else "-F",
        FOLDER: f"{exclusive}-a '(__fish_complete_directories)' ",
        NUMBER: "-x " if required else "",
        WORDS: f"{exclusive}-a {_quote(' '.join(value.words))} ",
    }[value.kind]


def _quote(text):
    """Returns a text in single quotes."""
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"
