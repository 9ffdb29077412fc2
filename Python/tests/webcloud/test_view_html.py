# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios view --html and the page beside a report: runs, files and surveys; every error."""

import json
import shutil

import numpy as np
import pytest
from _real_data import real_file
from webcloud._page_reader import PageReader

from vtkhelios import cli, formats
from vtkhelios.cli import view

FORMATS = ("las", "xyz", "vtp")


@pytest.fixture
def view_html(tmp_path, capsys):
    """Writes a page; returns (exit code, page or None, standard output, standard error)."""

    def call(source, *arguments, name="page.html"):
        capsys.readouterr()
        path = tmp_path / name
        code = cli.main(["view", str(source), f"--html={path}", *map(str, arguments)])
        out, err = capsys.readouterr()
        return code, PageReader(path.read_text()) if code == 0 else None, out, err

    return call


def echoes_of(folder):
    """All arrays of a run, by the reader of its format."""
    with formats.open_reader(folder) as reader:
        chunks = list(reader.chunks())
    return {name: np.concatenate([chunk[name] for chunk in chunks]) for name in chunks[0]}


@pytest.mark.parametrize("kind", FORMATS)
def test_page_of_a_run(small_runs, view_html, kind):
    """Every echo, and the waveforms, which are the same whatever their file."""
    code, page, out, _ = view_html(small_runs[kind])
    echoes = echoes_of(small_runs[kind])
    points, values = page.cloud()
    assert code == 0 and len(points) == len(echoes["points"]) and "points" in out
    order = np.lexsort((echoes["ReturnNumber"], echoes["PulseIds"]))
    back = np.lexsort((values["ReturnNumber"], values["PulseIds"]))
    assert np.abs(points[back] - echoes["points"][order]).max() <= 0.5001e-4
    assert np.allclose(values["Amplitude"][back], echoes["Amplitude"][order], rtol=1.6e-5, atol=0)
    assert page.meta["title"] == "fence" and page.meta["crs"] == (
        "" if kind == "xyz" else "EPSG:25832 (ETRS89 / UTM zone 32N)"
    )
    waves = page.meta["waveforms"]
    assert waves["of"] == len(np.unique(echoes["PulseIds"])) == waves["count"]


def test_page_of_a_file_and_of_its_waveforms(small_runs, view_html):
    path = next(small_runs["las"].glob("leg000_points.las"))
    _, page, _, _ = view_html(
        path, "--points", 1000, "--color-by", "AMPLITUDE", "--arrays", "Amplitude,PulseIds"
    )
    assert page.meta["shown"] == 1000 < page.meta["total"] and page.meta["colourBy"] == "Amplitude"
    assert [column["name"] for column in page.meta["columns"]] == ["PulseIds", "Amplitude"]
    assert page.meta["waveforms"]["count"] > 900


def test_page_of_a_survey(make_survey, view_html):
    code, page, _, err = view_html(make_survey(stop=5), "--color-by", "incidence", "--waveforms")
    assert code == 0 and err == "" and page.meta["colourBy"] == "IncidenceAngle"
    points, values = page.cloud()
    assert np.abs(points[:, 2]).max() < 0.05 and page.meta["waveforms"]["count"] > 1000
    _, page, _, _ = view_html(make_survey(stop=5), "--overwrite")
    assert page.meta["waveforms"] is None


def test_waveforms_of_an_instrument(view_html):
    """Points refer to them by their time."""
    path = real_file("waveform/100429_152240_2535pt_UTM.las")
    _, page, _, _ = view_html(path)
    waves = page.meta["waveforms"]
    values = page.cloud()[1]
    assert waves["count"] == waves["of"] > 2300 and (values["PulseIds"] >= 0).all()
    echoes = echoes_of(path)
    row = int(np.flatnonzero(values["GpsTime"] == np.round(echoes["GpsTime"][0], 7))[0])
    assert values["PulseIds"][row] == 0 and values["Intensity"][row] == echoes["Intensity"][0]


def test_cloud_of_an_instrument(view_html):
    """LAZ in hundredths of feet, at projected coordinates: in metres."""
    pytest.importorskip("lazrs")
    path = real_file("als/autzen_trim.laz")
    _, page, _, _ = view_html(path, "--arrays", "GpsTime,ReturnNumber,Intensity")
    points, values = page.cloud()
    echoes = echoes_of(path)
    order = np.lexsort(
        (echoes["ReturnNumber"], np.round(echoes["GpsTime"], 7), echoes["points"][:, 0])
    )
    back = np.lexsort((values["ReturnNumber"], values["GpsTime"], points[:, 0]))
    assert np.abs(points[back] - 0.3048 * echoes["points"][order]).max() <= 0.5001e-4
    assert np.array_equal(values["Intensity"][back], echoes["Intensity"][order])


def test_first_view_shows_the_classes_if_there_are_several(tmp_path, view_html):
    arrays = {
        "points": np.random.default_rng(1).normal(size=(50, 3)),
        "ClassificationIds": np.arange(50) % 2,
    }
    with formats.open_writer(tmp_path / "a.ply") as writer:
        writer.write(arrays)
    assert view_html(tmp_path / "a.ply")[1].meta["colourBy"] == "ClassificationIds"
    arrays["ClassificationIds"] = np.zeros(50, int)
    with formats.open_writer(tmp_path / "b.ply") as writer:
        writer.write(arrays)
    assert view_html(tmp_path / "b.ply", "--overwrite")[1].meta["colourBy"] == "Height"


def test_errors(small_runs, view_html, tmp_path, make_survey, capsys):
    run = small_runs["xyz"]
    assert view_html(run)[0] == 0
    for arguments, message in {
        (run,): "page.html: already exists; give --overwrite to replace it",
        (
            run,
            "--overwrite",
            "--color-by",
            "rnge",
        ): "--color-by rnge: the cloud has no such array; it has: Height",
        (run, "--overwrite", "--color-by", "Amplitde"): "did you mean Amplitude?",
        (
            run,
            "--overwrite",
            "--arrays",
            "Range,Amplitude",
        ): "has no array Range for --arrays; of those it has",
        (tmp_path / "none.las", "--overwrite"): "none.las: no such file; check its name",
        (tmp_path / "none.xml", "--overwrite"): "none.xml",
        (tmp_path / "a.abc", "--overwrite"): "its ending is not of a known format",
        (make_survey(), "--overwrite", "--assets", tmp_path / "no"): "no: no such folder",
    }.items():
        code, _, _, err = view_html(*arguments)
        assert code == 1 and message in err and err.count("error:") == 1, err
    (tmp_path / "file").write_text("")
    code, _, _, err = view_html(run, name="file/page.html")
    assert code == 1 and "cannot be written: " in err and "give another --html" in err
    (tmp_path / "empty.xyz").write_text("nan 1 2\n")
    code, _, _, err = view_html(tmp_path / "empty.xyz", "--overwrite")
    assert code == 1 and "empty.xyz" in err and "points" in err
    for words, message in {
        ("--points", "0"): "'0' is not a whole number from 1",
        ("--pionts", "3"): "did you mean --points?",
    }.items():
        with pytest.raises(SystemExit):
            view_html(run, *words)
        assert message in capsys.readouterr().err
    assert not list(tmp_path.glob("*.part"))


def test_arrays_that_some_legs_lack(small_runs, view_html, tmp_path):
    run = tmp_path / "run"
    shutil.copytree(small_runs["vtp"], run)
    path = run / "leg001_points_0000.vtp"
    with formats.open_reader(path) as reader:
        chunks = list(reader.chunks())
    path.unlink()
    with formats.open_writer(path) as writer:
        for chunk in chunks:
            writer.write({name: values for name, values in chunk.items() if name != "EchoWidth"})
    code, page, _, err = view_html(run)
    assert code == 0 and f"{run}: EchoWidth: not in all of its files; left out" in err
    names = [column["name"] for column in page.meta["columns"]]
    assert "EchoWidth" not in names and "Range" in names


def test_names_that_are_not_utf8(small_runs, view_html, tmp_path):
    odd = tmp_path / "odd\udcff.xyz"
    shutil.copy(next(small_runs["xyz"].glob("leg000_points.xyz")), odd)
    assert view_html(odd)[1].meta["title"] == "odd�.xyz"


def test_help(capsys):
    with pytest.raises(SystemExit) as end:
        cli.main(["view", "--html", "--help"])
    assert end.value.code == 0 and "--color-by ARRAY" in capsys.readouterr().out


def test_viewer_is_started_without_html(monkeypatch):
    monkeypatch.setattr(view, "find_viewer", lambda: "/viewer")
    started = []
    monkeypatch.setattr(view.os, "execv", lambda program, words: started.append(words))
    cli.main(["view", "a.las", "--still", "--htm"])
    assert started[0][:4] == ["/viewer", "a.las", "--still", "--htm"]


# Reports


def test_report_has_a_page_of_the_cloud(small_runs, tmp_path, capsys):
    pytest.importorskip("matplotlib")
    run = tmp_path / "run"
    shutil.copytree(small_runs["vtp"], run)
    assert cli.main(["report", str(run)]) == 0
    page = PageReader((run / "report_cloud.html").read_text())
    assert (
        page.meta["shown"] == page.meta["total"] > 40_000
        and page.meta["waveforms"]["count"] > 30_000
    )
    assert (
        '<a href="report_cloud.html">The point cloud</a>: 42,' in (run / "report.html").read_text()
    )
    assert f"cloud    {run / 'report_cloud.html'} (" in capsys.readouterr().out
    assert (
        cli.main(["report", str(run)]) == 1
        and "report.html: already exists" in capsys.readouterr().err
    )
    (run / "report.html").unlink()
    assert cli.main(["report", str(run)]) == 1
    assert "report_cloud.html: already exists; give --overwrite" in capsys.readouterr().err
    assert cli.main(["report", str(run), "--cloud-points", "100", "--overwrite", "--json"]) == 0
    json.loads(capsys.readouterr().out)
    assert PageReader((run / "report_cloud.html").read_text()).meta["shown"] == 100
    assert "100 of 42," in (run / "report.html").read_text()


def test_report_without_the_page_of_the_cloud(small_runs, tmp_path):
    pytest.importorskip("matplotlib")
    page = tmp_path / "new" / "r s.html"
    assert (
        cli.main(["report", str(small_runs["xyz"]), "--output", str(page), "--cloud-points", "0"])
        == 0
    )
    assert "The point cloud" not in page.read_text() and [page] == list(page.parent.iterdir())
    arguments = ["report", str(small_runs["xyz"]), "--output", str(page), "--overwrite"]
    assert cli.main([*arguments, "--cloud-points", "10"]) == 0
    assert (
        'href="r%20s_cloud.html"' in page.read_text() and (page.parent / "r s_cloud.html").is_file()
    )
