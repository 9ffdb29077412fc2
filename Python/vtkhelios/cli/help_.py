# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios help: the texts of --help."""

from .. import cli

SUMMARY = "describe a command, or list all"

EPILOG = """\
vtkhelios help COMMAND is vtkhelios COMMAND --help.

examples:
  vtkhelios help
  vtkhelios help run
"""


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument(
        "name",
        metavar="COMMAND",
        nargs="?",
        choices=cli.command_names(),
        help="the command (default: list all commands)",
    )


def run(arguments):
    return cli.run_command([arguments.name, "--help"] if arguments.name else ["--help"])
