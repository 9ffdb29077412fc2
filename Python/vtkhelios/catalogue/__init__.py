# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The catalogue: scanners with the sources of their numbers, platforms, and scenes of folders.

>>> for each in vtkhelios.catalogue.find_scanners("riegl terrestrial"):
...     print(each.reference, each.pulse_frequencies[-1])
"""

from ._files import CatalogueError
from .platforms import Platform, find_platforms
from .scanners import KINDS, USES, Scanner, Source, find_file, find_scanners, read_file
from .scenes import SceneEntry, find_scenes

__all__ = [
    "KINDS", "USES", "CatalogueError", "Platform", "Scanner", "SceneEntry", "Source", "find_file",
    "find_platforms", "find_scanners", "find_scenes", "read_file",
]  # fmt: skip
