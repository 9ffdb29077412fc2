// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlyTesting.h"
#include "heliosSceneCrs.h"
#include "heliosWriterTesting.h"
#include "vtkHeliosPLYPointReader.h"

#include <vtkFieldData.h>
#include <vtkPointData.h>

using helios::ply::MakeBinary;
using Reading = helios::SceneReading<vtkHeliosPLYPointReader>;

namespace
{

const std::string Xyz = "property float x\nproperty float y\nproperty float z\n";

std::string MakeText(const std::string& properties, const std::string& rows, int count = 2)
{
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) + "\n" + properties +
    "end_header\n" + rows;
}

vtkDataArray* Get(Reading& reading, const char* name)
{
  return reading.Scene()->GetPointData()->GetArray(name);
}

} // namespace

TEST_CASE("PLYPointReader: vertices of text and of both byte orders", "[PLYPointReader]")
{
  for (const std::string& bytes : { helios::ply::Square, MakeBinary(false), MakeBinary(true) })
  {
    Reading reading("a.ply", bytes);
    REQUIRE(reading.Read());
    REQUIRE(reading.Points() == 5);
    CHECK(reading.Scene()->GetPoint(4)[0] == 447422.9990000001);
    CHECK(reading.Scene()->GetPoint(4)[1] == 0.1);
    CHECK(reading.Triangles() == 0);
    CHECK(Get(reading, "red")->GetDataType() == VTK_UNSIGNED_CHAR);
    CHECK(reading.Reader->GetNumberOfVertices() == 5);
    CHECK(std::string(reading.Reader->GetFormat()) ==
      (bytes == helios::ply::Square    ? "ascii"
          : bytes == MakeBinary(false) ? "binary_little_endian"
                                       : "binary_big_endian"));
  }
}

TEST_CASE("PLYPointReader: pieces of a file in any order are the whole", "[PLYPointReader]")
{
  const double xs[] = { 0.0, 1.0, 1.0, 0.0, 447422.9990000001 };
  const int begins[] = { 0, 1, 3, 5 };
  for (const std::string& bytes : { helios::ply::Square, MakeBinary(false) })
  {
    Reading reading("a.ply", bytes);
    for (const int piece : { 0, 1, 2, 1, 0, 2 })
    {
      reading.Log->Clear();
      reading.Reader->UpdatePiece(piece, 3, 0);
      REQUIRE(reading.Log->Errors.empty());
      REQUIRE(reading.Points() == begins[piece + 1] - begins[piece]);
      for (vtkIdType i = 0; i < reading.Points(); ++i)
      {
        CHECK(reading.Scene()->GetPoint(i)[0] == xs[begins[piece] + i]);
      }
    }
  }
}

TEST_CASE("PLYPointReader: types, names and comments of vtkhelios", "[PLYPointReader]")
{
  Reading reading("a.ply",
    MakeText("comment vtkhelios crs EPSG:25832\ncomment vtkhelios epoch 1e9\ncomment vtkhelios\n"
             "comment vtkhelios type:H\\u00f6he int64\nproperty int X\n" +
        Xyz.substr(17) + "property double H\\u00f6he\nproperty char \xe4\n",
      "1 2.123456789 3 9007199254740992 -128\n4 nan inf -5 127\n"));
  REQUIRE(reading.Read());
  CHECK(reading.Scene()->GetPoint(0)[0] == 1.0);
  CHECK(reading.Scene()->GetPoint(0)[1] == 2.123456789);
  CHECK(std::isnan(reading.Scene()->GetPoint(1)[1]));
  CHECK(Get(reading, "H\xc3\xb6he")->GetDataType() == VTK_TYPE_INT64);
  CHECK(Get(reading, "H\xc3\xb6he")->GetTuple1(0) == 9007199254740992.0);
  CHECK(Get(reading, "\xc3\xa4")->GetTuple1(0) == -128.0);
  CHECK(helios::GetCRS(reading.Scene()) == "EPSG:25832");
  CHECK(reading.Scene()->GetFieldData()->GetArray("GpsEpoch")->GetTuple1(0) == 1e9);
}

TEST_CASE("PLYPointReader: errors", "[PLYPointReader]")
{
  const std::string number = "property uchar n\n";
  const std::string whole = "comment vtkhelios type:n uint16\nproperty float n\n";
  std::string cut = MakeBinary(false);
  cut.resize(cut.find("end_header\n") + 11 + 60);
  helios::CheckErrors<vtkHeliosPLYPointReader>("a.ply",
    { { "no PLY", ":1: is not a PLY file" },
      { MakeText(Xyz + "property list uchar int n\n", ""),
        ":8: property \"n\" of element vertex is a list; points have plain numbers only: remove" },
      { "ply\nformat ascii 1.0\nelement face 1\nproperty int n\nelement vertex 1\n" + Xyz +
          "end_header\n1\n",
        ":9: element \"face\" comes before element vertex; write the vertices first" },
      { MakeText(Xyz + "property int X\nproperty int x\n", ""), ":8: property \"x\" of" },
      { MakeText(Xyz, "1 2 3\n", 999999),
        ": the elements of its header need 5999994 bytes or more, and 6 follow, so it is cut off" },
      { cut,
        ": the elements of its header need 135 bytes or more, and 60 follow, so it is cut off" },
      { MakeText(Xyz + "comment vtkhelios epoch x\n", "1 2 3\n1 2 3\n"),
        ": gives \"x\" as the origin of its times, which is not a number; correct it" },
      { MakeText(Xyz + number, "1 2 3 4\n1 2 3 300\n"),
        ":10: n is 300, not of type uchar; correct it" },
      { MakeText(Xyz + "property float n\n", "1 2 3 1e99\n1 2 3 4\n"),
        ":9: n is 1e+99, not of type float; correct it" },
      { MakeText(Xyz + whole, "1 2 3 0.5\n1 2 3 300\n"),
        ":10: n is 0.5, not of type uint16; correct it" },
      { MakeText(Xyz + whole, "1 2 3 -1\n1 2 3 300\n"), ":10: n is -1, not of type uint16" },
      { MakeText(Xyz + whole, "1 2 3 nan\n1 2 3 300\n"), ":10: n is nan, not of type uint16" },
      { MakeText(Xyz, "1 2 3\n1 2,5 3\n"), ":9: \"2,5\" is not a number; correct it" },
      { MakeText(Xyz, "1 2 3\n\n\n\n\n\n\n"), ":14: the file ends here, so it is cut off" } });
  vtkNew<vtkHeliosPLYPointReader> reader;
  const auto log = helios::WatchErrors(reader);
  const auto quiet = helios::WatchErrors(reader->GetExecutive());
  reader->Update();
  CHECK(log->HasError("FileName is not set; give the PLY file with SetFileName"));
}

TEST_CASE("PLYPointReader: damaged files give an error or points", "[PLYPointReader]")
{
  const std::vector<std::string> good = { helios::ply::Square, MakeBinary(false),
    MakeBinary(true) };
  const int count = helios::GetNumberOfMutations();
  int clouds = 0;
  for (int seed = 0; seed < count; ++seed)
  {
    INFO("seed " << seed);
    const std::string& bytes = good[static_cast<std::size_t>(seed) % good.size()];
    Reading reading("a.ply", helios::Mutator(static_cast<unsigned>(seed))(bytes));
    const bool isRead = reading.Read();
    clouds += isRead;
    REQUIRE(reading.Points() == (isRead ? reading.Reader->GetNumberOfVertices() : 0));
  }
  CHECK(clouds > 0);
  CHECK(clouds < count);
}
