// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Images by the bytes of their formats.
#include "heliosImageTesting.h"

#include <catch2/catch.hpp>

#include <array>

using helios::Damaged;
using helios::ReadBytesAsImage;
using helios::TestBmp;
using helios::TestTiff;
using helios::ToBytes;

namespace
{

// Red and green above blue and white, in blue green red.
const std::string Corners =
  ToBytes({ 255, 0, 0, 255, 255, 255, 0, 0 }) + ToBytes({ 0, 0, 255, 0, 255, 0, 0, 0 });
const std::string CornersRead = "2x2: ff0000 00ff00 / 0000ff ffffff";

// Black, red, green, blue.
const std::string Palette =
  ToBytes({ 0, 0, 0, 0 }) + ToBytes({ 0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0, 0 });

std::string WriteRuns(int compression, const std::vector<int>& codes)
{
  TestBmp image;
  image.Columns = 5;
  image.Bits = compression == 1 ? 8 : 4;
  image.Compression = compression;
  image.Colors = 4;
  image.Between = Palette;
  image.Pixels = ToBytes(codes);
  return image.Write();
}

// The pixels 1 2 3 / 4 5 6, of which the first is red.
std::string WriteTurned(std::uint32_t orientation)
{
  TestTiff image;
  image.Orientation = orientation;
  image.Pixels = ToBytes({ 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0, 5, 0, 0, 6, 0, 0 });
  return image.Write();
}

} // namespace

TEST_CASE("ImageFormats: BMP from the bottom and from the top", "[ImageFormats]")
{
  TestBmp image;
  image.Pixels = Corners;
  CHECK(ReadBytesAsImage(image.Write()) == CornersRead);
  image.Rows = -2;
  CHECK(ReadBytesAsImage(image.Write()) == "2x2: 0000ff ffffff / ff0000 00ff00");
}

TEST_CASE("ImageFormats: BMP of OS/2", "[ImageFormats]")
{
  const std::string bytes = "BM" + ToBytes(0, 8) + ToBytes(32, 4) + ToBytes(12, 4) + ToBytes(2, 2) +
    ToBytes(1, 2) + ToBytes(1, 2) + ToBytes(1, 2) + ToBytes({ 1, 2, 3, 4, 5, 6 }) +
    ToBytes({ 0x40, 0, 0, 0 });
  CHECK(ReadBytesAsImage(bytes) == "2x1: 030201 060504");
}

TEST_CASE("ImageFormats: BMP with a palette of 1, 2, 4 and 8 bits", "[ImageFormats]")
{
  const auto [bits, row] = GENERATE(table<int, std::vector<int>>({ { 1, { 0x40, 0, 0, 0 } },
    { 2, { 0x6c, 0, 0, 0 } }, { 4, { 0x12, 0x30, 0, 0 } }, { 8, { 1, 2, 3, 0 } } }));
  TestBmp image;
  image.Columns = 3;
  image.Rows = 1;
  image.Bits = bits;
  image.Between = bits == 1 ? Palette.substr(0, 8) : Palette;
  image.Colors = bits == 1 ? 2 : 4;
  image.Pixels = ToBytes(row);
  CHECK(ReadBytesAsImage(image.Write()) ==
    (bits == 1 ? "3x1: 000000 ff0000 000000" : "3x1: ff0000 00ff00 0000ff"));
  image.Colors = 1;
  image.Between = Palette.substr(0, 4);
  CHECK(ReadBytesAsImage(image.Write()) ==
    Damaged("BMP", "is damaged: a pixel has colour 1 of a palette of 1"));
}

TEST_CASE("ImageFormats: BMP of 16 and 32 bits", "[ImageFormats]")
{
  TestBmp image;
  image.Rows = 1;
  image.Bits = 16;
  image.Pixels = ToBytes(0x7c00, 2) + ToBytes(0x0210, 2); // 5 bits each
  CHECK(ReadBytesAsImage(image.Write()) == "2x1: ff0000 008484");
  image.Compression = 3;
  image.Between = ToBytes(0xf800, 4) + ToBytes(0x07e0, 4) + ToBytes(0x1f, 4);
  CHECK(ReadBytesAsImage(image.Write()) == "2x1: 7b8200 004184");
  image.Bits = 32;
  image.Between = ToBytes(0x3ff00000, 4) + ToBytes(0xffc00, 4) + ToBytes(0x3ff, 4); // 10 bits each
  image.Pixels = ToBytes(0x3ff80000, 4) + ToBytes(512, 4);
  CHECK(ReadBytesAsImage(image.Write()) == "2x1: ff8000 000080");
  image.Compression = 0;
  image.Between.clear();
  image.Pixels = ToBytes({ 1, 2, 3, 9, 4, 5, 6, 9 });
  CHECK(ReadBytesAsImage(image.Write()) == "2x1: 030201 060504");
}

TEST_CASE("ImageFormats: BMP in run lengths", "[ImageFormats]")
{
  // Three red, two pixels one by one, end of the row; a move by one; a run; the end of the image.
  CHECK(ReadBytesAsImage(WriteRuns(1, { 3, 1, 0, 0, 0, 2, 1, 0, 2, 2, 0, 1 })) ==
    "5x2: 000000 00ff00 00ff00 000000 000000 / ff0000 ff0000 ff0000 000000 000000");
  CHECK(ReadBytesAsImage(WriteRuns(1, { 0, 5, 1, 2, 3, 0, 1, 0, 0, 0, 5, 3, 0, 1 })) ==
    "5x2: 0000ff 0000ff 0000ff 0000ff 0000ff / ff0000 00ff00 0000ff 000000 ff0000");
  CHECK(ReadBytesAsImage(WriteRuns(2, { 5, 0x12, 0, 0, 0, 5, 0x12, 0x31, 0x20, 0, 0, 1 })) ==
    "5x2: ff0000 00ff00 0000ff ff0000 00ff00 / ff0000 00ff00 ff0000 00ff00 ff0000");
  // Rows that are packed with their padding, without a mark of the end.
  CHECK(ReadBytesAsImage(WriteRuns(1, { 8, 1, 0, 0, 8, 2, 0, 0 })) ==
    "5x2: 00ff00 00ff00 00ff00 00ff00 00ff00 / ff0000 ff0000 ff0000 ff0000 ff0000");
}

TEST_CASE("ImageFormats: damaged run lengths are errors", "[ImageFormats]")
{
  const std::string leaves = Damaged("BMP", "is damaged: a run of pixels leaves the image");
  const std::string ends = Damaged("BMP", "is damaged: it ends too early");
  CHECK(ReadBytesAsImage(WriteRuns(1, { 9, 1, 0, 1 })) == leaves);
  CHECK(ReadBytesAsImage(WriteRuns(1, { 0, 2, 0, 2, 1, 1, 0, 1 })) == leaves);
  CHECK(ReadBytesAsImage(WriteRuns(1, { 3, 1 })) == ends);
  CHECK(ReadBytesAsImage(WriteRuns(1, { 0, 2, 1 })) == ends);
  CHECK(ReadBytesAsImage(WriteRuns(1, { 0, 4, 1, 1 })) == ends);
  CHECK(ReadBytesAsImage(WriteRuns(1, { 3, 1, 0, 1 })) ==
    Damaged("BMP", "is damaged: it has 1 of 2 rows"));
  CHECK(ReadBytesAsImage(WriteRuns(1, { 3, 4, 0, 1 })) ==
    Damaged("BMP", "is damaged: a pixel has colour 4 of a palette of 4"));
}

TEST_CASE("ImageFormats: headers of BMP that are wrong are errors", "[ImageFormats]")
{
  TestBmp image;
  image.Pixels = Corners;
  std::string bytes = image.Write();
  bytes.replace(10, 4, ToBytes(20, 4));
  CHECK(ReadBytesAsImage(bytes) == Damaged("BMP", "is damaged: its pixels begin at byte 20"));
  image.HeaderSize = 300;
  CHECK(ReadBytesAsImage(image.Write()) == Damaged("BMP", "is damaged: its header has 300 bytes"));
  image.HeaderSize = 14;
  CHECK(ReadBytesAsImage(image.Write()) == Damaged("BMP", "is damaged: its header has 14 bytes"));
  image.HeaderSize = 40;
  image.Compression = 4; // JPEG
  CHECK(ReadBytesAsImage(image.Write()) ==
    Damaged(
      "BMP", "has pixels of 24 bits with compression 4, which are not read; save it with 24 bits"));
  image.Compression = 1;
  image.Bits = 8;
  image.Rows = -2;
  CHECK(ReadBytesAsImage(image.Write()) ==
    Damaged("BMP", "is damaged: it has run lengths from the top"));
  image.Compression = 3;
  image.Bits = 32;
  image.Between = ToBytes(0x500, 4) + ToBytes(0xff, 4) + ToBytes(0xff, 4);
  CHECK(
    ReadBytesAsImage(image.Write()) == Damaged("BMP", "is damaged: the bits of a colour are 1280"));
  image = TestBmp();
  image.Columns = -1;
  CHECK(ReadBytesAsImage(image.Write()) == Damaged("BMP", "is damaged: it has -1 x 2 pixels"));
}

TEST_CASE("ImageFormats: PNM as text and as bytes", "[ImageFormats]")
{
  const auto [bytes, read] = GENERATE(table<std::string, std::string>(
    { { "P1\n# comment\n3 2\n1 0 1\n010", "3x2: 000000 ffffff 000000 / ffffff 000000 ffffff" },
      { "P2 3 1 7#x\n0 7 3", "3x1: 000000 ffffff 6d6d6d" },
      { "P3\n1\t1\r\n65535\n65535 0 32768\n", "1x1: ff0080" },
      { "P4\n3 1\n\x40", "3x1: ffffff 000000 ffffff" },
      { "P5 2 1 100\n" + ToBytes({ 100, 50 }), "2x1: ffffff 808080" },
      { "P5 1 1 65535\n" + ToBytes({ 128, 0 }), "1x1: 808080" },
      { "P6 1 1 255\n" + ToBytes({ 1, 2, 3 }), "1x1: 010203" } }));
  CHECK(ReadBytesAsImage(bytes) == read);
}

TEST_CASE("ImageFormats: damaged PNM is an error", "[ImageFormats]")
{
  const auto [bytes, fault] = GENERATE(table<std::string, std::string>({
    { "P7\nWIDTH 1\n", "is of kind P7 (PAM), which is not read" },
    { "P5 0 1 255\n", "is damaged: it has 0 x 1 pixels" },
    { "P5 1 1 0\n1", "is damaged: its largest value is 0" },
    { "P5 1 1 70000\n1", "is damaged: it has a number above 65535" },
    { "P5 1 1 255x1", "is damaged: it has byte 120 after a number" },
    { "P5 -1 1 255\n1", "is damaged: it has byte 45 in place of a number" },
    { "P2 2 1 255\n1 x", "is damaged: it has byte 120 in place of a number" },
    { "P2 2 1 255\n1   ", "is damaged: it ends too early" },
    { "P2 2 1 9\n1 10", "is damaged: it has a number above 9" },
    { "P1 2 1\n1 2", "is damaged: it has byte 50 in place of a bit" },
    { "P1 2 1\n1 ", "is damaged: it ends too early" },
    { "P5 1 1 9\n" + ToBytes({ 10 }), "is damaged: it has a value of 10, above 9" },
    { "P5 2 2 255\nabc#", "" }, // complete
    { "P6 60000 60000 255\nabc",
      "is damaged: 60000 x 60000 pixels do not fit into a file of 22 bytes" },
  }));
  CHECK(ReadBytesAsImage(bytes) ==
    (fault.empty() ? "2x2: 616161 626262 / 636363 232323" : Damaged("PNM", fault)));
}

TEST_CASE("ImageFormats: TIFF is upright, whatever its orientation", "[ImageFormats]")
{
  const std::array<std::string, 8> read = {
    "3x2: 010000 020000 030000 / 040000 050000 060000",
    "3x2: 030000 020000 010000 / 060000 050000 040000",
    "3x2: 060000 050000 040000 / 030000 020000 010000",
    "3x2: 040000 050000 060000 / 010000 020000 030000",
    "2x3: 010000 040000 / 020000 050000 / 030000 060000",
    "2x3: 040000 010000 / 050000 020000 / 060000 030000",
    "2x3: 060000 030000 / 050000 020000 / 040000 010000",
    "2x3: 030000 060000 / 020000 050000 / 010000 040000",
  };
  for (std::uint32_t orientation = 1; orientation <= 8; ++orientation)
  {
    INFO("orientation " << orientation);
    CHECK(ReadBytesAsImage(WriteTurned(orientation)) == read[orientation - 1]);
  }
  CHECK(ReadBytesAsImage(WriteTurned(9)) == read[0]);
}

TEST_CASE("ImageFormats: greys and inks of TIFF", "[ImageFormats]")
{
  TestTiff image;
  image.Columns = 2;
  image.Rows = 1;
  image.Samples = 1;
  image.Photometric = 1;
  image.Pixels = ToBytes({ 1, 254 });
  CHECK(ReadBytesAsImage(image.Write()) == "2x1: 010101 fefefe");
  image.Photometric = 0; // 0 is white
  CHECK(ReadBytesAsImage(image.Write()) == "2x1: fefefe 010101");
  image.Bits = 4;
  image.Pixels = ToBytes({ 0x1f });
  CHECK(ReadBytesAsImage(image.Write()) == "2x1: eeeeee 000000");
  image.Bits = 16;
  image.Pixels = ToBytes(0x1ff, 2) + ToBytes(0, 2);
  CHECK(ReadBytesAsImage(image.Write()) == "2x1: fdfdfd ffffff");
  image.Bits = 8;
  image.Samples = 4;
  image.Photometric = 5; // cyan magenta yellow black
  image.Pixels = ToBytes({ 255, 0, 0, 0, 0, 0, 255, 128 });
  CHECK(ReadBytesAsImage(image.Write()) == "2x1: 00ffff 7f7f00");
}

TEST_CASE("ImageFormats: TIFF that is damaged, or not read, is an error", "[ImageFormats]")
{
  TestTiff image;
  image.Pixels = std::string(18, '\1');
  const std::string whole = image.Write();
  const std::string start = "image: TIFF image cannot be read: Read error"; // the rest by libtiff
  CHECK(ReadBytesAsImage(whole.substr(0, whole.size() - 1)).find(start) == 0);
  image.Pixels.resize(12);
  CHECK(ReadBytesAsImage(image.Write()).find(start) == 0);
  image.Rows = 90000;
  image.Columns = 90000;
  CHECK(ReadBytesAsImage(image.Write()) ==
    Damaged("TIFF", "is damaged: 90000 x 90000 pixels do not fit into a file of 170 bytes"));
  image = TestTiff();
  image.Pixels = std::string(18, '\1');
  image.Format = 3; // real numbers
  CHECK(ReadBytesAsImage(image.Write()) ==
    Damaged(
      "TIFF", "has samples of format 3, which are not read; give it whole numbers without a sign"));
  image.Format = 1;
  image.Compression = 6;
  CHECK(ReadBytesAsImage(image.Write()) ==
    Damaged("TIFF", "has compression 6, which is not read; give it another"));
  image.Compression = 1;
  image.Photometric = 8; // CIE L*a*b*
  CHECK(ReadBytesAsImage(image.Write()) ==
    Damaged("TIFF", "has colours of kind 8, which are not read; give it RGB"));
  image.Photometric = 3; // a palette, which is missing
  image.Samples = 1;
  image.Bits = 4;
  CHECK(ReadBytesAsImage(image.Write()).find("image: TIFF image cannot be read: ") == 0);
  image.Bits = 8;
  image.Photometric = 5;
  CHECK(ReadBytesAsImage(image.Write()) ==
    Damaged("TIFF", "has 1 samples of 8 bits, which are not read; give it RGB of 8 or 16 bits"));
}
