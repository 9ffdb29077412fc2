# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The options of a run, as its summary has them, in words with units."""

from ..._outputs import OUTPUTS

FORMATS = {"xyz": "text (.xyz)", "las": "LAS 1.4 (.las)", "vtp": "VTK XML (.vtp)"}


def describe_options(options):
    """Names and values of a page, such as ("waveform bins", "0.25 ns").

    Options that are not given, and so as the survey has them, are left out; one of an unknown name
    is shown as it is stored.
    """
    rows = []
    for name, value in options.items():
        title, describe = _WORDS.get(name, (name, str))
        text = describe(value)
        if text:
            rows.append((title, text))
    order = [title for title, _ in _WORDS.values()]
    return sorted(rows, key=lambda row: order.index(row[0]) if row[0] in order else len(order))


def _measure(unit, scale=1.0):
    """A number with its unit; 0: not given."""
    return (
        lambda value: f"{scale * value:.6g} {unit}" if _is_number(value) and value else _text(value)
    )


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


def _step(value):
    return "" if value == 1 else f"one of {value:,}" if _is_number(value) else _text(value)


_WORDS = {  # in the order of a page: title, text of a value
    "format": ("format", _format),
    "seed": ("seed of random numbers", str),
    "noise": ("noise", _flag("on", "off")),
    "rangeTolerance_m": ("range tolerance", _measure("mm", 1e3)),
    "energyTolerance": ("energy tolerance", _measure("%", 1e2)),
    "subRays": ("sub-rays per pulse", _count("(fixed sampling)")),
    "maximumSubRays": ("maximum of sub-rays per pulse", _count("")),
    "subRayPattern": ("pattern of sub-rays", _text),
    "binSize_ns": ("waveform bins", _measure("ns")),
    "detector": ("echo detector", _text),
    "rayCaster": ("ray caster asked for", _text),
    "without": ("parts of the model left out", _text),
    "pulseStep": ("pulses computed", _step),
    "weather": ("weather", _text),
    "gpsStart": ("start of the survey", _text),
    "play": ("epoch", str),
    **{output.key: (output.title, _flag(output.state)) for output in OUTPUTS},
    "pulsesPerBlock": ("pulses per block", _count("")),
}
