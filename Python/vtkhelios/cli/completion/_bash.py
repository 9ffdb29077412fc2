# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The script for bash."""

from ._describe import FILE, FLAG, FOLDER, NUMBER, WORDS

_SCRIPT = """\
# Completion of vtkhelios in bash, made by: vtkhelios completion bash
_vtkhelios() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
  local command=${{COMP_WORDS[1]}} options="" words="" endings="" kind=file file
  COMPREPLY=()
  if [ "$current" = "=" ]; then current=""; fi
  if [ "$previous" = "=" ]; then previous=${{COMP_WORDS[COMP_CWORD - 2]}}; fi
  if [ "$COMP_CWORD" -eq 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W "{commands}" -- "$current")
    return
  fi
  case $command in
{options}
  esac
  case $command:$previous in
{values}
  esac
  if [ "$kind" = file ] && [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
  elif [ "$kind" = words ] || [ -n "$words" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  elif [ "$kind" = folder ]; then
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -d -- "$current")
  elif [ "$kind" = file ] && [ -n "$endings" ]; then
    compopt -o filenames 2>/dev/null
    while IFS= read -r file; do
      if [ -d "$file" ] || [[ ${{file,,}} =~ \\.($endings)$ ]]; then COMPREPLY+=("$file"); fi
    done < <(compgen -f -- "$current")
  elif [ "$kind" = file ] || [ "$kind" = files ]; then
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
  fi
}}
complete -F _vtkhelios vtkhelios
"""


def write_script(commands):
    """Returns the script, as text."""
    options, values = [], []
    for command in commands:
        names = " ".join(name for option in command.options for name in option.names)
        first = command.arguments[0] if command.arguments else None
        words = " ".join(first.words) if first else ""
        words = f' words="{words}"' if words else ""
        endings = "|".join(each[1:].replace(".", r"\.") for each in first.endings) if first else ""
        endings = f" endings='{endings}'" if endings else ""
        options.append(f'    {command.name}) options="{names}"{words}{endings} ;;')
        values += [_case(command, option) for option in command.options]
    return _SCRIPT.format(
        commands=" ".join(command.name for command in commands),
        options="\n".join(options),
        values="\n".join(filter(None, values)),
    )


def _case(command, option):
    """The line of an option that has a value."""
    if option.value.kind == FLAG:
        return ""
    places = "|".join(f"{command.name}:{name}" for name in option.names)
    actions = {
        FILE: 'kind=files words=""',
        FOLDER: 'kind=folder words=""',
        NUMBER: 'kind=number words=""',
        WORDS: f'kind=words words="{" ".join(option.value.words)}"',
    }
    return f"    {places}) {actions[option.value.kind]} ;;"
