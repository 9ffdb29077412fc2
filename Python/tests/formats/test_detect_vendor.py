# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios detect on LAS with waveforms: of a run, and of an airborne RIEGL scanner.

The instrument's file comes from github.com/PulseWaves/PulseWaves, data/RIEGL; see test_pulsewaves.py.
"""

import importlib.util
import os
import pathlib
import shutil

import numpy as np
import pytest

from vtkhelios import cli, formats

DEFAULT = pathlib.Path(__file__).resolve().parents[4] / "shared" / "data"
REAL = pathlib.Path(os.environ.get("HELIOS_DATA", DEFAULT)) / "real" / "waveform"
RIEGL = REAL / "100429_152240_2535pt_UTM.las"
STUDIES = pathlib.Path(__file__).resolve().parents[2] / "studies"


def load_study():
    spec = importlib.util.spec_from_file_location("validation", STUDIES / "validate_waveforms.py")
    study = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(study)
    return study


@pytest.fixture
def detect(tmp_path, capsys):
    def call(path, *options):
        capsys.readouterr()
        words = ["detect", path, "--pulse-length", "4.2", "-o", tmp_path / "found.pvtp", *options]
        return cli.main([*map(str, words)]), capsys.readouterr().err

    return call


def read(path):
    with formats.open_reader(path) as reader:
        chunks = list(reader.chunks())
        return {name: np.concatenate([each[name] for each in chunks]) for name in chunks[0]}


def test_echoes_of_a_run_in_las_equal_those_in_vtk_xml(small_runs, detect, tmp_path):
    found = []
    for name in ("las/fence/leg000_points.las", "vtp/fence/leg000_fullwave.pvtt"):
        path = small_runs["las"].parents[1] / name
        assert detect(path, "--threshold", "1e-3") == (0, "")
        found.append(read(tmp_path / "found.pvtp"))
    las, xml = found
    assert len(las["PulseIds"]) > 1000
    assert np.array_equal(las["PulseIds"], xml["PulseIds"])
    away = np.linalg.norm(las["points"] - xml["points"], axis=1)
    assert np.median(away) < 1e-4 and away.max() < 2e-3  # LAS rounds points to 0.1 mm


def test_errors_say_what_is_missing(small_runs, detect, tmp_path):
    run = small_runs["las"]
    code, error = detect(small_runs["las"].parents[1] / "missing.las")
    assert code == 1 and "missing.las: no such file; check its name" in error
    shutil.copy(run / "leg000_points.las", tmp_path / "a.las")
    code, error = detect(tmp_path / "a.las")
    assert code == 1 and "a.wdp: cannot be read, but holds the waveforms of" in error
    (tmp_path / "a.wdz").write_bytes(b"compressed")
    code, error = detect(tmp_path / "a.las")
    assert code == 1 and "a.wdz: compressed waveforms (.wdz) cannot be read; decompress" in error
    whole = (run / "leg000_points.wdp").read_bytes()
    (tmp_path / "a.wdp").write_bytes(whole[: len(whole) // 2])
    code, error = detect(tmp_path / "a.las")
    assert code == 1 and "beyond the end of" in error and "a.wdp" in error
    with formats.open_reader(tmp_path / "a.las") as reader:  # the points are there
        assert sum(len(chunk["points"]) for chunk in reader.chunks()) == reader.count
        with formats.open_writer(tmp_path / "b.las", reader.header) as writer:
            for chunk in reader.chunks():
                writer.write(chunk)
    code, error = detect(tmp_path / "b.las")
    assert code == 1 and "b.las: is LAS 1.4, point format 6, which has no waveforms; give" in error
    assert not list(tmp_path.glob("found*"))


def test_convert_names_compressed_waveforms(small_runs, tmp_path, capsys):
    pytest.importorskip("laspy")
    shutil.copy(small_runs["las"] / "leg000_points.las", tmp_path / "a.las")
    (tmp_path / "a.wdz").write_bytes(b"compressed")
    assert cli.main(["convert", str(tmp_path / "a.las"), str(tmp_path / "b.las")]) == 1
    assert "its waveforms are compressed (a.wdz), which cannot be read" in capsys.readouterr().err


@pytest.mark.parametrize("option", [["--fit-background"], ["--relative-threshold", "0.1"]])
def test_options_of_the_gaussian_detector(small_runs, detect, option):
    code, error = detect(small_runs["las"] / "leg000_points.las", *option)
    assert code == 2 and "need --detector gaussian: give it" in error


@pytest.mark.skipif(not RIEGL.is_file(), reason="without the data of the vendor")
def test_echoes_of_an_instrument_equal_the_makers():
    """Separations of two echoes and widths of single ones: Docs/validation/waveforms.md has the table."""
    row = load_study().compare_echoes(RIEGL, relative_threshold=0.1, ringing_time=30.0)
    assert row["packets with the maker's number of echoes"] > 2290  # 2375 in all
    assert row["pairs found"] >= 119  # 144 in all, of which 15 have one maximum
    assert row["separation: median absolute deviation [mm]"] < 5.0
    assert abs(row["separation: median difference [mm]"]) < 2.5
    assert abs(row["width: median difference [%]"]) < 1.0
    assert row["later echo nearer"] == 0


@pytest.mark.parametrize("name, edges", [("bcts_1", 768), ("autzen_trim", 0)])
def test_flags_of_airborne_files(name, edges):
    """The direction flag is 1 where the scan angle rises, as in files of vtkHelios."""
    path = REAL.parent / "als" / f"{name}.laz"
    if not path.is_file():
        pytest.skip("without the data of the vendor")
    pytest.importorskip("lazrs")
    row = load_study().count_flags(name, path)
    assert row["angle rises: flag 1 [%]"] == 100.0
    assert row["angle falls: flag 0 [%]"] > 99.9
    assert row["pulses with an edge"] == row["edge: first after a change"] == edges
