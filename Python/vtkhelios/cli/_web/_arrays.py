# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of arrays in --color-by: their own, or the words of the viewer."""

from ...array_names import (
    AMPLITUDE, CLASSIFICATION_IDS, GPS_TIME, INCIDENCE_ANGLE, LEG_IDS, MATERIAL_IDS, PART_IDS,
    RANGE, RETURN_NUMBER,
)  # fmt: skip
from ...formats import FormatError
from .._parser import nearest

HEIGHT = "Height"  # names of webcloud/page/cloud.js

NAMES = {
    "height": HEIGHT, "amplitude": AMPLITUDE, "return": RETURN_NUMBER, "class": CLASSIFICATION_IDS,
    "time": GPS_TIME, "part": PART_IDS, "material": MATERIAL_IDS, "leg": LEG_IDS,
    "incidence": INCIDENCE_ANGLE, "range": RANGE,
}  # fmt: skip


def find_array(word, contents):
    """Returns the name of the array that a word of --color-by means, or None without a word."""
    if word is None:
        return None
    known = [HEIGHT, *contents.column_names()]
    name = NAMES.get(word, word)
    found = next((each for each in known if each.lower() == name.lower()), None)
    if found is None:
        best = nearest(name, known)
        hint = (
            f"did you mean {best}? (it has: {', '.join(known)})"
            if best
            else f"it has: {', '.join(known)}"
        )
        raise FormatError(f"--color-by {word}: the cloud has no such array; {hint}")
    return found
