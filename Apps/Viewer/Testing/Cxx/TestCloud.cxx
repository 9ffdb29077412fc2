// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCloud.h"
#include "heliosCloudColors.h"
#include "heliosViewerTest.h"

#include <catch2/catch.hpp>

#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedShortArray.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace helios;
using namespace helios::viewer;
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

vtkSmartPointer<vtkPolyData> MakeFullEchoes(vtkIdType first, vtkIdType count)
{
  std::vector<Vec3> places;
  std::vector<double> times, pulses, amplitudes, counts, ranges, angles;
  for (vtkIdType i = first; i < first + count; ++i)
  {
    const auto at = static_cast<double>(i);
    places.emplace_back(500000.0 + 0.01 * at, 5400000.0, 300.0 + 0.001 * at);
    times.push_back(1e-5 * at);
    pulses.push_back(at);
    amplitudes.push_back(1e-9 * (1.0 + at));
    counts.push_back(1.0 + static_cast<double>(i % 5));
    ranges.push_back(100.0 + 0.001 * at);
    angles.push_back(static_cast<double>(i % 90));
  }
  auto echoes = MakeEchoes(places);
  AddColumn(echoes, names::GpsTime, times);
  AddColumn(echoes, names::PulseIds, pulses);
  AddColumn(echoes, names::Amplitude, amplitudes);
  AddColumn(echoes, names::ReturnNumber, counts);
  AddColumn(echoes, names::NumberOfReturns, counts);
  AddColumn(echoes, names::ClassificationIds, counts);
  AddColumn(echoes, names::PartIds, angles);
  AddColumn(echoes, names::MaterialIds, counts);
  AddColumn(echoes, names::LegIds, counts);
  AddColumn(echoes, names::Range, ranges);
  AddColumn(echoes, names::IncidenceAngle, angles);
  return echoes;
}

} // namespace

TEST_CASE("Cloud: every column is stored and returned")
{
  Cloud cloud;
  cloud.Append(MakeFullEchoes(1000, 50));
  const Echo echo = cloud.GetEcho(7);
  CHECK(echo.Row == 7);
  CHECK(echo.PulseId == 1007);
  CHECK(std::abs(echo.Position[0] - 500010.07) < 1e-6);
  CHECK(std::abs(echo.Position[2] - 301.007) < 1e-6);
  CHECK(std::abs(echo.GpsTime - 0.01007) < 1e-9);
  CHECK(std::abs(echo.Amplitude / 1.008e-6 - 1.0) < 7e-4);
  CHECK(std::abs(echo.Range - 101.007) < 1e-5);
  CHECK(std::abs(echo.IncidenceAngle - 17.0) < 0.18);
  CHECK(echo.ReturnNumber == 3);
  CHECK(echo.NumberOfReturns == 3);
  CHECK(echo.Class == 3);
  CHECK(echo.Part == 17);
  CHECK(echo.Material == 3);
  CHECK(echo.Leg == 3);
}

TEST_CASE("Cloud: arrays may be missing or of any type")
{
  auto echoes = MakeEchoes({ { 1, 2, 3 }, { 4, 5, 6 } });
  vtkNew<vtkIntArray> parts;
  parts->SetName(names::PartIds);
  parts->InsertNextValue(70000);
  parts->InsertNextValue(-1);
  echoes->GetPointData()->AddArray(parts);
  vtkNew<vtkIntArray> tooFew;
  tooFew->SetName(names::Range);
  tooFew->InsertNextValue(5);
  echoes->GetPointData()->AddArray(tooFew);
  Cloud cloud;
  cloud.Append(echoes);
  CHECK(cloud.Has(CloudColumn::Height));
  CHECK(cloud.Has(CloudColumn::Part));
  CHECK_FALSE(cloud.Has(CloudColumn::Range));
  CHECK_FALSE(cloud.Has(CloudColumn::Time));
  const Echo echo = cloud.GetEcho(0);
  CHECK(echo.Part == 70000);
  CHECK(cloud.GetEcho(1).Part == -1);
  CHECK(echo.PulseId == -1);
  CHECK(std::isnan(echo.GpsTime));
  CHECK(std::isnan(echo.Amplitude));
  CHECK(std::isnan(echo.Range));
  CHECK(std::isnan(echo.IncidenceAngle));
  double range[2];
  CHECK_FALSE(cloud.GetTimeRange(range));
}

TEST_CASE("Cloud: names of parts are those of the blocks")
{
  auto echoes = MakeEchoes({ { 1, 2, 3 } });
  Cloud cloud;
  cloud.Append(echoes);
  CHECK(cloud.GetPartName(0).empty());
  vtkNew<vtkStringArray> parts;
  parts->SetName(names::PartName);
  parts->InsertNextValue("ground");
  parts->InsertNextValue("house");
  echoes->GetFieldData()->AddArray(parts);
  cloud.Append(echoes);
  echoes->GetFieldData()->RemoveArray(names::PartName);
  cloud.Append(echoes);
  CHECK(cloud.GetPartName(1) == "house");
  CHECK(cloud.GetPartName(2).empty());
  CHECK(cloud.GetPartName(-1).empty());
  cloud.Clear();
  CHECK(cloud.GetPartName(1).empty());
}

TEST_CASE("Cloud: intensity replaces a missing amplitude")
{
  auto echoes = MakeEchoes({ { 1, 2, 3 } });
  AddColumn(echoes, names::Intensity, { 40000.0 });
  Cloud cloud;
  cloud.Append(echoes);
  CHECK(cloud.HasRawAmplitudes());
  CHECK(std::abs(cloud.GetEcho(0).Amplitude / 40000.0 - 1.0) < 7e-4);
}

TEST_CASE("Cloud: points that are not finite are dropped and counted")
{
  auto echoes = MakeEchoes({ { NaN, 0, 0 }, { 1, 2, 3 }, { 1, HUGE_VAL, 3 }, { 4, 5, 6 } });
  AddColumn(echoes, names::PulseIds, { 10, 11, 12, 13 });
  Cloud cloud;
  cloud.Append(echoes);
  CHECK(cloud.GetNumberOfPoints() == 2);
  CHECK(cloud.GetNumberOfDroppedPoints() == 2);
  CHECK(cloud.GetEcho(0).PulseId == 11);
  CHECK(cloud.GetEcho(1).PulseId == 13);
}

TEST_CASE("Cloud: chunks never move and are filled in order")
{
  Cloud cloud;
  cloud.Append(MakeFullEchoes(0, 100000));
  const float* first = cloud.GetChunks()[0]->GetXyz();
  cloud.Append(MakeFullEchoes(100000, 200000));
  REQUIRE(cloud.GetChunks().size() == 3);
  CHECK(cloud.GetChunks()[0]->GetXyz() == first);
  CHECK(cloud.GetChunks()[0]->GetSize() == CloudChunk::Capacity);
  for (const vtkIdType row :
    { vtkIdType(0), CloudChunk::Capacity - 1, CloudChunk::Capacity, vtkIdType(299999) })
  {
    CHECK(cloud.GetEcho(row).PulseId == row);
  }
  double range[2];
  REQUIRE(cloud.GetTimeRange(range));
  CHECK(range[0] == 0.0);
  CHECK(std::abs(range[1] - 2.99999) < 1e-7);
}

TEST_CASE("Cloud: times of long runs and far pulses are exact")
{
  auto echoes = MakeEchoes({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } });
  AddColumn(echoes, names::GpsTime, { 4e8, 4e8 + 1e-6, 4e8 + 0.25 });
  AddColumn(echoes, names::PulseIds, { 5e9, 5e9 + 1, 9e12 });
  Cloud cloud;
  cloud.Append(echoes);
  CHECK(std::abs(cloud.GetEcho(1).GpsTime - (4e8 + 1e-6)) <= 6e-8);
  CHECK(cloud.GetEcho(2).GpsTime == 4e8 + 0.25);
  CHECK(cloud.GetEcho(1).PulseId == 5000000001);
  CHECK(cloud.GetEcho(2).PulseId == 9000000000000);
  CHECK(cloud.GetChunks().size() == 2);
}

TEST_CASE(
  "Cloud: bounds are in world coordinates, and the origin cannot change after the first data")
{
  Cloud cloud;
  double bounds[6];
  CHECK_FALSE(cloud.GetBounds(bounds));
  CHECK(cloud.SetOrigin({ 100.0, 200.0, 300.0 }));
  cloud.Append(MakeEchoes({ { 101, 202, 303 }, { 111, 192, 313 } }));
  CHECK_FALSE(cloud.SetOrigin({ 0.0, 0.0, 0.0 }));
  REQUIRE(cloud.GetBounds(bounds));
  const double expected[6] = { 101, 111, 192, 202, 303, 313 };
  for (int i = 0; i < 6; ++i)
  {
    CHECK(bounds[i] == expected[i]);
  }
  CHECK(cloud.GetChunks()[0]->GetXyz()[0] == 1.0f);
  cloud.Clear();
  CHECK(cloud.GetNumberOfPoints() == 0);
  CHECK(cloud.GetOrigin()[0] == 100.0);
}

TEST_CASE("Cloud: blocks without points have no effect")
{
  Cloud cloud;
  cloud.Append(nullptr);
  cloud.Append(vtkNew<vtkPolyData>());
  CHECK(cloud.GetNumberOfPoints() == 0);
  CHECK_FALSE(cloud.Has(CloudColumn::Height));
}

TEST_CASE("Cloud: points keep colours of their own, real numbers or whole ones")
{
  const bool areWords = GENERATE(false, true);
  vtkNew<vtkFloatArray> real;
  vtkNew<vtkUnsignedShortArray> words;
  vtkDataArray* colors = areWords ? static_cast<vtkDataArray*>(words.Get()) : real.Get();
  colors->SetName(names::RGB);
  colors->SetNumberOfComponents(3);
  const double full = areWords ? 65535.0 : 1.0;
  colors->InsertNextTuple3(full, 0.2 * full, 0.0);
  colors->InsertNextTuple3(0.0, 0.0, 0.4 * full);
  const auto painted = MakeEchoes({ { 0, 0, 0 }, { 1, 0, 0 } });
  painted->GetPointData()->AddArray(colors);
  Cloud cloud;
  cloud.Append(MakeEchoes({ { 2, 0, 0 } }));
  CHECK_FALSE(cloud.Has(CloudColumn::Color));
  CHECK(cloud.GetChunks().front()->Colors.empty());
  cloud.Append(painted);
  cloud.Append(MakeEchoes({ { 3, 0, 0 } }));
  CHECK(cloud.Has(CloudColumn::Color));

  CloudColors mapped;
  mapped.By = ColorBy::Own;
  std::uint8_t rgba[16];
  mapped.Map(cloud, *cloud.GetChunks().front(), 0, 4, rgba);
  const std::vector<int> expected{ 128, 128, 128, 255, 255, 51, 0, 255, 0, 0, 102, 255, 128, 128,
    128, 255 };
  CHECK(std::vector<int>(rgba, rgba + 16) == expected);
  CHECK_FALSE(mapped.FitRange({ 1.0, 2.0 }));
  CHECK(mapped.MakeLegend(cloud, {}).Colors.empty());
}
