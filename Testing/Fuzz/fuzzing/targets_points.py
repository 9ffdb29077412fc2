# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Point files: the readers of vtkhelios.formats, info, convert, and points by laspy."""

import json
import re
import struct


from . import small_files
from .outcomes import Silent, check_chunk, check_count, check_polydata, plain_lines
from .target import Seed, Target, command_line, need, pick, update

NAMES = {
    "las": "points.las", "laz": "points.laz", "copc": "points.copc.laz", "ply": "points.ply",
    "pcd": "points.pcd", "vtp": "points.vtp", "pvtp": "points_0000.vtp", "xyz": "points.xyz",
    "e57": "points.e57",
}  # fmt: skip
NEEDS = {"e57": ("pye57",)}
KINDS = {"xyz": "text", "vtp": "mixed", "pvtp": "xml", "ply": "mixed", "pcd": "mixed"}


def las_count(data):
    if len(data) < 375 or data[:4] != b"LASF":
        return None
    old, new = struct.unpack_from("<I", data, 107)[0], struct.unpack_from("<Q", data, 247)[0]
    return new if data[25] >= 4 and (new or data[104] & 63 >= 6) else old


def one_number(pattern, data):
    """The value in a header, if unique."""
    found = re.findall(pattern, data)
    return int(found[0]) if len(found) == 1 and len(found[0]) < 18 else None


PTX = b"2\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n" \
    b"1 2 3 0.5 255 0 9\n0 0 0 0.5 0 0 0\n"  # fmt: skip


def expected_count(kind, data):
    """The number of points by an independent method; None: ambiguous."""
    if kind in ("las", "laz", "copc"):
        return las_count(data)
    if kind == "ply":
        return one_number(rb"(?m)^element vertex (\d+)$", data[: data.find(b"end_header")])
    if kind == "pcd":
        return one_number(rb"(?m)^POINTS (\d+)$", data[:2000])
    if kind == "vtp":
        return one_number(rb'<Piece [^<>]*NumberOfPoints="(\d+)"', data)
    if kind == "xyz":
        lines = plain_lines(data)
        return len(lines) if lines and is_row(lines[0]) else None
    return None


def is_row(line):
    """Returns whether a line begins with three numbers: it is neither names nor a number of points."""
    try:
        return len([float(word) for word in line.split()[:3]]) == 3
    except ValueError:
        return False


def read_points(path, rows=37):
    """All chunks of a file, checked: count, notes."""
    from vtkhelios import formats

    with formats.open_reader(path) as reader:
        count, invalid = 0, False
        for chunk in reader.chunks(rows):
            try:
                count += check_chunk(chunk)
            except Silent as error:
                if "not finite" not in str(error):
                    raise
                invalid = invalid or str(error)
                count += len(chunk["points"])
        notes = list(reader.notes)
        if invalid and not any("finite" in note for note in notes):
            raise Silent(f"{invalid}, and no note")
        if reader.count is not None and "E57" not in reader.kind:
            check_count(count, reader.count, notes, "points of the reader's count")
    return count, notes


class Points(Target):
    """A format of vtkhelios.formats."""

    def __init__(self, key):
        self.key = key
        self.name = f"points-{key}"
        self.kind = KINDS.get(key, "binary")
        self.modules = NEEDS.get(key, ())

    def missing(self):
        return need(*NEEDS.get(self.key, ()))

    def make_seeds(self, folder):
        chunk = small_files.make_chunk()
        if self.key == "pvtp":
            small_files.write_points(folder / "points.pvtp", chunk, 2)
            files = small_files.files_below(folder)
            index = files.pop("points.pvtp")
            return [Seed("points.pvtp", index, files)]
        name = NAMES[self.key]
        seeds = [Seed(name, small_files.write_points(folder / name, chunk).read_bytes())]
        plain = {key: chunk[key] for key in ("points", "ReturnNumber", "NumberOfReturns")}
        if self.key not in ("e57", "copc"):
            more = small_files.write_points(folder / f"plain-{name}", plain)
            seeds.append(Seed(f"plain-{name}", more.read_bytes()))
        return seeds + self.more_seeds()

    def more_seeds(self):
        if self.key == "ply":
            head = b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n" \
                b"property float z\nproperty uchar red\nproperty int label\nend_header\n"  # fmt: skip
            return [Seed("ascii.ply", head + b"1 2 3 4 5\n1.5 2e1 -3 255 -1\n0 0 0 0 0\n")]
        if self.key == "pcd":
            head = b"VERSION .7\nFIELDS x y z intensity label\nSIZE 4 4 4 4 2\nTYPE F F F F U\n" \
                b"COUNT 1 1 1 1 1\nWIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\n" \
                b"DATA ascii\n"  # fmt: skip
            return [Seed("ascii.pcd", head + b"1 2 3 4 5\n1.5 2e1 -3 255 1\n0 0 0 0 0\n")]
        if self.key == "xyz":
            return [
                Seed("three.xyz", b"1 2 3\n4.5 -6e1 7\n476000.123 5473000.456 110.5\n"),
                Seed(
                    "named.xyz", b"X,Y,Z,Intensity,Red,Green,Blue\n1,2,3,7,255,0,9\n4,5,6,8,1,2,3\n"
                ),
                Seed("counted.xyz", b"2\n1 2 3 -2048 255 0 9\n4 5 6 2047 1 2 3\n"),
                Seed("scans.xyz", PTX + PTX),
                Seed("five.xyz", b"# a comment\n1 2 3 4 5\n4.5 -6e1 7 x y\n0 0 1 // end\n"),
            ]
        return []

    def repair(self, data, random):
        return mend_pages(data) if self.key == "e57" and random.random() < 0.8 else data

    def run(self, path, data):
        count, notes = read_points(path)
        check_count(count, expected_count(self.key, data), notes)


class Info(Points):
    """vtkhelios info --json on a file of points."""

    def __init__(self, key):
        super().__init__(key)
        self.name = f"info-{key}"
        self.weight = 0.5

    def run(self, path, data):
        out, told = command_line("info", path, "--json")
        facts = parse_strict(out)
        warned = facts["warnings"] or "warning" in told
        check_count(facts["points"], expected_count(self.key, data), warned)
        command_line("info", path)


class Convert(Points):
    """vtkhelios convert to another format, read again."""

    def __init__(self, key):
        super().__init__(key)
        self.name = f"convert-{key}"
        self.weight = 0.5

    def run(self, path, data):
        output = path.with_name("out") / pick(data, ["a.las", "a.ply", "a.xyz", "a.vtp", "a.pcd"])
        out, told = command_line("convert", path, output)
        count, _ = read_points(output, 1000)
        check_count(count, expected_count(self.key, data), "warning" in told)


class LasSource(Points):
    """vtkhelios.points.las_source, by laspy."""

    def __init__(self, key):
        super().__init__(key)
        self.name = f"source-{key}"
        self.weight = 0.5

    def missing(self):
        return need("laspy")

    def run(self, path, data):
        from vtkhelios import PipelineError, points, update

        try:
            source = points.las_source(path)
        except (ValueError, OSError) as error:  # documented so
            raise PipelineError([str(error)]) from error
        cloud = update(source)
        check_polydata(cloud)
        check_count(cloud.GetNumberOfPoints(), las_count(data), False)


class Waves(Target):
    """LAS with waveform packets beside it: the points, or the packets, are damaged."""

    name = "las-waveforms"
    kind = "binary"

    def make_seeds(self, folder):
        run = small_files.run_survey(
            folder,
            small_files.STAND,
            "--format",
            "las",
            "--waveforms",
            "--waveforms-in-points",
            scene=small_files.SIMPLE_SCENE,
        )
        las, wdp = run / "leg000_points.las", run / "leg000_points.wdp"
        return [
            Seed(las.name, las.read_bytes(), {wdp.name: wdp.read_bytes()}),
            Seed(wdp.name, wdp.read_bytes(), {las.name: las.read_bytes()}),
        ]

    def run(self, path, data):
        import vtkhelios

        from .targets_scene import check_waveforms

        reader = vtkhelios.vtkHeliosLASReader()
        las = path.with_suffix(".las")
        reader.SetFileName(str(las))
        reader.SetReadWaveforms(True)
        cloud, warned = update(reader)
        try:
            check_polydata(cloud)
        except Silent as error:  # kept, with a message
            if "not finite" not in str(error) or not any("not finite" in each for each in warned):
                raise
        check_count(cloud.GetNumberOfPoints(), las_count(las.read_bytes()), False)
        check_waveforms(reader.GetOutputDataObject(1))


def parse_strict(text):
    """Standard JSON: no NaN."""

    def fail(word):
        raise Silent(f"{word} in JSON")

    try:
        return json.loads(text, parse_constant=fail)
    except ValueError as error:
        raise Silent(f"not valid JSON: {error}") from error


# E57: every page of 1024 bytes ends in a checksum; without repair no damage passes the first check.

PAGE = 1024


def _make_table():
    table = []
    for value in range(256):
        for _ in range(8):
            value = value >> 1 ^ (0x82F63B78 if value & 1 else 0)
        table.append(value)
    return table


CRC_TABLE = _make_table()


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc = crc >> 8 ^ CRC_TABLE[(crc ^ byte) & 255]
    return crc ^ 0xFFFFFFFF


def mend_pages(data):
    """Returns the same bytes with valid checksums, if the file has whole pages."""
    if len(data) % PAGE or not data:
        return data
    pages = []
    for begin in range(0, len(data), PAGE):
        page = data[begin : begin + PAGE - 4]
        pages.append(page + struct.pack(">I", crc32c(page)))
    return b"".join(pages)


def make_targets():
    return (
        [Points(key) for key in NAMES]
        + [Info(key) for key in ("las", "laz", "ply", "xyz", "pcd", "vtp")]
        + [Convert(key) for key in ("las", "laz", "ply", "xyz", "pcd", "vtp", "pvtp", "e57")]
        + [LasSource("las"), LasSource("laz"), Waves()]
    )
