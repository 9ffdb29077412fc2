# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The options of vtkhelios run that are on or off: what it writes besides the echoes."""

from ...surveys.outputs import OUTPUTS


def add_output_arguments(parser):
    for output in OUTPUTS:
        parser.add_argument(output.option, action="store_true", help=output.help)


def set_outputs(player, arguments):
    for output in OUTPUTS:
        getattr(player, f"Set{output.player}")(getattr(arguments, output.name))


def find_fault(arguments):
    """Returns the output that the format cannot have; or None."""
    for output in OUTPUTS:
        formats = output.formats.split()
        if getattr(arguments, output.name) and arguments.format not in formats:
            needed = ", ".join(formats[:-1]) + " or " * (len(formats) > 1) + formats[-1]
            return (
                f"{output.option} needs --format {needed}: files of the format "
                f"{arguments.format} cannot have {output.title}"
            )
    return None
