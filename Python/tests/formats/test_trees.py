# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Trees keep their number, species, leaf and wood: from scenes and tables through all formats."""

import json

import numpy as np
import pytest

import vtkhelios
from vtkhelios import cli, formats

from vtkhelios.array_names import (
    MATERIAL_IDS, MATERIAL_NAME, ORGAN_IDS, ORGAN_NAME, PART_IDS, SPECIES_IDS, SPECIES_NAME,
    TREE_IDS,
)  # fmt: skip

TREES = (TREE_IDS, SPECIES_IDS, ORGAN_IDS)
SCENE = """\
<document>
<scene id="s">
  <part id="ground"><filter type="objloader"><param key="filepath" value="ground.obj"/></filter></part>
  <part id="shrub" {shrub}><filter type="detailedvoxels"><param key="filepath" value="shrub.vox"/>
    <param key="matfile" value="a.mtl"/><param key="matname" value="leaves"/></filter></part>
  <part id="oak" {oak}><filter type="objloader"><param key="filepath" value="tree.obj"/></filter>
    <filter type="translate"><param key="offset" value="-6;0;0"/></filter></part>
  <partTable file="stand.csv">
    <model id="fir" species="Abies alba"><filter type="objloader"><param key="filepath" value="tree.obj"/></filter></model>
  </partTable>
</scene>
<survey name="v" scene="#s" platform="platforms.xml#airplane_linearpath" scanner="scanners.xml#rotating_als">
  <leg><platformSettings x="-9" y="0" z="200" movePerSec_m="6"/>
    <scannerSettings pulseFreq_hz="150000" scanFreq_hz="20" scanAngle_deg="1"/></leg>
  <leg><platformSettings x="16" y="0" z="200"/><scannerSettings active="false"/></leg>
</survey>
</document>
"""
NUMBERED = dict(shrub='species="Corylus" tree="9"', oak='species="Quercus robur" tree="71"')
ROWS = "model,x,y,z,tree,species\nfir,0,0,,12,\nfir,6,0,,13,Picea abies\n"


def write_scene(folder, shrub="", oak="", rows="model,x,y\nfir,0,0\nfir,6,0\n"):
    (folder / "a.mtl").write_text(
        "newmtl soil\nhelios_classification 2\nhelios_isGround true\n"
        "newmtl Oak_Leaf\nnewmtl bark\nnewmtl leaves\nnewmtl cone\n"
    )
    (folder / "ground.obj").write_text(
        "mtllib a.mtl\nusemtl soil\nv -99 -99 0\nv 99 -99 0\nv 99 99 0\nv -99 99 0\nf 1 2 3 4\n"
    )
    boxes = ((-1, 0, "Oak_Leaf"), (0, 1, "bark"), (1, 2, "cone"))
    corners = ("v {0} -1 {2}\nv {1} -1 {2}\nv {1} 1 {2}\nv {0} 1 {2}\n".format(a, b, 3 + a)
               for a, b, _ in boxes)  # fmt: skip
    faces = (f"usemtl {name}\nf {4 * i + 1} {4 * i + 2} {4 * i + 3} {4 * i + 4}\n"
             for i, (_, _, name) in enumerate(boxes))  # fmt: skip
    (folder / "tree.obj").write_text("mtllib a.mtl\n" + "".join(corners) + "".join(faces))
    (folder / "shrub.vox").write_text(
        "VOXEL SPACE\n#min_corner: 9 -1 0\n#max_corner: 11 1 2\n#split: 1 1 1\n#res: 2\n"
        "i j k PadBVTotal\n0 0 0 5\n"
    )
    (folder / "stand.csv").write_text(rows)
    (folder / "v.xml").write_text(SCENE.format(shrub=shrub, oak=oak))


def run(folder, kind, *options):
    command = ["run", str(folder / "v.xml"), "--output", str(folder / kind), "--format", kind]
    assert cli.main([*command, "--sub-rays", "1", "--no-accuracy-report", "--quiet", *options]) == 0
    return folder / kind / "v"


def read_all(path):
    with formats.open_reader(path) as reader:
        chunks = list(reader.chunks())
        header = reader.header
    return {name: np.concatenate([chunk[name] for chunk in chunks]) for name in chunks[0]}, header


def rows_of(points, header):
    """The species and organs that each tree is seen with."""
    species, organs = header.texts(SPECIES_NAME), header.texts(ORGAN_NAME)
    names = {-1: None, **dict(enumerate(species))}
    found = {}
    for tree, kind, organ in zip(*(points[name].tolist() for name in TREES)):
        found.setdefault((tree, names[kind]), set()).add(organs[organ])
    return found


EXPECTED = {
    (-1, None): {"none"},
    (9, "Corylus"): {"leaf"},
    (71, "Quercus robur"): {"leaf", "wood", "none"},
    (12, "Abies alba"): {"leaf", "wood", "none"},
    (13, "Picea abies"): {"leaf", "wood", "none"},
}


@pytest.mark.parametrize("instances", [[], ["--no-instances"]])
@pytest.mark.parametrize("kind", ["vtp", "las"])
def test_echoes_of_a_run_have_their_trees(tmp_path, kind, instances):
    write_scene(tmp_path, rows=ROWS, **NUMBERED)
    points, header = read_all(run(tmp_path, kind, *instances))
    assert rows_of(points, header) == EXPECTED
    names = header.texts(MATERIAL_NAME)
    shrub = points[TREE_IDS] == 9
    assert {names[each] for each in points[MATERIAL_IDS][shrub]} == {"leaves"}
    wood = {names[each] for each in points[MATERIAL_IDS][points[ORGAN_IDS] == 2]}
    leaf = {names[each] for each in points[MATERIAL_IDS][points[ORGAN_IDS] == 1]}
    assert wood == {"bark"} and leaf == {"Oak_Leaf", "leaves"}


def test_without_numbers_a_tree_has_that_of_its_part(tmp_path):
    write_scene(tmp_path, oak='species="Quercus robur"')
    points, header = read_all(run(tmp_path, "vtp"))
    is_tree = points[TREE_IDS] >= 0
    assert (points[TREE_IDS] == points[PART_IDS])[is_tree].all()
    assert set(points[PART_IDS][~is_tree]) == {0, 4}  # the ground, and the shrub, without a species
    assert set(points[PART_IDS][is_tree]) == {1, 2, 3}
    assert header.texts(SPECIES_NAME) == ["Quercus robur", "Abies alba"]


def test_a_scene_without_trees_has_nothing_of_them(tmp_path):
    write_scene(tmp_path)
    text = (tmp_path / "v.xml").read_text().replace(' species="Abies alba"', "")
    (tmp_path / "v.xml").write_text(text)
    points, header = read_all(run(tmp_path, "las"))
    assert not set(TREES) & set(points) and not header.texts(SPECIES_NAME)
    names = json.loads((tmp_path / "las/v/leg000_points.names.json").read_text())
    assert set(names) == {"format", "version", "checksum", "points", "parts", "materials"}


@pytest.mark.parametrize("kind", ["las", "laz", "copc.laz", "ply", "e57", "vtp", "csv", "pcd"])
def test_formats_keep_the_trees(tmp_path, kind):
    if kind == "e57":
        pytest.importorskip("pye57")
    write_scene(tmp_path, rows=ROWS, **NUMBERED)
    folder = run(tmp_path, "vtp")
    before, header = read_all(folder)
    target = tmp_path / f"a.{kind}"
    assert cli.main(["convert", str(folder), str(target), "--quiet"]) == 0
    after, kept = read_all(target)
    assert {name: after[name].dtype.kind for name in TREES} == dict(zip(TREES, "iiu"))
    order = np.sort if kind == "copc.laz" else np.asarray
    for name in TREES:
        assert np.array_equal(order(after[name]), order(before[name]))
    has_names = kind not in ("csv", "pcd")
    assert kept.texts(SPECIES_NAME) == (header.texts(SPECIES_NAME) if has_names else [])
    assert kept.texts(ORGAN_NAME) == (["none", "leaf", "wood"] if has_names else [])


def test_e57_without_trees_has_no_extension(tmp_path):
    pye57 = pytest.importorskip("pye57")
    (tmp_path / "a.csv").write_text("x,y,z\n1,2,3\n")
    assert cli.main(["convert", str(tmp_path / "a.csv"), str(tmp_path / "a.e57"), "--quiet"]) == 0
    assert b"urn:vtkhelios" not in (tmp_path / "a.e57").read_bytes()
    assert pye57.E57(str(tmp_path / "a.e57")).scan_count == 1


def test_other_programs_read_the_points_of_e57_with_trees(tmp_path):
    pye57 = pytest.importorskip("pye57")
    (tmp_path / "a.csv").write_text(
        "x,y,z,treeID,SpeciesIds,OrganIds\n1,2,3,7,0,1\n4,5,6,-1,-1,0\n"
    )
    assert cli.main(["convert", str(tmp_path / "a.csv"), str(tmp_path / "a.e57"), "--quiet"]) == 0
    raw = pye57.E57(str(tmp_path / "a.e57")).read_scan_raw(0, ignore_unsupported_fields=True)
    assert raw["cartesianX"].tolist() == [1, 4]
    points, _ = read_all(tmp_path / "a.e57")
    assert points[TREE_IDS].tolist() == [7, -1] and points[ORGAN_IDS].tolist() == [1, 0]


def test_merged_files_renumber_species_and_fill(tmp_path):
    for name, species in (("a", "Abies alba"), ("b", "Picea abies")):
        header = formats.Header()
        header.set_texts(SPECIES_NAME, [species])
        with formats.open_writer(tmp_path / f"{name}.las", header) as writer:
            ids = np.zeros(1, np.int32)
            writer.write({"points": np.ones((1, 3)), SPECIES_IDS: ids, TREE_IDS: ids + 5})
    with formats.open_writer(tmp_path / "c.las", formats.Header()) as writer:
        writer.write({"points": np.ones((1, 3))})
    files = [str(tmp_path / f"{name}.las") for name in "abcd"]
    assert cli.main(["convert", *files, "--merge", "--quiet"]) == 0
    points, header = read_all(files[-1])
    assert header.texts(SPECIES_NAME) == ["Abies alba", "Picea abies"]
    assert points[SPECIES_IDS].tolist() == [0, 1, -1] and points[TREE_IDS].tolist() == [5, 5, -1]


def test_labels_of_echoes_without_names_are_by_organ():
    arrays = {"points": np.zeros((3, 3)), ORGAN_IDS: np.array([0, 1, 2], np.uint8)}
    fields = formats.Header().fields
    assert vtkhelios.learning.Labels().find(arrays, fields).tolist() == [0, 70, 71]


def test_info_counts_species_and_organs(tmp_path, capsys):
    write_scene(tmp_path, rows=ROWS, **NUMBERED)
    folder = run(tmp_path, "las")
    assert cli.main(["info", str(folder / "leg000_points.las")]) == 0
    said = capsys.readouterr().out.splitlines()
    named = {line[:10].strip(): line for line in said}
    assert "Abies alba: " in named["species"] and "Corylus: " in named["species"]
    assert named["organs"].startswith("organs     none: ") and "wood: " in named["organs"]


@pytest.mark.parametrize(
    ("scene", "message"),
    [
        (dict(oak='species="Quercus"', rows=ROWS),
         'v.xml:6: the tree has species="Quercus", but no number, and others have, as tree="13" ('),
        (dict(oak='species="Quercus"', rows=ROWS),
         "stand.csv:3); give all trees of a scene a number, or none"),
        (dict(oak='tree="-1"'), 'v.xml:6: tree="-1" is out of range'),
        (dict(rows="model,x,y,tree\nfir,0,0,a\n"), 'stand.csv:2: tree="a" is not'),
    ],
)  # fmt: skip
def test_trees_that_are_not_valid(tmp_path, capsys, scene, message):
    write_scene(tmp_path, **scene)
    assert cli.main(["run", str(tmp_path / "v.xml"), "--output", str(tmp_path / "out")]) == 1
    assert message in capsys.readouterr().err


def test_objects_of_a_file_are_no_tree(tmp_path, capsys):
    write_scene(tmp_path)
    city = {"type": "CityJSON", "version": "2.0", "transform": {"scale": [1, 1, 1], "translate": [0, 0, 0]},
            "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
            "CityObjects": {"a": {"type": "SolitaryVegetationObject", "geometry": [
                {"type": "MultiSurface", "lod": "1", "boundaries": [[[0, 1, 2]]]}]}}}  # fmt: skip
    (tmp_path / "a.city.json").write_text(json.dumps(city))
    part = '<part species="Tilia"><filter type="cityjsonloader"><param key="filepath" value="a.city.json"/></filter></part>'
    text = (tmp_path / "v.xml").read_text().replace('<part id="shrub"', part + '<part id="shrub"')
    (tmp_path / "v.xml").write_text(text)
    assert cli.main(["run", str(tmp_path / "v.xml"), "--output", str(tmp_path / "out")]) == 1
    assert (
        "v.xml:4: species or tree is given to a part that consists of objects"
        in capsys.readouterr().err
    )
