# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The options of vtkhelios run that are on or off: what it writes besides the echoes."""

from ..._outputs import OUTPUTS


def add_output_arguments(parser):
    for output in OUTPUTS:
        parser.add_argument(output.option, action="store_true", help=output.help)


def set_outputs(player, arguments):
    for output in OUTPUTS:
        setter = f"Set{''.join(map(str.capitalize, output.player.split('_')))}"
        getattr(player, setter)(getattr(arguments, output.name))
