# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A cloud in a notebook: its page in a frame."""

import html

from ..core.files import write_whole
from ._contents import Contents

LIMIT = 200_000  # points, as the notebook file holds the page


class CloudPage:
    """A page of a cloud: shown by notebooks, or written to a file. ``text`` is its HTML."""

    def __init__(self, text, height):
        self.text = text
        self.height = height

    def write(self, path):
        """Writes the page to a file, replacing it."""
        write_whole(path, self.text)

    def _repr_html_(self):
        return (
            f'<iframe srcdoc="{html.escape(self.text)}" title="point cloud" width="100%" '
            f'height="{self.height}" style="border: 0" allowfullscreen></iframe>'
        )

    def __repr__(self):
        return f"CloudPage({len(self.text) / 1e6:.1f} MB); write(path) writes it, notebooks show it"


def show(cloud, points=LIMIT, color_by=None, arrays=None, height=600, title="cloud"):
    """Returns the page of a Cloud: see Cloud.show()."""
    if not 1 <= points <= 2**31:
        raise ValueError(f"points is {points!r}; give the most points of the page, from 1")
    for name in arrays or ():
        cloud[name]  # KeyError with the nearest name
    contents = Contents.of_cloud(cloud, title, int(points), arrays)
    return CloudPage(contents.make_page(color_by), int(height))
