# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that are removed if a signal ends the process."""

import os

from .. import _native


def set_unfinished(path, is_unfinished=True):
    """Sets whether a signal that ends the process removes a file."""
    _native.remove_at_end(os.path.abspath(os.fsencode(path)), is_unfinished)
