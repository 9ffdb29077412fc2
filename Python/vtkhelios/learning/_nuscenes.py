# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The layout of nuScenes, with lidarseg.

samples/LIDAR_TOP/SCENE_000000.pcd.bin  float32: x right, y forward, z up [m], intensity [0, 255], ring
lidarseg/VERSION/TOKEN_lidarseg.bin     uint8: the label of nuScenes-lidarseg of each point
VERSION/*.json                          its tables; boxes of objects as sample_annotation
maps/none.png                           an empty map, which its software requires

A sample is a scan, and a scene is a leg. Poses are relative to the first one, in whole metres. The
visibility is not known, and is empty.
"""

import json

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

from ..array_names import CHANNEL_IDS, GPS_TIME
from ..core.files import write_whole
from ..core.paths import to_vtk
from ..vtkHeliosFiltersCore import vtkHeliosGpsTime
from ..core.rotation import quaternion_of
from ._scans import FORWARD_LEFT_UP

VERSION = "v1.0-vtkhelios"
# The categories of nuScenes-lidarseg; the index is the label.
CATEGORIES = (
    "noise", "animal", "human.pedestrian.adult", "human.pedestrian.child",
    "human.pedestrian.construction_worker", "human.pedestrian.personal_mobility",
    "human.pedestrian.police_officer", "human.pedestrian.stroller", "human.pedestrian.wheelchair",
    "movable_object.barrier", "movable_object.debris", "movable_object.pushable_pullable",
    "movable_object.trafficcone", "static_object.bicycle_rack", "vehicle.bicycle",
    "vehicle.bus.bendy", "vehicle.bus.rigid", "vehicle.car", "vehicle.construction",
    "vehicle.emergency.ambulance", "vehicle.emergency.police", "vehicle.motorcycle",
    "vehicle.trailer", "vehicle.truck", "flat.driveable_surface", "flat.other", "flat.sidewalk",
    "flat.terrain", "static.manmade", "static.other", "static.vegetation", "vehicle.ego",
)  # fmt: skip
# By label of SemanticKITTI; vans are trucks, trams rigid buses.
LABELS = {
    10: 17, 11: 14, 13: 16, 15: 21, 16: 16, 18: 23, 20: 23, 30: 2, 31: 14, 32: 21, 40: 24, 44: 24,
    48: 26, 49: 25, 50: 28, 51: 28, 52: 28, 60: 24, 70: 30, 71: 30, 72: 27, 80: 28, 81: 28, 99: 29,
}  # fmt: skip
RIDDEN, CYCLES = {31, 32}, {11, 15, 31, 32}
ATTRIBUTES = (
    "vehicle.moving", "vehicle.parked", "cycle.with_rider", "cycle.without_rider",
    "pedestrian.moving", "pedestrian.standing",
)  # fmt: skip
VISIBILITIES = ("v0-40", "v40-60", "v60-80", "v80-100")


class NuscenesWriter:
    """Writes points, labels, boxes and tables; folder is a Path."""

    def __init__(self, folder, content):
        self.folder, self.content = folder, content
        epoch = content.header.epoch
        self.begin = vtkHeliosGpsTime.ToUnixTime(epoch) if epoch else 0.0  # [s]
        self.origin, self.scenes, self.instances = None, {}, {}
        self.tables = {name: [] for name in ("sample", "sample_data", "ego_pose", "lidarseg",
                                             "calibrated_sensor", "sample_annotation")}  # fmt: skip

    def write(self, scans):
        """Writes all scans; returns the number of scans and of points."""
        for name in ("samples/LIDAR_TOP", f"lidarseg/{VERSION}", VERSION, "maps"):
            (self.folder / name).mkdir(parents=True)
        count, number = 0, -1
        for number, scan in enumerate(scans):
            boxes = self.content.find_boxes(scan.arrays, "--nuscenes")
            self._write_points(number, scan)
            self._add_sample(number, scan)
            for box in boxes:
                self._add_box(number, scan, box)
            count += len(scan.arrays["points"])
        self._write_tables()
        return number + 1, count

    def _write_points(self, number, scan):
        arrays, turn = scan.arrays, _turned(scan)[:3, :3]
        rows = np.zeros((len(arrays["points"]), 5), "<f4")
        rows[:, :3] = (arrays["points"] - scan.pose[:3, 3]) @ turn
        rows[:, 3] = 255 * self.content.find_intensities(arrays)
        rows[:, 4] = arrays.get(CHANNEL_IDS, 0)
        write_whole(self.folder / _file_of(number, scan), rows.tobytes())
        labels = self.content.find_static_labels(arrays)
        found = np.zeros(len(labels), np.uint8)
        for label, index in LABELS.items():
            found[labels == label] = index
        name = f"lidarseg/{VERSION}/{_token('data', number)}_lidarseg.bin"
        write_whole(self.folder / name, found.tobytes())
        self.tables["lidarseg"].append({
            "token": _token("data", number), "sample_data_token": _token("data", number),
            "filename": name,
        })  # fmt: skip

    def _add_sample(self, number, scan):
        if self.origin is None:
            self.origin = np.floor(scan.platform[:3, 3])
        scene = self.scenes.setdefault(scan.leg, [])
        scene.append(number)
        platform = scan.platform.copy()
        platform[:3, 3] -= self.origin
        token, time = _token("data", number), self._time(scan)
        first = {"token": _token("sample", number), "timestamp": time}
        self.tables["sample"].append(
            {**first, "prev": "", "next": "", "scene_token": _token("scene", len(self.scenes) - 1)}
        )
        self.tables["sample_data"].append({
            "token": token, "sample_token": first["token"], "ego_pose_token": token,
            "calibrated_sensor_token": token, "timestamp": time, "fileformat": "pcd",
            "is_key_frame": True, "height": 0, "width": 0, "filename": _file_of(number, scan),
            "prev": "", "next": "",
        })  # fmt: skip
        self.tables["ego_pose"].append({"token": token, "timestamp": time, **_pose(platform)})
        self.tables["calibrated_sensor"].append({
            "token": token, "sensor_token": _token("sensor", 0), "camera_intrinsic": [],
            **_pose(np.linalg.inv(scan.platform) @ _turned(scan)),
        })  # fmt: skip

    def _add_box(self, number, scan, box):
        key = (scan.leg, box.part)
        known = self.instances.setdefault(key, {"label": box.label, "boxes": []})
        instance = list(self.instances).index(key)
        length, width, height = map(float, box.size)
        token = _token("box", len(self.tables["sample_annotation"]))
        known["boxes"].append(len(self.tables["sample_annotation"]))
        self.tables["sample_annotation"].append({
            "token": token, "sample_token": _token("sample", number),
            "instance_token": _token("instance", instance), "visibility_token": "",
            "attribute_tokens": [_token("attribute", ATTRIBUTES.index(_attribute(box)))],
            "translation": [float(value) for value in box.center - self.origin],
            "size": [width, length, height], "rotation": quaternion_of(box.axes),
            "prev": "", "next": "", "num_lidar_pts": box.points, "num_radar_pts": 0,
        })  # fmt: skip

    def _time(self, scan):
        """The time of a sample [us]: of the middle of its window, where the pose is."""
        middle = scan.start + scan.duration / 2 if scan.duration else scan.arrays[GPS_TIME][0]
        return round(1e6 * (self.begin + float(middle)))

    def _write_tables(self):
        samples, data = self.tables["sample"], self.tables["sample_data"]
        for numbers in self.scenes.values():
            _link([samples[number] for number in numbers])
            _link([data[number] for number in numbers])
        for instance in self.instances.values():
            _link([self.tables["sample_annotation"][number] for number in instance["boxes"]])
        for name, rows in {**self.tables, **self._make_fixed()}.items():
            text = json.dumps(rows, indent=1) + "\n"
            write_whole(self.folder / VERSION / f"{name}.json", text)
        _write_map(self.folder / "maps/none.png")

    def _make_fixed(self):
        """Returns the tables of scenes, objects and kinds."""
        log = {"token": _token("log", 0), "logfile": "", "vehicle": "", "date_captured": "",
               "location": ""}  # fmt: skip
        return {
            "log": [log],
            "map": [{"token": _token("map", 0), "log_tokens": [log["token"]],
                     "category": "semantic_prior", "filename": "maps/none.png"}],
            "sensor": [
                {"token": _token("sensor", 0), "channel": "LIDAR_TOP", "modality": "lidar"}
            ],
            "visibility": [{"token": str(number), "level": level, "description": ""}
                           for number, level in enumerate(VISIBILITIES, 1)],
            "attribute": [{"token": _token("attribute", number), "name": name, "description": ""}
                          for number, name in enumerate(ATTRIBUTES)],
            "category": [{"token": _token("category", number), "name": name, "description": "",
                          "index": number} for number, name in enumerate(CATEGORIES)],
            "scene": [
                {"token": _token("scene", number), "name": leg, "description": "",
                 "log_token": log["token"], "nbr_samples": len(samples),
                 "first_sample_token": _token("sample", samples[0]),
                 "last_sample_token": _token("sample", samples[-1])}
                for number, (leg, samples) in enumerate(self.scenes.items())
            ],
            "instance": [
                {"token": _token("instance", number),
                 "category_token": _token("category", LABELS[known["label"]]),
                 "nbr_annotations": len(known["boxes"]),
                 "first_annotation_token": _token("box", known["boxes"][0]),
                 "last_annotation_token": _token("box", known["boxes"][-1])}
                for number, known in enumerate(self.instances.values())
            ],
        }  # fmt: skip


def _attribute(box):
    if box.label in CYCLES:
        return "cycle.with_rider" if box.label in RIDDEN else "cycle.without_rider"
    if box.label == 30:
        return "pedestrian.moving" if box.moves else "pedestrian.standing"
    return "vehicle.moving" if box.moves else "vehicle.parked"


def _turned(scan):
    """Returns the pose of the sensor with the axes of nuScenes: x right, y forward, z up."""
    pose = scan.pose.copy()
    pose[:3, :3] = pose[:3, :3] @ FORWARD_LEFT_UP.T
    return pose


def _pose(pose):
    return {
        "translation": [float(value) for value in pose[:3, 3]],
        "rotation": quaternion_of(pose[:3, :3]),
    }


def _file_of(number, scan):
    return f"samples/LIDAR_TOP/{scan.leg}_{number:06}.pcd.bin"


def _token(kind, number):
    """Returns the key of a row: the same for the same run."""
    return f"{kind}{number:06}"


def _link(rows):
    """Sets the rows before and after each of a sequence."""
    for before, after in zip(rows, rows[1:]):
        before["next"], after["prev"] = after["token"], before["token"]


def _write_map(path):
    image = vtkImageData()
    image.SetDimensions(1, 1, 1)
    image.AllocateScalars(3, 1)  # VTK_UNSIGNED_CHAR
    image.SetScalarComponentFromDouble(0, 0, 0, 0, 0)
    writer = vtkPNGWriter()
    writer.SetFileName(to_vtk(path))
    writer.SetInputDataObject(image)
    writer.Write()
