// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosPlatform.h"

#include <catch2/catch.hpp>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <cmath>
#include <limits>

namespace names = vtkHeliosArrayNames;

namespace
{

/// A user-defined platform: one second per leg, always facing east.
class Steps : public vtkHeliosPlatform
{
public:
  static Steps* New();
  vtkTypeMacro(Steps, vtkHeliosPlatform);

  bool Fail = false;

protected:
  bool Move(vtkPolyData* waypoints, std::vector<State>& path) override
  {
    for (vtkIdType i = 0; i < waypoints->GetNumberOfPoints(); ++i)
    {
      State state{};
      state.Time = this->StartTime + static_cast<double>(i);
      waypoints->GetPoint(i, state.Position);
      HeadingToOrientation(5.0, 0.0, state.Orientation);
      state.Velocity[1] = 3.0;
      state.LegId = GetLegId(waypoints, i);
      path.push_back(state);
    }
    return !this->Fail;
  }
};
vtkStandardNewMacro(Steps);

vtkSmartPointer<vtkPolyData> MakeWaypoints(int count)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < count; ++i)
  {
    points->InsertNextPoint(500000.125 + i, 5500000.654321, 300.0);
  }
  auto waypoints = vtkSmartPointer<vtkPolyData>::New();
  waypoints->SetPoints(points);
  return waypoints;
}

} // namespace

TEST_CASE("Platform: samples become one polyline with all arrays", "[Platform]")
{
  vtkNew<Steps> platform;
  platform->SetStartTime(1e9);
  platform->SetInputData(MakeWaypoints(4));
  platform->Update();

  vtkPolyData* path = platform->GetOutput();
  REQUIRE(path->GetNumberOfPoints() == 4);
  CHECK(path->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(path->GetNumberOfVerts() == 0);
  REQUIRE(path->GetNumberOfLines() == 1);
  CHECK(path->GetLines()->GetNumberOfConnectivityIds() == 4);
  CHECK(path->GetPoint(3)[0] == 500003.125);
  CHECK(path->GetPoint(3)[1] == 5500000.654321);

  vtkPointData* data = path->GetPointData();
  auto* time = vtkDoubleArray::SafeDownCast(data->GetArray(names::GpsTime));
  auto* orientation = vtkDoubleArray::SafeDownCast(data->GetArray(names::Orientation));
  auto* velocity = vtkDoubleArray::SafeDownCast(data->GetArray(names::Velocity));
  auto* legs = vtkIntArray::SafeDownCast(data->GetArray(names::LegIds));
  REQUIRE(time);
  REQUIRE(orientation);
  REQUIRE(velocity);
  REQUIRE(legs);
  CHECK(time->GetValue(3) == 1e9 + 3.0);
  CHECK(orientation->GetNumberOfComponents() == 4);
  CHECK(orientation->GetComponent(2, 0) == Approx(0.5 * std::sqrt(2.0)));
  CHECK(orientation->GetComponent(2, 3) == Approx(-0.5 * std::sqrt(2.0)));
  CHECK(velocity->GetComponent(2, 1) == 3.0);
  CHECK(legs->GetValue(2) == 2);
}

TEST_CASE("Platform: a single sample is a vertex", "[Platform]")
{
  vtkNew<Steps> platform;
  platform->SetInputData(MakeWaypoints(1));
  platform->Update();
  CHECK(platform->GetOutput()->GetNumberOfVerts() == 1);
  CHECK(platform->GetOutput()->GetNumberOfLines() == 0);
}

TEST_CASE("Platform: leg ids come from the waypoints, field data are passed", "[Platform]")
{
  auto waypoints = MakeWaypoints(3);
  vtkNew<vtkIntArray> legs;
  legs->SetName(names::LegIds);
  for (const int leg : { 7, 9, 11 })
  {
    legs->InsertNextValue(leg);
  }
  waypoints->GetPointData()->AddArray(legs);
  vtkNew<vtkStringArray> crs;
  crs->SetName(names::CRS);
  crs->InsertNextValue("EPSG:25832");
  waypoints->GetFieldData()->AddArray(crs);

  vtkNew<Steps> platform;
  platform->SetInputData(waypoints);
  platform->Update();
  vtkPolyData* path = platform->GetOutput();
  CHECK(path->GetPointData()->GetArray(names::LegIds)->GetTuple1(1) == 9.0);
  CHECK(path->GetFieldData()->GetAbstractArray(names::CRS) == crs.Get());
}

TEST_CASE("Platform: bad waypoints are errors", "[Platform]")
{
  vtkNew<Steps> platform;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(platform);
  auto waypoints = MakeWaypoints(3);
  SECTION("none")
  {
    waypoints = MakeWaypoints(0);
    platform->SetInputData(waypoints);
    platform->Update();
    CHECK(log->HasError("The input has no waypoints; give at least one point."));
  }
  SECTION("no points at all")
  {
    platform->SetInputData(vtkNew<vtkPolyData>());
    platform->Update();
    CHECK(log->HasError("The input has no waypoints; give at least one point."));
  }
  SECTION("not a number")
  {
    waypoints->GetPoints()->SetPoint(1, 0.0, std::numeric_limits<double>::quiet_NaN(), 2.0);
    platform->SetInputData(waypoints);
    platform->Update();
    CHECK(log->HasError("Waypoint 1 is (0, nan, 2); coordinates must be finite numbers."));
  }
  SECTION("infinite")
  {
    waypoints->GetPoints()->SetPoint(2, 0.0, 1.0, std::numeric_limits<double>::infinity());
    platform->SetInputData(waypoints);
    platform->Update();
    CHECK(log->HasError("Waypoint 2 is (0, 1, inf); coordinates must be finite numbers."));
  }
  SECTION("leg ids with two components")
  {
    vtkNew<vtkIntArray> legs;
    legs->SetName(names::LegIds);
    legs->SetNumberOfComponents(2);
    legs->SetNumberOfTuples(3);
    legs->Fill(0);
    waypoints->GetPointData()->AddArray(legs);
    platform->SetInputData(waypoints);
    platform->Update();
    CHECK(
      log->HasError("The point array LegIds of the waypoints must hold one number per waypoint."));
  }
  CHECK(platform->GetOutput()->GetNumberOfPoints() == 0);
}

TEST_CASE("Platform: a failed path has no trajectory", "[Platform]")
{
  vtkNew<Steps> platform;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(platform->GetExecutive());
  platform->Fail = true;
  platform->SetInputData(MakeWaypoints(2));
  platform->Update();
  CHECK(platform->GetOutput()->GetNumberOfPoints() == 0);
  CHECK(log->HasError("returned failure"));
}
