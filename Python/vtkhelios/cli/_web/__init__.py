# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages of point clouds: vtkhelios view --html, and the page beside a report."""

from .report_page import ReportCloud
from .view_page import start

__all__ = ["ReportCloud", "start"]
