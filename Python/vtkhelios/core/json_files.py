# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""JSON of files, strictly read: any fault is a JsonError of one line."""

import json


class JsonError(ValueError):
    """The fault of a text, to follow the name of its file and a colon."""


def parse_json(data):
    """Returns the value of a text, or of bytes in UTF-8."""
    try:
        text = data if isinstance(data, str) else data.decode()
        return json.loads(text, object_pairs_hook=_make_object, parse_constant=_refuse)
    except UnicodeDecodeError as error:
        raise JsonError(f"byte {error.start} is not UTF-8") from error
    except RecursionError as error:
        raise JsonError("is nested too deeply") from error
    except ValueError as error:
        raise JsonError(f"is not valid JSON: {error}") from error


def _make_object(pairs):
    entries = dict(pairs)
    if len(entries) < len(pairs):
        seen = set()
        twice = next(key for key, _ in pairs if key in seen or seen.add(key))
        raise ValueError(f"the key {json.dumps(twice[:60])} is given twice")
    return entries


def _refuse(word):
    raise ValueError(f"{word} is not a valid JSON number")
