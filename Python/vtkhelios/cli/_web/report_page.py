# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of the cloud beside a report."""

import urllib.parse

from ...reports.run import readable
from ...webcloud import Contents
from .view_page import write_page


class ReportCloud:
    """The cloud of a report, read with it chunk by chunk; without points: no page."""

    def __init__(self, report, points):
        self.path = report.with_name(f"{report.stem}_cloud{report.suffix}") if points else None
        self._points = points
        self._contents = None

    def begin(self, reader):
        if self.path:
            self._contents = Contents.of_reader(reader, self._points)

    def add(self, chunk):
        if self._contents:
            self._contents.add(chunk)

    def write(self):
        """Writes the page; returns its link for the report: href, points, size. None: no page."""
        if not self._contents:
            return None
        write_page(self._contents, self.path)
        shown, count = min(self._points, self._contents.sample.count), self._contents.sample.count
        return {
            "href": urllib.parse.quote(self.path.name, errors="surrogateescape"),
            "points": f"{shown:,}" if shown == count else f"{shown:,} of {count:,}",
            "size": readable(self.path.stat().st_size),
        }
