// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPointTextTesting.h"
#include "heliosWriterTesting.h"
#include "vtkHeliosPointTextWriter.h"

#include <vtkCallbackCommand.h>
#include <vtkIntArray.h>
#include <vtkStringArray.h>
#include <vtkTypeInt64Array.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace names = vtkHeliosArrayNames;
using helios::PointTextReading;

namespace
{

/// A row of 11 columns.
std::string Row(const std::string& part, const std::string& pulse = "7")
{
  return "1 2 3 4 5 1 2 " + pulse + ' ' + part + " 2 0.5\n";
}

std::string GetParts(PointTextReading& reading)
{
  std::string parts;
  for (vtkIdType i = 0; i < reading.CountPoints(); ++i)
  {
    parts += std::to_string(static_cast<int>(reading.Get(names::PartIds, i))) + ' ';
  }
  return parts;
}

} // namespace

TEST_CASE("PointTextReader: reads what the writer writes", "[PointTextReader]")
{
  constexpr vtkIdType count = 5000;
  const auto echoes = helios::MakeEchoes(count);
  vtkNew<vtkStringArray> parts;
  parts->SetName(names::PartName);
  for (const char* name : { "ground", "the red house", "#1" })
  {
    parts->InsertNextValue(name);
  }
  echoes->GetFieldData()->AddArray(parts);
  auto* pulses = vtkTypeInt64Array::SafeDownCast(echoes->GetPointData()->GetArray(names::PulseIds));
  REQUIRE(pulses);
  pulses->SetValue(1, std::numeric_limits<vtkTypeInt64>::max() - 1); // not a double
  PointTextReading reading;
  vtkNew<vtkHeliosPointTextWriter> writer;
  writer->SetFileName(reading.Reader->GetFileName());
  REQUIRE((writer->Open() && writer->Write(echoes) && writer->Close()));

  CHECK(reading.CountColumns() == 11);
  CHECK(reading.Kind() == "echoes");
  REQUIRE(reading.Read());
  REQUIRE(reading.CountPoints() == count);
  REQUIRE(reading.Cloud()->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(reading.GetPartNames() == std::vector<std::string>{ "ground", "the_red_house", "#1" });
  CHECK(reading.Reader->GetEnd() == reading.Reader->GetFileSize());
  vtkIdType wrong = 0;
  for (int i = 0; i < vtkHeliosPointTextWriter::GetNumberOfArrays(); ++i)
  {
    const char* name = vtkHeliosPointTextWriter::GetArrayName(i);
    vtkDataArray* array = echoes->GetPointData()->GetArray(name);
    REQUIRE(reading.Get(name));
    const bool isWhole = reading.Get(name)->GetDataType() != VTK_DOUBLE;
    const double scale = name == std::string(names::Amplitude) ? 1e-9 : 1.0;
    for (vtkIdType row = 0; row < count; ++row)
    {
      const double error = std::abs(reading.Get(name, row) - array->GetComponent(row, 0));
      wrong += error > (isWhole ? 0.0 : 5.1e-5 * scale);
    }
  }
  CHECK(wrong == 0);
  auto* read = vtkTypeInt64Array::SafeDownCast(reading.Get(names::PulseIds));
  REQUIRE(read);
  CHECK(read->GetValue(1) == pulses->GetValue(1));
  CHECK(reading.Get(names::ReturnNumber)->GetDataType() == VTK_UNSIGNED_CHAR);
  CHECK(reading.Get(names::PartIds)->GetDataType() == VTK_INT);
  CHECK(std::abs(reading.Cloud()->GetPoint(9)[0] - echoes->GetPoint(9)[0]) < 5.1e-5);
  CHECK(vtkHeliosPointTextWriter::GetArrayName(-1) == nullptr);
  CHECK(vtkHeliosPointTextWriter::GetArrayName(8) == nullptr);
}

TEST_CASE("PointTextReader: a file in parts is the whole", "[PointTextReader]")
{
  std::string text = "// echoes\n";
  for (int i = 0; i < 10; ++i)
  {
    text += Row("part" + std::to_string(i % 4), std::to_string(i)) + (i == 4 ? "\n\r\n" : "");
  }
  PointTextReading reading(text + "# end");
  reading.Reader->SetMaximumNumberOfPoints(4);
  std::string sizes, pulses;
  do
  {
    reading.Reader->SetBegin(reading.Reader->GetEnd());
    REQUIRE(reading.Read());
    sizes += std::to_string(reading.CountPoints()) + ' ';
    for (vtkIdType i = 0; i < reading.CountPoints(); ++i)
    {
      const auto pulse = static_cast<int>(reading.Get(names::PulseIds, i));
      pulses += std::to_string(pulse);
      CHECK(reading.Get(names::PartIds, i) == pulse % 4);
    }
  } while (reading.Reader->GetEnd() < reading.Reader->GetFileSize());
  CHECK(sizes == "4 4 2 ");
  CHECK(pulses == "0123456789");
  reading.Reader->SetBegin(1); // within a line: the next one
  REQUIRE(reading.Read());
  CHECK(reading.Get(names::PulseIds, 0) == 0.0);
}

TEST_CASE("PointTextReader: parts by name and by number", "[PointTextReader]")
{
  PointTextReading reading(Row("3") + Row("-1") + Row("3"));
  REQUIRE(reading.Read());
  CHECK(GetParts(reading) == "3 -1 3 ");
  CHECK(reading.GetPartNames().empty());

  // Names keep their numbers, and take no number of another part.
  reading.Set(Row("a") + Row("b") + Row("1") + Row("c") + Row("d") + Row("3") + Row("b"));
  REQUIRE(reading.Read());
  CHECK(GetParts(reading) == "0 1 2 4 5 3 1 ");
  CHECK(reading.GetPartNames() == std::vector<std::string>{ "a", "b", "1", "", "c", "d" });
  reading.Set(Row("99999999999") + Row("d"));
  REQUIRE(reading.Read());
  CHECK(GetParts(reading) == "6 5 ");

  vtkNew<vtkStringArray> known;
  known->InsertNextValue("ground");
  known->InsertNextValue("oak");
  reading.Reader->SetPartNames(known);
  reading.Set(Row("#odd") + Row("17") + Row("oak") + Row("0") + Row("2"));
  REQUIRE(reading.Read());
  CHECK(GetParts(reading) == "2 17 1 0 3 ");
  CHECK(reading.GetPartNames() == std::vector<std::string>{ "ground", "oak", "#odd", "2" });
  reading.Reader->SetPartNames(nullptr);
  reading.Set(Row("oak"));
  REQUIRE(reading.Read());
  CHECK(GetParts(reading) == "0 ");
}

TEST_CASE("PointTextReader: thirteen columns have the flags of scan lines", "[PointTextReader]")
{
  PointTextReading reading("1 2 3 4 5 1 1 7 roof 2 0.5 1 0\n1 2 3 4 5 1 1 7 roof 2 0.5 0 1\n");
  CHECK(reading.CountColumns() == 13);
  CHECK(reading.Kind() == "echoes");
  REQUIRE(reading.Read());
  REQUIRE(reading.CountPoints() == 2);
  vtkPointData* data = reading.Cloud()->GetPointData();
  for (vtkIdType row : { 0, 1 })
  {
    CHECK(data->GetArray(names::GpsTime)->GetTuple1(row) == 0.5);
    CHECK(data->GetArray(names::ScanDirectionFlag)->GetTuple1(row) == 1.0 - row);
    CHECK(data->GetArray(names::EdgeOfFlightLine)->GetTuple1(row) == row);
  }
  reading.Set("1 2 3 4 5 1 1 7 roof 2 0.5 1 0\n1 2 3 4 5 1 1 7 roof 2 0.5\n");
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError(":2: has 11 columns, but the first row has 13; correct or remove"));
}

TEST_CASE("PointTextReader: other text is x y z", "[PointTextReader]")
{
  PointTextReading reading("\xEF\xBB\xBF# x y z n\n1 2 3 4\r\n\n5 +6e1 7 8 // another\n9 10 11");
  CHECK(reading.CountColumns() == 4);
  CHECK(reading.Kind() == "named columns");
  REQUIRE(reading.Read());
  REQUIRE(reading.CountPoints() == 3);
  CHECK(reading.Cloud()->GetPoint(1)[1] == 60.0);
  CHECK(reading.Cloud()->GetPointData()->GetNumberOfArrays() == 0);

  for (const char* row : { "1 2 3 4 5 1 1 x part 2 0.5\n", "1 2 3 4 5 0.5 1 1 part 2 0.5\n" })
  {
    reading.Set(row); // eleven, and not ours
    CHECK(reading.CountColumns() == 11);
    CHECK(reading.Kind() == "x y z");
    REQUIRE(reading.Read());
    CHECK(reading.Cloud()->GetPointData()->GetNumberOfArrays() == 0);
  }
  reading.Set("1 2 3 4 5 1 1 7 #part 2 0.5\n");
  CHECK(reading.CountColumns() == 11);
  reading.Set("1 2 3 4 5 1 1 7 # 2 words\n");
  CHECK(reading.CountColumns() == 8);
  reading.Set("1 2 3 4 5 1 1 7 #part 2 0.5 1 0\n");
  CHECK(reading.CountColumns() == 13);
  reading.Set("1 2 3 4 5 1 1 7 #part 2 0.5 1\n");
  CHECK(reading.CountColumns() == 8);
  reading.Reader->SetFileName("/none");
  CHECK_FALSE(reading.Reader->ReadLayout());
  CHECK(reading.Log->HasError("/none: "));
  reading.Reader->SetFileName(nullptr);
  CHECK_FALSE(reading.Reader->ReadLayout());
  CHECK(reading.Log->HasError("FileName is not set"));
}

TEST_CASE("PointTextReader: numbers in other forms", "[PointTextReader]")
{
  PointTextReading reading("1 2 3 4 5 2.0 1e1 7 part -3 0.5 # a comment\n" + Row("part"));
  REQUIRE(reading.Read());
  CHECK(reading.Get(names::ReturnNumber, 0) == 2.0);
  CHECK(reading.Get(names::NumberOfReturns, 0) == 10.0);
  CHECK(reading.Get(names::ClassificationIds, 0) == -3.0);
  CHECK(reading.Get(names::Amplitude, 0) == 4e-9);

  reading.Set("1 nan 3 inf 5 1 1 7 part 2 0.5\n");
  CHECK_FALSE(reading.Read());
  reading.Log->Clear();
  reading.Reader->KeepInvalidOn();
  REQUIRE(reading.Read());
  CHECK(std::isnan(reading.Cloud()->GetPoint(0)[1]));
  CHECK(std::isinf(reading.Get(names::Amplitude, 0)));
}

TEST_CASE("PointTextReader: errors name the line, the word and the remedy", "[PointTextReader]")
{
  PointTextReading reading;
  const std::string good = Row("part");
  CHECK(reading.FailsWith(
    good + Row("part", "x"), "a.xyz:2: \"x\" in column 8 (pulse) is not a number; correct or rem"));
  CHECK(reading.FailsWith(good + Row("part", "1.5"),
    "a.xyz:2: \"1.5\" in column 8 (pulse) is not a whole number from -9223372036854775808 to"));
  CHECK(reading.FailsWith(good + Row("part", "9223372036854775808"), "is not a whole number"));
  CHECK(reading.FailsWith("1 2 3 4 5 256 1 7 0 2 0\n",
    "\"256\" in column 6 (return number) is not a whole number from "
    "0 to 255; correct or remove the row"));
  CHECK(reading.FailsWith("1 2 3 4 5 -1 1 7 0 2 0\n", "from 0 to 255"));
  CHECK(reading.FailsWith("1 2 3 4 5 1 1 7 0 2147483648 0\n", "(class) is not a whole number fro"));
  CHECK(reading.FailsWith("1 nan 3\n", "a.xyz:1: \"nan\" in column 2 (y) is not finite; correct"));
  CHECK(reading.FailsWith("1 1e999 3\n", "\"1e999\" in column 2 (y) is not a number"));
  CHECK(reading.FailsWith("1 2 3 4 5 1 1 7 0 2 inf\n", "column 11 (time) is not finite"));
  CHECK(reading.FailsWith(
    good + "1 2 3 4 5\n", "a.xyz:2: has 5 columns, but the first row has 11; correct or remove"));
  CHECK(reading.FailsWith(good + "1 2 3 4 5 1 1 7\n", "has 8 columns"));
  CHECK(
    reading.FailsWith(good + "1 2 3 4 5 1 1 7 part 2 0.5 9\n", "has 12 columns, but the first"));
  CHECK(reading.FailsWith("1 2 3\n4 5 // 6\n", "a.xyz:2: has 2 columns, but the first row has 3"));
  CHECK(
    reading.FailsWith("1 2\n", "a.xyz: has 2 columns; give x y z, or the 11 columns of echoes"));
  CHECK(reading.FailsWith("\n# none\n", "a.xyz: has no points; give a file with points"));
  CHECK(reading.FailsWith(good + Row(std::string("a\0b", 3)),
    "a.xyz:2: has zero bytes, so it is not valid text: it is damaged, copy it again"));
  reading.Set("");
  reading.Reader->SetFileName("/none.xyz");
  CHECK((!reading.Read() && reading.Log->HasError("/none.xyz: ")));
  reading.Log->Clear();
  reading.Reader->SetFileName(nullptr);
  CHECK((!reading.Read() && reading.Log->HasError("FileName is not set; give the file of points")));
}

TEST_CASE("PointTextReader: can be aborted, and tells its progress", "[PointTextReader]")
{
  std::string text;
  for (int i = 0; i < 60000; ++i) // more than one block of 1 MiB
  {
    text += Row("part");
  }
  PointTextReading reading(text);
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 60000);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* reader, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(reader)->AbortExecuteOn(); });
  reading.Reader->AddObserver(vtkCommand::ProgressEvent, abort);
  reading.Reader->Modified();
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("reading was aborted here; update again to read it"));
  CHECK(reading.CountPoints() == 0);
}
