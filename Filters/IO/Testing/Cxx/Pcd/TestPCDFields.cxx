// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The fields of PCL in PCD files, and headers in ASCII.
#include "heliosLasTesting.h"
#include "heliosPcdTesting.h"
#include "vtkHeliosPCDWriter.h"

#include <vtkUnsignedShortArray.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::AppendBytes;
using helios::PcdReading;

namespace
{

struct Files
{
  helios::TempFolder Folder;
  std::string Path = this->Folder / "a.pcd";
  PcdReading Reading{ this->Path };

  bool Read(const std::string& text)
  {
    helios::WriteFile(this->Path, text);
    return this->Reading.Read();
  }

  bool Write(vtkPolyData* cloud, double resolution = 0.0, int precision = vtkHeliosPCDWriter::Float)
  {
    vtkNew<vtkHeliosPCDWriter> writer;
    const auto log = helios::WatchErrors(writer);
    writer->SetFileName(this->Path.c_str());
    writer->SetResolution(resolution);
    writer->SetPrecision(precision);
    return writer->Open() && writer->Write(cloud) && writer->Close();
  }
};

/// One point: x y z and fields of a name, sizes, types and counts.
std::string MakeHeader(const std::string& name, const std::string& size, const std::string& type,
  const std::string& count, const std::string& data)
{
  return "VERSION 0.7\nFIELDS x y z " + name + "\nSIZE 4 4 4 " + size + "\nTYPE F F F " + type +
    "\nCOUNT 1 1 1 " + count + "\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA " + data + "\n";
}

std::string MakeBytes(std::uint32_t bits)
{
  std::string bytes;
  for (int axis = 0; axis < 3; ++axis)
  {
    AppendBytes(bytes, 1.0F);
  }
  AppendBytes(bytes, bits);
  return bytes;
}

void AddColors(vtkPolyData* cloud, double shade)
{
  vtkNew<vtkFloatArray> colors;
  colors->SetName(names::RGB);
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    colors->InsertNextTuple3(shade, 0.0, 1.0);
  }
  cloud->GetPointData()->AddArray(colors);
}

bool IsAscii(const std::string& path)
{
  const std::string text = helios::ReadText(path);
  const std::string head = text.substr(0, text.find("\nDATA"));
  return std::all_of(
    head.begin(), head.end(), [](char c) { return c == '\n' || (c >= ' ' && c < 127); });
}

} // namespace

TEST_CASE("PCDFields: colours packed as a float, and as an integer", "[PCDFields]")
{
  const std::string name = GENERATE("rgb", "rgba", "RGB");
  const std::string type = GENERATE("F", "U", "I");
  const auto alpha = GENERATE(0xFFU, 0U);
  Files files;
  REQUIRE(
    files.Read(MakeHeader(name, "4", type, "1", "binary") + MakeBytes(alpha << 24U | 0x00FF8001U)));
  CHECK(files.Reading.Log->Warnings.empty());
  vtkDataArray* rgb = files.Reading.Get(names::RGB);
  REQUIRE((rgb && rgb->GetNumberOfComponents() == 3 && rgb->GetDataType() == VTK_FLOAT));
  CHECK(rgb->GetComponent(0, 0) == 1.0);
  CHECK(rgb->GetComponent(0, 1) == Approx(128.0 / 255.0));
  CHECK(rgb->GetComponent(0, 2) == Approx(1.0 / 255.0));
  CHECK(files.Reading.Cloud()->GetPointData()->GetNumberOfArrays() == 1);
}

TEST_CASE("PCDFields: colours in text, and an alpha", "[PCDFields]")
{
  Files files;
  REQUIRE(files.Read(MakeHeader("rgb", "4", "F", "1", "ascii") + "1 2 3 3.57331108e-43\n"));
  CHECK(files.Reading.Get(names::RGB)->GetComponent(0, 2) == 1.0); // a denormal float
  REQUIRE(files.Read(MakeHeader("rgb", "4", "U", "1", "ascii") + "1 2 3 4294901760\n"));
  CHECK(files.Reading.Get(names::RGB)->GetComponent(0, 0) == 1.0);
  REQUIRE(
    files.Read(MakeHeader("rgb", "4", "F", "1", "ascii") + "1 2 3 nan\n")); // its bits are lost
  CHECK(std::isnan(files.Reading.Get(names::RGB)->GetComponent(0, 0)));
  CHECK(files.Reading.Log->HasWarning("RGB is not finite at 1 of 1 points, and is kept so"));
  REQUIRE(files.Read(MakeHeader("rgba", "4", "U", "1", "binary") + MakeBytes(0x7F0000FFU)));
  CHECK(files.Reading.Get(names::RGB)->GetComponent(0, 2) == 1.0);
  CHECK(files.Reading.Log->HasWarning("a.pcd: the alpha of 1 colours is dropped"));
}

TEST_CASE("PCDFields: upper case, further fields and own names", "[PCDFields]")
{
  Files files;
  REQUIRE(files.Read("VERSION 0.7\nFIELDS X Y Z INTENSITY RGB _ Label NORMAL_X NORMAL_Y NORMAL_Z "
                     "Curvature\nSIZE 4 4 4 4 4 1 4 4 4 4 4\nTYPE F F F F U U U F F F F\nCOUNT 1 1 "
                     "1 1 1 2 1 1 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n"
                     "1 2 3 0.5 255 7 7 9 0 0 1 0.25\n"));
  CHECK(files.Reading.Cloud()->GetPoint(0)[2] == 3.0);
  CHECK(files.Reading.Get(names::Intensity)->GetTuple1(0) == 0.5);
  CHECK(files.Reading.Get(names::RGB)->GetComponent(0, 2) == 1.0);
  CHECK(files.Reading.Get(names::ClassificationIds)->GetTuple1(0) == 9);
  CHECK(files.Reading.Get(names::Normals)->GetComponent(0, 2) == 1.0);
  CHECK(files.Reading.Get("Curvature")->GetTuple1(0) == 0.25);
  CHECK(files.Reading.Cloud()->GetPointData()->GetNumberOfArrays() == 5);

  // Another name in upper case is an array beside the one of PCL, and so are other shapes of it.
  REQUIRE(files.Read(
    MakeHeader("X intensity Intensity", "4 4 2", "F F U", "1 1 1", "ascii") + "1 2 3 7 0.5 9\n"));
  CHECK(files.Reading.Cloud()->GetPoint(0)[0] == 1.0);
  CHECK(files.Reading.Get("X")->GetTuple1(0) == 7);
  CHECK(files.Reading.Get("intensity")->GetTuple1(0) == 0.5);
  CHECK(files.Reading.Get(names::Intensity)->GetTuple1(0) == 9);
  REQUIRE(files.Read(MakeHeader("RGB rgb", "4 4", "F U", "3 1", "ascii") + "1 2 3 .1 .2 .3 255\n"));
  CHECK(files.Reading.Get(names::RGB)->GetComponent(0, 1) == Approx(0.2)); // in full, not packed
  CHECK(files.Reading.Cloud()->GetPointData()->GetNumberOfArrays() == 1);
  REQUIRE(
    files.Read(MakeHeader("rgb rgba", "4 4", "U U", "1 1", "ascii") + "1 2 3 255 16711680\n"));
  CHECK(files.Reading.Get(names::RGB)->GetComponent(0, 2) == 1.0);
  CHECK(files.Reading.Get("rgba")->GetTuple1(0) == 16711680);
}

TEST_CASE(
  "PCDFields: zeros after the points are padding, a viewpoint is not applied", "[PCDFields]")
{
  Files files;
  const std::string text = MakeHeader("rgb", "4", "F", "1", "binary") + MakeBytes(0U);
  REQUIRE(files.Read(text + std::string(4096 - text.size(), '\0')));
  CHECK(files.Reading.Log->Warnings.empty());
  REQUIRE(files.Read(text + std::string(100, '\0') + "x"));
  CHECK(files.Reading.Log->HasWarning("101 bytes after the last point are ignored; is POINTS"));
  REQUIRE(files.Read(text + std::string(1 << 20, '\0')));
  CHECK(files.Reading.Log->HasWarning("bytes after the last point are ignored; is POINTS right?"));
  REQUIRE(files.Read(helios::Replace(text, "POINTS", "VIEWPOINT 9 0 0 1 0 0 0\nPOINTS")));
  CHECK(files.Reading.Cloud()->GetPoint(0)[0] == 1.0);
  CHECK(files.Reading.Log->HasWarning("a.pcd: its VIEWPOINT is not applied, as in PCL"));
}

TEST_CASE("PCDFields: UTF-16 is an error, old line ends are read", "[PCDFields]")
{
  Files files;
  CHECK_FALSE(files.Read(std::string("\xFF\xFEV\0E\0", 6)));
  CHECK(files.Reading.Log->HasError("a.pcd: is text of UTF-16 or UTF-32; save it as UTF-8"));
  std::string text = helios::AsciiPcd;
  text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
  std::replace(text.begin(), text.end(), '\n', '\r');
  REQUIRE(files.Read(text));
  CHECK(files.Reading.CountPoints() == 3);
  CHECK_FALSE(files.Read(helios::Replace(text, "-2e1", "two")));
  CHECK(files.Reading.Log->HasError("a.pcd:13: \"two\" is not a number of type F"));
}

TEST_CASE("PCDFields: the header is ASCII, and gives back the same system and names", "[PCDFields]")
{
  Files files;
  const std::string system = "PROJCS[\"Zone 6\xC2\xB0"
                             "E \xF0\x9F\x9B\xB0 a\\u00b0b\",\"\xE2\x82\xAC\"]";
  const auto cloud = helios::MakeEchoes(5);
  helios::SetCrs(cloud, system);
  helios::AddColumn<vtkIntArray>(
    cloud->GetPointData(), "H\xC3\xB6he m", 5, [](vtkIdType i) { return i; });
  REQUIRE(files.Write(cloud));
  CHECK(IsAscii(files.Path));
  CHECK(helios::ReadText(files.Path).find("Zone 6\\u00b0E \\ud83d\\udef0 a\\u005cu00b0b") !=
    std::string::npos);
  REQUIRE(files.Reading.Read());
  CHECK(files.Reading.Cloud()->GetFieldData()->GetAbstractArray(names::CRS)->GetVariantValue(0) ==
    vtkVariant(system));
  REQUIRE(files.Reading.Get("H\xC3\xB6he_m"));
  CHECK(files.Reading.Get("H\xC3\xB6he_m")->GetTuple1(3) == 3);

  helios::SetCrs(cloud,
    "a\xB0"
    "b"); // Latin-1, not UTF-8
  REQUIRE(files.Write(cloud));
  CHECK(IsAscii(files.Path));
  REQUIRE(files.Reading.Read());
  CHECK(files.Reading.Cloud()->GetFieldData()->GetAbstractArray(names::CRS)->GetVariantValue(0) ==
    vtkVariant("a\xC2\xB0"
               "b"));
}

TEST_CASE("PCDFields: a resolution decides on the type of coordinates", "[PCDFields]")
{
  const auto cloud = helios::MakeLasEchoes(2000); // 2 km along y
  Files files;
  REQUIRE(files.Write(cloud, 1e-3));
  CHECK(helios::ReadText(files.Path).find("\nSIZE 4 4 4 ") != std::string::npos);
  REQUIRE(files.Write(cloud, 1e-6));
  const std::string text = helios::ReadText(files.Path);
  CHECK(text.find("\nSIZE 8 8 8 ") != std::string::npos);
  CHECK(text.find("origin") == std::string::npos);
  REQUIRE(files.Reading.Read());
  CHECK(helios::CountWrong(
          files.Reading.Cloud()->GetPoints()->GetData(), cloud->GetPoints()->GetData()) == 0);
  CHECK(files.Reading.Get(names::Amplitude)->GetDataType() == VTK_FLOAT);

  vtkNew<vtkHeliosPCDWriter> writer; // a later block that is farther
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(files.Path.c_str());
  writer->SetResolution(1e-3);
  REQUIRE((writer->Open() && writer->Write(cloud)));
  const auto far = helios::MakeLasEchoes(2000);
  far->GetPoints()->SetPoint(0, 1e7 + 0.123, 0.0, 0.0);
  REQUIRE((writer->Write(far) && writer->Close()));
  CHECK(log->HasWarning("off, more than half of the Resolution 0.001, which the first block kept"));
}

TEST_CASE("PCDFields: intensities that are not of 16 bits are PCL's, too", "[PCDFields]")
{
  Files files;
  const auto cloud = helios::MakeEchoes(5);
  cloud->GetPointData()->RemoveArray(names::Amplitude);
  helios::AddColumn<vtkDoubleArray>(cloud->GetPointData(), "intensity", 5,
    [](vtkIdType i) { return -0.5 * static_cast<double>(i); });
  REQUIRE(files.Write(cloud));
  REQUIRE(files.Reading.Read());
  CHECK(files.Reading.Get(names::Intensity)->GetDataType() == VTK_FLOAT);
  CHECK(files.Reading.Get(names::Intensity)->GetTuple1(3) == -1.5);
}

TEST_CASE("PCDFields: colours finer than 8 bits are a further field", "[PCDFields]")
{
  Files files;
  const auto cloud = helios::MakeEchoes(5);
  AddColors(cloud, 77.0 / 255.0);
  REQUIRE(files.Write(cloud));
  CHECK(helios::ReadText(files.Path).find(" RGB") == std::string::npos);
  REQUIRE(files.Reading.Read());
  CHECK(files.Reading.Get(names::RGB)->GetComponent(4, 0) == Approx(77.0 / 255.0));

  const auto fine = helios::MakeEchoes(5);
  AddColors(fine, 0.12345);
  REQUIRE(files.Write(fine));
  REQUIRE(files.Reading.Read());
  CHECK(files.Reading.Get(names::RGB)->GetComponent(4, 0) == Approx(0.12345).margin(1e-7));
  CHECK(helios::ReadText(files.Path).find("FIELDS x y z ") != std::string::npos);

  vtkNew<vtkHeliosPCDWriter> writer; // a later block with finer colours
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(files.Path.c_str());
  REQUIRE((writer->Open() && writer->Write(cloud) && writer->Write(fine) && writer->Close()));
  CHECK(
    log->HasWarning("colours are stored in 8 bits, as those of the first block; set Precision"));
  REQUIRE(files.Reading.Read());
  CHECK(files.Reading.Get(names::RGB)->GetComponent(9, 0) == Approx(31.0 / 255.0));

  const auto words = helios::MakeEchoes(5); // integers of 16 bits
  vtkNew<vtkUnsignedShortArray> array;
  array->SetName(names::RGB);
  array->SetNumberOfComponents(3);
  for (int i = 0; i < 5; ++i)
  {
    array->InsertNextTuple3(65535, 257, 0);
  }
  words->GetPointData()->AddArray(array);
  REQUIRE(files.Write(words));
  REQUIRE(files.Reading.Read());
  CHECK(files.Reading.Get(names::RGB)->GetComponent(2, 0) == 1.0);
  CHECK(files.Reading.Get(names::RGB)->GetComponent(2, 1) == Approx(1.0 / 255.0));
}
