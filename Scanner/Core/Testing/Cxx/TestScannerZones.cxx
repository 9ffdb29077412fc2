// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Several pulses in the air: echoes that are assigned to other pulses.
#include "heliosScannerBench.h"
#include "vtkHeliosLinearPathPlatform.h"
#include "vtkHeliosRotatingMirror.h"
#include "vtkHeliosSpinningChannels.h"

#include <catch2/catch.hpp>

#include <map>
#include <string>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;
using namespace helios::testing;

namespace
{

constexpr double Zone = 0.5 * 299792458.0 / 1e5; // depth for 100 kHz [m]

/// Every echo lies on the beam of the pulse whose id and time it has, and at its true range less a
/// whole number of zones; echoes of pulses that are not emitted are lost.
void CheckZones(vtkHeliosScanner* scanner, int zone, vtkIdType stride)
{
  scanner->SetMTAZone(zone);
  scanner->GeneratePulsesOn();
  scanner->GenerateTruthOn();
  scanner->Update();
  vtkPolyData* echoes = scanner->GetOutput();
  auto* pulses = vtkPolyData::SafeDownCast(scanner->GetOutputDataObject(2));
  std::map<vtkIdType, vtkIdType> rows;
  for (vtkIdType row = 0; row < pulses->GetNumberOfPoints(); ++row)
  {
    rows[static_cast<vtkIdType>(Value(pulses, names::PulseIds, row))] = row;
  }
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(echoes);
  scanner->SetMTAZone(0);
  scanner->Update();
  vtkPolyData* truth = scanner->GetOutput();
  vtkIdType k = 0;
  for (vtkIdType i = 0; i < truth->GetNumberOfPoints(); ++i)
  {
    const double range = Value(truth, names::Range, i);
    const auto step = static_cast<vtkIdType>(range / Zone) - (zone - 1);
    const auto row =
      rows.find(static_cast<vtkIdType>(Value(truth, names::PulseIds, i)) + step * stride);
    if (row == rows.end())
    {
      continue;
    }
    REQUIRE(k < moved->GetNumberOfPoints());
    CAPTURE(i, k, zone);
    REQUIRE(Value(moved, names::PulseIds, k) == static_cast<double>(row->first));
    const double apparent = range - static_cast<double>(step) * Zone;
    CHECK(Value(moved, names::Range, k) == Approx(apparent).epsilon(1e-12));
    CHECK(apparent >= (zone - 1) * Zone);
    CHECK(apparent < zone * Zone);
    const Vec3 direction(
      pulses->GetPointData()->GetArray(names::Direction)->GetTuple3(row->second));
    const Vec3 point = Vec3(pulses->GetPoint(row->second)) + apparent * direction;
    CHECK((Vec3(moved->GetPoint(k)) - point).Norm() < 1e-9);
    for (const char* name : { names::GpsTime, names::ScanAngle, names::ChannelIds })
    {
      CHECK(Value(moved, name, k) == Value(pulses, name, row->second));
    }
    const Vec3 target(moved->GetPointData()->GetArray(names::TruePoint)->GetTuple3(k));
    CHECK((target - Vec3(truth->GetPoint(i))).Norm() < 1e-9);
    CHECK(Value(moved, names::Amplitude, k) == Value(truth, names::Amplitude, i));
    ++k;
  }
  CHECK(k == moved->GetNumberOfPoints());
  CHECK(k > truth->GetNumberOfPoints() / 2);
}

} // namespace

TEST_CASE("Zones: the range is known up to a multiple of c / 2 f", "[Zones]")
{
  Bench bench(MakeScene({ Wall(2000) }));
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(0.0);
  bench.Scanner->SetMTAZone(1);
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 999); // the last is lost
  CHECK(Value(echoes, names::Range, 0) == Approx(2000 - 1498.96229).epsilon(1e-9));
  CHECK(Value(echoes, names::PulseIds, 0) == 1.0);
  CHECK(Value(echoes, names::GpsTime, 0) == 1e-5);
  CHECK(bench.Scanner->GetCount("points") == 999);
}

TEST_CASE("Zones: echoes of the zone are right, byte for byte", "[Zones]")
{
  Bench bench(MakeScene({ Wall(2000) }));
  bench.Scanner->SetRangeAccuracy(0.01);
  const std::string right = Bytes(bench.Run());
  bench.Scanner->SetMTAZone(2);
  CHECK(Bytes(bench.Run()) == right);
}

TEST_CASE("Zones: echoes are on the beam of the pulse that they are taken for", "[Zones]")
{
  const int zone = GENERATE(1, 2, 3);
  // A mirror that is turned away between its lines, on a moving platform.
  Bench bench(MakeScene({ Wall(2000, 4000), { { -50, 1000, 2 }, { 100, 0, 0 }, { 0, 0, 400 } },
    { { -50, 3200, -900 }, { 100, 0, 0 }, { 0, 0, 600 } } }));
  vtkNew<vtkHeliosLinearPathPlatform> plane;
  plane->SetInputData(MakeWaypoints({ { 0, 0, 0 }, { 0, 2, 0 } }, 100.0));
  bench.Scanner->SetInputConnection(1, plane->GetOutputPort());
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetMirrorAngle(30);
  mirror->SetVerticalAngleMin(-20);
  mirror->SetVerticalAngleMax(20);
  mirror->SetScanFrequency(1000);
  bench.Scanner->SetBeamDeflector(mirror);
  CheckZones(bench.Scanner, zone, 1);
}

TEST_CASE("Zones: each channel of a spinning head has pulses of its own", "[Zones]")
{
  Bench bench(MakeScene({ Wall(2000, 4000) }));
  vtkNew<vtkHeliosSpinningChannels> head;
  head->SetNumberOfChannels(3);
  head->SetElevation(0, -2);
  head->SetElevation(2, 3);
  head->SetScanFrequency(1);
  head->SetPulseFrequency(3e5);
  bench.Scanner->SetBeamDeflector(head);
  CheckZones(bench.Scanner, 1, 3);
}

TEST_CASE("Zones: echoes do not depend on windows", "[Zones]")
{
  Bench whole(MakeScene({ Wall(2000) }));
  whole.Scanner->SetMTAZone(1);
  const vtkIdType count = whole.Run()->GetNumberOfPoints();
  vtkIdType sum = 0;
  for (const vtkIdType first : { 0, 300, 700 })
  {
    Bench part(MakeScene({ Wall(2000) }));
    part.Scanner->SetMTAZone(1);
    const vtkIdType last = first == 0 ? 300 : (first == 300 ? 700 : 1000);
    part.Scanner->SetPulseWindow(first, last);
    vtkPolyData* echoes = part.Run();
    REQUIRE(echoes->GetNumberOfPoints() > 0);
    CHECK(Value(echoes, names::PulseIds, 0) == static_cast<double>(first + 1));
    CHECK(Value(echoes, names::Range, 0) == Value(whole.Scanner->GetOutput(), names::Range, sum));
    sum += echoes->GetNumberOfPoints();
  }
  CHECK(sum == count);
}

TEST_CASE("Zones: waveforms are not taken for those of other pulses", "[Zones]")
{
  Bench bench(MakeScene({ Wall(2000) }));
  bench.Scanner->SetMTAZone(2);
  bench.Scanner->GenerateWaveformsOn();
  bench.Run();
  CHECK(bench.Log->HasError(
    "MTAZone is 2 and GenerateWaveforms is on: waveforms cannot be taken for those of other "
    "pulses; turn GenerateWaveforms off, or set MTAZone to 0"));
}
