# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Programs of Python/studies and Python/examples as modules, and quick runs of studies."""

import importlib.util
import pathlib

import pytest

PYTHON = pathlib.Path(__file__).resolve().parents[1]


def load(name, folder="studies"):
    spec = importlib.util.spec_from_file_location(name, PYTHON / folder / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def run_quick(study, tmp_path_factory):
    """The results of a quick run, and its output folder."""
    folder = tmp_path_factory.mktemp("study")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sys.argv", [f"{study.__name__}.py", str(folder), "--quick"])
        return study.main(), folder
