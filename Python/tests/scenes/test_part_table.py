# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts of a scene from tables: files, columns and arrays."""

import numpy as np
import pytest

import vtkhelios

TRIPOD = dict(scan_frequency=100, vertical=(-40, 60), head=(0, 180), head_speed=60)
STAND = dict(x=[5, -5, 5, 30], y=[8, 9, 9, 30], z=[np.nan, 0, 1.5, 0], model=["a", "b", "a", "b"])


@pytest.fixture
def bare(tmp_path):
    """A survey of a scene of parts, with the ground, and files of two trees."""
    (tmp_path / "ground.obj").write_text(
        "v -60 -60 0\nv 60 -60 0\nv 60 60 0\nv -60 60 0\nf 1 2 3\nf 1 3 4\n"
    )
    (tmp_path / "a.obj").write_text("v -1 0 1\nv 1 0 1\nv 0 0 6\nf 1 2 3\n")
    (tmp_path / "b.obj").write_text("v -2 0 0\nv 2 0 0\nv 0 0 4\nf 1 2 3\n")
    survey = vtkhelios.make_survey(None, [(0, 0, 2)], assets=[tmp_path], **TRIPOD)
    assert survey.vtk.AddPart("objloader", "ground.obj") == 0
    return survey


def test_parts_of_columns(bare, tmp_path):
    models = {"a": "a.obj", "b": {"objloader/filepath": tmp_path / "b.obj", "classification": 5}}
    bare.add_parts(dict(STAND, id=["p", "q", 'r "1"', "s"]), models, seed=3, yaw=(0, 360))
    assert [bare.vtk.GetPartName(i) for i in range(5)] == ["0", "p", "q", 'r "1"', "s"]
    scene = bare.scene
    bounds = [0.0] * 6
    scene.GetCellBounds(2, bounds)
    assert bounds[4:] == [0, 5]  # its lowest corner was at 1 m
    scene.GetCellBounds(4, bounds)
    assert bounds[4:] == [2.5, 7.5]
    cloud = bare.run(noise=False)
    hit = bare.run(noise=False, instances=True)
    assert np.array_equal(cloud["PartIds"], hit["PartIds"]) and {0, 2} <= set(cloud["PartIds"])
    assert set(cloud["ClassificationIds"][cloud["PartIds"] == 2]) == {5}


def test_parts_of_a_file_and_an_array(bare, tmp_path):
    (tmp_path / "stand.csv").write_text("model,x,y,yaw_deg\na.obj,5,8,0\n,6,8,90\n")
    bare.add_parts(tmp_path / "stand.csv", {"b": "b.obj"}, scale=(2, 2))
    rows = np.array([(3.5, 4.0, 1.0)], dtype=[("x", float), ("y", float), ("scale", float)])
    bare.add_parts(rows, {"b": "b.obj"})
    scene = bare.scene
    assert scene.GetNumberOfCells() == 2 + 3
    bounds = [0.0] * 6
    scene.GetCellBounds(3, bounds)
    assert np.allclose(bounds, [6, 6, 4, 12, 0, 8])  # half a turn, twice as large
    scene.GetCellBounds(4, bounds)
    assert np.allclose(bounds, [1.5, 5.5, 4, 4, 0, 4])


def test_parts_that_are_not_valid(bare):
    with pytest.raises(vtkhelios.PipelineError, match='part table 0, rows:2: model="c" is neither'):
        bare.add_parts(dict(x=[1], y=[2], model=["c"]), {"a": "a.obj"})
    with pytest.raises(vtkhelios.PipelineError, match='part table: file="none.csv": no such file'):
        bare.add_parts("none.csv")
    with pytest.raises(
        vtkhelios.PipelineError, match="attribute model\\[0\\]/objlader/filepath is"
    ):
        bare.add_parts(STAND, {"a": {"objlader/filepath": "a.obj"}})
    with pytest.raises(ValueError, match="columns have different lengths: {'x': 1, 'y': 2}"):
        bare.add_parts(dict(x=[1], y=[2, 3]))
    flat = vtkhelios.Scene([[-9, -9, 0], [9, -9, 0], [0, 9, 0]], [[0, 1, 2]])
    with pytest.raises(ValueError, match="the scene of this survey is an input"):
        vtkhelios.make_survey(flat, [(0, 0)], **TRIPOD).add_parts(STAND)
