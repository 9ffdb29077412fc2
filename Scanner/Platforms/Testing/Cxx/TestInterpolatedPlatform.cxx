// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosPose.h"
#include "heliosWaypointTesting.h"
#include "vtkHeliosInterpolatedPlatform.h"

#include <catch2/catch.hpp>
#include <vtkCellArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;

namespace
{

constexpr double NotGiven = std::numeric_limits<double>::quiet_NaN();

/// t, x, y, z and yaw, anticlockwise [deg].
using Row = std::array<double, 5>;

vtkSmartPointer<vtkPolyData> MakeRecord(const std::vector<Row>& rows)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> times, orientations;
  times->SetName(names::GpsTime);
  orientations->SetName(names::Orientation);
  orientations->SetNumberOfComponents(4);
  for (const Row& row : rows)
  {
    points->InsertNextPoint(&row[1]);
    times->InsertNextValue(row[0]);
    orientations->InsertNextTuple(helios::AxisAngle({ 0, 0, 1 }, row[4]).GetData());
  }
  auto record = vtkSmartPointer<vtkPolyData>::New();
  record->SetPoints(points);
  record->GetPointData()->AddArray(times);
  record->GetPointData()->AddArray(orientations);
  return record;
}

/// A sample per second from 100 s to 110 s at 2 m/s along x, turning by 15 deg/s.
vtkSmartPointer<vtkPolyData> MakeFlight()
{
  std::vector<Row> rows;
  for (int i = 0; i <= 10; ++i)
  {
    rows.push_back({ 100.0 + i, 2.0 * i, 5.0, 400.0, 300.0 + 15.0 * i });
  }
  return MakeRecord(rows);
}

struct Flight
{
  vtkNew<vtkHeliosInterpolatedPlatform> Platform;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  vtkSmartPointer<helios::ErrorObserver> Quiet =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());

  explicit Flight(vtkPolyData* record)
  {
    this->Platform->SetInputData(record);
    this->Log->Watch(this->Platform);
    this->Quiet->Watch(this->Platform->GetExecutive());
  }

  vtkPolyData* Run()
  {
    this->Platform->Update();
    return this->Platform->GetOutput();
  }
};

/// Times, x and leg of the samples.
std::string Describe(vtkPolyData* path)
{
  std::string text;
  for (vtkIdType i = 0; i < path->GetNumberOfPoints(); ++i)
  {
    char sample[64];
    std::snprintf(sample, sizeof sample, "%s%g:%g(%g)", i > 0 ? " " : "",
      helios::Value(path, names::GpsTime, i), path->GetPoint(i)[0],
      helios::Value(path, names::LegIds, i));
    text += sample;
  }
  return text;
}

bool Heads(vtkPolyData* path, vtkIdType sample, double yaw)
{
  const helios::Point forward = helios::BodyToWorld(path, sample, { 0.0, 1.0, 0.0 });
  const double a = vtkMath::RadiansFromDegrees(yaw);
  return std::hypot(forward[0] + std::sin(a), forward[1] - std::cos(a)) < 1e-12;
}

} // namespace

TEST_CASE(
  "InterpolatedPlatform: a complete record, its clock from StartTime", "[InterpolatedPlatform]")
{
  auto record = MakeFlight();
  vtkNew<vtkStringArray> crs;
  crs->SetName(names::CRS);
  record->GetFieldData()->AddArray(crs);
  Flight flight(record);
  flight.Platform->SetStartTime(7);
  vtkPolyData* path = flight.Run();
  REQUIRE(path->GetNumberOfPoints() == 11);
  CHECK(path->GetNumberOfLines() == 1);
  CHECK(path->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(path->GetFieldData()->GetAbstractArray(names::CRS) == crs.Get());
  CHECK_FALSE(path->GetPointData()->HasArray(names::Velocity)); // linear
  for (vtkIdType i = 0; i < 11; ++i)
  {
    const auto t = static_cast<double>(i);
    CHECK(helios::Value(path, names::GpsTime, i) == 7 + t);
    CHECK(helios::Value(path, names::LegIds, i) == 0);
    CHECK(path->GetPoint(i)[0] == 2 * t);
    CHECK(Heads(path, i, 300 + 15 * t));
  }
  flight.Platform->KeepFileTimesOn();
  CHECK(helios::Value(flight.Run(), names::GpsTime, 3) == 103.0);
}

TEST_CASE("InterpolatedPlatform: a leg starts and ends between samples", "[InterpolatedPlatform]")
{
  Flight flight(MakeFlight());
  flight.Platform->AddLeg(103.25, 105.5, false);
  vtkPolyData* path = flight.Run();
  CHECK(Describe(path) == "0:6.5(0) 0.75:8(0) 1.75:10(0) 2.25:11(0)");
  CHECK(Heads(path, 0, 300 + 15 * 3.25)); // through 360 degrees
  CHECK(Heads(path, 3, 300 + 15 * 5.5));
  flight.Platform->RemoveAllLegs();
  flight.Platform->AddLeg(103.25, 103.75, false); // inside one piece
  CHECK(Describe(flight.Run()) == "0:6.5(0) 0.5:7.5(0)");
  flight.Platform->RemoveAllLegs();
  flight.Platform->AddLeg(NotGiven, 101, false);
  flight.Platform->AddLeg(109, NotGiven, true);
  CHECK(Describe(flight.Run()) == "0:0(0) 1:2(0) 1:18(1) 2:20(1)");
}

TEST_CASE("InterpolatedPlatform: the attitude rotates along the shorter arc at a constant rate",
  "[InterpolatedPlatform]")
{
  auto record = MakeRecord(
    { { 0, 0, 0, 0, 350 }, { 1, 0, 0, 0, 370 }, { 2, 0, 0, 0, 369 }, { 3, 0, 0, 0, 369 + 170 } });
  // The same attitude as its negative.
  vtkDataArray* q = record->GetPointData()->GetArray(names::Orientation);
  q->SetTuple4(1, -q->GetComponent(1, 0), 0, 0, -q->GetComponent(1, 3));
  for (int k = 1; k < 10; ++k)
  {
    const double s = 0.1 * k;
    Flight flight(record);
    flight.Platform->AddLeg(s, 1 + s, false);
    flight.Platform->AddLeg(1 + s, 2 + s, false);
    vtkPolyData* path = flight.Run();
    REQUIRE(path->GetNumberOfPoints() == 6);
    CHECK(Heads(path, 0, 350 + 20 * s));
    CHECK(Heads(path, 2, 370 - s));
    CHECK(Heads(path, 3, 370 - s));
    CHECK(Heads(path, 5, 369 + 170 * s));
  }
}

TEST_CASE("InterpolatedPlatform: transitions between legs", "[InterpolatedPlatform]")
{
  Flight flight(MakeFlight());
  SECTION("one behind the other")
  {
    flight.Platform->AddLeg(101, 102, false);
    flight.Platform->AddLeg(102, 103.5, false);
    CHECK(Describe(flight.Run()) == "0:2(0) 1:4(0) 1:4(1) 2:6(1) 2.5:7(1)");
  }
  SECTION("the interval between legs is flown without a leg")
  {
    flight.Platform->AddLeg(101, 102, false);
    flight.Platform->AddLeg(104, 105, false);
    CHECK(Describe(flight.Run()) == "0:2(0) 1:4(0) 1:4(-1) 2:6(-1) 3:8(-1) 3:8(1) 4:10(1)");
    flight.Platform->KeepFileTimesOn();
    CHECK(Describe(flight.Run()) ==
      "101:2(0) 102:4(0) 102:4(-1) 103:6(-1) 104:8(-1) 104:8(1) 105:10(1)");
  }
  SECTION("teleporting takes no time")
  {
    flight.Platform->AddLeg(101, 102, true);
    flight.Platform->AddLeg(104, 105, true);
    flight.Platform->AddLeg(100, 100.5, true);
    CHECK(Describe(flight.Run()) == "0:2(0) 1:4(0) 1:8(1) 2:10(1) 2:0(2) 2.5:1(2)");
    CHECK(flight.Log->Warnings.empty());
  }
  SECTION("with KeepFileTimes it waits")
  {
    flight.Platform->AddLeg(101, 102, true);
    flight.Platform->AddLeg(104, 105, true);
    flight.Platform->KeepFileTimesOn();
    vtkPolyData* path = flight.Run();
    CHECK(Describe(path) == "101:2(0) 102:4(0) 102:4(-1) 104:4(-1) 104:8(1) 105:10(1)");
    CHECK(Heads(path, 3, 330));
  }
  SECTION("backwards without teleporting is an error")
  {
    flight.Platform->AddLeg(104, 105, false);
    flight.Platform->AddLeg(101, 102, false);
    CHECK(Describe(flight.Run()) == "0:8(0) 1:10(0) 1:2(1) 2:4(1)");
    CHECK(flight.Log->HasWarning("Leg 1 starts at 101 s of the recorded times, before leg 0 ends, "
                                 "at 105 s: the platform jumps back to an earlier position."));
  }
}

TEST_CASE("InterpolatedPlatform: a leg to a jump ends before it, a leg from a jump starts after it",
  "[InterpolatedPlatform]")
{
  Flight flight(MakeRecord(
    { { 0, 0, 0, 0, 0 }, { 1, 10, 0, 0, 0 }, { 1, 50, 0, 0, 90 }, { 2, 60, 0, 0, 90 } }));
  CHECK(Describe(flight.Run()) == "0:0(0) 1:10(0) 1:50(0) 2:60(0)");
  flight.Platform->AddLeg(0.5, 1, false);
  flight.Platform->AddLeg(1, 1.5, false);
  vtkPolyData* path = flight.Run();
  CHECK(Describe(path) == "0:5(0) 0.5:10(0) 0.5:50(1) 1:55(1)");
  CHECK(Heads(path, 1, 0));
  CHECK(Heads(path, 2, 90));
}

TEST_CASE("InterpolatedPlatform: several records in sequence", "[InterpolatedPlatform]")
{
  Flight flight(MakeRecord({ { 20, 2, 0, 0, 0 }, { 21, 3, 0, 0, 0 } }));
  flight.Platform->AddInputData(0, MakeRecord({ { 10, 0, 0, 0, 0 }, { 12, 1, 0, 0, 0 } }));
  flight.Platform->AddInputData(0, MakeRecord({ { 21, 7, 0, 0, 0 }, { 23, 9, 0, 0, 0 } }));
  CHECK(Describe(flight.Run()) == "0:0(0) 2:1(0) 10:2(0) 11:3(0) 11:7(0) 13:9(0)");
  CHECK(flight.Platform->GetOutput()->GetPoints()->GetDataType() == VTK_DOUBLE);
  flight.Platform->AddInputData(0, MakeRecord({ { 22.5, 7, 0, 0, 0 }, { 24, 9, 0, 0, 0 } }));
  flight.Run();
  CHECK(flight.Log->HasError("Trajectory 3 starts at 22.5 s, before trajectory 2 ends, at 23 s; "
                             "connect each once, and cut them where they overlap."));
}

TEST_CASE("InterpolatedPlatform: records after the end of a week or day follow those before it",
  "[InterpolatedPlatform]")
{
  const auto [period, name] = GENERATE(table<double, std::string>(
    { { 604800.0, "a GPS week ends between them" }, { 86400.0, "a day ends between them" } }));
  Flight flight(MakeRecord({ { 1, 5, 0, 0, 0 }, { 2, 6, 0, 0, 0 } }));
  flight.Platform->AddInputData(0, MakeRecord({ { 3, 7, 0, 0, 0 }, { 4, 8, 0, 0, 0 } }));
  flight.Platform->AddInputData(
    0, MakeRecord({ { period - 3, 1, 0, 0, 0 }, { period - 1, 3, 0, 0, 0 } }));
  CHECK(Describe(flight.Run()) == "0:1(0) 2:3(0) 4:5(0) 5:6(0) 6:7(0) 7:8(0)");
  CHECK(flight.Log->HasWarning("Trajectory 0 starts at 1 s, after the end of trajectory 2 at"));
  CHECK(flight.Log->HasWarning(name + ", and its times continue with"));
  flight.Platform->KeepFileTimesOn();
  CHECK(helios::Value(flight.Run(), names::GpsTime, 5) == period + 4);
}

TEST_CASE("InterpolatedPlatform: records of two clocks are an error", "[InterpolatedPlatform]")
{
  Flight flight(MakeRecord({ { 345600, 5, 0, 0, 0 }, { 345602, 6, 0, 0, 0 } }));
  flight.Platform->AddInputData(
    0, MakeRecord({ { 1.42e9, 7, 0, 0, 0 }, { 1.42e9 + 1, 8, 0, 0, 0 } }));
  flight.Run();
  CHECK(flight.Log->HasError("Trajectory 1 starts at 1420000000 s, trajectory 0 ends at 345602 s: "
                             "these are times of two clocks, such as seconds of a GPS week and GPS "
                             "time since 1980; give all trajectories times of one."));
}

TEST_CASE("InterpolatedPlatform: cubic interpolation uses the velocity of parabolas",
  "[InterpolatedPlatform]")
{
  std::vector<Row> rows; // x = t^2, y = 3 t - t^2 at irregular times
  for (const double t : { 0.0, 1.0, 1.5, 4.0, 5.0 })
  {
    rows.push_back({ t, t * t, 3 * t - t * t, 7, 0 });
  }
  auto record = MakeRecord(rows);
  Flight flight(record);
  flight.Platform->SetInterpolationToCubic();
  flight.Platform->AddLeg(0, 2.75, false);
  flight.Platform->AddLeg(2.75, 5, false);
  vtkPolyData* path = flight.Run();
  REQUIRE(path->GetNumberOfPoints() == 7);
  for (vtkIdType i = 0; i < 7; ++i)
  {
    const double t = helios::Value(path, names::GpsTime, i);
    INFO("time " << t);
    CHECK(path->GetPoint(i)[0] == Approx(t * t).margin(1e-14));
    CHECK(path->GetPoint(i)[1] == Approx(3 * t - t * t).margin(1e-14));
    CHECK(helios::Value(path, names::Velocity, i, 0) == Approx(2 * t).margin(1e-14));
    CHECK(helios::Value(path, names::Velocity, i, 1) == Approx(3 - 2 * t).margin(1e-14));
    CHECK(helios::Value(path, names::Velocity, i, 2) == 0.0);
  }
  SECTION("or that of the input: a cubic is exact")
  {
    vtkNew<vtkDoubleArray> velocity;
    velocity->SetName(names::Velocity);
    velocity->SetNumberOfComponents(3);
    for (Row& row : rows)
    {
      row[1] = row[0] * row[0] * row[0];
      velocity->InsertNextTuple3(3 * row[0] * row[0], 0, 0);
    }
    record = MakeRecord(rows);
    record->GetPointData()->AddArray(velocity);
    flight.Platform->SetInputData(record);
    path = flight.Run();
    CHECK(path->GetPoint(3)[0] == Approx(std::pow(2.75, 3)).epsilon(1e-14));
    CHECK(helios::Value(path, names::Velocity, 3) == Approx(3 * 2.75 * 2.75).epsilon(1e-14));
    velocity->SetComponent(2, 1, std::numeric_limits<double>::infinity());
    record->Modified();
    flight.Run();
    CHECK(flight.Log->HasError(
      "Trajectory 0 sample 2 has a Velocity that is not finite; correct or remove it."));
  }
  SECTION("a jump is not interpolated")
  {
    flight.Platform->RemoveAllLegs();
    flight.Platform->SetInputData(
      MakeRecord({ { 0, 0, 0, 0, 0 }, { 1, 1, 0, 0, 0 }, { 1, 50, 0, 0, 0 }, { 3, 54, 0, 0, 0 } }));
    path = flight.Run();
    const double speeds[4] = { 1, 1, 2, 2 };
    for (vtkIdType i = 0; i < 4; ++i)
    {
      CHECK(helios::Value(path, names::Velocity, i) == speeds[i]);
    }
  }
}

TEST_CASE("InterpolatedPlatform: a single sample is static", "[InterpolatedPlatform]")
{
  Flight flight(MakeRecord({ { 50, 1, 2, 3, 90 } }));
  vtkPolyData* path = flight.Run();
  CHECK(Describe(path) == "0:1(0)");
  CHECK(path->GetNumberOfVerts() == 1);
  CHECK(Heads(path, 0, 90));
}

TEST_CASE("InterpolatedPlatform: bad input is an error", "[InterpolatedPlatform]")
{
  auto record = MakeFlight();
  Flight flight(record);
  const auto fails = [&flight, &record](const std::string& message)
  {
    record->Modified();
    return flight.Run()->GetNumberOfPoints() == 0 && flight.Log->HasError(message);
  };
  SECTION("legs")
  {
    flight.Platform->AddLeg(103, 103, false);
    CHECK(fails("Leg 0 starts at 103 s and ends at 103 s; its end must be later."));
    flight.Platform->RemoveAllLegs();
    flight.Platform->AddLeg(100, 101, false);
    flight.Platform->AddLeg(105, 110.25, false);
    CHECK(fails("Leg 1 covers 105 s to 110.25 s, but the recorded times are 100 s to 110 s; "
                "give times within them."));
    flight.Platform->RemoveAllLegs();
    flight.Platform->AddLeg(99, 101, false);
    CHECK(fails("Leg 0 covers 99 s to 101 s, but"));
  }
  SECTION("times that cannot be stored")
  {
    flight.Platform->KeepFileTimesOn();
    flight.Platform->AddLeg(104, 105, true);
    flight.Platform->AddLeg(101, 102, true);
    CHECK(fails("Leg 1 starts at 101 s, before leg 0 ends, at 105 s; times must increase; switch "
                "KeepFileTimes off or sort the legs."));
    flight.Platform->RemoveAllLegs();
    record = MakeRecord({ { -1, 0, 0, 0, 0 }, { 1, 1, 0, 0, 0 } });
    flight.Platform->SetInputData(record);
    CHECK(fails("Leg 0 covers -1 s to 1 s; kept times must lie between 0 and 1e12 s"));
  }
  SECTION("samples")
  {
    vtkPointData* data = record->GetPointData();
    data->GetArray(names::GpsTime)->SetTuple1(4, 90);
    CHECK(fails("Trajectory 0 sample 4 is earlier than the previous one; sort the samples by "));
    data->GetArray(names::GpsTime)->SetTuple1(4, NotGiven);
    CHECK(fails("Trajectory 0 sample 4 is not finite; correct or remove it."));
    data->GetArray(names::Orientation)->SetTuple4(3, 1, 1, 0, 0);
    CHECK(fails(
      "Trajectory 0 sample 3 has an Orientation that is not a unit quaternion; normalize it."));
    data->RemoveArray(names::Orientation);
    CHECK(fails("Trajectory 0 needs the point arrays GpsTime (1 component) and Orientation (4)"));
    record->Initialize();
    CHECK(fails("Trajectory 0 has no samples; connect a vtkHeliosTrajectoryReader."));
  }
  SECTION("no input")
  {
    flight.Platform->RemoveAllInputConnections(0);
    flight.Platform->Update();
    CHECK(flight.Quiet->HasError("Input port 0"));
  }
}
