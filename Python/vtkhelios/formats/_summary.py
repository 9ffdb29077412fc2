# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""run_summary.json: read, and checked against the output of vtkhelios run."""

import json

from ..core.classes import vtk_class
from ..core.json_files import JsonError, parse_json
from ..core.words import counted
from ._base import FormatError, check_file

CURE = "run the survey again"
LARGEST_COUNT = 2**63 - 1
LARGEST = 1e15  # limit of other numbers
LONGEST = 60  # characters of a value in a message


def _count(value):
    is_whole = isinstance(value, int) and not isinstance(value, bool)
    return is_whole and 0 <= value <= LARGEST_COUNT


def _index(value):
    return _count(value) and value < 2**31


def _number(value):
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return is_number and 0 <= value <= LARGEST


def _text(value):
    return isinstance(value, str) and not any("\ud800" <= c <= "\udfff" for c in value)


def _file_name(value):
    return _text(value) and value not in ("", ".", "..") and not set(value) & set("/\0")


def _coordinates(value, count):
    numbers = value if isinstance(value, list) else []
    return len(numbers) == count and all(
        isinstance(each, (int, float)) and not isinstance(each, bool) and abs(each) <= LARGEST
        for each in numbers
    )


def _three(value):
    return _coordinates(value, 3)


def _four(value):
    return _coordinates(value, 4) and abs(sum(each * each for each in value) - 1) < 1e-6


def _option(value):
    return value is None or isinstance(value, bool) or _text(value) or _number(value)


EXPECTED = {
    _count: f"a whole number from 0 to {LARGEST_COUNT}",
    _index: f"a whole number from 0 to {2**31 - 1}",
    _number: f"a number from 0 to {LARGEST:g}",
    _text: "a text",
    _file_name: "the name of a file in the folder of the run",
    _option: f"a text, true, false or a number from 0 to {LARGEST:g}",
    _three: f"three numbers up to {LARGEST:g}",
    _four: "the four numbers of a unit quaternion",
    dict: "an object",
    list: "a list",
}

# Contents of a summary: a dict by its keys, a list by its one kind of entry; any keys in OPTIONS.
_COUNTS = vtk_class("vtkHeliosScanner").GetCountNames().split()
_OPTIONS = {None: _option}
_MEASURES = ("rangeP50_m", "rangeP95_m", "rangeRms_m", "missed", "invented", "missedAndInvented")
_MEASURES = {name: [_number] for name in (*_MEASURES, "amplitudeRms", "widthRms_ns")}
WHOLE = {
    "accuracy": {
        **_MEASURES, **dict.fromkeys(("pulses", "echoes", "matched"), _count),
        "asked": {"rangeTolerance_m": _number, "energyTolerance": _number},
        "reference": {
            **_MEASURES, "rangeTolerance_m": _number, "energyTolerance": _number,
            "subRays": _count,  # name in version 0.2
            "check": {**_MEASURES, "pulses": _count, "subRays": _count},
        },
        "reason": _text, "without": [_text],
    },
    "carriers": {None: _text},
    "inputs": [{"bytes": _count, "file": _text, "sha256": _text}],
    "legs": [{
        "leg": _index, "start_s": _number, "duration_s": _number,
        "files": [{"name": _file_name, "records": _count, "bytes": _count}],
        "mount": {"position_m": _three, "orientation": _four},
        **dict.fromkeys(("firstReturns", "points", "pulses", "pulsesFired", "pulsesHit"), _count),
    }],
    "movingParts": [{"part": _text, "motion": _text, "speed_m_s": [_number]}],
    "options": _OPTIONS,
    "part": {"number": _index, "count": _index, "command": _text},
    "rayCaster": _text,
    "sampling": _text,
    "scene": _text,
    "survey": _text,
    "timings": {"legs_s": [_number], "threads": _count,
                **dict.fromkeys(("load_s", "run_s", "accuracy_s", "parts_s"), _number)},
    "totals": dict.fromkeys(_COUNTS, _count),
    "versions": {"VTK": _text, "vtkHelios": _text, "summary": _count},
}  # fmt: skip

# Keys that an accuracy has, if it was measured and is shown. Its reference is adaptive; in 0.2 it
# had sub-rays.
MEASURED = dict.fromkeys(
    ("rangeP50_m", "rangeP95_m", "missed", "invented", "missedAndInvented", "amplitudeRms")
)
ADAPTIVE = {**MEASURED, **dict.fromkeys(("rangeTolerance_m", "energyTolerance"))}
SUB_RAYS = {**MEASURED, "subRays": None}
ACCURACY = {**MEASURED, "pulses": None, "echoes": None, "without": None, "reference": None}

# Required to find points; other keys are checked if present.
FILES = {"legs": [{"files": [{"name": None, "records": None}]}]}
# Also for reports.
REPORT = {
    **FILES,
    "inputs": [{"bytes": None, "file": None, "sha256": None}],
    "legs": [{
        **dict.fromkeys(("leg", "start_s", "duration_s", "points", "pulsesFired", "pulsesHit")),
        "files": [{"name": None, "records": None}],
    }],
    **dict.fromkeys(("options", "rayCaster", "sampling", "scene", "survey")),
    "timings": dict.fromkeys(("legs_s", "load_s", "run_s", "threads")),
    "totals": dict.fromkeys(
        ("pulsesFired", "pulsesHit", "pulsesOnPlane", "pulsesWithoutBins", "pulsesBinned", "subRays")
    ),
    "versions": dict.fromkeys(("VTK", "vtkHelios")),
}  # fmt: skip
# Also for vtkhelios run on a finished run.
FINISHED = {**REPORT, "totals": {**REPORT["totals"], "points": None, "firstReturns": None}}
FINISHED["legs"] = [{**REPORT["legs"][0], "pulses": None,
                     "files": [{"name": None, "records": None, "bytes": None}]}]  # fmt: skip


def read_summary(path, needed=FILES):
    """Returns the summary in a file; FormatError if it cannot be read, or is not valid."""
    check_file(path)
    try:
        data = path.read_bytes()
    except OSError as error:
        raise FormatError(f"{path}: cannot be read: {error.strerror}") from error
    return parse_summary(data, path, needed)


def parse_summary(data, path, needed=FILES):
    """Returns the summary in text or bytes; messages name the file."""
    try:
        summary = parse_json(data)
    except JsonError as error:
        raise FormatError(f"{path}: {error}; {CURE}") from error
    check_summary(summary, path, needed)
    return convert_to_current(summary)


def convert_to_current(summary):
    """Converts a summary or fingerprint of version 1 to version 2, which has epochs for plays."""
    options = summary.get("options", {})
    if "summary" not in summary.get("versions", {}) and "play" in options:
        options["epoch"] = options.pop("play")
    return summary


def check_summary(summary, path, needed=FILES):
    """Raises FormatError if a required key is missing, or a value is not valid."""
    try:
        _check(summary, WHOLE, "")
        _check_keys(summary, needed, "")
        if needed is not FILES and "reason" not in (
            accuracy := summary.get("accuracy") or {"reason"}
        ):
            _check_keys(accuracy, ACCURACY, "accuracy")
            reference = accuracy["reference"]
            kind = SUB_RAYS if "subRays" in reference else ADAPTIVE
            _check_keys(reference, kind, "accuracy.reference")
        _check_lengths(summary)
    except _Wrong as wrong:
        raise FormatError(f"{path}: {wrong}; {CURE}") from wrong


class _Wrong(ValueError):
    """The error of a value, and its location."""


def _check(value, kind, where):
    expected = type(kind) if isinstance(kind, (dict, list)) else kind
    is_good = isinstance(value, expected) if isinstance(expected, type) else expected(value)
    if not is_good:
        raise _Wrong(f"{where or 'the file'} is {_quote(value)}: expected {EXPECTED[expected]}")
    if isinstance(kind, list):
        for index, each in enumerate(value):
            _check(each, kind[0], f"{where}[{index}]")
    elif isinstance(kind, dict):
        for key, each in value.items():
            if known := kind.get(key) or kind.get(None):
                _check(each, known, f"{where}.{_plain(key)}" if where else _plain(key))
            if not _text(key):
                raise _Wrong(f"a key of {where or 'the file'} is {_quote(key)}: expected a text")


def _check_keys(value, needed, where):
    if isinstance(needed, list):
        for index, each in enumerate(value):
            _check_keys(each, needed[0], f"{where}[{index}]")
    for key in needed if isinstance(needed, dict) else ():
        if key not in value:
            raise _Wrong(f"{where or 'the file'} has no {key}")
        _check_keys(value[key], needed[key], f"{where}.{key}" if where else key)


def _check_lengths(summary):
    times = summary.get("timings", {}).get("legs_s")
    if times is not None and len(times) != len(summary.get("legs", [])):
        raise _Wrong(
            f"timings.legs_s has {len(times)} entries, for "
            f"{counted(len(summary.get('legs', [])), 'leg')}"
        )


def _quote(value):
    """Returns a value in a message: one line of ASCII, truncated if long."""
    if isinstance(value, (dict, list)):
        return "an object" if isinstance(value, dict) else "a list"
    if isinstance(value, int) and abs(value) > 10**LONGEST:
        return f"a number of more than {LONGEST} digits"
    text = json.dumps(value)
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}..."


def _plain(key):
    return key if key.isidentifier() and key.isascii() else _quote(key)
