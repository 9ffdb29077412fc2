// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Errors of the PLY reader on bad files.
#include "heliosPlyTesting.h"

using helios::BadFile;
using helios::ply::MakeBinary;
using helios::ply::MakeHead;
using helios::ply::Reading;
using helios::ply::Square;

namespace
{

void Check(const std::vector<BadFile>& cases)
{
  helios::CheckErrors<vtkHeliosPLYSceneReader>("a.ply", cases);
}

const std::string Start = "ply\nformat ascii 1.0\n";
const std::string Vertex =
  "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
const std::string Face = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string End = "end_header\n";

} // namespace

TEST_CASE("PLYErrors: headers", "[PLYErrors]")
{
  Check({ { "", ":0: the file ends before end_header; it is not a PLY file, or is cut off" },
    { "solid\n", ":1: is not a PLY file: its first line is not ply; check its name" },
    { "ply\nformat zip 1.0\n", ":2: format \"zip\" is not known; expected one of ascii" },
    { "ply\nformat ascii 2.0\n", ":2: format \"ascii\" is not known" },
    { Start + "elements 3\n", ":3: unknown entry \"elements\"; a PLY header has format" },
    { Start + "element vertex x\n",
      ":3: element \"vertex\" has the count \"x\"; expected a whole number from 0 to 2^40" },
    { Start + "element vertex -1\n", ":3: element \"vertex\" has the count \"-1\"" },
    { Start + "element vertex 9999999999999\n", ":3: element \"vertex\" has the count" },
    { Start + Vertex + "element vertex 1\n", ":7: element \"vertex\" is given twice; remove one" },
    { Start + "property float x\n", ":3: property comes before any element; write element NAME" },
    { Start + Vertex + "property real w\n",
      ":7: type \"real\" is not known; expected one of char" },
    { Start + Vertex + "property list float int w\n",
      ":7: a list has a count of floating point; give it an integer type" },
    { Start + Vertex + "property float x\n", ":7: property \"x\" of \"vertex\" is given twice" },
    { Start + Vertex + "property float\n", ":7: property has no name; give it one" },
    { Start + Face + End, ":5: the header has no element vertex; write it again" },
    { "ply\n" + Vertex + End, ":6: the header has no format; write it again" },
    { Start + "element vertex 1\nproperty float x\nproperty list uchar int y\nproperty float z\n" +
        Face + End,
      ":9: element vertex has no number y; vertices need x, y and z" },
    { Start + Vertex + Face + "element odd 3\n" + End,
      ":10: element \"odd\" has no property; remove it" },
    { Start + Vertex + "element tristrips 1\nproperty list int int vertex_indices\n" + End,
      ":9: element tristrips is not supported; save the triangles as faces" },
    { Start + Vertex + End,
      ":7: the header has no element face: the file is a cloud; give a mesh" },
    { Start + Vertex + "element face 1\nproperty list uchar float vertex_indices\n" + End,
      ":9: element face has no list vertex_indices of integers; write it again" },
    { Start + Face + Vertex + End + "3 0 0 0\n0 0 0\n",
      ": element face comes before element vertex; write the vertices first" },
    { Start + "element vertex 1000000\nproperty float x\nproperty float y\nproperty float z\n" +
        Face + End,
      ": the elements of its header need 6000002 bytes or more, and 0 follow" } });
}

TEST_CASE("PLYErrors: text", "[PLYErrors]")
{
  const std::string head = MakeHead("ascii", 3, 1);
  const std::string rest(40, '\n'); // no shorter than the header tells
  const std::string points = "0 0 0 0\n1 0 0 0\n1 1 0 0\n";
  Check({ { head + "0 0 1,5 0\n" + rest, ":16: \"1,5\" is not a number; correct it" },
    { head + "0 0 0\n" + rest, ":16: too few numbers for the properties of the header; add them" },
    { head + "0 0 0 0 9\n" + rest,
      ":16: \"9\" is one number more than the header has properties; remove it" },
    { head + "0 0 nan 0\n" + rest, ":16: vertex coordinate z is NaN; correct the vertex" },
    { head + "0 -inf 0 0\n" + rest, ":16: vertex coordinate y is infinite" },
    { head + points + rest, ":58: the file ends here, so it is cut off; copy or write it again" },
    { head + points + "0 3 0 1 3\n" + rest,
      ":19: face refers to vertex 3, but the file has 3, counted from 0; correct the index" },
    { head + points + "0 3 0 1 -1\n" + rest, ":19: face refers to vertex -1, but the file has 3" },
    { head + points + "0 3 0 1 1.5\n" + rest, ":19: \"1.5\" is not a whole number; correct it" },
    { head + points + "0 3 0 1 inf\n" + rest, ":19: \"inf\" is not a whole number; correct it" },
    { head + points + "0 3 0 1 1e300\n" + rest, ":19: \"1e300\" is not a whole number" },
    { head + points + "0 2 0 1\n" + rest, ":19: face has 2 corners; it needs three or more" },
    { head + points + "0 -1 0 1\n" + rest,
      ":19: list vertex_indices has a count below 0; correct it" } });
}

TEST_CASE("PLYErrors: binary data", "[PLYErrors]")
{
  const std::string good = MakeBinary(false);
  const std::size_t begin = MakeHead("binary_little_endian", 5, 3).size();
  std::string bad = good;
  bad.replace(begin + 25 * 5 + 3 + 8, 1, "\x09"); // the third corner of the first face
  std::string notFinite = good;
  notFinite.replace(begin + 25 + 22, 2, "\xf8\x7f"); // z of the second vertex
  Check({ { bad, ": face 0: face refers to vertex 9, but the file has 5" },
    { notFinite, ": vertex 1: vertex coordinate z is NaN; correct the vertex" },
    { good.substr(0, good.size() - 4), ": edge 0: the file ends here, so it is cut off" },
    { good.substr(0, begin + 50),
      ": the elements of its header need 135 bytes or more, and "
      "50 follow, so it is cut off; copy or write it again" } });
}
