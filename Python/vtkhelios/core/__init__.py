# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tools that every other package uses: wrapped classes, pipelines, files, paths, messages."""
