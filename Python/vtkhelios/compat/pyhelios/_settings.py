# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Attributes of pyhelios objects as attributes of a survey (Docs/dialect.md), in their units."""

import math
import typing

from ._errors import Closed


class Setting(typing.NamedTuple):
    """An attribute of the dialect, and how its text is converted."""

    attribute: str
    default: object  # its type is the value's; None: a number, NaN if it is not given
    unit: float = 1.0  # unit of pyhelios in units of the dialect


DEGREES = 180.0 / math.pi  # degrees of a radian


def name_all(rows):
    """Returns a dictionary by all names of rows (names of version 1 and 2.1, separated by blanks;
    Setting)."""
    return {name: setting for names, setting in rows for name in names.split()}


class Settings(Closed):
    """Attributes by SETTINGS of a class, read and set by _read(name) and _write(name, text)."""

    SETTINGS = {}

    def __getattr__(self, name):
        setting = self.SETTINGS.get(name)
        if setting is None:
            raise self._refuse(name)
        return parse(setting, self._read(setting.attribute))

    def __setattr__(self, name, value):
        setting = self.SETTINGS.get(name)
        if setting is None:
            super().__setattr__(name, value)
        else:
            self._write(setting.attribute, format_value(setting, value))


def parse(setting, text):
    """Returns the value of a text of the dialect; the default if it is empty."""
    default = setting.default
    if not text:
        return math.nan if default is None else default
    if isinstance(default, bool):
        return text.strip().lower() in ("true", "1")
    if isinstance(default, str):
        return text
    number = float(text) / setting.unit
    return round(number) if isinstance(default, int) else number


def format_value(setting, value):
    """Returns the text of a value in the dialect."""
    if isinstance(setting.default, bool):
        return "true" if value else "false"
    if isinstance(setting.default, str):
        return str(value)
    number = float(value) * setting.unit
    return str(round(number)) if isinstance(setting.default, int) else repr(number)
