# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of numbers as text."""

import io

import numpy as np

from ..core.files import write_whole


def write_table(path, rows, form):
    """Writes rows of numbers as text, in a format of printf."""
    text = io.BytesIO()
    np.savetxt(text, rows, form)
    write_whole(path, text.getvalue())
