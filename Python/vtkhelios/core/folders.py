# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The folder of the package's data."""

import pathlib


def data_directory():
    """Returns the folder with the scanners, platforms and surveys shipped with vtkHelios (a
    Path)."""
    return pathlib.Path(__file__).absolute().parents[1] / "data"
