# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The list of vtkhelios list platforms."""

from ...catalogue import find_platforms as find  # noqa: F401  of this list

COLUMNS = ("platform", "name", "type", "mount")
LEGEND = (
    "mount: x (right), y (forward), z (up) of the scanner [m]; Docs/platforms.md describes how each type moves. "
    'platform="interpolated" follows a recorded trajectory (Docs/trajectories.md)'
)


def explain_none(text):
    """The error if nothing is found."""
    return (
        f'"{text}": no platform has all these words in its id, name or type; '
        "vtkhelios list platforms lists all"
    )


def row_of(platform):
    """Returns the words of a line."""
    mount = ", ".join(f"{value:g}" for value in platform.mount)
    return platform.reference, platform.name, platform.type, mount


def facts_of(platform):
    """Returns the facts that --json prints for a platform."""
    facts = platform._asdict()
    facts["mount_m"] = facts.pop("mount")
    return facts
