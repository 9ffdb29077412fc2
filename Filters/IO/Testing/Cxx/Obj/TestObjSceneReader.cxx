// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosAborts.h"
#include "heliosObjTestFiles.h"

#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkPoints.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

using helios::ObjReading;
using helios::ObjSquare;
using helios::TestFolder;
using Ids = std::vector<vtkIdType>;

namespace
{

// Records the progress of an algorithm, and aborts it at a given progress.
class ProgressObserver : public vtkCommand
{
public:
  static ProgressObserver* New() { return new ProgressObserver; }
  void Execute(vtkObject* caller, unsigned long, void* data) override
  {
    this->Values.push_back(*static_cast<double*>(data));
    if (this->Values.back() >= this->AbortFrom)
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  }
  std::vector<double> Values;
  double AbortFrom = 2.0;
};

// A triangle strip that spans many blocks of the reader.
std::string MakeLongFile(int vertexCount)
{
  std::string text;
  char line[80];
  for (int i = 0; i < vertexCount; ++i)
  {
    std::snprintf(line, sizeof(line), "v %d.5 %d %d.25\n", i / 2, i % 2, i % 7);
    text += line;
  }
  for (int i = 1; i + 2 <= vertexCount; ++i)
  {
    std::snprintf(line, sizeof(line), "f %d %d %d\n", i, i + 1, i + 2);
    text += line;
  }
  return text;
}

} // namespace

TEST_CASE("ObjSceneReader: decimals are rounded to the nearest double", "[ObjSceneReader]")
{
  TestFolder folder;
  std::mt19937_64 random(20210);
  std::vector<std::string> numbers = { "5500000.654321", "+0.1", "-0.0", "1.", ".5", "-.5e-3",
    "1E+5", "0.30000000000000004", "9007199254740993", "2.2250738585072011e-308", "4.9e-324",
    "179769.31348623157e3", "123456789012345678901234567890", "1e-7", "7.2057594037927933e16" };
  while (numbers.size() % 3 != 0 || numbers.size() < 3000)
  {
    char text[64];
    const double value = std::ldexp(static_cast<double>(random() >> 11), -30);
    std::snprintf(text, sizeof(text), numbers.size() % 2 ? "%.17g" : "%.6f", value);
    numbers.push_back(text);
  }
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
  {
    text += "v " + numbers[i] + " " + numbers[i + 1] + "\t" + numbers[i + 2] + "\n";
  }
  for (std::size_t i = 3; i <= numbers.size() / 3; ++i)
  {
    text +=
      "f " + std::to_string(i - 2) + ' ' + std::to_string(i - 1) + ' ' + std::to_string(i) + '\n';
  }
  ObjReading reading(folder.Write("a.obj", text));
  REQUIRE(reading.Read());
  REQUIRE(reading.Scene()->GetPoints()->GetDataType() == VTK_DOUBLE);
  REQUIRE(reading.Scene()->GetNumberOfPoints() == static_cast<vtkIdType>(numbers.size() / 3));
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const double expected = std::strtod(numbers[i].c_str(), nullptr);
    const double value = reading.Scene()->GetPoints()->GetData()->GetComponent(i / 3, i % 3);
    INFO(numbers[i]);
    REQUIRE(std::memcmp(&value, &expected, sizeof(double)) == 0);
  }
}

TEST_CASE("ObjSceneReader: cells are 32-bit triangles in file order", "[ObjSceneReader]")
{
  TestFolder folder;
  ObjReading reading(folder.Write("a.obj", ObjSquare + "f 1 2 3\nf 1 3 4\n"));
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty());
  REQUIRE(reading.TriangleCount() == 2);
  CHECK_FALSE(reading.Scene()->GetPolys()->IsStorage64Bit());
  CHECK(reading.Scene()->GetPolys()->IsHomogeneous() == 3);
  CHECK(reading.Corners(0) == Ids{ 0, 1, 2 });
  CHECK(reading.Corners(1) == Ids{ 0, 2, 3 });
}

TEST_CASE("ObjSceneReader: all notations of a face corner", "[ObjSceneReader]")
{
  TestFolder folder;
  const std::string head = ObjSquare + "vt 0 0\nvt 1 0 0\nvt 0.5\nvn 0 0 1\n";
  for (const char* face : { "f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/3/1",
         "f -4 -3 -2", "f -4/-3/-1 2/-2/-1 -2/3/1", "  f\t1   2 3  ", "f 1 2 3 # a comment",
         "f 1 2 \\\n3", "f \\\n 1 \\\r\n 2 \\\n 3\\\n", "f 1/1/ 2// 3/" })
  {
    INFO(face);
    ObjReading reading(folder.Write("a.obj", head + face));
    REQUIRE(reading.Read());
    REQUIRE(reading.TriangleCount() == 1);
    CHECK(reading.Corners(0) == Ids{ 0, 1, 2 });
  }
}

TEST_CASE("ObjSceneReader: a convex polygon is a fan about its first corner", "[ObjSceneReader]")
{
  TestFolder folder;
  ObjReading reading(folder.Write("a.obj",
    "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 2 2 0\nv 0 2 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3 4 5\n"));
  REQUIRE(reading.Read());
  REQUIRE(reading.TriangleCount() == 4);
  CHECK(reading.Corners(1) == Ids{ 0, 1, 2 });
  CHECK(reading.Corners(2) == Ids{ 0, 2, 3 });
  CHECK(reading.Corners(3) == Ids{ 0, 3, 4 });
  CHECK(reading.MaterialOf(0).Name == "a");
  CHECK(reading.MaterialOf(3).Name == "b");
}

TEST_CASE("ObjSceneReader: indices are relative to the face or to the start", "[ObjSceneReader]")
{
  TestFolder folder;
  ObjReading reading(folder.Write("a.obj",
    "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 5 0 0\nv 6 0 0\nv 6 1 0\nf -3 -2 -1\n"));
  REQUIRE(reading.Read());
  REQUIRE(reading.TriangleCount() == 3);
  CHECK(reading.Corners(0) == Ids{ 0, 1, 2 }); // vertices may come after the face
  CHECK(reading.Corners(1) == Ids{ 0, 1, 2 });
  CHECK(reading.Corners(2) == Ids{ 3, 4, 5 });
}

TEST_CASE("ObjSceneReader: elements other than points and faces are ignored", "[ObjSceneReader]")
{
  TestFolder folder;
  ObjReading reading(folder.Write("a.obj",
    "\xEF\xBB\xBF# made by \"hand\" in C:\\temp\\\r\no thing one\r\ng a b\r\n\r\ns off\r\n"
    "v 0 0 0 0.5 0.5 0.5\r\nv 1 0 0 1.0\r\n   v 1 1 0 # corner\r\nl 1 2\r\np 1\r\nvn nan 0 1\r\n"
    "f 1 2 3"));
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty());
  CHECK(reading.TriangleCount() == 1);
  CHECK(reading.Scene()->GetNumberOfPoints() == 3);
}

TEST_CASE("ObjSceneReader: unused vertices are dropped", "[ObjSceneReader]")
{
  TestFolder folder;
  ObjReading reading(
    folder.Write("a.obj", "v 9 9 9\n" + ObjSquare + "v 8 8 8\nf 2 3 4\nf 2 4 5\n"));
  REQUIRE(reading.Read());
  CHECK(reading.Scene()->GetNumberOfPoints() == 4);
  CHECK(reading.Corners(1) == Ids{ 0, 2, 3 });
  CHECK(reading.Scene()->GetPoint(3)[1] == 1.0);
}

TEST_CASE("ObjSceneReader: y up is converted to z up", "[ObjSceneReader]")
{
  TestFolder folder;
  ObjReading reading(folder.Write("a.obj", "v 1 2 3\nv 4 5 6\nv 7 8 10\nf 1 2 3\n"));
  reading.Reader->SetUpAxisToY();
  REQUIRE(reading.Read());
  const double* p = reading.Scene()->GetPoint(0);
  CHECK(p[0] == 1.0);
  CHECK(p[1] == -3.0);
  CHECK(p[2] == 2.0);

  reading.Reader->SetUpAxisToZ();
  REQUIRE(reading.Read());
  CHECK(reading.Scene()->GetPoint(0)[1] == 2.0);
}

TEST_CASE("ObjSceneReader: lines across blocks, and lines longer than a block", "[ObjSceneReader]")
{
  TestFolder folder;
  constexpr int count = 150000;
  ObjReading strip(folder.Write("strip.obj", MakeLongFile(count)));
  REQUIRE(strip.Read());
  REQUIRE(strip.TriangleCount() == count - 2);
  for (int i = 0; i < count; i += 997)
  {
    REQUIRE(strip.Scene()->GetPoint(i)[0] == i / 2 + 0.5);
    REQUIRE(strip.Scene()->GetPoint(i)[2] == i % 7 + 0.25);
  }
  CHECK(strip.Corners(count - 3) == Ids{ count - 3, count - 2, count - 1 });

  std::string circle;
  std::string face = "f";
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * 3.141592653589793 * i / count;
    circle += "v " + std::to_string(1e6 * std::cos(angle)) + ' ' +
      std::to_string(1e6 * std::sin(angle)) + " 0\n";
    face += "  " + std::to_string(i + 1);
  }
  REQUIRE(face.size() > (1 << 20));
  ObjReading fan(folder.Write("circle.obj", circle + face));
  REQUIRE(fan.Read());
  CHECK(fan.TriangleCount() == count - 2);
}

TEST_CASE(
  "ObjSceneReader: reports progress, can be aborted, and can be repeated", "[ObjSceneReader]")
{
  TestFolder folder;
  ObjReading reading(folder.Write("a.obj", MakeLongFile(200000)));
  vtkNew<ProgressObserver> observer;
  reading.Reader->AddObserver(vtkCommand::ProgressEvent, observer);

  observer->AbortFrom = 0.4;
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("reading was aborted here; update again to read it"));
  CHECK(reading.TriangleCount() == 0);
  if (helios::ReportsAfterAbort > 0)
  {
    CHECK(observer->Values.back() == 1.0);
    observer->Values.pop_back();
  }
  CHECK(observer->Values.back() < 0.9);

  observer->AbortFrom = 2.0;
  observer->Values.clear();
  reading.Log->Clear();
  reading.Reader->SetAbortExecute(0);
  reading.Reader->Modified();
  REQUIRE(reading.Read());
  CHECK(reading.TriangleCount() == 199998);
  CHECK(observer->Values.size() > 4);
  CHECK(std::is_sorted(observer->Values.begin(), observer->Values.end()));
  CHECK(observer->Values.back() == 1.0);
}

TEST_CASE("ObjSceneReader: an unchanged reader does not execute again", "[ObjSceneReader]")
{
  TestFolder folder;
  const std::string path = folder.Write("a.obj", ObjSquare + "f 1 2 3\n");
  ObjReading reading(path);
  REQUIRE(reading.Read());
  std::filesystem::remove(path);
  CHECK(reading.Read());
  reading.Reader->SetUpAxisToY();
  CHECK_FALSE(reading.Read());
}

TEST_CASE("ObjSceneReader: properties are clamped and printed", "[ObjSceneReader]")
{
  vtkNew<vtkHeliosObjSceneReader> reader;
  CHECK(reader->GetUpAxis() == vtkHeliosObjSceneReader::UP_AXIS_Z);
  reader->SetUpAxis(7);
  CHECK(reader->GetUpAxis() == vtkHeliosObjSceneReader::UP_AXIS_Z);
  reader->SetFileName("a.obj");
  std::ostringstream text;
  reader->Print(text);
  CHECK(text.str().find("FileName: a.obj") != std::string::npos);
}
