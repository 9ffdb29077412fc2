# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Exported data sets, read back as their publishers describe them."""

import json

import numpy as np
import pytest

from vtkhelios import cli, formats
from vtkhelios.learning import Content, _s3dis, _scans
from vtkhelios.learning._parts import Parts
from vtkhelios.core.rotation import matrix_of, quaternion_of

WINDOW = 0.25  # s; legs last 1 s, of which a quarter has pulses


@pytest.fixture(scope="module")
def export(small_runs, tmp_path_factory):
    """Exports the run of a format; returns its folder and the arrays of the run."""
    made = {}

    def call(layout, kind="las", *options):
        key = (layout, kind, options)
        if key not in made:
            folder = tmp_path_factory.mktemp(layout) / "out"
            code = cli.main(
                ["export", str(small_runs[kind]), str(folder), f"--{layout}", "--quiet", *options]
            )
            assert code == 0
            made[key] = folder
        return made[key]

    return call


@pytest.fixture(scope="module")
def run(small_runs):
    """The arrays of the run in LAS, and its trajectories."""
    with formats.open_reader(small_runs["las"]) as reader:
        chunks = list(reader.chunks())
        arrays = {name: np.concatenate([c[name] for c in chunks]) for name in chunks[0]}
        return arrays, [reader.trajectory(name) for name in reader.files]


def read_kitti(folder, poses):
    """Reads like the development kit: points of all scans in the coordinates of the first one."""
    sequence, clouds = folder / "sequences/00", []
    calibration = {}
    for line in (sequence / "calib.txt").read_text().splitlines():
        name, values = line.split(":")
        calibration[name] = np.vstack(
            [np.reshape(values.split(), (3, 4)).astype(float), [0, 0, 0, 1]]
        )
    tr = calibration["Tr"]
    rows = np.loadtxt(folder / poses, ndmin=2)
    files = sorted((sequence / "velodyne").iterdir())
    assert len(files) == len(rows) == len(np.loadtxt(sequence / "times.txt", ndmin=1))
    for path, row in zip(files, rows):
        points = np.fromfile(path, np.float32).reshape(-1, 4)
        pose = np.linalg.inv(tr) @ np.vstack([row.reshape(3, 4), [0, 0, 0, 1]]) @ tr
        local = np.column_stack([points[:, :3].astype(float), np.ones(len(points))])
        clouds.append(((local @ pose.T)[:, :3], points[:, 3]))
    return clouds


@pytest.mark.parametrize(("layout", "poses"), [("kitti", "poses/00.txt"), ("semantickitti", "sequences/00/poses.txt")])  # fmt: skip
def test_kitti(export, run, layout, poses):
    folder = export(layout, "las", "--window", str(WINDOW))
    clouds, (arrays, _) = read_kitti(folder, poses), run
    assert len(clouds) > 1
    first = np.loadtxt(folder / "sequences/00/origin.txt")
    points = np.concatenate([points for points, _ in clouds])
    world = points @ first[:3, :3].T + first[:3, 3]
    assert np.abs(world - arrays["points"]).max() < 1e-5
    intensities = np.concatenate([intensity for _, intensity in clouds])
    assert intensities.min() >= 0 and intensities.max() == 1 and intensities.std() > 0.01
    assert (folder / "sequences/00/labels").exists() == (layout == "semantickitti")


def test_semantic_kitti(small_runs, export, run, tmp_path):
    (tmp_path / "labels.json").write_text(json.dumps({"classes": {"0": 9}, "materials": {"0": 71}}))
    folder = export("semantickitti", "las", "--labels", str(tmp_path / "labels.json"))
    arrays, _ = run
    files = sorted((folder / "sequences/00/labels").iterdir())
    words = np.concatenate([np.fromfile(path, np.uint32) for path in files])
    assert np.array_equal(words >> 16, arrays["PartIds"] + 1)
    assert np.array_equal(words & 0xFFFF, np.where(arrays["MaterialIds"] == 0, 71, 9))


def test_s3dis(export, run):
    folder = export("s3dis", "las", "--window", "leg") / "Area_1"
    rooms = sorted(path for path in folder.iterdir() if path.is_dir())
    assert [room.name for room in rooms] == ["leg000_000000", "leg001_000001"]
    origin = np.loadtxt(folder / "origin.txt")
    rows = [np.loadtxt(room / f"{room.name}.txt") for room in rooms]
    assert np.abs(np.concatenate(rows)[:, :3] + origin - run[0]["points"]).max() < 1e-4
    for room, whole in zip(rooms, rows):
        assert whole.shape[1] == 6 and 0 <= whole[:, 3:].min() <= whole[:, 3:].max() <= 255
        objects = [np.loadtxt(path, ndmin=2) for path in (room / "Annotations").iterdir()]
        assert sum(map(len, objects)) == len(whole)
        merged = np.concatenate(objects)
        assert np.array_equal(np.sort(merged[:, 0]), np.sort(whole[:, 0]))


def test_objects_are_the_parts_of_a_class():
    arrays = {
        "points": np.zeros((6, 3)), "ClassificationIds": np.array([0, 1, 5, 5, 5, 99]),
        "PartIds": np.array([3, 3, 7, 2, 7, 0]),
    }  # fmt: skip

    def find(parts):
        content = Content(parts=parts)
        labels = content.find_static_labels(arrays)
        objects = _s3dis._find_objects(arrays, labels, content.find_instances(arrays))
        return {name: np.flatnonzero(mask).tolist() for name, mask in objects}

    assert find(Parts()) == {
        "clutter_1": [0, 1], "highvegetation_1": [3], "highvegetation_2": [2, 4], "class99_1": [5],
    }  # fmt: skip
    assert find(Parts(["pole", "", "tree", "car", "", "", "", "signs"])) == {
        "highvegetation_1": [3], "car_1": [0, 1], "pole_1": [5], "sign_1": [2, 4],
    }  # fmt: skip


def read_mcap(path):
    """Messages by topic, decoded by rosbags from the definitions in the file."""
    reader = pytest.importorskip("mcap.reader")
    typesys = pytest.importorskip("rosbags.typesys")
    store, found = typesys.get_typestore(typesys.Stores.EMPTY), {}
    with open(path, "rb") as file:
        for schema, channel, message in reader.make_reader(file).iter_messages():
            assert schema.encoding == "ros2msg" and channel.message_encoding == "cdr"
            if schema.name not in store.fielddefs:
                text = schema.data.decode()
                known = typesys.get_types_from_msg(text, schema.name)
                store.register({k: v for k, v in known.items() if k not in store.fielddefs})
            item = store.deserialize_cdr(message.data, schema.name)
            found.setdefault(channel.topic, []).append((message.log_time, item))
    return found


def to_rows(cloud):
    """The rows of a PointCloud2 by its fields."""
    kinds = {7: "<f4", 4: "<u2", 2: "u1"}
    dtype = np.dtype({
        "names": [field.name for field in cloud.fields],
        "formats": [kinds[field.datatype] for field in cloud.fields],
        "offsets": [field.offset for field in cloud.fields], "itemsize": cloud.point_step,
    })  # fmt: skip
    assert cloud.row_step == cloud.point_step * cloud.width == len(cloud.data)
    return np.frombuffer(bytes(cloud.data), dtype)


def test_mcap(export, run):
    pytest.importorskip("mcap")
    pytest.importorskip("rosbags")
    found = read_mcap(export("mcap", "las", "--window", str(WINDOW)) / "scans.mcap")
    arrays, _ = run
    clouds = [to_rows(cloud) for _, cloud in found["/points"]]
    starts = [time * 1e-9 for time, _ in found["/points"]]
    rows = np.concatenate(clouds)
    assert np.allclose(rows["range"], arrays["Range"], rtol=1e-6)
    assert np.array_equal(rows["return_number"], arrays["ReturnNumber"])
    times = np.concatenate([start + rows["t"] for start, rows in zip(starts, clouds)])
    assert np.abs(times - arrays["GpsTime"]).max() < 1e-6
    assert len(found["/tf"]) == len(clouds)
    frames = [(each.header.frame_id, each.child_frame_id) for each in found["/tf"][0][1].transforms]
    assert frames == [("map", "base_link"), ("base_link", "lidar")]
    mount = found["/tf"][0][1].transforms[1].transform.translation
    assert (mount.x, mount.y, mount.z) == pytest.approx((0, 0, 1.5))
    misses = [to_rows(cloud) for _, cloud in found["/misses"]]
    lengths = np.concatenate([np.sqrt(m["dx"] ** 2 + m["dy"] ** 2 + m["dz"] ** 2) for m in misses])
    assert np.allclose(lengths, 1) and len(lengths) > 100
    hits = len(np.unique(arrays["PulseIds"]))
    assert len(lengths) + hits <= 50_000


def test_all_pulses_are_hits_or_misses(small_runs):
    for window in (None, WINDOW):
        with formats.open_reader(small_runs["las"]) as reader:
            scans = list(_scans.read_scans(reader, window))
            fired = sum(leg["pulsesFired"] for leg in reader.summary["legs"])
        ids = [np.unique(scan.arrays["PulseIds"]) for scan in scans]
        missed = [scan.misses["PulseIds"] for scan in scans]
        assert all(not np.isin(a, b).any() for a, b in zip(missed, ids))
        if window is None:
            assert sum(map(len, ids)) + sum(map(len, missed)) == fired


@pytest.mark.parametrize("seed", range(5))
def test_quaternions(seed):
    turn = np.random.default_rng(seed).normal(size=4)
    turn /= np.linalg.norm(turn)
    assert np.allclose(quaternion_of(matrix_of(turn)), turn * np.sign(turn[0]))


def test_poses_between_samples():
    """A turn of 90 degrees about the vertical in 1 s, while moving 10 m."""
    half = np.sqrt(0.5)
    poses = object.__new__(_scans._Poses)
    poses._times = np.array([0.0, 1.0])
    poses._places = np.array([[0.0, 0, 0], [10, 0, 0]])
    poses._turns = np.array([[1.0, 0, 0, 0], [half, 0, 0, half]])
    pose = poses.of_platform(1 / 3)
    forward = np.deg2rad(90 + 30)  # yaw of the body, counter-clockwise from east
    assert np.allclose(pose[:3, 0], [np.cos(forward), np.sin(forward), 0])
    left = forward + np.pi / 2
    assert np.allclose(pose[:3, 1], [np.cos(left), np.sin(left), 0])
    assert np.allclose(pose[:3, 2], [0, 0, 1])
    assert np.allclose(pose[:3, 3], [10 / 3, 0, 0])


def call(capsys, *arguments):
    code = cli.main(["export", *map(str, arguments)])
    return code, capsys.readouterr().err


def test_errors(small_runs, tmp_path, capsys):
    out, run = tmp_path / "out", small_runs["las"]
    assert call(capsys, tmp_path / "none", out, "--kitti") == (
        1, f"error: {tmp_path}/none: is not a folder; give the folder of a run\n"
    )  # fmt: skip
    (tmp_path / "full").mkdir()
    (tmp_path / "full/a").touch()
    code, err = call(capsys, run, tmp_path / "full", "--kitti")
    assert code == 1 and "already exists; give a new or empty folder" in err
    for text, message in (
        ("[1]", "is not a table of labels"), ('{"classes": {"2": 70000}}', "70000 is no label"),
        ('{"colours": {}}', "\"colours\" is unknown; give {"), ("{", "is not valid JSON"),
        ("[" * 100_000, "is nested too deeply"), ('{"classes": [1]}', "classes is no object"),
        ('{"classes": {"256": 1}}', 'class "256" is not from 0 to 255'),
        ('{"moving": {"car": 1}}', 'label "car" is not from 0 to 65535'),
        ('{"parts": {"car": "x"}}', '"x" is no label'),
    ):  # fmt: skip
        (tmp_path / "l.json").write_text(text)
        code, err = call(capsys, run, out, "--kitti", "--labels", tmp_path / "l.json")
        assert code == 1 and message in err, err
    code, err = call(capsys, run, out, "--kitti", "--labels", tmp_path / "none.json")
    assert code == 1 and "cannot be read: No such file" in err
    with pytest.raises(SystemExit):
        call(capsys, run, out, "--kitti", "--window", "0")
    assert "0 is not valid: expected seconds, 1e-6 to 1e6, or leg" in capsys.readouterr().err


def test_missing_libraries(small_runs, tmp_path, capsys, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "mcap.writer", None)
    code, err = call(capsys, small_runs["las"], tmp_path / "out", "--mcap")
    assert code == 1 and "pip install mcap rosbags" in err


def test_runs_without_trajectory_or_times(small_runs, tmp_path, capsys):
    import shutil

    run = tmp_path / "run"
    shutil.copytree(small_runs["las"], run)
    for path in run.glob("*_trajectory*"):
        path.unlink()
    code, err = call(capsys, run, tmp_path / "out", "--kitti")
    assert code == 1 and "has no trajectory, which gives the pose of a scan" in err


def test_points_that_are_not_in_order():
    chunk = {"GpsTime": np.array([0.0, 0.6, 0.1]), "points": np.zeros((3, 3))}
    with pytest.raises(formats.FormatError, match="not in order of time; give --window leg"):
        list(_scans._split([chunk], 0.0, 0.5, "a.las"))


def test_times_that_are_equal_but_for_rounding_are_in_order():
    """Beams that fire at once, of runs before 0.4: the last unit of their times differs."""
    edge = 123456.7
    times = np.array([edge, np.nextafter(edge, 0), edge, edge + 0.5, np.nextafter(edge + 0.5, 0)])
    chunk = {"GpsTime": times, "points": np.zeros((5, 3))}
    for start in (edge, edge - 0.5):
        split = list(_scans._split([chunk], start, 0.5, "a.las"))
        assert [len(part["GpsTime"]) for _, part in split] == [3, 2]


def test_points_before_the_first_time_of_the_trajectory_are_in_the_first_window():
    """Trajectories in text have times of nine digits, LAS has all."""
    chunk = {"points": np.zeros((3, 3)), "GpsTime": np.array([4.66666, 4.7, 4.8])}
    split = _scans._split(iter([chunk]), 4.66667, 0.1, "leg002_points.las")
    assert [(number, len(part["GpsTime"])) for number, part in split] == [(0, 2), (1, 1)]
