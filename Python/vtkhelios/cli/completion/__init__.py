# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios completion: scripts with which shells complete command lines."""

from . import _bash, _fish, _zsh
from ._describe import describe_commands

SUMMARY = "print a script with which a shell completes commands, options and files"

EPILOG = """\
The script is made from the options of this version; print it again after an update.

  bash  vtkhelios completion bash > ~/.local/share/bash-completion/completions/vtkhelios
        (needs the package bash-completion; or, in ~/.bashrc: eval "$(vtkhelios completion bash)")
  zsh   vtkhelios completion zsh > DIR/_vtkhelios, with a DIR of $fpath, before compinit
        (or, in ~/.zshrc after compinit: eval "$(vtkhelios completion zsh)")
  fish  vtkhelios completion fish > ~/.config/fish/completions/vtkhelios.fish

exit codes: 0 done, 2 wrong usage.
"""

SHELLS = {"bash": _bash.write_script, "zsh": _zsh.write_script, "fish": _fish.write_script}


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument("shell", metavar="bash|zsh|fish", choices=list(SHELLS), help="the shell")


def run(arguments):
    print(SHELLS[arguments.shell](describe_commands()), end="")
    return 0
