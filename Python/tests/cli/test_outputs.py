# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Outputs of a run besides the echoes: the same in memory, in files, in blocks and in the report."""

import argparse
import json

import numpy as np
import pytest

import vtkhelios
from vtkhelios import arrays, cli, update
from vtkhelios.surveys.outputs import OUTPUTS, in_files, in_memory
from vtkhelios.core.properties import properties
from vtkhelios.cli._run.outputs import add_output_arguments, set_outputs
from vtkhelios.reports.options import describe_options

PORTS = {"points": None, "pulse": "pulses", "hits": "sub_rays"}  # files only: attribute of a Cloud
OF_ONE_FORMAT = {"colors": "las"} | dict.fromkeys(
    ("truth", "columns", "velocities", "motion"), "vtp"
)


pytestmark = pytest.mark.filterwarnings("ignore:GenerateColors is on, but the scene has no colours")


@pytest.fixture
def survey(make_survey):
    return vtkhelios.read_survey(make_survey(stop=5))


def test_files_are_what_a_run_in_memory_returns(survey, tmp_path):
    options = dict.fromkeys(in_memory(), True) | {"seed": 3, "sub_rays": 7}
    cloud = survey.run(**options)
    report = survey.run_to(tmp_path, format="vtp", **options)
    for name, attribute in PORTS.items():
        path = report["folder"] / f"leg000_{name}.pvtp"
        found = arrays(update(vtkhelios.vtkHeliosPointXMLReader(file_name=path)))
        wanted = getattr(cloud, attribute) if attribute else cloud
        for key, values in arrays(wanted.data).items():
            assert np.array_equal(found[key], values), (name, key)
    assert (report["folder"] / "leg000_fullwave.pvtt").exists()
    assert all(report["options"][output.key] is True for output in OUTPUTS if output.source)


@pytest.mark.parametrize("output", OUTPUTS, ids=lambda output: output.name)
def test_each_is_an_option_of_files_and_of_the_command_line(output, survey, tmp_path):
    form = OF_ONE_FORMAT.get(output.name, "las")
    options = {output.name: True, "waveforms": True, "format": form}
    report = survey.run_to(tmp_path / "python", **options)
    words = ["--waveforms", "--format", form, *{output.option, "--waveforms"} - {"--waveforms"}]
    code = cli.main(["run", str(survey.path), "--quiet", "--output", str(tmp_path / "cli"), *words])
    assert code == 0
    summary = json.loads((tmp_path / "cli/plane/run_summary.json").read_text())
    assert summary["options"] == report["options"] and summary["options"][output.key] is True
    titles = dict(describe_options(summary["options"]))
    assert titles[output.title] == output.state


def test_the_report_has_words_for_all_options(survey, tmp_path):
    report = survey.run_to(tmp_path, format="las", weather="fog 0.5", colors=True, hits=True)
    titles = dict(describe_options(report["options"]))
    assert titles["weather"] == "fog 0.5" and titles["colours of surfaces"] == "written, as RGB"
    assert not set(titles) & {name for name in report["options"] if not name.islower()}


def test_the_table_has_all_properties():
    """Properties of outputs are named Generate... and Write..."""
    for cls, table, start in (
        (vtkhelios.vtkHeliosSurveySource, in_memory(), "generate_"),
        (vtkhelios.vtkHeliosSurveyPlayer, in_files(), "write_"),
    ):
        assert {name for name in properties(cls) if name.startswith(start)} <= set(table.values())
        assert set(table.values()) <= set(properties(cls))
    parser, player = argparse.ArgumentParser(), vtkhelios.vtkHeliosSurveyPlayer()
    add_output_arguments(parser)
    set_outputs(player, parser.parse_args([output.option for output in OUTPUTS]))
    assert all(getattr(player, name) for name in in_files().values())


def test_parts_with_hits_join_to_the_whole(make_survey, tmp_path, capsys):
    """With blocks larger than the pieces of text."""
    survey = str(make_survey(stop=30))
    options = ["--hits", "--pulses-per-block", "40000", "--quiet", "--no-accuracy-report"]
    for form in ("xyz", "las"):
        whole, parts, joined = (
            str(tmp_path / form / name) for name in ("whole", "parts", "joined")
        )
        run = ["run", survey, "--format", form, *options]
        assert cli.main([*run, "--output", whole]) == 0
        for part in ("1/2", "2/2"):
            assert cli.main([*run, "--output", parts, "--part", part]) == 0
        assert cli.main(["join", f"{parts}/plane", "--output", joined, "--quiet"]) == 0
        files = {path.name for path in (tmp_path / form / "whole/plane").iterdir()}
        hits = {name for name in files if "_hits_" in name}
        assert hits == {"leg000_hits_0000.vtp", "leg000_hits_0001.vtp"}
        assert files == {path.name for path in (tmp_path / form / "joined/plane").iterdir()}
        for name in files - {"run_summary.json"}:
            both = [
                (tmp_path / form / each / "plane" / name).read_bytes()
                for each in ("whole", "joined")
            ]
            assert both[0] == both[1], name


def test_the_table_names_the_arrays_of_each_output(survey):
    """An output has the arrays that a run has with it, and not without."""
    plain = set(arrays(survey.run().data))
    for output in OUTPUTS:
        if output.source:
            cloud = survey.run(**{output.name: True})
            assert set(arrays(cloud.data)) - plain == set(output.arrays.split()), output.name
