// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Points from text: all column formats, errors and pieces.
#include "heliosXyzTesting.h"

#include <catch2/catch.hpp>

#include <vtkCallbackCommand.h>
#include <vtkFloatArray.h>

#include <random>
#include <sstream>

namespace names = vtkHeliosArrayNames;
using helios::XyzReading;
using Triple = std::array<double, 3>;

TEST_CASE("XyzReader: coordinates are rounded to the nearest double", "[XyzReader]")
{
  XyzReading reading("476000.123 5473000.456 110.001\n+1 -2.5e3 .5\n0 1e-310 -0\n");
  REQUIRE(reading.Read());
  REQUIRE(reading.CountPoints() == 3);
  CHECK(reading.Cloud()->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(reading.GetPoint(0) == Triple{ 476000.123, 5473000.456, 110.001 });
  CHECK(reading.GetPoint(1) == Triple{ 1.0, -2500.0, 0.5 });
  CHECK(reading.GetPoint(2) == Triple{ 0.0, 1e-310, 0.0 });
  CHECK(reading.Cloud()->GetPointData()->GetNumberOfArrays() == 0); // only requested arrays
  CHECK(reading.Cloud()->GetNumberOfCells() == 0);
}

TEST_CASE("XyzReader: line ends, blanks, comments", "[XyzReader]")
{
  XyzReading reading;
  for (const char* text : { "1 2 3\n4 5 6\n", "1 2 3\n4 5 6", "1 2 3\r\n4 5 6\r\n",
         ("\xEF\xBB\xBF"
          "1 2 3\n4 5 6\n"),
         "1 2 3\r4 5 6\r", "2\n1 2 3\n4 5 6\n", "X\tY\tZ\n1\t2\t3\n4\t5\t6",
         "\n\n1\t2  3\t\n \t \n  4 5\t\t6 \n\n",
         "//X Y Z\n# a comment\n1 2 3 # here, too\n4 5 6 // and here\n  //end",
         "1 2 3 7 8 anything, at all\n4 5 6 #\n", "\xEF\xBB\xBF// c\r\n1 2 3\r\n4 5 6\r\n\r\n" })
  {
    INFO(text);
    reading.Set(text);
    REQUIRE(reading.Read());
    CHECK(reading.Log->Warnings.empty());
    REQUIRE(reading.CountPoints() == 2);
    CHECK(reading.GetPoint(0) == Triple{ 1, 2, 3 });
    CHECK(reading.GetPoint(1) == Triple{ 4, 5, 6 });
  }
}

TEST_CASE("XyzReader: separators", "[XyzReader]")
{
  XyzReading reading;
  const std::pair<const char*, const char*> cases[] = { { ",", "1,2,3\n4 , 5,\t6,\n" },
    { ";", "1;2;3;x y;z\n4;5;6\n" }, { ",;", "1,2;3\n4;5;6\n" }, { ", ", "1, 2, 3\n4 5,6\n" },
    { " ", "1\t2 3\n4 5 6\n" }, { "|\t", "1|2\t3\n4 5 6\n" } };
  for (const auto& [separators, text] : cases)
  {
    INFO(separators << ": " << text);
    reading.Reader->SetSeparators(separators);
    reading.Set(text);
    REQUIRE(reading.Read());
    REQUIRE(reading.CountPoints() == 2);
    CHECK(reading.GetPoint(0) == Triple{ 1, 2, 3 });
    CHECK(reading.GetPoint(1) == Triple{ 4, 5, 6 });
  }
  reading.Reader->SetSeparators(",");
  CHECK(reading.FailsWith("1,,3\n", "a.xyz:1: column 1 is empty"));
  CHECK(reading.FailsWith(",1,2,3\n", "a.xyz:1: column 0 is empty"));
  CHECK(reading.FailsWith("1 2,3,4\n", "a.xyz:1: \"1 2\" in column 0 is not a number"));
  for (const char* separators : { "e", "1", "-", ".", "#", "/", "\n" })
  {
    reading.Reader->SetSeparators(separators);
    CHECK(reading.FailsWith("1 2 3\n", "give characters other than letters"));
  }
}

TEST_CASE("XyzReader: normals and colours in any columns", "[XyzReader]")
{
  XyzReading reading("1 2 3 0 0.6 0.8 255 0 51\n4 5 6 0 0 -2 128 64 32\n");
  reading.Reader->ReadNormalsOn();
  reading.Reader->ReadColorsOn();
  REQUIRE(reading.Read());
  CHECK(reading.Cloud()->GetPointData()->GetNormals()->GetName() == std::string(names::Normals));
  CHECK(reading.GetTriple(names::Normals, 0) == Triple{ 0.0, 0.6, 0.8 });
  CHECK(reading.GetTriple(names::Normals, 1) == Triple{ 0, 0, -2 }); // value in the file
  CHECK(reading.GetTriple(names::RGB, 0) == Triple{ 1.0, 0.0, 51.0f / 255.0f });

  reading.Reader->SetNormalXIndex(5);
  reading.Reader->SetNormalYIndex(4);
  reading.Reader->SetNormalZIndex(4);
  reading.Reader->SetRgbRIndex(3);
  reading.Reader->SetRgbGIndex(3);
  reading.Reader->SetRgbBIndex(3);
  reading.Reader->SetMaximumColorValue(65535.0);
  reading.Set("1 2 3 65535 0.25 1 text\n");
  REQUIRE(reading.Read());
  CHECK(reading.GetTriple(names::Normals, 0) == Triple{ 1.0, 0.25, 0.25 });
  CHECK(reading.GetTriple(names::RGB, 0) == Triple{ 1.0, 1.0, 1.0 });
}

TEST_CASE("XyzReader: bad rows are errors", "[XyzReader]")
{
  XyzReading reading;
  CHECK(reading.FailsWith("1 2 3\n1,5 2 3\n", "a.xyz:2: \"1,5\" in column 0 is not a number"));
  CHECK(reading.FailsWith("1 2 0x3\n", "a.xyz:1: \"0x3\" in column 2"));
  CHECK(reading.FailsWith("1 2 3a\n", "a.xyz:1: \"3a\" in column 2"));
  CHECK(reading.FailsWith("1 2 +-3\n", "a.xyz:1: \"+-3\" in column 2"));
  CHECK(reading.FailsWith("1 2 1e999\n", "a.xyz:1: \"1e999\" in column 2"));
  CHECK(reading.FailsWith("# c\n\n1 2 nan\n", "a.xyz:3: \"nan\" in column 2 is not finite"));
  CHECK(reading.FailsWith("1 -inf 3\n", "a.xyz:1: \"-inf\" in column 1 is not finite"));
  CHECK(reading.FailsWith("1 2 3\n1 2\n", "a.xyz:2: the row has 2 columns"));
  CHECK(reading.FailsWith("1 2 # 3\n", "a.xyz:1: the row has 2 columns"));
  CHECK(reading.FailsWith("7\n", "a.xyz:1: the row has 1 column, but"));
  CHECK(reading.FailsWith(std::string(3 << 20, '1'), "a.xyz:1: the line is longer than 1 MiB"));
  CHECK(reading.FailsWith(std::string("1 2 3\0\n", 7), "a.xyz:1: \"3?\" in column 2"));
  reading.Reader->ReadNormalsOn();
  CHECK(reading.FailsWith("1 2 3 4 5\n", "up to 5 from 0 (x y z in 0 1 2, normals in 3 4 5)"));
  CHECK(reading.FailsWith("1 2 3 0 0 nan\n", "\"nan\" in column 5 is not finite"));
  reading.Reader->ReadNormalsOff();
  reading.Reader->ReadColorsOn();
  CHECK(reading.FailsWith("1 2 3 0 0 1 0 256 0\n",
    "a.xyz:1: the colour in column 7 is not within 0 and MaximumColorValue, 255"));
  CHECK(reading.FailsWith("1 2 3 0 0 1 -1 0 0\n", "the colour in column 6"));
}

TEST_CASE("XyzReader: a header is skipped with a warning", "[XyzReader]")
{
  XyzReading reading;
  for (const char* text : { "a b c\n1 2 3\n", "# c\n\nX Y Z Nx\r\n1 2 3\r\n" })
  {
    reading.Set(text);
    REQUIRE(reading.Read());
    CHECK(reading.CountPoints() == 1);
    CHECK(reading.Log->HasWarning("has no numbers, and no names x, y and z of 3 columns; it is"));
  }
  reading.Reader->SetSeparators(",");
  reading.Set("\"e\",\"n\",\"h\"\n1,2,3\n");
  REQUIRE(reading.Read());
  CHECK(reading.Log->HasWarning("a.xyz:1: "));
  reading.Log->Clear();
  REQUIRE(reading.Read(0, 2));
  CHECK(reading.Log->Warnings.empty()); // reported once
  reading.Reader->SetSeparators(" ");
  CHECK(reading.FailsWith("x y z\na b c\n1 2 3\n", "a.xyz:2: \"a\" in column 0 is not a number"));
  CHECK(reading.FailsWith(
    "# .PCD v.7\nVERSION .7\nFIELDS x y z\n", "a.xyz:2: \"VERSION\" in column 0 is not a number"));
  CHECK(reading.FailsWith("1 2 3\nx y z\n", "begin header lines with # or //"));
}

TEST_CASE("XyzReader: damaged files are errors", "[XyzReader]")
{
  XyzReading reading;
  reading.Read();
  CHECK(reading.Log->HasError("FileName is not set"));
  CHECK(reading.FailsWith("", "a.xyz: has no points"));
  CHECK(reading.FailsWith("# nothing\n\n", "a.xyz: has no points"));
  reading.Set("1 2 3\n");
  reading.Reader->AddFileName(reading.Write("b.xyz", "").c_str());
  CHECK(!reading.Read());
  CHECK(reading.Log->HasError("b.xyz: has no points"));
  reading.Log->Clear();
  reading.Reader->SetFileName((reading.Folder / "none.xyz").c_str());
  CHECK(!reading.Read());
  CHECK(reading.Log->HasError("none.xyz: cannot be read"));
  reading.Log->Clear();
  reading.Reader->SetFileName((reading.Folder / ".").c_str());
  CHECK(!reading.Read());
  CHECK(reading.Log->HasError("it is a folder"));
  for (const double maximum : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    reading.Reader->SetMaximumColorValue(maximum);
    CHECK(reading.FailsWith("1 2 3\n", "MaximumColorValue is "));
  }
}

TEST_CASE("XyzReader: file names", "[XyzReader]")
{
  vtkNew<vtkHeliosXyzReader> reader;
  CHECK(reader->GetFileName() == nullptr);
  reader->SetFileName("a");
  reader->AddFileName("b");
  CHECK(reader->GetNumberOfFileNames() == 2);
  CHECK(reader->GetFileName(1) == std::string("b"));
  const vtkMTimeType before = reader->GetMTime();
  reader->SetFileName("c");
  CHECK(reader->GetMTime() > before);
  const vtkMTimeType same = reader->GetMTime();
  reader->SetFileName("c");
  CHECK(reader->GetMTime() == same);
  reader->SetFileName(nullptr);
  CHECK(reader->GetNumberOfFileNames() == 0);
}

TEST_CASE("XyzReader: pieces contain each row once", "[XyzReader]")
{
  std::mt19937 random(11);
  std::ostringstream texts[3];
  int count = 0;
  for (std::ostringstream& text : texts)
  {
    text << (count == 0 ? "\xEF\xBB\xBF" : "") << "// a header of some length\n";
    for (int i = 0; i < 150; ++i)
    {
      text << count++ << ' ' << random() << " -" << random() % 10 << (i % 3 ? "\n" : "\r\n");
      text << (i % 10 ? "" : "\n") << (i % 17 ? "" : "# comment\n");
    }
  }
  XyzReading reading(texts[0].str() + "0 0 0"); // last line without line end
  reading.Reader->AddFileName(reading.Write("b.xyz", texts[1].str()).c_str());
  reading.Reader->AddFileName(reading.Write("c.xyz", texts[2].str()).c_str());
  REQUIRE(reading.Read());
  std::vector<Triple> whole;
  for (vtkIdType i = 0; i < reading.CountPoints(); ++i)
  {
    whole.push_back(reading.GetPoint(i));
  }
  CHECK(whole.size() == 451);
  for (const int pieces : { 1, 2, 7, 1000, 5000 })
  {
    std::vector<Triple> parts;
    vtkIdType largest = 0;
    for (int piece = 0; piece < pieces; ++piece)
    {
      REQUIRE(reading.Read(piece, pieces));
      largest = std::max(largest, reading.CountPoints());
      for (vtkIdType i = 0; i < reading.CountPoints(); ++i)
      {
        parts.push_back(reading.GetPoint(i));
      }
    }
    CHECK(parts == whole);
    CHECK(largest <= 451 / std::min(pieces, 451) * 1.3 + 1);
  }
  REQUIRE(reading.Read(7, 7)); // past the end
  CHECK(reading.CountPoints() == 0);
}

TEST_CASE("XyzReader: errors in a piece name the line of the file", "[XyzReader]")
{
  std::string text = "x y z\n";
  for (int i = 2; i <= 1000; ++i)
  {
    text += i == 777 ? "1 2 bad\n" : "10 20 30\n";
  }
  XyzReading reading;
  const std::string message = "a.xyz:777: \"bad\" in column 2";
  CHECK(reading.FailsWith(text, message));
  int failures = 0;
  for (int piece = 0; piece < 100; ++piece)
  {
    reading.Log->Clear();
    if (!reading.Read(piece, 100))
    {
      ++failures;
      CHECK(reading.Log->HasError(message));
    }
  }
  CHECK(failures == 1);
  // The end of a line longer than 1 MiB is found from any start of a piece.
  reading.Set("1 2 3\n# " + std::string(5 << 20, '-') + "\n4 5 6\n");
  CHECK(!reading.Read());
  CHECK(reading.Log->HasError("a.xyz:2: the line is longer"));
  reading.Log->Clear();
  for (int piece = 1; piece < 8; ++piece)
  {
    REQUIRE(reading.Read(piece, 8));
    CHECK(reading.CountPoints() == (piece == 7));
  }
}

TEST_CASE("XyzReader: reports progress and can be aborted", "[XyzReader]")
{
  std::string text;
  for (int i = 0; i < 400000; ++i)
  {
    text += "1 2 3.5\n";
  }
  XyzReading reading(text);
  int calls = 0;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&calls);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  reading.Reader->AddObserver(vtkCommand::ProgressEvent, command);
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 400000);
  CHECK(calls > 3);
  command->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  reading.Reader->Modified();
  CHECK(!reading.Read());
  CHECK(reading.Log->HasError("reading was aborted here"));
  CHECK(reading.CountPoints() == 0);
}
