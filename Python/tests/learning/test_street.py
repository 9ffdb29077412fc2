# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A street with traffic in the layouts for robots, read back by other readers or by the layout."""

import json

import numpy as np
import pytest

from vtkhelios import cli, formats
from vtkhelios.learning import read_scans
from vtkhelios.core.rotation import matrix_of

MOUNT = 1.8  # height of the sensor above the road [m]
SCANS = 10
SPEEDS = {"car1": 8, "car2": 10, "bicyclist1": 5, "person1": 1.4, "person2": 1.2, "person3": 0,
          "car3": 0, "car4": 0, "car5": 0, "car6": 0, "bicycle2": 0, "bicycle3": 0,
          "bicycle4": 0}  # fmt: skip


def read_points(path, columns=4):
    return np.fromfile(path, np.float32).reshape(-1, columns)


def test_beams_that_fire_at_once_have_equal_times(street):
    """Fault F50: they differed by a unit of the last place, and were not in order."""
    with formats.open_reader(street.run) as reader:
        times = np.concatenate([chunk["GpsTime"] for chunk in reader.chunks()])
    assert (np.diff(times) >= 0).all()
    assert len(np.unique(times)) <= 1024 * SCANS


def test_points_of_the_road_are_at_minus_the_height_of_the_mount(exports):
    """Fault F52: points were in the frame of the platform."""
    sequence = exports("semantickitti") / "sequences/00"
    files = sorted((sequence / "velodyne").iterdir())
    assert len(files) == SCANS
    for path in files:
        words = np.fromfile(sequence / f"labels/{path.stem}.label", np.uint32)
        heights = read_points(path)[(words & 0xFFFF) == 40, 2]
        assert len(heights) > 500 and np.abs(heights + MOUNT).max() < 1e-5
    platform = exports("semantickitti", "--frame", "platform") / "sequences/00"
    words = np.fromfile(platform / "labels/000004.label", np.uint32)
    heights = read_points(platform / "velodyne/000004.bin")[(words & 0xFFFF) == 40, 2]
    assert len(heights) > 500 and np.abs(heights).max() < 1e-5


def test_labels_and_instances_are_of_objects(exports, content):
    sequence = exports("semantickitti") / "sequences/00"
    names = content.parts.names
    words = np.concatenate([np.fromfile(p, np.uint32) for p in (sequence / "labels").iterdir()])
    labels = {}
    for word in np.unique(words):
        labels.setdefault(names[(word >> 16) - 1], set()).add(int(word & 0xFFFF))
    expected = {
        "road": {40}, "sidewalks": {48}, "houses": {50}, "car1": {252}, "car2": {252},
        "car3": {10}, "bicyclist1": {253}, "bicycle2": {11}, "person1": {254}, "person2": {254},
        "person3": {30}, "pole1": {80}, "sign1": {81}, "tree1": {70, 71},
    }  # fmt: skip
    assert {name: labels.get(name) for name in expected} == expected
    assert not any("_" in name for name in labels)  # wheels and legs belong to what carries them


def test_points_are_in_the_boxes_of_their_objects(street, content):
    """Points of what moves: within its way between its echoes; legs swing out of boxes at rest."""
    found = set()
    with formats.open_reader(street.run) as reader:
        for scan in read_scans(reader, 0.1):
            roots = content.parts.find_roots(scan.arrays)
            for box in content.boxes.find(scan.arrays):
                name = content.parts.names[box.part]
                points = scan.arrays["points"][roots == box.part]
                times = scan.arrays["GpsTime"][roots == box.part]
                slack = SPEEDS[name] * np.ptp(times) + (0.35 if "person" in name else 1e-3)
                outside = np.abs((points - box.center) @ box.axes) - box.size / 2
                assert outside.max() < slack, name
                assert box.points == len(points) and box.moves == (SPEEDS[name] > 0)
                found.add(name)
    assert SPEEDS.keys() - found <= {"bicycle2", "bicycle3", "bicycle4"}  # one behind the other


def test_kitti_objects(exports, street, content):
    folder = exports("kitti-objects", "--survey", str(street.file)) / "training"
    calibration = {}
    for line in (folder / "calib/000003.txt").read_text().splitlines():
        name, values = line.split(":")
        calibration[name] = np.array(values.split(), float).reshape(3, -1)
    to_camera, rectify = calibration["Tr_velo_to_cam"], calibration["R0_rect"]
    assert calibration["Tr_imu_to_velo"][:, 3] == pytest.approx([0, 0, -MOUNT])
    cloud = read_points(folder / "velodyne/000003.bin")[:, :3].astype(float)
    camera = rectify @ (to_camera[:, :3] @ cloud.T + to_camera[:, 3:])
    lines = [line.split() for line in (folder / "label_2/000003.txt").read_text().splitlines()]
    assert {line[0] for line in lines} == {"Car", "Cyclist", "Pedestrian"}
    assert all(len(line) == 15 for line in lines)
    counts = []
    for line in lines:
        height, width, length, x, y, z, turn = map(float, line[8:])
        alpha = float(line[3])
        assert np.cos(alpha) == pytest.approx(np.cos(turn - np.arctan2(x, z)), abs=1e-3)
        # The development kit: x along the length, y down, and a turn about y.
        cosine, sine = np.cos(turn), np.sin(turn)
        local = np.array([[cosine, 0, -sine], [0, 1, 0], [sine, 0, cosine]]) @ (
            camera - np.array([[x], [y], [z]])
        )
        inside = (np.abs(local[0]) < length / 2 + 0.05) & (np.abs(local[2]) < width / 2 + 0.05)
        counts.append(np.count_nonzero(inside & (local[1] < 0.01) & (local[1] > -height - 0.01)))
        if line[0] == "Car":  # on the road
            assert y == pytest.approx(MOUNT, abs=1e-3) and length > 4 > width
    assert min(counts) > 0 and max(counts) > 100
    assert len((folder.parent / "ImageSets/train.txt").read_text().split()) == SCANS


@pytest.fixture(scope="module")
def nuscenes(exports, street):
    folder = exports("nuscenes", "--survey", str(street.file))
    tables = {
        path.stem: json.loads(path.read_text()) for path in (folder / "v1.0-vtkhelios").iterdir()
    }
    return folder, tables


def test_nuscenes_tables_refer_to_each_other(nuscenes):
    folder, tables = nuscenes
    tokens = {name: {row["token"] for row in rows} for name, rows in tables.items()}
    assert all(len(tokens[name]) == len(rows) for name, rows in tables.items())
    others = {"prev", "next", "token", "first_sample", "last_sample", "first_annotation",
              "last_annotation", "visibility"}  # fmt: skip
    for rows in tables.values():
        for row in rows:
            for key, value in row.items():
                name = key.removesuffix("_tokens").removesuffix("_token")
                if name != key and name not in others:
                    assert set(value if isinstance(value, list) else [value]) <= tokens[name], key
    for table in ("sample", "sample_data", "sample_annotation"):
        by_token = {row["token"]: row for row in tables[table]}
        for row in tables[table]:
            assert not row["next"] or by_token[row["next"]]["prev"] == row["token"]
    assert len(tables["sample"]) == len(tables["lidarseg"]) == SCANS
    assert (folder / tables["map"][0]["filename"]).read_bytes().startswith(b"\x89PNG")


def test_nuscenes_points_are_in_boxes(nuscenes):
    """From the sensor by calibrated_sensor and ego_pose to the frame of the boxes."""
    folder, tables = nuscenes
    rows = {name: {row["token"]: row for row in tables[name]} for name in tables}
    data = tables["sample_data"][4]
    points = read_points(folder / data["filename"], 5)
    road = np.fromfile(folder / tables["lidarseg"][4]["filename"], np.uint8) == 24
    assert np.abs(points[road, 2] + MOUNT).max() < 1e-5
    world = points[:, :3].astype(float)
    for table in ("calibrated_sensor", "ego_pose"):
        pose = rows[table][data[f"{table}_token"]]
        world = world @ matrix_of(pose["rotation"]).T + pose["translation"]
    speeds = {}
    for box in tables["sample_annotation"]:
        if box["sample_token"] == data["sample_token"]:
            category = rows["category"][rows["instance"][box["instance_token"]]["category_token"]]
            width, length, height = box["size"]
            local = (world - box["translation"]) @ matrix_of(box["rotation"])
            margin = 0.1 + 0.3 * ("pedestrian" in category["name"])
            inside = (np.abs(local) < np.array([length, width, height]) / 2 + margin).all(axis=1)
            assert np.count_nonzero(inside) >= box["num_lidar_pts"] > 0
            before = rows["sample_annotation"].get(box["prev"])
            if before:
                times = [
                    rows["sample"][b["sample_token"]]["timestamp"] * 1e-6 for b in (before, box)
                ]
                way = np.subtract(box["translation"], before["translation"])
                speed = np.linalg.norm(way) / (times[1] - times[0])
                speeds.setdefault(category["name"], set()).add(round(speed))
    assert {10, 8} <= speeds["vehicle.car"] and 5 in speeds["vehicle.bicycle"]
    assert 1 in speeds["human.pedestrian.adult"]


def test_rosbag_reads_the_bag(exports):
    rosbag2 = pytest.importorskip("rosbags.rosbag2")
    typesys = pytest.importorskip("rosbags.typesys")
    store = typesys.get_typestore(typesys.Stores.ROS2_HUMBLE)
    with rosbag2.Reader(exports("rosbag")) as bag:
        topics = {each.topic: (each.msgtype, each.msgcount) for each in bag.connections}
        messages = [
            (c.topic, store.deserialize_cdr(raw, c.msgtype)) for c, _, raw in bag.messages()
        ]
    cloud = "sensor_msgs/msg/PointCloud2"
    assert topics == {
        "/points": (cloud, SCANS), "/misses": (cloud, SCANS),
        "/tf": ("tf2_msgs/msg/TFMessage", SCANS),
    }  # fmt: skip
    scan = next(message for topic, message in messages if topic == "/points")
    offsets = {field.name: field.offset for field in scan.fields}
    rows = np.frombuffer(bytes(scan.data), np.uint8).reshape(-1, scan.point_step)
    heights = rows[:, offsets["z"] : offsets["z"] + 4].copy().view("<f4")[:, 0]
    assert np.count_nonzero(np.abs(heights + MOUNT) < 1e-5) > 500
    assert scan.header.frame_id == "lidar"


def test_mcap_has_the_road_below_the_sensor_at_increasing_times(exports):
    reader = pytest.importorskip("mcap.reader")
    typesys = pytest.importorskip("rosbags.typesys")
    store = typesys.get_typestore(typesys.Stores.ROS2_HUMBLE)
    with open(exports("mcap") / "scans.mcap", "rb") as file:
        found = [
            (channel.topic, message.log_time, store.deserialize_cdr(message.data, schema.name))
            for schema, channel, message in reader.make_reader(file).iter_messages()
        ]
    scans = [(time, message) for topic, time, message in found if topic == "/points"]
    assert len(scans) == SCANS
    assert np.diff([time for time, _ in scans]) == pytest.approx(1e8, abs=2e3)  # [ns]
    for time, scan in scans:
        assert scan.header.stamp.sec * 10**9 + scan.header.stamp.nanosec == time
        offsets = {field.name: field.offset for field in scan.fields}
        rows = np.frombuffer(bytes(scan.data), np.uint8).reshape(-1, scan.point_step)
        z, since = (
            rows[:, offsets[name] : offsets[name] + 4].copy().view("<f4")[:, 0]
            for name in ("z", "t")
        )
        assert np.count_nonzero(np.abs(z + MOUNT) < 1e-5) > 500
        assert (np.diff(since) >= 0).all() and since[0] > -1e-9 and since[-1] < 0.1001
    mounts = [
        message.transforms[1].transform.translation for topic, _, message in found if topic == "/tf"
    ]
    assert len(mounts) == SCANS and all(mount.z == pytest.approx(MOUNT) for mount in mounts)


def test_boxes_of_label_2_hold_the_points_of_moving_cars(exports, street):
    """Points of SemanticKITTI with the label 252, in the boxes of KITTI, both of one scan."""
    sequence = exports("semantickitti") / "sequences/00"
    folder = exports("kitti-objects", "--survey", str(street.file)) / "training"
    cloud = read_points(sequence / "velodyne/000004.bin")
    assert np.array_equal(cloud, read_points(folder / "velodyne/000004.bin"))
    words = np.fromfile(sequence / "labels/000004.label", np.uint32)
    rows = [line.split() for line in (folder / "label_2/000004.txt").read_text().splitlines()]
    boxes = [[*map(float, row[8:])] for row in rows if row[0] == "Car"]
    # The camera of the export looks along x of the sensor: x right, y down, z forward.
    x, y, z = cloud[:, :3].T.astype(float)
    camera = np.array([-y, -z, x])
    cars = np.unique(words[(words & 0xFFFF) == 252])
    assert len(cars) == 2
    for car in cars:
        shares = []
        for height, width, length, *place, turn in boxes:
            cosine, sine = np.cos(turn), np.sin(turn)
            away = camera[:, words == car] - np.array(place)[:, None]
            along, across = cosine * away[0] - sine * away[2], sine * away[0] + cosine * away[2]
            inside = (np.abs(along) < length / 2 + 0.05) & (np.abs(across) < width / 2 + 0.05)
            shares.append(np.mean(inside & (away[1] < 0.01) & (away[1] > -height - 0.01)))
        assert sorted(shares)[-2:] == [0.0, 1.0]  # one box has all of them


def call(capsys, *arguments):
    code = cli.main(["export", *map(str, arguments)])
    return code, capsys.readouterr().err


@pytest.mark.parametrize("layout", ["--kitti-objects", "--nuscenes"])
def test_boxes_need_the_survey(street, tmp_path, capsys, layout):
    code, error = call(capsys, street.run, tmp_path / "out", layout, "--quiet")
    assert code == 1
    assert error == (
        f"error: {layout} has boxes of objects, which need the scene: give --survey FILE, the survey of "
        "the run\n"
    )


def test_a_survey_that_has_changed_is_an_error(street, tmp_path, capsys):
    import shutil

    folder = tmp_path / "street"
    shutil.copytree(street.folder, folder, ignore=shutil.ignore_patterns("output"))
    with open(folder / "car1.csv", "a") as file:
        file.write("\n")
    arguments = (street.run, tmp_path / "out", "--kitti-objects", "--quiet", "--survey")
    code, error = call(capsys, *arguments, folder / "street.xml")
    assert code == 1
    assert error == f"error: {folder}/car1.csv: has changed since the run; run the survey again\n"
    code, error = call(capsys, *arguments, folder / "none.xml")
    assert code == 1
    assert error == f"error: {folder}/none.xml: is not the survey of the run; give that one\n"


def test_a_run_without_motion_or_mount(street, tmp_path, capsys):
    """Boxes of what moves need --motion; runs of earlier versions have no mount."""
    import shutil

    import vtkhelios

    survey = vtkhelios.read_survey(street.file)
    report = survey.run_to(tmp_path, "vtp", pulse_step=64, sub_rays=1)
    arguments = (report["folder"], tmp_path / "out", "--kitti-objects", "--quiet", "--survey")
    code, error = call(capsys, *arguments, street.file)
    assert code == 1
    assert error == (
        "error: boxes of parts that move need PartPosition, which the points do not have; run the survey "
        "again with --format vtp --motion\n"
    )
    old = tmp_path / "old"
    shutil.copytree(street.run, old)
    summary = json.loads((old / "run_summary.json").read_text())
    del summary["legs"][0]["mount"]
    (old / "run_summary.json").write_text(json.dumps(summary))
    code, error = call(capsys, old, tmp_path / "out", "--kitti", "--quiet")
    assert code == 1
    assert error == (
        f"error: {old}/run_summary.json: does not have the mount of the scanner, which gives the frame of "
        "the sensor; run the survey again, or give --frame platform\n"
    )
    code, _ = call(capsys, old, tmp_path / "out", "--kitti", "--quiet", "--frame", "platform")
    assert code == 0


def test_a_scene_of_another_run_is_an_error(content):
    from vtkhelios.learning._boxes import Boxes
    from vtkhelios.learning._parts import Parts

    import vtkhelios

    mesh = vtkhelios.vtkHeliosSyntheticScene()
    mesh.Update()
    with pytest.raises(formats.FormatError, match="no part 0, which is car in the run"):
        Boxes(mesh.GetOutput(), Parts(["car"]), content.labels)
