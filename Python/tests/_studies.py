# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Programs of Python/studies as modules, and their quick runs."""

import importlib.util
import pathlib

import pytest

STUDIES = pathlib.Path(__file__).resolve().parents[1] / "studies"


def load(name):
    spec = importlib.util.spec_from_file_location(name, STUDIES / f"{name}.py")
    study = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(study)
    return study


def run_quick(study, tmp_path_factory):
    """The numbers of a quick run, and the folder it wrote."""
    folder = tmp_path_factory.mktemp("study")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sys.argv", [f"{study.__name__}.py", str(folder), "--quick"])
        return study.main(), folder
