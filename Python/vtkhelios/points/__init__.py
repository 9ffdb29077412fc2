# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points: as input of filters, selected, and converted from format to format.

>>> from vtkhelios import points
>>> voxelizer.SetInputConnection(points.las_source("trees.laz").GetOutputPort())
"""

from .sources import las_source, points_from_arrays

__all__ = ["las_source", "points_from_arrays"]
