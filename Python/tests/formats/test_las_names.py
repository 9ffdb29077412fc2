# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of parts and materials beside LAS, LAZ and COPC."""

import json
import re
import shutil

import numpy as np
import pytest
import vtkhelios
from _point_files import read, write
from vtkhelios import cli, formats
from vtkhelios.array_names import MATERIAL_IDS, MATERIAL_NAME, PART_IDS
from vtkhelios.core.classes import vtk_class
from vtkhelios.formats._base import to_cloud

pytest.importorskip("lazrs")
PARTS, MATERIALS = ["ground", "größtes Haus", "", 'a "b"'], ["grass", "brick"]


def make_header(parts=PARTS, materials=MATERIALS):
    header = formats.Header()
    header.part_names = list(parts)
    header.set_texts(MATERIAL_NAME, list(materials))
    return header


def make_chunk(count=4):
    numbers = np.arange(count, dtype=np.int32)
    return {
        "points": np.arange(3.0 * count).reshape(count, 3),
        PART_IDS: numbers % 4 - (numbers == 2),
        MATERIAL_IDS: numbers % 2,
    }


def names_of(reader):
    return reader.header.part_names, reader.header.texts(MATERIAL_NAME)


@pytest.fixture
def convert(capsys):
    def call(*arguments):
        code = cli.main(["convert", *map(str, arguments)])
        return code, capsys.readouterr()

    return call


@pytest.fixture(params=["las", "laz", "copc.laz"])
def ending(request):
    return request.param


def test_names_come_back(tmp_path, ending):
    write(tmp_path / f"a.{ending}", make_chunk(), make_header())
    reader, _ = read(tmp_path / f"a.{ending}")
    assert names_of(reader) == (PARTS, MATERIALS) and not reader.notes
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"a.{ending}", "a.names.json"]
    found = json.loads((tmp_path / "a.names.json").read_text(encoding="utf-8"))
    assert re.fullmatch("[0-9a-f]{64}", found.pop("checksum"))
    assert found == {
        "format": "vtkHelios names of points", "version": 1, "points": 4,
        "parts": PARTS, "materials": MATERIALS,
    }  # fmt: skip


def test_the_points_are_the_same_with_names(tmp_path):
    write(tmp_path / "a.las", make_chunk(), make_header())
    write(tmp_path / "b.las", make_chunk(), formats.Header())
    assert (tmp_path / "a.las").read_bytes() == (tmp_path / "b.las").read_bytes()
    assert not (tmp_path / "b.names.json").exists()


def test_names_of_an_earlier_file_are_removed(tmp_path, ending):
    for header in (make_header(), formats.Header()):
        write(tmp_path / f"a.{ending}", make_chunk(), header)
    assert not (tmp_path / "a.names.json").exists()
    (tmp_path / "a.names.json").write_text('{"mine": 1}')
    write(tmp_path / f"a.{ending}", make_chunk(), formats.Header())
    assert (tmp_path / "a.names.json").read_text() == '{"mine": 1}'


def test_another_file_of_that_name_is_kept(tmp_path, ending):
    (tmp_path / "a.names.json").write_text('{"mine": 1}')
    with pytest.raises(formats.FormatError, match=r"a.names.json: is no file of names: its format"):
        write(tmp_path / f"a.{ending}", make_chunk(), make_header())
    assert [path.name for path in tmp_path.iterdir()] == ["a.names.json"]


@pytest.mark.parametrize("target", ["las", "laz", "copc.laz", "vtp"])
def test_names_are_converted(tmp_path, convert, ending, target):
    write(tmp_path / f"a.{ending}", make_chunk(), make_header())
    code, said = convert(tmp_path / f"a.{ending}", tmp_path / f"b.{target}")
    reader, _ = read(tmp_path / f"b.{target}")
    assert code == 0 and names_of(reader) == (PARTS, MATERIALS)
    assert "dropped" not in said.out + said.err


def test_a_selection_has_the_names(tmp_path, convert):
    write(tmp_path / "a.las", make_chunk(), make_header())
    assert convert(tmp_path / "a.las", tmp_path / "b.laz", "--every", 2)[0] == 0
    assert names_of(read(tmp_path / "b.laz")[0]) == (PARTS, MATERIALS)
    assert json.loads((tmp_path / "b.names.json").read_text("utf-8"))["points"] == 2


def test_other_formats_drop_the_names(tmp_path, convert):
    write(tmp_path / "a.las", make_chunk(), make_header())
    _, said = convert(tmp_path / "a.las", tmp_path / "b.ply")
    assert "dropped  Material.Name, Part.Name: points keep the numbers; LAS, LAZ, COPC" in said.out


def test_merged_files_with_unlike_names_get_new_numbers(tmp_path, convert):
    write(tmp_path / "a.las", make_chunk(), make_header(["ground", "tree"], ["leaf"]))
    write(tmp_path / "b.las", make_chunk(), make_header(["house", "ground"], ["leaf"]))
    code, said = convert(tmp_path / "a.las", tmp_path / "b.las", tmp_path / "c.las", "--merge")
    reader, back = read(tmp_path / "c.las")
    assert code == 0 and "b.las: has other names of parts or materials than" in said.err
    assert names_of(reader) == (["ground", "tree", "house"], ["leaf"])
    # a: 0, 1, none, 3 without a name; b: house, ground, none, 3
    assert back[PART_IDS].tolist() == [0, 1, 1, 3, 2, 0, 0, 3]


def test_equal_names_are_merged_as_records(tmp_path, convert):
    for name in ("a.las", "b.laz"):
        write(tmp_path / name, make_chunk(), make_header())
    code, said = convert(tmp_path / "a.las", tmp_path / "b.laz", tmp_path / "c.las", "--merge")
    assert code == 0 and "warning" not in said.err
    assert names_of(read(tmp_path / "c.las")[0]) == (PARTS, MATERIALS)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{", "a.names.json:1: is not valid JSON at column "),
        ("[]", "a.names.json: is JSON, but no object; check the name of the file"),
        ('{"format": "x"}', "a.names.json: is no file of names: its format is not"),
        ('{"format": "vtkHelios names of points",\n"version": 2}', "a.names.json:2: version is 2"),
        ('{"format": "vtkHelios names of points", "version": 1, "points":\n5}',
         "a.names.json:2: is for a file of 5 points, and .*a.* has 4; correct"),
        ('{"format": "vtkHelios names of points", "version": 1, "points": 4,\n"parts": 1}',
         "a.names.json:2: is 1, not a list of names; write the file again"),
        ('{"format": "vtkHelios names of points", "version": 1, "points": 4, "parts": [\n1]}',
         "a.names.json:2: the name 1 is no text; write the file again"),
    ],
)  # fmt: skip
def test_wrong_files_of_names_are_named(tmp_path, ending, text, message):
    import re

    write(tmp_path / f"a.{ending}", make_chunk(), formats.Header())
    (tmp_path / "a.names.json").write_text(text)
    reader, back = read(tmp_path / f"a.{ending}")
    assert names_of(reader) == ([], []) and len(back["points"]) == 4
    pattern = f"{message}.*" + re.escape("(names are not read)")
    assert len([note for note in reader.notes if re.search(pattern, note)]) == 1


def test_info_lists_parts_and_materials(tmp_path, capsys):
    write(tmp_path / "a.las", make_chunk(), make_header())
    assert cli.main(["info", str(tmp_path / "a.las")]) == 0
    said = capsys.readouterr().out
    assert (
        "parts      größtes Haus: 2, ground: 1" in said and "materials  grass: 2, brick: 2" in said
    )
    assert cli.main(["info", str(tmp_path / "a.las"), "--json"]) == 0
    facts = json.loads(capsys.readouterr().out)
    facts = facts[0] if isinstance(facts, list) else facts
    assert facts["parts"][1] == {"id": 1, "name": "größtes Haus", "points": 2}


def test_an_abandoned_file_leaves_no_names(tmp_path):
    with pytest.raises(ZeroDivisionError), formats.open_writer(
        tmp_path / "a.las", make_header()
    ) as writer:
        writer.write(make_chunk())
        assert (tmp_path / "a.names.json.part").exists()
        raise ZeroDivisionError
    assert list(tmp_path.iterdir()) == []


def test_a_resumed_file_has_the_names(tmp_path):
    """A resumed file has the names of its first part: no block comes after the interruption."""
    writer = vtkhelios.vtkHeliosLASWriter(file_name=str(tmp_path / "a.las"))
    chunk, header = make_chunk(), make_header()
    assert writer.Open() and writer.Write(formats._base.to_cloud(chunk, header))
    size, records, count = (
        writer.GetFileSize(), writer.GetNumberOfRecords(), writer.GetNumberOfBytes(),
    )  # fmt: skip
    writer.Abandon()
    again = vtkhelios.vtkHeliosLASWriter(file_name=str(tmp_path / "a.las"))
    assert again.Reopen(size, records, count) and again.Close()
    assert names_of(read(tmp_path / "a.las")[0]) == (PARTS, MATERIALS)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.las", "a.names.json"]


def test_moved_files_of_the_other_kind_have_the_names(tmp_path, convert):
    """a.laz, packed by any program, has the names of a.las."""
    write(tmp_path / "a.las", make_chunk(), make_header())
    (tmp_path / "b").mkdir()
    convert(tmp_path / "a.las", tmp_path / "b" / "a.laz")
    shutil.copy(tmp_path / "a.names.json", tmp_path / "b" / "a.names.json")
    assert names_of(read(tmp_path / "b" / "a.laz")[0]) == (PARTS, MATERIALS)


def test_names_of_a_run_that_ended_while_it_wrote_them(tmp_path):
    """They have the number of points already, and not yet their name."""
    path = tmp_path / "a.laz"
    writer = vtk_class("vtkHeliosLASWriter")()
    writer.SetFileName(str(path))
    writer.SetWriteCompressed(True)
    assert writer.Open() and writer.Write(to_cloud(make_chunk(), make_header()))
    assert writer.EndBlock()
    state = writer.GetFileSize(), writer.GetNumberOfRecords(), writer.GetNumberOfBytes()
    assert writer.Close()
    expected = (tmp_path / "a.names.json").read_bytes()
    path.rename(tmp_path / "a.laz.part")
    (tmp_path / "a.names.json").rename(tmp_path / "a.names.json.part")
    assert writer.Reopen(*state) and writer.Close()
    assert (tmp_path / "a.names.json").read_bytes() == expected
    assert not (tmp_path / "a.names.json.part").exists()
