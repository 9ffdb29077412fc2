# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of vtkhelios detect: LAZ as LAS, and others."""

import pytest

from vtkhelios import cli


@pytest.fixture
def fullwave(make_survey, tmp_path):
    options = ("--format", "las", "--waveforms", "--quiet", "--output", tmp_path / "out")
    assert cli.main(["run", str(make_survey(stop=2)), *map(str, options)]) == 0
    return tmp_path / "out/plane/leg000_fullwave.las"


def detect(path, output):
    return cli.main(["detect", str(path), "-o", str(output), "--pulse-length", "3"])


@pytest.mark.parametrize("packets", ["internal", "external"])
def test_laz_gives_the_echoes_of_las(packets, fullwave, tmp_path):
    pytest.importorskip("lazrs")
    laz = tmp_path / "full.laz"
    assert cli.main(["convert", str(fullwave), str(laz), "--waveforms", packets, "--quiet"]) == 0
    assert detect(fullwave, tmp_path / "las.xyz") == detect(laz, tmp_path / "laz.xyz") == 0
    assert (tmp_path / "laz.xyz").read_bytes() == (tmp_path / "las.xyz").read_bytes()
    assert (tmp_path / "las.xyz").stat().st_size > 1000


def test_a_missing_pulse_length_names_the_option(fullwave, tmp_path, capsys):
    assert cli.main(["detect", str(fullwave), "-o", str(tmp_path / "a.xyz")]) == 1
    assert "not a positive number of ns; give --pulse-length" in capsys.readouterr().err


def test_files_without_waveforms_are_one_error(fullwave, tmp_path, capsys):
    pytest.importorskip("lazrs")
    points = fullwave.with_name("leg000_points.las")
    for name, reason in (
        (
            "plain.laz",
            "is LAS 1.4, point format 6, which has no waveforms; give a file of point format 4",
        ),
        (
            "plain.ply",
            "files of this kind have no waveforms; give those of a run, such as leg000_fullwave.txt or ",
        ),
    ):
        assert cli.main(["convert", str(points), str(tmp_path / name), "--quiet"]) == 0
        capsys.readouterr()
        assert detect(tmp_path / name, tmp_path / "none.xyz") == 1
        assert f"{tmp_path / name}: {reason}" in capsys.readouterr().err
        assert not (tmp_path / "none.xyz").exists()
