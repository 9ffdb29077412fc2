# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of the classes of LAS files."""

# ASPRS classes used by scenes.
CLASSES = {
    0: "never classified", 1: "unclassified", 2: "ground", 3: "low vegetation",
    4: "medium vegetation", 5: "high vegetation", 6: "building", 7: "low noise", 9: "water",
    10: "rail", 11: "road", 13: "wire, guard", 14: "wire, conductor", 15: "tower", 17: "bridge",
}  # fmt: skip
