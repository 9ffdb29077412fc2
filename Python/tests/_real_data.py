# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of real instruments, which are not part of the project: tests skip where they are absent.

They are searched in real/ of the folder HELIOS_DATA, by default shared/data beside the checkout.
"""

import os
import pathlib

import pytest

DEFAULT = pathlib.Path(__file__).resolve().parents[3] / "shared/data"


def real_file(name):
    """The path of a file, as in "pattern/livox_mid40.npy"; skips the test if it is absent."""
    path = pathlib.Path(os.environ.get("HELIOS_DATA") or DEFAULT) / "real" / name
    if not path.is_file():
        pytest.skip(f"no {name} in {path.parents[len(pathlib.PurePath(name).parts) - 1]}")
    return path
