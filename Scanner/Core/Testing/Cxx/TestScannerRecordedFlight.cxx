// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Pulses along a recorded or a simulated trajectory.
#include "heliosScannerBench.h"
#include "vtkHeliosInterpolatedPlatform.h"
#include "vtkHeliosMulticopterPlatform.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;
using namespace helios::testing;

namespace
{

/// From 1000 s, one sample per second: along x at 10 m/s, turning by 30 degrees.
vtkSmartPointer<vtkPolyData> MakeRecord()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> times, orientations;
  times->SetName(names::GpsTime);
  orientations->SetName(names::Orientation);
  orientations->SetNumberOfComponents(4);
  for (int i = 0; i <= 4; ++i)
  {
    points->InsertNextPoint(10.0 * i, i % 2, 0);
    times->InsertNextValue(1000 + i);
    orientations->InsertNextTuple(helios::AxisAngle({ 0, 0, 1 }, 30.0 * i - 60).GetData());
  }
  auto record = vtkSmartPointer<vtkPolyData>::New();
  record->SetPoints(points);
  record->GetPointData()->AddArray(times);
  record->GetPointData()->AddArray(orientations);
  return record;
}

} // namespace

TEST_CASE("Scanner: pulses between the samples of a recorded trajectory", "[Scanner]")
{
  Bench bench(MakeScene({ Wall(500, 5000) }));
  vtkNew<StraightAhead> deflector;
  deflector->SetPulseFrequency(64);
  vtkNew<vtkHeliosInterpolatedPlatform> platform;
  platform->SetInputData(MakeRecord());
  platform->AddLeg(1000.5, 1003.5, false);
  bench.Scanner->SetInputConnection(1, platform->GetOutputPort());
  bench.Scanner->SetBeamDeflector(deflector);
  bench.Scanner->SetDuration(-1);
  bench.Scanner->GeneratePulsesOn();
  for (const bool keeps : { false, true })
  {
    platform->SetKeepFileTimes(keeps);
    bench.Run();
    auto* pulses = vtkPolyData::SafeDownCast(bench.Scanner->GetOutputDataObject(2));
    REQUIRE(pulses->GetNumberOfPoints() == 3 * 64);
    vtkDataArray* directions = pulses->GetPointData()->GetArray(names::Direction);
    for (vtkIdType i = 0; i < pulses->GetNumberOfPoints(); ++i)
    {
      const double t = 0.5 + static_cast<double>(i) / 64;
      const double yaw = vtkMath::RadiansFromDegrees(30 * t - 60);
      const Vec3 origin(10 * t, std::abs(std::remainder(t, 2)), 0);
      REQUIRE(Value(pulses, names::GpsTime, i) == (keeps ? 1000 : -0.5) + t);
      REQUIRE((Vec3(pulses->GetPoint(i)) - origin).Norm() < 1e-12);
      const Vec3 direction(-std::sin(yaw), std::cos(yaw), 0);
      REQUIRE((Vec3(directions->GetTuple3(i)) - direction).Norm() < 1e-14);
    }
  }
}

TEST_CASE("Scanner: a flight is identical at 10 kHz and at 1 MHz", "[Scanner]")
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> speeds;
  speeds->SetName(names::Speed);
  for (const Vec3& p : { Vec3(0, 0, 30), Vec3(60, 0, 30), Vec3(60, 40, 35), Vec3(0, 40, 35) })
  {
    points->InsertNextPoint(p.GetData());
    speeds->InsertNextValue(8.0);
  }
  vtkNew<vtkPolyData> path;
  path->SetPoints(points);
  path->GetPointData()->AddArray(speeds);
  vtkNew<vtkHeliosMulticopterPlatform> copter;
  copter->SetInputData(path);
  Bench bench(MakeScene({ Wall(500, 5000) }));
  vtkNew<StraightAhead> deflector;
  bench.Scanner->SetInputConnection(1, copter->GetOutputPort());
  bench.Scanner->SetBeamDeflector(deflector);
  bench.Scanner->SetDuration(-1);
  bench.Scanner->GeneratePulsesOn();
  const auto run = [&](double frequency, vtkIdType first, vtkIdType last)
  {
    deflector->SetPulseFrequency(frequency);
    bench.Scanner->SetPulseWindow(first, last);
    bench.Run();
    vtkNew<vtkPolyData> pulses;
    pulses->DeepCopy(bench.Scanner->GetOutputDataObject(2));
    return pulses;
  };
  double farthest = 0.0;
  for (vtkIdType i = 0; i < 200000; i += 10007) // pulses of 20 s, inside and outside turns
  {
    const auto slow = run(1e4, i, i + 3);
    const auto fast = run(1e6, 100 * i, 100 * i + 201);
    REQUIRE(slow->GetNumberOfPoints() == 3);
    REQUIRE(fast->GetNumberOfPoints() == 201);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      const Vec3 a(slow->GetPoint(k));
      const Vec3 b(fast->GetPoint(100 * k));
      vtkDataArray* directions[] = { slow->GetPointData()->GetArray(names::Direction),
        fast->GetPointData()->GetArray(names::Direction) };
      farthest = std::max(farthest, (a - b).Norm());
      REQUIRE((Vec3(directions[0]->GetTuple3(k)) - Vec3(directions[1]->GetTuple3(100 * k))).Norm() <
        1e-9);
    }
  }
  CHECK(farthest < 1e-6);
}
