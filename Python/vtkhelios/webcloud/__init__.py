# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A point cloud as one HTML page that needs no network: levels of detail, colours, picking, waveforms.

>>> from vtkhelios import webcloud
>>> text = webcloud.make_page({"points": points, "Range": ranges}, title="my cloud")

The page is made of a sample of at most LIMIT points (_sample.py), in an octree (_octree.py), as whole
numbers (_quantise.py) in compressed streams (_pack.py); page/ has its scripts.
"""

from ._contents import Contents
from ._page import make_page
from ._sample import LIMIT, Sample
from ._show import CloudPage, show

__all__ = ["LIMIT", "CloudPage", "Contents", "Sample", "make_page", "show"]
