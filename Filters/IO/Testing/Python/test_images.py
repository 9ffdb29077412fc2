# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images that Pillow, GDAL and ImageMagick wrote, pixel by pixel."""

import shutil
import subprocess

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkhelios

Image = pytest.importorskip("PIL.Image")

WIDTH, HEIGHT = 21, 13  # no multiples of bytes, tiles or strips
RANDOM = np.random.default_rng(7)
COLORS = RANDOM.integers(0, 256, (HEIGHT, WIDTH, 3), dtype=np.uint8)
GREYS = COLORS[..., 0]
BITS = GREYS > 127
WIDE = RANDOM.integers(0, 65536, (HEIGHT, WIDTH, 3), dtype=np.uint16)
PALETTE = RANDOM.integers(0, 256, (256, 3), dtype=np.uint8)
Y, X = np.mgrid[:40, :60]
SMOOTH = np.dstack([3 * X + Y, 2 * Y, 200 - 2 * X]).astype(np.uint8)  # for JPEG
ORIENTATIONS = [
    lambda a: a, lambda a: a[:, ::-1], lambda a: a[::-1, ::-1], lambda a: a[::-1],
    lambda a: a.transpose(1, 0, 2), lambda a: a.transpose(1, 0, 2)[:, ::-1],
    lambda a: a.transpose(1, 0, 2)[::-1, ::-1], lambda a: a.transpose(1, 0, 2)[::-1],
]  # fmt: skip


def read(path):
    """Rows of red green blue, from the top."""
    image = vtkhelios.update(vtkhelios.vtkHeliosImageReader(file_name=str(path)))
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)[::-1]


def check(path, expected, tolerance=0):
    expected = np.asarray(expected)
    if expected.ndim == 2:
        expected = np.repeat(expected[..., None], 3, axis=2)
    found = read(path)
    assert found.shape == expected.shape
    assert np.abs(found.astype(int) - expected.astype(int)).max() <= tolerance


def narrow(values, most=65535):
    """Rounds to 8 bits."""
    return np.floor(values * 255.0 / most + 0.5).astype(np.uint8)


def with_palette(indices):
    image = Image.fromarray(indices, mode="P")
    image.putpalette(PALETTE.tobytes())
    return image


def grey_with_alpha():
    return Image.merge("LA", [Image.fromarray(GREYS), Image.fromarray(GREYS[::-1].copy())])


def ink():
    """Cyan, magenta, yellow and black, and the colours that they are on paper."""
    values = RANDOM.integers(0, 256, (HEIGHT, WIDTH, 4), dtype=np.uint8)
    light = 255 - values.astype(int)
    return Image.fromarray(values, mode="CMYK"), (light[..., :3] * light[..., 3:] + 127) // 255


def make_kinds():
    """Images of Pillow by mode, and what is seen."""
    inks, seen = ink()
    return {
        "RGB": (Image.fromarray(COLORS), COLORS),
        "RGBA": (Image.fromarray(np.dstack([COLORS, GREYS])), COLORS),
        "L": (Image.fromarray(GREYS), GREYS),
        "LA": (grey_with_alpha(), GREYS),
        "1": (Image.fromarray(BITS), 255 * BITS),
        "P": (with_palette(GREYS), PALETTE[GREYS]),
        "I;16": (Image.fromarray(WIDE[..., 0].copy()), narrow(WIDE[..., 0])),
        "CMYK": (inks, seen),
    }


KINDS = make_kinds()


@pytest.mark.parametrize("mode", ["RGB", "RGBA", "L", "LA", "1", "P", "I;16"])
def test_png(tmp_path, mode):
    KINDS[mode][0].save(tmp_path / "a.png")
    check(tmp_path / "a.png", KINDS[mode][1])


@pytest.mark.parametrize("bits", [1, 2, 4, 8])
@pytest.mark.parametrize("options", [{}, {"transparency": 0}])
def test_png_with_a_palette(tmp_path, bits, options):
    indices = GREYS >> (8 - bits)
    with_palette(indices).save(tmp_path / "a.png", bits=bits, **options)
    check(tmp_path / "a.png", PALETTE[indices])


@pytest.mark.parametrize(
    "options", [{}, {"progressive": True}, {"subsampling": 0}, {"optimize": True, "quality": 30}]
)
def test_jpeg(tmp_path, options):
    for mode in ("RGB", "L", "CMYK"):
        path = tmp_path / f"{mode}.jpg"
        Image.fromarray(SMOOTH).convert(mode).save(path, **{"quality": 95, **options})
        # decoders round on their own; CMYK is then multiplied
        check(path, Image.open(path).convert("RGB"), 2 if mode == "CMYK" else 1)


@pytest.mark.parametrize("compression", [None, "tiff_lzw", "tiff_adobe_deflate", "packbits"])
@pytest.mark.parametrize("mode", ["RGB", "RGBA", "L", "1", "P", "I;16", "CMYK"])
def test_tiff(tmp_path, mode, compression):
    KINDS[mode][0].save(tmp_path / "a.tif", compression=compression)
    check(tmp_path / "a.tif", KINDS[mode][1])


@pytest.mark.parametrize("compression", ["group3", "group4"])
def test_faxes(tmp_path, compression):
    KINDS["1"][0].save(tmp_path / "a.tif", compression=compression)
    check(tmp_path / "a.tif", KINDS["1"][1])


@pytest.mark.parametrize("orientation", range(1, 9))
def test_tiff_is_upright(tmp_path, orientation):
    Image.fromarray(COLORS).save(tmp_path / "a.tif", tiffinfo={274: orientation})
    check(tmp_path / "a.tif", ORIENTATIONS[orientation - 1](COLORS))
    image = Image.open(tmp_path / "a.tif")
    image.load()  # upright, by Pillow
    check(tmp_path / "a.tif", image)


@pytest.mark.parametrize("mode", ["RGB", "RGBA", "L", "1", "P"])
def test_bmp(tmp_path, mode):
    KINDS[mode][0].save(tmp_path / "a.bmp")
    check(tmp_path / "a.bmp", KINDS[mode][1])


@pytest.mark.parametrize("mode", ["RGB", "L", "1", "I;16"])
def test_pnm(tmp_path, mode):
    image = KINDS[mode][0].convert("I") if mode == "I;16" else KINDS[mode][0]
    image.save(tmp_path / "a.ppm")
    check(tmp_path / "a.ppm", KINDS[mode][1])


# GDAL


def write_with_gdal(path, driver, values, options, palette=None):
    gdal = pytest.importorskip("osgeo.gdal")
    values = values if values.ndim == 3 else values[..., None]
    kind = gdal.GDT_UInt16 if values.dtype == np.uint16 else gdal.GDT_Byte
    memory = gdal.GetDriverByName("MEM").Create(
        "", values.shape[1], values.shape[0], values.shape[2], kind
    )
    for band in range(values.shape[2]):
        memory.GetRasterBand(band + 1).WriteArray(values[..., band])
    if palette is not None:
        table = gdal.ColorTable()
        for index, color in enumerate(palette):
            table.SetColorEntry(index, (*map(int, color), 255))
        memory.GetRasterBand(1).SetRasterColorTable(table)
    copy = gdal.GetDriverByName(driver).CreateCopy(str(path), memory, options=options)
    assert copy is not None
    copy.FlushCache()


@pytest.mark.parametrize("compression", ["NONE", "LZW", "DEFLATE", "PACKBITS"])
@pytest.mark.parametrize(
    "layout", ["TILED=YES BLOCKXSIZE=16 BLOCKYSIZE=16", "TILED=NO BLOCKYSIZE=5"]
)
@pytest.mark.parametrize("planes", ["PIXEL", "BAND"])
def test_layouts_of_tiff(tmp_path, compression, layout, planes):
    path = tmp_path / "a.tif"
    options = [*layout.split(), f"COMPRESS={compression}", f"INTERLEAVE={planes}"]
    variants = [[], ["ENDIANNESS=BIG"], ["BIGTIFF=YES"]]
    variants += [["PREDICTOR=2"]] if compression in ("LZW", "DEFLATE") else []
    for more in variants:
        write_with_gdal(path, "GTiff", COLORS, [*options, "PHOTOMETRIC=RGB", *more])
        check(path, COLORS)
        write_with_gdal(path, "GTiff", WIDE, [*options, "PHOTOMETRIC=RGB", *more])
        check(path, narrow(WIDE))
        write_with_gdal(path, "GTiff", WIDE[..., 1], [*options, *more])
        check(path, narrow(WIDE[..., 1]))


@pytest.mark.parametrize("bits", [1, 2, 4])
def test_small_samples_of_tiff(tmp_path, bits):
    path = tmp_path / "a.tif"
    values = GREYS >> (8 - bits)
    write_with_gdal(path, "GTiff", values, [f"NBITS={bits}"])
    check(path, narrow(values, 2**bits - 1))
    write_with_gdal(path, "GTiff", values, [f"NBITS={bits}"], PALETTE[: 2**bits])
    check(path, PALETTE[values])


def test_other_colours_of_tiff(tmp_path):
    path = tmp_path / "a.tif"
    write_with_gdal(path, "GTiff", GREYS, ["PHOTOMETRIC=MINISWHITE"])
    check(path, 255 - GREYS)
    for layout in ["TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16"], []:
        options = ["COMPRESS=JPEG", "PHOTOMETRIC=YCBCR", "JPEG_QUALITY=95", *layout]
        write_with_gdal(path, "GTiff", SMOOTH, options)
        check(path, Image.open(path).convert("RGB"), 2)


def test_png_and_pnm_of_16_bits(tmp_path):
    for driver, name in (("PNG", "a.png"), ("PNM", "a.ppm")):
        write_with_gdal(tmp_path / name, driver, WIDE, [])
        check(tmp_path / name, narrow(WIDE))


# ImageMagick


@pytest.fixture
def convert(tmp_path):
    """Converts a PNG of Pillow, and returns the path of the result."""
    program = shutil.which("convert-im6.q16") or shutil.which("magick") or shutil.which("convert")
    if not program:
        pytest.skip("ImageMagick is not installed")

    def call(image, name, *options):
        image.save(tmp_path / "source.png")
        path = tmp_path / name.split(":")[-1]
        form = name.split(":")[0] + ":" if ":" in name else ""
        subprocess.run([program, tmp_path / "source.png", *options, f"{form}{path}"], check=True)
        return path

    return call


@pytest.mark.parametrize("mode", ["RGB", "L", "1", "P"])
def test_interlaced_png(convert, mode):
    check(convert(KINDS[mode][0], "a.png", "-interlace", "line"), KINDS[mode][1])


@pytest.mark.parametrize("form", ["BMP2", "BMP3", "BMP"])
def test_bmp_of_all_versions(convert, form):
    check(convert(KINDS["RGB"][0], f"{form}:a.bmp"), COLORS)
    # runs of bytes, also for what pads a row
    flat = GREYS // 64
    flat[4:9] = 3
    check(convert(with_palette(flat), f"{form}:b.bmp", "-compress", "RLE"), PALETTE[flat])


@pytest.mark.parametrize("kind", ["RGB565", "RGB555", "ARGB1555"])
def test_bmp_of_16_bits(convert, kind):
    path = convert(KINDS["RGB"][0], "a.bmp", "-define", f"bmp:subtype={kind}")
    check(path, COLORS, 8)


@pytest.mark.parametrize("mode", ["RGB", "L", "1"])
def test_pnm_as_text(convert, mode):
    path = convert(KINDS[mode][0], "a.pnm", "-compress", "none")
    assert path.read_bytes()[:2] in (b"P1", b"P2", b"P3")
    check(path, KINDS[mode][1])


def test_jpeg_in_inks(convert):
    image = Image.fromarray(SMOOTH)
    path = convert(image, "a.jpg", "-colorspace", "CMYK", "-quality", "100")
    check(path, SMOOTH, 16)


# Errors


def test_errors_are_exceptions(tmp_path):
    Image.fromarray(COLORS).save(tmp_path / "a.png")
    (tmp_path / "a.png").write_bytes((tmp_path / "a.png").read_bytes()[:-20])
    with pytest.raises(
        vtkhelios.PipelineError,
        match="a.png: PNG image cannot be read: the file ends too early; get it",
    ):
        read(tmp_path / "a.png")
    with pytest.raises(vtkhelios.PipelineError, match="b.png does not exist; give it"):
        read(tmp_path / "b.png")


def test_an_orientation_of_a_camera_is_a_warning(tmp_path):
    exif = Image.Exif()
    exif[274] = 6
    path = tmp_path / "a.jpg"
    Image.fromarray(SMOOTH).save(path, quality=95, exif=exif)
    with pytest.warns(RuntimeWarning, match="a.jpg: EXIF orientation 6 is not applied"):
        assert read(path).shape == SMOOTH.shape
    check_again = Image.open(path)
    assert check_again.size == SMOOTH.shape[1::-1]
