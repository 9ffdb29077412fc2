# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The options of a run, as its summary has them, in words with units."""

from ..surveys.options import OPTIONS
from ..surveys.outputs import OUTPUTS
from ..vtkHeliosScannerRun import vtkHeliosRunOptions

FORMATS = {
    "xyz": "text (.xyz)",
    "las": "LAS 1.4 (.las)",
    "laz": "LAZ (.laz)",
    "copc": "COPC (.copc.laz)",
    "vtp": "VTK XML (.vtp)",
}


def describe_options(options):
    """Returns the names and values of a page, such as ("waveform bins", "0.25 ns").

    Options that are not given, and so as the survey has them, are left out; one of an unknown name
    is shown as it is stored.
    """
    rows = []
    for name, value in options.items():
        title, describe = _LABELS.get(name, (name, str))
        text = describe(value)
        if text:
            rows.append((title, text))
    order = [title for title, _ in _LABELS.values()]
    return sorted(rows, key=lambda row: order.index(row[0]) if row[0] in order else len(order))


def _is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _count(unit):
    return (
        lambda value: f"{value:,} {unit}".strip() if _is_number(value) and value else _text(value)
    )


def _text(value):
    """Nothing for a value that stands for the default."""
    return str(value) if value else ""


def _flag(on, off=""):
    return lambda value: (on if value else off) if isinstance(value, bool) else _text(value)


def _format(value):
    return FORMATS.get(value, _text(value))


def _option(option):
    """Words for a value of an option; without a scale for the default, too."""
    default = getattr(vtkHeliosRunOptions(), f"Get{option.property}")()

    def describe(value):
        if isinstance(default, bool):
            return _flag(*option.words.split())(value)
        if not option.scale:
            return str(value)
        if value == default or not value or not _is_number(value):
            return "" if value == default else _text(value)
        number = (
            f"{float(option.scale) * value:.6g}" if isinstance(default, float) else f"{value:,}"
        )
        return option.words.format(number)

    return describe


_LABELS = {  # in the order of a page: title, text of a value
    "format": ("format", _format),
    **{option.key: (option.title, _option(option)) for option in OPTIONS if option.key},
    **{output.key: (output.title, _flag(output.state)) for output in OUTPUTS},
    "pulsesPerBlock": ("pulses per block", _count("")),
}
