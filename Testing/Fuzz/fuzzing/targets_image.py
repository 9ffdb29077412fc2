# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Textures: images of all formats, by their reader and on a wall that is scanned."""

import io
import struct
import zlib

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkhelios

from .outcomes import check, check_finite
from .target import Seed, Target, need, update

WIDTH, HEIGHT = 13, 9
MAXIMUM_PIXELS = 4_000_000  # pixels that are compared
WALL = """\
mtllib a.mtl
v -5 5 -5
v 5 5 -5
v 5 5 5
v -5 5 5
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl wall
f 1/1 2/2 3/3 4/4
"""


def make_pixels():
    """Smooth, so that JPEG keeps them."""
    y, x = np.mgrid[:HEIGHT, :WIDTH]
    return np.dstack([10 * x + 8 * y, 20 * y, 128 - 6 * x]).astype(np.uint8)


class Texture(Target):
    """Images: whole, and of the pixels that Pillow reads, if it reads them."""

    kind = "binary"

    def __init__(self, name, ways, tolerance=0):
        self.name = f"texture-{name}"
        self.ways = ways
        self.tolerance = tolerance

    def missing(self):
        return need("PIL")

    def make_seeds(self, folder):
        from PIL import Image

        image = Image.fromarray(make_pixels())
        seeds = []
        for number, (mode, options) in enumerate(self.ways):
            buffer = io.BytesIO()
            turned = image.quantize(16) if mode == "P" else image.convert(mode)
            turned.save(buffer, **options)
            seeds.append(Seed(f"{number}.{options['format'].lower()}", buffer.getvalue()))
        return seeds + self.more_seeds()

    def more_seeds(self):
        """Returns seeds of variants that Pillow does not write."""
        return []

    def run(self, path, data):
        reader = vtkhelios.vtkHeliosImageReader()
        reader.SetFileName(str(path))
        image, warned = update(reader)
        width, height, _ = image.GetDimensions()
        colors = vtk_to_numpy(image.GetPointData().GetScalars())
        check(colors.shape == (width * height, 3), f"{colors.shape} colours of {width} x {height}")
        if width * height <= MAXIMUM_PIXELS:
            self.compare(colors.reshape(height, width, 3)[::-1], data)

    def compare(self, rows, data):
        """Compares with another program, where that reads the file as well."""
        from PIL import Image

        try:
            image = Image.open(io.BytesIO(data))
            image.load()
        except Exception:  # whatever it raises, it reads no pixels
            return
        if not self.is_comparable(image):
            return
        check(image.size == rows.shape[1::-1], f"{rows.shape} of {image.size} pixels")
        expected = np.asarray(image.convert("RGB"), dtype=int)
        worst = int(np.abs(rows - expected).max())
        check(worst <= self.tolerance, f"pixels differ from Pillow's by {worst}")

    def is_comparable(self, image):
        """Pillow clips more than 8 bits."""
        return image.mode in ("1", "L", "LA", "P", "RGB", "RGBA")


class Png(Texture):
    """PNG images, some with their checksums repaired."""

    def repair(self, data, random):
        """The checksums, of half of the cases."""
        if random.random() < 0.5 or data[:8] != b"\x89PNG\r\n\x1a\n":
            return data
        at, fixed = 8, data[:8]
        while at + 12 <= len(data):
            size = int.from_bytes(data[at : at + 4], "big")
            chunk = data[at + 4 : at + 8 + size]
            if at + 12 + size > len(data):
                break
            fixed += struct.pack(">I", size) + chunk + struct.pack(">I", zlib.crc32(chunk))
            at += 12 + size
        return fixed + data[at:]


class Bmp(Texture):
    """BMP images, also with run lengths."""

    def more_seeds(self):
        palette = bytes(range(64))
        runs = bytes([3, 1, 0, 4, 2, 3, 4, 5, 6, 7, 0, 0, 0, 2, 1, 0, 9, 15, 0, 0, 13, 2, 0, 1])
        head = b"BM" + struct.pack(
            "<IIIIiiHHIIIIII", 0, 0, 54 + 64, 40, 13, 3, 1, 8, 1, 0, 0, 0, 16, 0
        )
        return [Seed("runs.bmp", head + palette + runs)]

    def is_comparable(self, image):
        """It reads moves in run lengths in its own way."""
        return super().is_comparable(image) and not image.info.get("compression")


class Pnm(Texture):
    """PNM images, of all kinds."""

    def more_seeds(self):
        return [
            Seed("bits.pbm", b"P1\n# bits\n3 2\n1 0 1\n010\n"),
            Seed("grey.pgm", b"P2 3 2 15\n0 7 3\n15 1 2\n"),
            Seed("wide.ppm", b"P6 2 1 1000\n" + struct.pack(">6H", 0, 200, 400, 600, 800, 1000)),
            Seed("text.ppm", b"P3\n2 1\n255\n1 2 3\n40 50 60\n"),
        ]


class Tiff(Texture):
    """TIFF images, whose damaged tags can be read in several ways."""

    def is_comparable(self, image):
        """Returns whether a file is comparable: Pillow uses another part of an entry that is there
        twice, and of palettes that are too long."""
        return False


class Scanned(Target):
    """A wall with a texture: echoes have finite colours, or there is an error with its name."""

    name = "texture-scan"
    kind = "binary"
    weight = 0.4

    def missing(self):
        return need("PIL")

    def make_seeds(self, folder):
        from PIL import Image

        beside = {"wall.obj": WALL.encode(), "a.mtl": b"newmtl wall\nKd 1 0.5 1\nmap_Kd image\n"}
        seeds = []
        for form in ("png", "jpeg", "tiff", "bmp", "ppm"):
            buffer = io.BytesIO()
            Image.fromarray(make_pixels()).save(buffer, form)
            seeds.append(Seed(f"image.{form}", buffer.getvalue(), beside))
        return seeds

    def run(self, path, data):
        path.rename(path.with_name("image"))
        try:
            scene = vtkhelios.Scene.read(path.with_name("wall.obj"), read_colors=True)
            cloud = vtkhelios.scan(
                scene, position=(0, 0, 0), scan_frequency=20, vertical=(-5, 5), head=(88, 92), head_speed=60,
                pulse_frequency=2000, noise=False, colors=True,
            )  # fmt: skip
        except vtkhelios.PipelineError as error:
            check("image" in str(error), f"an error without the name of the image: {error}")
            raise
        finally:
            path.with_name("image").rename(path)
        check_finite("RGB", cloud["RGB"])
        check((cloud["RGB"] >= 0).all() and (cloud["RGB"] <= 1).all(), "colours outside [0, 1]")


def make_targets():
    png, jpeg, tiff = "PNG", "JPEG", "TIFF"
    return [
        Png("png", [
            ("RGB", {"format": png}), ("RGBA", {"format": png}), ("L", {"format": png}),
            ("1", {"format": png}), ("P", {"format": png, "bits": 4}),
        ]),
        Texture("jpeg", [
            ("RGB", {"format": jpeg, "quality": 95}), ("L", {"format": jpeg}),
            ("RGB", {"format": jpeg, "progressive": True}), ("CMYK", {"format": jpeg}),
        ], tolerance=3),
        Tiff("tiff", [
            ("RGB", {"format": tiff}), ("L", {"format": tiff, "compression": "tiff_lzw"}),
            ("RGB", {"format": tiff, "compression": "packbits"}), ("P", {"format": tiff}),
            ("RGB", {"format": tiff, "compression": "tiff_adobe_deflate"}), ("1", {"format": tiff}),
            ("RGB", {"format": tiff, "compression": "jpeg"}),
        ]),
        Bmp("bmp", [("RGB", {"format": "BMP"}), ("P", {"format": "BMP"}), ("1", {"format": "BMP"})]),
        Pnm("pnm", [
            ("RGB", {"format": "PPM"}), ("L", {"format": "PPM"}), ("1", {"format": "PPM"}),
        ], tolerance=1),  # halves are rounded up, or to an even value
        Scanned(),
    ]  # fmt: skip
