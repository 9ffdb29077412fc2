# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""One list of endings: what it says is what the commands do, and what Docs/files.md says."""

import importlib.util
import json
import pathlib
import re

import numpy as np
import pytest

import vtkhelios
from vtkhelios import cli, formats
from vtkhelios.formats import _endings

ROOT = pathlib.Path(__file__).resolve().parents[3]
SQUARE = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nf 1 2 3 4\n"


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """A file of each ending that can be made here."""
    folder = tmp_path_factory.mktemp("endings")
    (folder / "a.obj").write_text(SQUARE)
    with formats.open_writer(folder / "a.xyz") as writer:
        writer.write({"points": np.array([[0.0, 0, 0], [1, 2, 3], [4, 4, 1]])})
    made = {".obj": folder / "a.obj", ".xyz": folder / "a.xyz"}
    for ending in _endings.points():
        path = folder / f"made{ending}"
        if (
            ending not in made
            and cli.main(["convert", str(made[".xyz"]), str(path), "--quiet"]) == 0
        ):
            made[ending] = path
    gdal = pytest.importorskip("osgeo.gdal")
    gdal.UseExceptions()
    raster = gdal.GetDriverByName("GTiff").Create(str(folder / "a.tif"), 3, 3, 1, gdal.GDT_Float64)
    raster.SetGeoTransform((0, 1, 0, 3, 0, -1))
    raster.GetRasterBand(1).WriteArray(np.arange(9.0).reshape(3, 3) / 100)
    del raster
    gdal.BuildVRT(str(folder / "a.vrt"), [str(folder / "a.tif")]).FlushCache()
    made |= {".tif": folder / "a.tif", ".vrt": folder / "a.vrt"}
    part = '<part><filter type="objloader"><param key="filepath" value="a.obj"/></filter></part>'
    (folder / "a.xml").write_text(f'<document><scene id="s" name="yard">{part}</scene></document>')
    (folder / "a.yaml").write_text("scene: {id: s, part: {objloader: {filepath: a.obj}}}\n")
    return {**made, ".xml": folder / "a.xml", ".yaml": folder / "a.yaml"}


def test_the_page_has_the_table_of_today():
    spec = importlib.util.spec_from_file_location("make_endings", ROOT / "Python/make_endings.py")
    maker = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(maker)
    text = maker.PAGE.read_text(encoding="utf-8")
    assert maker.make_page(text) == text, "run build/venv/bin/python Python/make_endings.py"


def test_the_viewer_reads_what_the_list_says():
    source = (ROOT / "Apps/Viewer/Cloud/heliosCloudReader.cxx").read_text()
    own = re.search(r"Endings\[\] = \{([^}]*)\}", source)[1]
    assert sorted(re.findall(r'"(\.[^"]+)"', own)) == sorted(
        set(_endings.IN_VIEWER) - {".copc.laz"}  # its ending is .laz there
    )
    assert set(_endings.converted_for_view()) >= {".pcd", ".e57"}


def test_commands_do_what_the_list_says(files, tmp_path, capsys):
    assert len(files) >= 10
    for ending, path in files.items():
        uses = dict(zip(_endings.COMMANDS, _endings.describe(ending)))
        assert uses["info"]
        assert cli.main(["info", str(path), "--json"]) == 0, path
        kind = json.loads(capsys.readouterr().out)["format"]
        assert ("mesh" in kind) == (uses["info"] == "mesh"), (path, kind)
        output = tmp_path / f"from{ending}.obj"
        target = output if uses["convert from"].startswith("mesh") else tmp_path / f"{ending}.xyz"
        target = tmp_path / f"{ending}.yml" if uses["convert from"] == "documents" else target
        done = cli.main(["convert", str(path), str(target), "--quiet"]) == 0
        assert done == bool(uses["convert from"]), path
        capsys.readouterr()
        done = cli.main(["compare", str(path), str(path), "--quiet"]) == 0
        message = capsys.readouterr().err
        assert done or not uses["compare"] or "format" not in message, message


@pytest.mark.parametrize("ending", [".obj", ".tif", ".vrt"])
def test_meshes_are_planned(ending, files, tmp_path, capsys):
    options = ("--grid", "2", "--output", tmp_path / "plans", "--quiet")
    assert cli.main(["plan", str(files[ending]), *map(str, options)]) == 0, capsys.readouterr().err


def test_other_endings_are_refused_with_all_known_ones(tmp_path, capsys):
    (tmp_path / "a.dxf").write_text("0\n")
    assert cli.main(["info", str(tmp_path / "a.dxf")]) == 1
    message = capsys.readouterr().err
    for ending in (*_endings.points(), *_endings.meshes(), ".xml"):
        assert ending in message
    with pytest.raises(
        formats.FormatError, match="is a mesh, not points; vtkhelios info, plan and"
    ):
        formats.open_reader(tmp_path / "a.vrt")
    with pytest.raises(formats.FormatError, match="is a document, not points; vtkhelios info, val"):
        formats.open_reader(tmp_path / "a.xml")


def test_info_shows_what_a_scene_holds(files, capsys):
    assert cli.main(["info", str(files[".xml"]), "--json"]) == 0
    facts = json.loads(capsys.readouterr().out)
    part = {"id": "", "filters": ["objloader"], "files": ["a.obj"]}
    assert facts["scenes"] == [{"id": "s", "name": "yard", "parts": [part], "tables": []}]
    assert cli.main(["info", str(files[".xml"])]) == 0
    assert "scene      s, yard: 1 part\n" in capsys.readouterr().out
    table = files[".xml"].with_name("table.xml")
    text = files[".xml"].read_text()
    model = re.search("<filter.*</filter>", text)[0]
    rows = f'<partTable file="t.csv"><model id="m">{model}</model></partTable></scene>'
    table.write_text(text.replace("</scene>", rows))
    table.with_name("t.csv").write_text("x,y\n1,2\n")
    assert cli.main(["info", str(table)]) == 0, capsys.readouterr().err
    assert "table      t.csv: a part for each row\n" in capsys.readouterr().out
    catalogue = vtkhelios.data_directory() / "Assets/scanners.xml"
    assert cli.main(["info", str(catalogue)]) == 0
    assert re.search(r"scanners   \d+: .*vz400_class_tls", capsys.readouterr().out)


def test_a_damaged_document_is_an_error_of_info(tmp_path, capsys):
    (tmp_path / "a.xml").write_text("<document><scene></document>")
    assert cli.main(["info", str(tmp_path / "a.xml")]) == 1
    assert "a.xml:1: this is not XML" in capsys.readouterr().err
