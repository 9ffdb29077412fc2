// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Simulated echoes of a pool's floor go back to where they are.
#include "heliosDispersion.h"
#include "heliosOpticsBench.h"
#include "vtkHeliosRefractionCorrection.h"

#include <vtkMath.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace helios::testing;
using helios::Material;
using helios::OpticsKind;
using helios::Vec3;
namespace names = vtkHeliosArrayNames;

namespace
{

struct CorrectionBench
{
  vtkNew<vtkHeliosRefractionCorrection> Filter;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());

  CorrectionBench(vtkPolyData* cloud, vtkPolyData* water, vtkPolyData* trajectory)
  {
    this->Filter->SetInputData(0, cloud);
    this->Filter->SetInputData(1, water);
    this->Filter->SetInputData(2, trajectory);
    this->Log->Watch(this->Filter);
    this->Log->Watch(this->Filter->GetExecutive());
  }

  vtkPolyData* Run()
  {
    this->Filter->Update();
    return this->Filter->GetOutput();
  }
};

/// A point at a place, at a time.
vtkSmartPointer<vtkPolyData> MakePoint(const Vec3& place, double time)
{
  const auto data = MakeWaypoints({ place });
  vtkNew<vtkDoubleArray> times;
  times->SetName(names::GpsTime);
  times->InsertNextValue(time);
  data->GetPointData()->AddArray(times);
  return data;
}

} // namespace

TEST_CASE("RefractionCorrection: a simulated floor is moved to where it is")
{
  const double degrees = GENERATE(0.0, 20.0, 60.0);
  const double a = vtkMath::RadiansFromDegrees(degrees);
  const bool hasDispersion = GENERATE(false, true);
  Material water = MakeMaterial(OpticsKind::Volume);
  water.Optics.RefractiveIndex = 1.33;
  water.Optics.Dispersion =
    hasDispersion ? helios::DispersionKind::Water : helios::DispersionKind::None;
  const helios::Indices green = helios::GetIndices(helios::DispersionKind::Water, 532.0);
  const Vec3 normal(std::sin(a), -std::cos(a), 0.0);
  const Rectangle surface = Across({ 0.0, 10.0, 0.0 }, normal, 50.0);
  const Rectangle floor = Across(Vec3(0.0, 10.0, 0.0) - 2.0 * normal, normal, 50.0);
  RayBench scan(MakeOpticalScene({ surface }, water, { floor }));
  scan.Scanner->SetWavelength(532.0);
  vtkPolyData* cloud = scan.Run();
  const vtkIdType last = cloud->GetNumberOfPoints() - 1;
  REQUIRE(last >= 0);
  CorrectionBench bench(cloud, MakeScene({ surface }), MakePoint({ 0, 0, 0 }, 0.0));
  bench.Filter->SetRefractiveIndex(hasDispersion ? green.Phase : 1.33);
  bench.Filter->SetGroupIndex(hasDispersion ? green.Group : 0.0);
  vtkPolyData* corrected = bench.Run();
  REQUIRE(corrected->GetNumberOfPoints() == last + 1);
  CHECK((Vec3(corrected->GetPoint(last)) - GetTruth(cloud, last)).Norm() < 1e-12);
  CHECK(Value(corrected, names::WaterDepth, last) == Approx(2.0).epsilon(1e-12));
  CHECK(Value(corrected, names::Range, last) == Value(cloud, names::Range, last));
  if (degrees == 0.0) // the glint of the surface
  {
    CHECK(Vec3(corrected->GetPoint(0)) == Vec3(cloud->GetPoint(0)));
    CHECK(Value(corrected, names::WaterDepth, 0) == 0.0);
  }
}

TEST_CASE("RefractionCorrection: beams start where the trajectory is, with its lever arm")
{
  // At 45 degrees on flat water 1 m below, for another sqrt(2) m in range.
  const auto water = MakeScene({ { { -9, -9, -1 }, { 18, 0, 0 }, { 0, 18, 0 } } });
  const auto cloud = MakePoint({ 2.0, 0.0, -2.0 }, 5.0);
  vtkNew<vtkPolyData> trajectory;
  trajectory->ShallowCopy(MakeWaypoints({ { -1, 0, 0 }, { 1, 0, 0 } }));
  vtkNew<vtkDoubleArray> times;
  times->SetName(names::GpsTime);
  times->InsertNextValue(0.0);
  times->InsertNextValue(10.0);
  trajectory->GetPointData()->AddArray(times);
  CorrectionBench bench(cloud, water, trajectory);
  const double length = std::sqrt(2.0) / 1.34;
  const double sine = std::sqrt(0.5) / 1.34;
  const Vec3 expected(1.0 + length * sine, 0.0, -1.0 - length * std::sqrt(1.0 - sine * sine));
  CHECK((Vec3(bench.Run()->GetPoint(0)) - expected).Norm() < 1e-12);
  bench.Filter->SetLeverArm(2.0, 0.0, 0.0); // straight down
  CHECK((Vec3(bench.Run()->GetPoint(0)) - Vec3(2.0, 0.0, -1.0 - 1.0 / 1.34)).Norm() < 1e-12);
  // above the water nothing changes
  const auto high = MakePoint({ 0.5, 0.0, -0.5 }, 5.0);
  CHECK(Vec3(CorrectionBench(high, water, trajectory).Run()->GetPoint(0)) == Vec3(0.5, 0.0, -0.5));
  CorrectionBench timeless(MakeWaypoints({ { 2, 0, -2 } }), water, trajectory);
  timeless.Run();
  CHECK(timeless.Log->HasError(
    "the cloud has no point array GpsTime, by which echoes find their place on the trajectory"));
}

TEST_CASE("RefractionCorrection: errors")
{
  const auto cloud = MakePoint({ 2.0, 0.0, -2.0 }, 5.0);
  CorrectionBench dry(cloud, vtkSmartPointer<vtkPolyData>::New(), cloud);
  dry.Run();
  CHECK(dry.Log->HasError("the surface of the water (port 1) has no triangles that can be hit"));
  CorrectionBench nowhere(cloud, MakeScene({ Wall(1.0) }), vtkSmartPointer<vtkPolyData>::New());
  nowhere.Run();
  CHECK(nowhere.Log->HasError("the trajectory has no points"));
}
