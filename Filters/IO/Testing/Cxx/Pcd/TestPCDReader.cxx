// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reading PCD files, and errors with their position and a remedy.
#include "heliosPcdTesting.h"

#include <vtkCallbackCommand.h>
#include <vtkStringArray.h>

#include <catch2/catch.hpp>

#include <lzf.h>

#include <array>

namespace names = vtkHeliosArrayNames;
using helios::AsciiPcd;
using helios::PcdReading;
using helios::Replace;

namespace
{

/// The header of three points with x y z (float), 3 bytes of padding and a 64-bit integer.
std::string MakeHeader(const std::string& data)
{
  return "VERSION 0.7\nFIELDS x y z _ id\nSIZE 4 4 4 1 8\nTYPE F F F U U\nCOUNT 1 1 1 3 1\n"
         "WIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA " +
    data + "\n";
}

std::string MakeRows()
{
  std::string rows;
  for (int i = 0; i < 3; ++i)
  {
    helios::AppendBytes(rows, 1.0F + static_cast<float>(i));
    helios::AppendBytes(rows, 2.5F);
    helios::AppendBytes(rows, -3.0F);
    rows += "pad";
    helios::AppendBytes(rows, ~std::uint64_t(0) - static_cast<std::uint64_t>(i));
  }
  return rows;
}

/// Writes the data field by field.
std::string MakeFields()
{
  const std::string rows = MakeRows();
  std::string fields;
  std::size_t from = 0;
  for (const std::size_t size : { 4, 4, 4, 3, 8 })
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      fields += rows.substr(23 * i + from, size);
    }
    from += size;
  }
  return fields;
}

std::string Compress(const std::string& data)
{
  std::string packed(2 * data.size() + 16, '\0');
  const unsigned int size = lzf_compress(data.data(), static_cast<unsigned int>(data.size()),
    packed.data(), static_cast<unsigned int>(packed.size()));
  REQUIRE(size > 0);
  std::string bytes;
  helios::AppendBytes(bytes, size);
  helios::AppendBytes(bytes, static_cast<std::uint32_t>(data.size()));
  return bytes + packed.substr(0, size);
}

struct FileReading : PcdReading
{
  helios::TempFolder Folder;

  FileReading()
    : PcdReading("")
  {
    this->Reader->SetFileName(this->Path().c_str());
  }
  std::string Path() const { return this->Folder / "a.pcd"; }
  bool ReadText(const std::string& text)
  {
    helios::WriteFile(this->Path(), text);
    return this->Read();
  }
  /// Whether the error is path + place + ": " + part.
  bool FailsWith(const std::string& text, const std::string& place, const std::string& part)
  {
    const bool isGood = this->ReadText(text);
    UNSCOPED_INFO(this->Log->Errors);
    return !isGood && this->CountPoints() == 0 &&
      this->Log->HasError(this->Path() + place + ": " + part);
  }
};

void CheckThree(FileReading& reading)
{
  REQUIRE(reading.CountPoints() == 3);
  CHECK(reading.Cloud()->GetPoint(2)[0] == 3.0);
  CHECK(reading.Cloud()->GetPoint(0)[1] == 2.5);
  CHECK(reading.Cloud()->GetPoint(1)[2] == -3.0);
  CHECK(reading.Cloud()->GetPointData()->GetNumberOfArrays() == 1); // no padding
  REQUIRE(reading.Get("id")->GetDataType() == VTK_TYPE_UINT64);
  CHECK(reading.Get("id")->GetVariantValue(1).ToTypeUInt64() == ~std::uint64_t(0) - 1);
}

} // namespace

TEST_CASE("PCDReader: ascii with all digits, types and counts", "[PCDReader]")
{
  FileReading reading;
  REQUIRE(reading.ReadText(AsciiPcd));
  CHECK(reading.Log->HasWarning("a.pcd: 1 of 4 points are not finite: dropped"));
  CHECK(reading.Log->HasWarning("a.pcd: Intensity is not finite at 1 of 3 points, and is kept so"));
  REQUIRE(reading.CountPoints() == 3);
  CHECK(reading.Cloud()->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(reading.Cloud()->GetPoint(1)[1] == -20.0);
  CHECK(reading.Cloud()->GetPoint(1)[2] == 476000.123456789);
  vtkDataArray* intensity = reading.Get(names::Intensity); // has unknown units
  REQUIRE((intensity && intensity->GetDataType() == VTK_FLOAT));
  CHECK(intensity->GetTuple1(0) == 0.5);
  CHECK(std::isnan(intensity->GetTuple1(1)));
  vtkDataArray* label = reading.Get("label");
  REQUIRE((label && label->GetDataType() == VTK_UNSIGNED_SHORT));
  CHECK(label->GetNumberOfComponents() == 2);
  CHECK(label->GetComponent(1, 0) == 65535);
  CHECK(label->GetComponent(2, 1) == 3);
  CHECK(label->GetNumberOfTuples() == 3);
}

TEST_CASE("PCDReader: binary and compressed", "[PCDReader]")
{
  FileReading reading;
  REQUIRE(reading.ReadText(MakeHeader("binary") + MakeRows()));
  CheckThree(reading);
  REQUIRE(reading.ReadText(MakeHeader("binary_compressed") + Compress(MakeFields())));
  CheckThree(reading);
  CHECK(reading.Log->Warnings.empty());
  REQUIRE(reading.ReadText(MakeHeader("binary") + MakeRows() + "more"));
  CheckThree(reading);
  CHECK(reading.Log->HasWarning("4 bytes after the last point are ignored; is POINTS right?"));
  const std::string none =
    Replace(Replace(MakeHeader("binary"), "WIDTH 3", "WIDTH 0"), "POINTS 3", "POINTS 0");
  REQUIRE(reading.ReadText(none));
  CHECK(reading.CountPoints() == 0);
}

TEST_CASE("PCDReader: normals, old names, no COUNT and WIDTH", "[PCDReader]")
{
  FileReading reading;
  REQUIRE(reading.ReadText("# a comment\n\nVERSION 0.5\nCOLUMNS x y z normal_x normal_y normal_z\n"
                           "SIZE 8 8 8 4 4 4\nTYPE F F F F F F\nPOINTS 1\nDATA ascii\n"
                           "1 2 3 0.6 0 0.8\n\n"));
  REQUIRE(reading.CountPoints() == 1);
  vtkDataArray* normals = reading.Cloud()->GetPointData()->GetNormals();
  REQUIRE(normals);
  CHECK(normals == reading.Get(names::Normals));
  CHECK(normals->GetComponent(0, 2) == Approx(0.8));
}

TEST_CASE("PCDReader: comments of the writer", "[PCDReader]")
{
  FileReading reading;
  const std::string marks = "# vtkHelios origin: 476000 5473000 100\n# vtkHelios GpsEpoch: 1e9\n"
                            "# vtkHelios CRS: EPSG:25832\n# vtkHelios intensity: Amplitude [W]\n";
  REQUIRE(reading.ReadText(marks + AsciiPcd));
  CHECK(reading.Cloud()->GetPoint(0)[1] == 5473002.0);
  CHECK(reading.Get(names::Amplitude)->GetTuple1(0) == 0.5);
  CHECK(reading.Get(names::Intensity) == nullptr);
  CHECK(reading.Cloud()->GetFieldData()->GetArray(names::GpsEpoch)->GetTuple1(0) == 1e9);
  auto* crs =
    vtkStringArray::SafeDownCast(reading.Cloud()->GetFieldData()->GetAbstractArray(names::CRS));
  REQUIRE(crs);
  CHECK(crs->GetValue(0) == "EPSG:25832");
  CHECK(reading.FailsWith(Replace(marks, "476000", "east") + AsciiPcd, ":1",
    "the origin is not three numbers; correct it: points are relative to it"));
  CHECK(reading.FailsWith(Replace(marks, "1e9", "") + AsciiPcd, ":2",
    "the GpsEpoch is not a number; correct or remove it"));
}

TEST_CASE("PCDReader: damaged headers are errors", "[PCDReader]")
{
  struct Fault
  {
    const char* From;
    const char* To;
    const char* Place;
    const char* Part;
  };
  const Fault faults[] = {
    { "VERSION .7", "VERSION 0.8", ":2", "VERSION is not 0.7, 0.6 or 0.5; save the file as PCD" },
    { "FIELDS x y z", "FIELDS x y e", ":11", "FIELDS has no z; points need x, y and z" },
    { "FIELDS x y z", "FIELDS x y y", ":3", "FIELDS has \"y\" twice; rename one" },
    { "FIELDS x y z intensity label\n", "FIELDS\n", ":3", "FIELDS is empty" },
    { "FIELDS x y z intensity label\n", "", ":3", "SIZE has 5 entries for 0 FIELDS" },
    { "SIZE 4 4 4 4 2", "SIZE 4 4 4", ":4", "SIZE has 3 entries for 5 FIELDS; give one for each" },
    { "SIZE 4 4 4 4 2", "SIZE 4 4 4 4 3", ":5", "the field \"label\" is of type U and size 3" },
    { "SIZE 4 4 4 4 2", "SIZE 4 4 4 2 2", ":5", "the field \"intensity\" is of type F and size 2" },
    { "SIZE 4 4 4 4 2", "SIZE 4 4 4 4 x", ":4",
      "SIZE of the field \"label\" is \"x\"; give a whole" },
    { "SIZE 4 4 4 4 2\n", "", ":10", "the header has no line SIZE; it must describe a point" },
    { "TYPE F F F F U", "TYPE F F F F D", ":5", "TYPE of the field \"label\" is \"D\"; types are" },
    { "TYPE F F F F U", "TYPE I F F F U", ":11", "x has TYPE I and COUNT 1; x, y and z are one" },
    { "COUNT 1 1 1 1 2", "COUNT 2 1 1 1 1", ":11", "x has TYPE F and COUNT 2; x, y and z are one" },
    { "COUNT 1 1 1 1 2", "COUNT 1 1 1 1 0", ":6", "COUNT of the field \"label\" is \"0\"" },
    { "WIDTH 2", "WIDTH 3", ":11",
      "POINTS is 4, but WIDTH times HEIGHT is 6; correct one of them" },
    { "WIDTH 2", "WIDTH -2", ":7", "WIDTH is not one whole number of at most 2^40; correct it" },
    { "WIDTH 2\n", "WIDTH 2\nWIDTH 2\n", ":8", "WIDTH is given twice; remove one" },
    { "HEIGHT 2", "HEIGHT 1099511627776", ":11",
      "WIDTH 2 times HEIGHT 1099511627776 gives too many" },
    { "VIEWPOINT 0", "VIEWPOINT", ":9", "VIEWPOINT is not seven numbers" },
    { "VIEWPOINT 0", "VIEWPONT 0", ":9", "unknown entry \"VIEWPONT\"; a PCD header has VERSION" },
    { "DATA ascii", "DATA utf8", ":11", "DATA is \"utf8\"; expected one of ascii, binary," },
    { "DATA ascii", "", ":12", "unknown entry \"1\"" },
  };
  FileReading reading;
  for (const Fault& fault : faults)
  {
    INFO(fault.To);
    CHECK(reading.FailsWith(Replace(AsciiPcd, fault.From, fault.To), fault.Place, fault.Part));
  }
  CHECK(reading.FailsWith(
    "VERSION 0.7\n", ":1", "the file ends before the line DATA; it is not a PCD"));
  CHECK(reading.FailsWith("", ":0", "the file ends before the line DATA"));
  CHECK(reading.FailsWith("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nDATA ascii\n1 2 3\n", ":4",
    "the header has neither WIDTH nor POINTS; it must give the number of points"));
}

TEST_CASE("PCDReader: bad lines are errors", "[PCDReader]")
{
  FileReading reading;
  CHECK(reading.FailsWith(Replace(AsciiPcd, "0.5 7 8", "0.5 7"), ":12",
    "the point has 5 numbers, but FIELDS and COUNT make 6; complete the line"));
  CHECK(reading.FailsWith(Replace(AsciiPcd, "0.5 7 8", "0.5 7 8 9"), ":12",
    "the point has more than the 6 numbers that FIELDS and COUNT make"));
  CHECK(reading.FailsWith(Replace(AsciiPcd, "0.5 7 8", "0,5 7 8"), ":12",
    "\"0,5\" is not a number of type F and size 4, as the field \"intensity\" has; write a decimal "
    "point, and blanks between numbers"));
  CHECK(reading.FailsWith(Replace(AsciiPcd, "65535", "65536"), ":13",
    "\"65536\" is not a number of type U and size 2, as the field \"label\" has"));
  CHECK(reading.FailsWith(Replace(AsciiPcd, "\n4 5 6 1 2 3", "\n"), ":15",
    "the file ends after 3 of 4 points; it is cut off, or POINTS is wrong"));
  CHECK(reading.FailsWith(
    AsciiPcd + "\n7 8 9 1 2 3", ":16", "a point more than the 4 of POINTS; correct POINTS"));
}

TEST_CASE("PCDReader: truncated or damaged data are errors", "[PCDReader]")
{
  FileReading reading;
  const std::string binary = MakeHeader("binary") + MakeRows();
  CHECK(reading.FailsWith(binary.substr(0, binary.size() - 1), "",
    "has 68 bytes of data, but its 3 points need 69; it is cut off, or POINTS is wrong"));
  const std::string many =
    Replace(Replace(binary, "WIDTH 3", "WIDTH 1099511627776"), "POINTS 3", "POINTS 1099511627776");
  CHECK(reading.FailsWith(many, "", "has 69 bytes of data, but its 1099511627776 points need"));
  const std::string manyLines =
    Replace(Replace(AsciiPcd, "WIDTH 2", "WIDTH 2000000"), "POINTS 4", "POINTS 4000000");
  CHECK(reading.FailsWith(manyLines, "", "has 78 bytes of data, but its 4000000 points need"));

  const std::string header = MakeHeader("binary_compressed");
  const std::string packed = Compress(MakeFields());
  CHECK(reading.FailsWith(
    header + packed.substr(0, packed.size() - 1), "", "the compressed data need"));
  CHECK(reading.FailsWith(header + "abc", "", "the compressed data need 0 bytes and two sizes"));
  CHECK(reading.FailsWith(header + Compress(MakeFields() + "x"), "",
    "the data unpack to 70 bytes, but 3 points need 69; FIELDS, SIZE, COUNT or POINTS is wrong"));
  std::string damaged = packed;
  damaged[8] = '\xff'; // a reference to before the start
  CHECK(reading.FailsWith(
    header + damaged, "", "the compressed data are damaged; get or write the file again"));
}

TEST_CASE("PCDReader: no file, a folder, an abort", "[PCDReader]")
{
  FileReading reading;
  reading.Reader->SetFileName(nullptr);
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("FileName is not set; give the PCD file with SetFileName"));
  reading.Reader->SetFileName((reading.Folder / "none.pcd").c_str());
  CHECK_FALSE(reading.Read());
  CHECK(
    reading.Log->HasError("none.pcd: cannot be read: No such file or directory; check the file"));
  reading.Reader->SetFileName((reading.Folder / "").c_str());
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("cannot be read: it is a folder; give the name of a file"));

  reading.Reader->SetFileName(reading.Path().c_str());
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  reading.Reader->AddObserver(vtkCommand::ProgressEvent, abort);
  CHECK_FALSE(reading.ReadText(MakeHeader("binary") + MakeRows()));
  CHECK(reading.Log->HasError("reading was aborted at point 3; update again to read it"));
}
