# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Platforms: how they move, and where the scanner is mounted."""

import typing

from ._files import CatalogueError, has_words, read_folders, read_root, shipped_assets


class Platform(typing.NamedTuple):
    """A platform of an XML file."""

    reference: str  # reference in surveys: file.xml#id
    id: str
    name: str
    type: str  # static, linearpath, groundvehicle, multicopter ...
    mount: tuple  # x (right), y (forward), z (up) of the scanner in the body frame [m]


def find_platforms(text="", assets=(), warn=None):
    """Returns the platforms of vtkHelios and of the XML files in folders, in the order of their
    files.

    text
        words that all occur in the reference, name or type, in upper or lower case. Default: all.
    assets, warn
        as of find_scanners().
    """
    found = read_folders(_read_file, [*assets, shipped_assets()], warn)
    return [each for each in found if has_words(text, " ".join(each[:4]))]


def _read_file(path, name):
    return [_read_platform(element, path, name) for element in read_root(path).iter("platform")]


def _read_platform(element, path, name):
    mount = element.find("scannerMount")
    place = {} if mount is None else mount.attrib
    try:
        position = tuple(float(place.get(axis, 0)) for axis in "xyz")
    except ValueError:
        raise CatalogueError(
            f"{path}: platform {element.get('id', '')}: its scannerMount is not valid: expected "
            "numbers; vtkhelios validate FILE lists all errors"
        ) from None
    given = element.attrib
    reference = f"{name}#{given.get('id', '')}"
    return Platform(
        reference, given.get("id", ""), given.get("name", ""), given.get("type", ""), position
    )
