# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The data of views; needs no numpy."""


class View:
    """A thin view of a VTK data object, which is its ``data``."""


def data_of(item):
    """Returns the data object of a Cloud, unchanged, or of a Scene; anything else is returned."""
    return item.data if isinstance(item, View) else getattr(item, "polydata", item)
