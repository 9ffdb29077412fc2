# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The options of vtkhelios run that are properties of vtkHeliosRunOptions."""

from ...core.paths import to_vtk
from ...surveys.options import OPTIONS
from ...vtkHeliosScannerRun import vtkHeliosRunOptions
from .._parser import number, whole_number


def add_option_arguments(parser):
    defaults = vtkHeliosRunOptions()
    for option in OPTIONS:
        if option.argument:
            parser.add_argument(
                option.argument, help=option.help, **_make_argument(option, defaults)
            )


def _make_argument(option, defaults):
    """Returns the arguments of argparse for an option, by type and valid range of its property."""

    def get(what):
        return getattr(defaults, f"Get{option.property}{what}", lambda: 0)()

    default = get("")
    if isinstance(default, bool):
        return {"action": "store_true"}
    given = {"metavar": option.metavar, "default": None if default == -1 else default}
    if isinstance(default, str):
        return given | {"choices": option.get_choices() or None}
    if isinstance(default, float):
        return given | {"type": number(get("MinValue"), get("MaxValue"))}
    return given | {"type": whole_number(get("MaxValue"), max(0, get("MinValue")))}


def set_options(options, arguments):
    for option in OPTIONS:
        value = vars(arguments).get(option.argument.strip("-").replace("-", "_"))
        if isinstance(value, bool):
            value = not value
        if value is not None:
            setter = getattr(options, f"Set{option.property}")
            setter(to_vtk(value) if isinstance(value, str) else value)
