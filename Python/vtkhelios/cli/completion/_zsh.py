# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The script for zsh."""

from ._describe import FILE, FLAG, FOLDER, NUMBER, WORDS

_SCRIPT = """\
#compdef vtkhelios
# Completion of vtkhelios in zsh, made by: vtkhelios completion zsh
_vtkhelios() {{
  local -a commands
  commands=(
{commands}
  )
  if (( CURRENT == 2 )); then
    _describe -t commands command commands
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
{cases}
  esac
}}
if [[ $funcstack[1] == _vtkhelios ]]; then
  _vtkhelios "$@"
else
  compdef _vtkhelios vtkhelios
fi
"""


def write_script(commands):
    """Returns the script, as text."""
    return _SCRIPT.format(
        commands="\n".join(f"    {_quote(_describe(each))}" for each in commands),
        cases="\n".join(map(_case, commands)),
    )


def _describe(command):
    return f"{command.name}:{command.help}"


def _case(command):
    """Returns the case of _arguments for a command."""
    lines = [f"    {command.name})", "      _arguments -S \\"]
    specs = [spec for option in command.options for spec in _option_specs(option)]
    specs += [_place(number, value) for number, value in enumerate(command.arguments, 1)]
    if command.arguments:
        specs.append(f"*{_place('', command.arguments[-1])}")
    lines += [f"        {_quote(spec)} \\" for spec in specs]
    return "\n".join([*lines, "        && return", "      ;;"])


def _option_specs(option):
    others = "" if option.repeats or len(option.names) == 1 else f"({' '.join(option.names)})"
    star = "*" if option.repeats else ""
    for name in option.names:
        value = "" if option.value.kind == FLAG else _place("", option.value)
        equals = "=" if value and name.startswith("--") else ""  # --name VALUE or --name=VALUE
        yield f"{star}{others}{name}{equals}[{_escape(option.help)}]{value}"


def _place(number, value):
    return f"{number}:{_escape(value.metavar)}:{_action(value)}"


def _action(value):
    endings = "|".join(each[1:] for each in value.endings)
    return {
        FILE: f'_files -g "(#i)*.({endings})"' if endings else "_files",
        FOLDER: "_files -/",
        NUMBER: " ",
        WORDS: f"({' '.join(value.words)})",
    }[value.kind]


def _escape(text):
    """Returns a text without a meaning for _arguments."""
    return "".join(f"\\{c}" if c in "[]:\\" else c for c in text)


def _quote(text):
    """Returns a text in single quotes."""
    return "'" + text.replace("'", "'\\''") + "'"
