# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reports, pages and pictures: a module per subject, over page, template, charts and raster."""
