# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small JSON files of commands, and areas in other formats."""

import json
import xml.etree.ElementTree as ElementTree

import numpy as np

from . import small_files
from .outcomes import check, check_finite
from .target import Refused, Seed, Target, command_line
from .targets_points import parse_strict
from .targets_run import is_data

RING = [[0.5, 0.0], [10.0, 0.0], [10.5, 5.25], [0.0, 6.0], [0.5, 0.0]]
HOLE = [[2.0, 2.0], [3.0, 2.0], [3.0, 3.0], [2.0, 2.0]]


class Area(Target):
    """Areas of flight plans: GeoJSON, WKT and text."""

    kind = "json"

    def __init__(self, ending):
        self.name = f"area-{ending}"
        self.kind = "json" if ending == "geojson" else "text"
        self._ending = ending

    def make_seeds(self, folder):
        if self._ending == "geojson":
            polygon = {"type": "Polygon", "coordinates": [RING, HOLE]}
            several = {"type": "MultiPolygon", "coordinates": [[RING], [HOLE]]}
            features = [{"type": "Feature", "properties": {"a": 1}, "geometry": polygon}]
            features.append({"type": "GeometryCollection", "geometries": [several]})
            whole = {"type": "FeatureCollection", "features": features}
            documents = {"one.geojson": polygon, "all.geojson": whole}
            return [Seed(name, json.dumps(each).encode()) for name, each in documents.items()]
        rows = ", ".join(f"{x} {y}" for x, y in RING)
        hole = ", ".join(f"{x} {y}" for x, y in HOLE)
        if self._ending == "wkt":
            return [
                Seed("one.wkt", f"SRID=25832;POLYGON (({rows}), ({hole}))".encode()),
                Seed("two.wkt", f"MULTIPOLYGON ((({rows})), (({hole})))".encode()),
            ]
        text = "# corners\n" + "".join(f"{x}, {y};1 # a\n" for x, y in RING)
        return [Seed("corners.txt", text.encode())]

    def run(self, path, data):
        from vtkhelios.plans.kinds import SettingError
        from vtkhelios.flight._area import contains, measure, read_area

        try:
            area = read_area(path)
        except SettingError as error:
            raise Refused(error.format(str)) from error
        for ring in (ring for rings in area for ring in rings):
            check_finite("ring", ring)
            check(ring.ndim == 2 and ring.shape[1] == 2, f"a ring has the shape {ring.shape}")
        check(len(area) > 0, "no polygon")
        check(not np.isnan(measure(area)), "the area is not a number")
        contains(area, np.zeros((3, 2)))


class Instrument(Target):
    """Metadata of an Ouster sensor: a scanner that vtkhelios validate accepts."""

    name = "instrument-json"
    kind = "json"

    def make_seeds(self, folder):
        facts = {
            "prod_line": "OS-1-3", "prod_sn": "12", "lidar_mode": "512x20",
            "beam_altitude_angles": [10.5, 0, -20.25], "beam_azimuth_angles": [4.21, 0, -1.4],
            "lidar_origin_to_beam_origin_mm": 15.806,
            "lidar_to_sensor_transform": [-1, 0, 0, 1, 0, -1, 0, 2, 0, 0, 1, 36.18, 0, 0, 0, 1],
        }  # fmt: skip
        newer = {
            "sensor_info": {"prod_line": "OS-1-3", "prod_sn": "12"},
            "config_params": {"lidar_mode": "512x20"},
            "beam_intrinsics": {
                **{name: facts[name] for name in ("beam_altitude_angles", "beam_azimuth_angles")},
                "beam_to_lidar_transform": [1, 0, 0, 15.8, 0, 1, 0, 0, 0, 0, 1, 2.5, 0, 0, 0, 1],
            },
            "lidar_intrinsics": {
                "lidar_to_sensor_transform": facts["lidar_to_sensor_transform"]
            },
        }  # fmt: skip
        return [Seed("old.json", json.dumps(facts, indent=1).encode()), Seed("new.json", json.dumps(newer).encode())]  # fmt: skip

    def run(self, path, data):
        scanner = path.with_name("scanner.xml")
        command_line("instrument", path, "--output", scanner)
        beams = ElementTree.parse(scanner).findall("scanner/beams/beam")
        check(len(beams) > 0, "the scanner has no beams")
        try:
            command_line("validate", scanner)
        except Refused as error:
            check(False, f"the scanner is not valid: {error}")


class Labels(Target):
    """Labels of vtkhelios export; accepted ones are used."""

    name = "labels"
    kind = "json"

    def make_seeds(self, folder):
        table = {"classes": {"2": 72, "6": 50}, "materials": {"bark": 71, "3": 70, "leaf": 0}}
        return [Seed("labels.json", json.dumps(table).encode())]

    def run(self, path, data):
        from vtkhelios import learning
        from vtkmodules.vtkCommonDataModel import vtkFieldData

        labels = learning.Labels.read(path)
        chunk = small_files.make_chunk()
        chunk["MaterialIds"] = np.arange(len(chunk["points"])) % 5
        found = labels.find(chunk, vtkFieldData())
        check(len(found) == len(chunk["points"]), "not every point has a label")


class Export(Target):
    """vtkhelios export of a run with a damaged file: a whole data set, or no folder."""

    name = "export"
    kind = "text"
    weight = 0.3

    def make_seeds(self, folder):
        run = small_files.run_survey(folder, small_files.STAND, scene=small_files.SIMPLE_SCENE)
        beside = {f"run/{name}": data for name, data in small_files.files_below(run).items()}
        seeds = []
        for name in ("run/leg000_points.xyz", "run/leg000_trajectory.txt"):
            others = dict(beside)
            seeds.append(Seed(name, others.pop(name), others))
        return seeds

    def run(self, path, data):
        output = path.parents[1] / "out"
        try:
            command_line("export", path.parent, output, "--semantickitti", "--window", "0.1")
        finally:
            left = sorted(each.name for each in path.parents[1].iterdir())
            check(set(left) <= {"run", "out"}, f"files are left: {left}")
        check((output / "sequences/00/calib.txt").is_file(), "the data set is not complete")


class Join(Target):
    """vtkhelios join of two parts with a damaged file: byte-identical to the whole, or an error."""

    weight = 0.3

    def __init__(self, form):
        self.name = f"join-{form}"
        self.kind = "text" if form == "xyz" else "mixed"
        self._options = ("--format", form, "--pulses-per-block", "150", "--hits", "--quiet")

    def make_seeds(self, folder):
        small_files.write_survey(folder, small_files.STAND, small_files.SIMPLE_SCENE)
        run = ("run", "survey.xml", "--threads", "1", *self._options)
        command_line(*run, "--output", "whole")
        for part in ("1/2", "2/2"):
            command_line(*run, "--output", "parts", "--part", part)
        beside = small_files.files_below(folder)
        seeds = []
        for name in beside:
            if name.startswith("parts/") and (is_data(name) or name.endswith("run.journal")):
                others = dict(beside)
                seeds.append(Seed(name, others.pop(name), others))
        journals = [seed for seed in seeds if seed.name.endswith("run.journal")]
        return journals * (len(seeds) // 4) + seeds

    def run(self, path, data):
        folder = next(each for each in path.parents if (each / "survey.xml").is_file())
        command_line(
            "join", folder / "parts/stand", "--survey", folder / "survey.xml", "--threads", "1",
            "--output", folder / "joined", "--quiet",
        )  # fmt: skip
        whole = small_files.files_below(folder / "whole")
        found = small_files.files_below(folder / "joined")
        check(whole.keys() == found.keys(), f"{sorted(whole.keys() ^ found.keys())} differ")
        for name, right in whole.items():
            if is_data(name):
                check(found[name] == right, f"{name} has other bytes than the whole run")
        told, right = (
            parse_strict(files["stand/run_summary.json"].decode()) for files in (found, whole)
        )
        check(told["totals"] == right["totals"], "the summary has other counts")


def make_targets():
    return [
        *map(Area, ("geojson", "wkt", "txt")), Instrument(), Labels(), Export(),
        *map(Join, ("xyz", "las", "vtp")),
    ]  # fmt: skip
