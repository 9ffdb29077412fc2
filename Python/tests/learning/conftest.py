# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A run of the street with traffic: exact points, of every 8th pulse."""

import types

import pytest

import vtkhelios
from vtkhelios import cli, formats
from vtkhelios.example_surveys import write_example
from vtkhelios.learning import Content

MOUNT = 1.8  # height of the sensor above the road [m]


@pytest.fixture(scope="session")
def street(tmp_path_factory):
    """The folder, survey file and run of vtkhelios new --kind street."""
    folder = tmp_path_factory.mktemp("example") / "street"
    write_example("street", folder)
    survey = vtkhelios.read_survey(folder / "street.xml")
    report = survey.run_to(
        folder / "output", "vtp", motion=True, velocities=True, pulses=True, pulse_step=8,
        noise=False, sub_rays=1, without="divergence",
    )  # fmt: skip
    return types.SimpleNamespace(
        folder=folder, file=folder / "street.xml", run=report["folder"], survey=survey
    )


@pytest.fixture(scope="session")
def content(street):
    with formats.open_reader(street.run) as reader:
        return Content.of(reader, survey=street.survey)


@pytest.fixture(scope="session")
def exports(street, tmp_path_factory):
    """Exports the run of the street; returns the folder."""
    made = {}

    def call(layout, *options):
        if (layout, options) not in made:
            folder = tmp_path_factory.mktemp(layout) / "out"
            arguments = ["export", street.run, folder, f"--{layout}", "--quiet", *options]
            assert cli.main([*map(str, arguments)]) == 0
            made[layout, options] = folder
        return made[layout, options]

    return call
