# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tutorials of Docs/tutorials run as they are written, and their notebooks are those of the pages."""

import importlib.util
import json
import os
import pathlib
import shutil
import subprocess
import sys

import numpy as np
import pytest

import vtkhelios

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "Docs/tutorials"
LAUNCHER = pathlib.Path(vtkhelios.__file__).absolute().parents[4] / "bin/vtkhelios"

spec = importlib.util.spec_from_file_location("make_tutorials", ROOT / "Python/make_tutorials.py")
maker = importlib.util.module_from_spec(spec)
spec.loader.exec_module(maker)


@pytest.fixture
def run_page(tmp_path, monkeypatch):
    """Runs the cells of a page in an empty folder; returns the names of its Python cells and all that commands printed."""
    pytest.importorskip("matplotlib")
    monkeypatch.setenv("MPLBACKEND", "Agg")
    monkeypatch.setenv("PATH", f"{LAUNCHER.parent}:{os.environ['PATH']}")
    monkeypatch.chdir(tmp_path)

    def run(name):
        names, said = {"__name__": "__main__"}, ""
        for number, (kind, code, file) in enumerate(maker.read_cells((FOLDER / name).read_text())):
            if kind == "file":
                pathlib.Path(file).write_text(code)
            elif kind == "python":
                exec(compile(code, f"{name}, cell {number}", "exec"), names)
            elif kind == "shell":
                done = subprocess.run(
                    ["bash", "-ec", code], capture_output=True, text=True, check=False
                )
                assert done.returncode == 0, done.stderr
                said += done.stdout
        return names, said

    return run


@pytest.mark.parametrize("page", maker.PAGES, ids=lambda page: page.stem)
def test_notebooks_are_of_today(page):
    notebook = page.with_suffix(".ipynb").read_text(encoding="utf-8")
    assert notebook == maker.make_notebook(
        page.read_text(encoding="utf-8")
    ), "run build/venv/bin/python Python/make_tutorials.py"
    assert f"[{page.stem}.ipynb]({page.stem}.ipynb)" in page.read_text(encoding="utf-8")


def test_cells():
    page = "# A\n\n`b/c.xml`:\n\n```xml\n<a/>\n```\n\nSee `d.tif`:\n\n```python\nx = 1\n```\n\n```\nls\n```\n\n```text\nz\n```\n"
    assert maker.read_cells(page) == [
        ("text", "# A\n\n`b/c.xml`:", ""),
        ("file", "<a/>", "b/c.xml"),
        ("text", "See `d.tif`:", ""),
        ("python", "x = 1", ""),
        ("shell", "ls", ""),
        ("text", "```text\nz\n```", ""),
    ]
    cells = json.loads(maker.make_notebook(page))["cells"]
    assert ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"] == [
        "%%writefile b/c.xml\n<a/>",
        "x = 1",
        "%%bash -e\nls",
    ]


def test_forest(run_page, tmp_path):
    names, said = run_page("forest.md")
    assert "material   needle" in said and "LAI" in said
    lai, shadow = names["lai"], {
        key: each["shadowed"].mean() for key, each in names["profiles"].items()
    }
    assert 0.5 < lai["three"] / names["true_lai"] < lai["five"] / names["true_lai"] < 0.9
    assert shadow["five"] < 0.5 * shadow["three"]
    assert {"profile.csv", "found.vox", "forest.png"} <= {path.name for path in tmp_path.iterdir()}


def test_building_site(run_page, tmp_path):
    for library in ("laspy", "lazrs", "pye57", "jinja2"):
        pytest.importorskip(library)
    names, said = run_page("building-site.md")
    assert "3 scans, proved to be the minimum" in said
    plan = tmp_path / "plan/works"
    kinds = {path.suffix for path in plan.glob("positions.*")} | {
        path.name for path in plan.iterdir()
    }
    assert {".csv", ".dxf", ".geojson", ".gpx", ".kml", "plan.html", "survey.xml"} <= kinds
    assert names["seen"].mean() > 0.7 and abs(np.median(names["difference"])) < 0.1
    assert "EPSG" in json.dumps(names["city"]) and (tmp_path / "works.e57").is_file()
    for gdal in filter(importlib.util.find_spec, ["osgeo"]):
        raster = importlib.import_module(f"{gdal}.gdal").Open("dtm.asc")
        assert (raster.RasterXSize, raster.RasterYSize) == (75, 70)
        assert raster.GetGeoTransform() == (478165, 1, 0, 5472115, 0, -1)


def test_street(run_page, tmp_path):
    names, said = run_page("street.md")
    assert said.count("40 scans") == 2
    assert min(names["counts"].values()) > 1000
    assert names["shares"]["road"] > 0.9 and names["shares"]["building"] > 0.8
    assert (tmp_path / "street.png").is_file()


@pytest.mark.parametrize("page", maker.PAGES, ids=lambda page: page.stem)
def test_notebook_in_jupyter(page, tmp_path, monkeypatch):
    """The notebook runs in a kernel, if Jupyter is installed (Testing/run.sh --browser)."""
    nbclient, nbformat = pytest.importorskip("nbclient"), pytest.importorskip("nbformat")
    pytest.importorskip("ipykernel")
    monkeypatch.setenv("PATH", f"{LAUNCHER.parent}:{os.environ['PATH']}")
    monkeypatch.setenv("PYTHONPATH", ":".join(sys.path))
    shutil.copy(page.with_suffix(".ipynb"), tmp_path)
    notebook = nbformat.read(tmp_path / f"{page.stem}.ipynb", as_version=4)
    client = nbclient.NotebookClient(
        notebook, timeout=600, resources={"metadata": {"path": str(tmp_path)}}
    )
    client.execute()
