// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged PCD files give an error or complete points.
#include "heliosMutation.h"
#include "heliosPcdTesting.h"
#include "vtkHeliosPCDWriter.h"

#include <catch2/catch.hpp>

#include <lzf.h>

#include <cmath>

namespace
{

/// Finite points, and the same number of tuples in all arrays.
bool IsWhole(vtkPolyData* cloud)
{
  const vtkIdType count = cloud->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double* x = cloud->GetPoint(i);
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      return false;
    }
  }
  vtkPointData* data = cloud->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (data->GetArray(i)->GetNumberOfTuples() != count)
    {
      return false;
    }
  }
  return true;
}

std::string MakeBinary(const std::string& path)
{
  vtkNew<vtkHeliosPCDWriter> writer;
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(helios::MakeEchoes(20)) && writer->Close()));
  return helios::ReadText(path);
}

std::string MakeCompressed()
{
  std::string data;
  for (int i = 0; i < 60; ++i)
  {
    helios::AppendBytes(data, static_cast<float>(i % 7));
  }
  std::string packed(400, '\0');
  const unsigned int size = lzf_compress(data.data(), 240, packed.data(), 400);
  std::string bytes;
  helios::AppendBytes(bytes, size);
  helios::AppendBytes(bytes, std::uint32_t(240));
  return "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 20\nHEIGHT 1\nPOINTS 20\n"
         "DATA binary_compressed\n" +
    bytes + packed.substr(0, size);
}

/// A header with a changed entry.
std::string SetEntry(std::string text, const std::string& key, const std::string& value)
{
  const std::size_t at = text.find('\n' + key + ' ') + 1;
  return text.replace(at, text.find('\n', at) - at, key + ' ' + value);
}

} // namespace

TEST_CASE("PCDMutations: impossible sizes are refused at once", "[PCDMutations][mutation]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "a.pcd";
  helios::PcdReading reading(path);
  const std::string binary = MakeBinary(path);
  const std::string numbers[] = { "0", "1", "-1", "19", "21", "4294967295", "4294967296",
    "1099511627776", "1099511627777", "1000000000000000000", "9223372036854775808",
    "18446744073709551615", "18446744073709551616", "99999999999999999999999", "1e18", "2.5", "" };
  for (const std::string& whole : { helios::AsciiPcd, binary, MakeCompressed() })
  {
    for (const std::string& width : numbers)
    {
      for (const std::string& height : numbers)
      {
        for (const bool hasPoints : { true, false })
        {
          std::string text = SetEntry(SetEntry(whole, "WIDTH", width), "HEIGHT", height);
          text = SetEntry(text, "POINTS", hasPoints ? width : "");
          text = hasPoints ? text : helios::Replace(text, "POINTS \n", "");
          helios::WriteFile(path, text);
          INFO("WIDTH " << width << " HEIGHT " << height << ' ' << hasPoints);
          const bool isGood = reading.Read();
          REQUIRE((isGood || reading.Log->HasError(path + ":")));
          REQUIRE(reading.CountPoints() <= 20);
          REQUIRE(IsWhole(reading.Cloud()));
        }
      }
    }
  }
}

TEST_CASE("PCDMutations: damaged files give an error or points", "[PCDMutations][mutation]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "a.pcd";
  const std::string files[] = { helios::AsciiPcd, MakeBinary(path), MakeCompressed() };
  helios::PcdReading reading(path);
  helios::Mutator mutate(20261);
  int errorCount = 0;
  int goodCount = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    const std::string& whole = files[i % 3];
    // most damage is done to the header, which is the smaller part of the binary file
    const std::size_t head = i % 2 == 0 ? whole.find("DATA ") + 5 : whole.size();
    helios::WriteFile(path, mutate(whole.substr(0, head)) + whole.substr(head));
    INFO("file " << i);
    const bool isGood = reading.Read();
    (isGood ? goodCount : errorCount) += 1;
    REQUIRE((isGood || reading.Log->HasError(path + ":")));
    REQUIRE((isGood || reading.CountPoints() == 0));
    REQUIRE(IsWhole(reading.Cloud()));
  }
  CHECK(errorCount > 20);
  CHECK(goodCount > 10);
}
