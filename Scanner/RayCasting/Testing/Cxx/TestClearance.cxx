// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosClearance.h"

#include "heliosErrorObserver.h"
#include "heliosRayCastingScenes.h"
#include "heliosTriangleDistance.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCallbackCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace
{

namespace names = vtkHeliosArrayNames;
using helios::Vec3;

constexpr double None = std::numeric_limits<double>::infinity();

void AddRectangle(helios::Soup& soup, const Vec3& corner, const Vec3& a, const Vec3& b)
{
  soup.AddTriangle(corner, corner + a, corner + a + b);
  soup.AddTriangle(corner, corner + a + b, corner + b);
}

struct Flight
{
  vtkNew<vtkHeliosClearance> Filter;
  vtkNew<vtkPolyData> Path;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  vtkSmartPointer<helios::ErrorObserver> Quiet =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());

  Flight(const helios::Soup& scene, const std::vector<Vec3>& samples)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vec3& p : samples)
    {
      points->InsertNextPoint(p.GetData());
    }
    this->Path->SetPoints(points);
    this->Filter->SetInputData(0, this->Path);
    this->Filter->SetInputData(1, scene.GetPolyData());
    this->Log->Watch(this->Filter);
    this->Quiet->Watch(this->Filter->GetExecutive());
  }

  void SetTimes(std::initializer_list<double> times)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(names::GpsTime);
    for (const double time : times)
    {
      array->InsertNextValue(time);
    }
    this->Path->GetPointData()->AddArray(array);
  }

  std::vector<double> Run()
  {
    this->Filter->Update();
    std::vector<double> values;
    vtkDataArray* array = this->Filter->GetOutput()->GetPointData()->GetArray(names::Clearance);
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      values.push_back(array->GetComponent(i, 0));
    }
    return values;
  }
};

/// A point of a triangle, or of a segment.
Vec3 Pick(const Vec3 corners[3], double u, double v)
{
  return u + v > 1 ? Pick(corners, 1 - u, 1 - v)
                   : corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
}

} // namespace

TEST_CASE("TriangleDistance: known distances", "[Clearance]")
{
  const Vec3 triangle[3] = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } };
  const auto distance = [&triangle](const Vec3& a, const Vec3& b)
  { return helios::SegmentToTriangle(a, b, triangle); };
  CHECK(distance({ 1, 1, 3 }, { 1, 1, 3 }) == 3.0);  // a point above
  CHECK(distance({ 1, 1, 3 }, { 1, 1, -3 }) == 0.0); // through
  CHECK(distance({ 1, 1, 3 }, { 2, 1, 2 }) == 2.0);  // towards
  CHECK(distance({ -9, 1, 2 }, { 9, 1, 2 }) == 2.0); // over an edge and out again
  CHECK(distance({ 5, 5, -3 }, { 5, 5, 3 }) == Approx(std::sqrt(18.0))); // past an edge
  CHECK(distance({ -3, -4, 9 }, { -3, -4, -9 }) == Approx(5));           // past a corner
  CHECK(distance({ -1, 2, 0 }, { -1, 3, 0 }) == Approx(1)); // in its plane, along an edge
  CHECK(distance({ -1, 1, 0 }, { 9, 1, 0 }) == 0.0);        // in its plane, through
  const Vec3 flat[3] = { { 0, 0, 0 }, { 4, 0, 0 }, { 2, 0, 0 } };
  CHECK(helios::SegmentToTriangle({ 1, 3, 0 }, { 3, 5, 0 }, flat) == 3.0);
  CHECK(helios::SegmentToSegment({ 0, 0, 1 }, { 1, 0, 1 }, { 3, 0, 1 }, { 5, 0, 1 }) ==
    2.0); // on one line
}

TEST_CASE("TriangleDistance: is a lower bound that is reached", "[Clearance]")
{
  helios::Dice dice(7);
  for (int i = 0; i < 300; ++i)
  {
    const double size = std::pow(10, dice(-4, 3));
    Vec3 corners[3];
    for (Vec3& corner : corners)
    {
      corner = size * dice.Point(-1, 1);
    }
    const Vec3 a = size * dice.Point(-1, 1);
    const Vec3 b = i % 5 == 0
      ? a + 1e-9 * (corners[1] - corners[0])
      : (i % 5 == 1 ? a + corners[2] - corners[0] : size * dice.Point(-1, 1));
    const double distance = helios::SegmentToTriangle(a, b, corners);
    // The nearest point of a grid, refined about the best.
    double best = None, s0 = 0.5, u0 = 0.5, v0 = 0.5;
    for (double width = 0.5; width > 1e-7; width *= 0.6)
    {
      const double s1 = s0, u1 = u0, v1 = v0;
      for (int k = 0; k < 9 * 9 * 9; ++k)
      {
        const auto at = [width](double x, int step)
        { return std::clamp(x + width * (0.25 * step - 1), 0.0, 1.0); };
        const double s = at(s1, k % 9), u = at(u1, k / 9 % 9), v = at(v1, k / 81);
        if (u + v > 1)
        {
          continue;
        }
        const double d = (a + s * (b - a) - Pick(corners, u, v)).Norm();
        if (d < best)
        {
          best = d;
          s0 = s;
          u0 = u;
          v0 = v;
        }
      }
    }
    INFO("case " << i);
    CHECK(distance <= best + 1e-14 * size);
    CHECK(distance >= best - 1e-4 * size);
  }
}

TEST_CASE("Clearance: distance to a plane, also between samples", "[Clearance]")
{
  helios::Soup scene;
  AddRectangle(scene, { -1000, -1000, 5 }, { 2000, 0, 0 }, { 0, 2000, 0 });
  for (const Vec3& offset : helios::Offsets)
  {
    helios::Soup moved = scene;
    moved.Move(offset);
    Flight flight(moved,
      { offset + Vec3(0, 0, 25), offset + Vec3(500, 0, 35), offset + Vec3(500, 300, 11),
        offset + Vec3(0, 0, 200) });
    for (const int direction : { vtkHeliosClearance::DOWN, vtkHeliosClearance::ALL_AROUND })
    {
      flight.Filter->SetDirection(direction);
      const auto values = flight.Run();
      REQUIRE(values.size() == 4);
      CHECK(values[0] == Approx(20).epsilon(1e-9));
      CHECK(values[1] == Approx(6).epsilon(1e-9));
      CHECK(values[2] == Approx(6).epsilon(1e-9));
      // No surface within the radius of 100 m.
      CHECK(values[3] == (direction == vtkHeliosClearance::DOWN ? Approx(195) : Approx(None)));
      CHECK(flight.Filter->GetSmallestClearance() == Approx(6).epsilon(1e-9));
    }
    CHECK(flight.Log->Warnings.empty());
  }
}

TEST_CASE("Clearance: distance to a step from the side", "[Clearance]")
{
  // Ground at 0, a wall of 30 m at x = 100, a plateau behind it.
  helios::Soup scene;
  AddRectangle(scene, { -500, -500, 0 }, { 600, 0, 0 }, { 0, 1000, 0 });
  AddRectangle(scene, { 100, -500, 0 }, { 0, 0, 30 }, { 0, 1000, 0 });
  AddRectangle(scene, { 100, -500, 30 }, { 600, 0, 0 }, { 0, 1000, 0 });
  Flight flight(scene, { { -400, 0, 20 }, { 92, 0, 20 }, { 92, 0, 36 }, { 300, 0, 36 } });
  const auto around = flight.Run();
  CHECK(around[0] == Approx(8).epsilon(1e-12)); // the wall, at the end of the piece
  CHECK(around[1] == Approx(8).epsilon(1e-12)); // along the wall
  CHECK(around[2] == Approx(6).epsilon(1e-12)); // over the plateau, not 10 from its edge
  CHECK(around[3] == Approx(6).epsilon(1e-12));
  flight.Filter->SetDirectionToDown();
  const auto down = flight.Run();
  CHECK(down[0] == Approx(20).epsilon(1e-12));
  CHECK(down[2] == Approx(6).epsilon(1e-12));
  // Through the wall.
  Flight through(scene, { { 50, 0, 20 }, { 150, 0, 20 } });
  CHECK(through.Run()[0] == 0.0);
  through.Filter->SetDirectionToDown();
  CHECK(through.Run()[1] == Approx(-10)); // under the plateau
  CHECK(through.Log->HasWarning("2 of 2 samples are closer to the scene than MinimumClearance (0 "
                                "m): the first is sample 0 at x 50, y 0, z 20 with -10 m"));
}

TEST_CASE("Clearance: distance to a sphere is that to its centre less the radius", "[Clearance]")
{
  helios::Soup sphere = helios::MakeIcosphere(5);
  sphere.Move({ 10, 20, 30 }, 4.0);
  // The triangles are up to their sagitta inside the sphere.
  const double sagitta = 4.0 * 7e-4;
  std::vector<Vec3> samples;
  std::vector<double> truths;
  helios::Dice dice(3);
  for (int i = 0; i < 100; ++i)
  {
    const Vec3 out = dice.Direction();
    const Vec3 along = out.Cross(dice.Direction()).Normalized();
    const double distance = dice(5, 40);
    const Vec3 nearest = Vec3(10, 20, 30) + distance * out; // point of a segment that passes by
    samples.push_back(nearest - dice(1, 90) * along);
    samples.push_back(nearest + dice(1, 90) * along);
    truths.push_back(distance - 4);
  }
  Flight flight(sphere, samples);
  const auto values = flight.Run();
  for (std::size_t i = 0; i < truths.size(); ++i)
  {
    CHECK(values[2 * i] >= truths[i] - 1e-12);
    CHECK(values[2 * i] <= truths[i] + sagitta);
  }
}

TEST_CASE("Clearance: the tree agrees with brute force", "[Clearance]")
{
  const helios::Soup scene = helios::MakeMixture();
  std::vector<Vec3> samples;
  helios::Dice dice(5);
  for (int i = 0; i < 60; ++i)
  {
    samples.push_back(dice.Point(-2, 2));
  }
  Flight flight(scene, samples);
  flight.Filter->SetRadius(0.7);
  const auto values = flight.Run();
  REQUIRE(values.size() == 60);
  int far = 0;
  for (std::size_t i = 0; i < 60; ++i)
  {
    double truth = None;
    for (const auto& triangle : scene.Triangles)
    {
      const Vec3 corners[3] = { scene.Points[triangle[0]], scene.Points[triangle[1]],
        scene.Points[triangle[2]] };
      if (helios::SpansArea(corners[0].GetData(), corners[1].GetData(), corners[2].GetData()))
      {
        truth = std::min(truth,
          helios::SegmentToTriangle(
            samples[i], samples[std::min<std::size_t>(i + 1, 59)], corners));
      }
    }
    INFO("sample " << i);
    CHECK((truth > 0.7 ? values[i] == None : values[i] == Approx(truth).margin(1e-12)));
    far += truth > 0.3;
  }
  CHECK(far > 0);
}

TEST_CASE("Clearance: jumps are excluded, single samples are included", "[Clearance]")
{
  helios::Soup scene;
  AddRectangle(scene, { -10, -10, 0 }, { 20, 0, 0 }, { 0, 20, 0 });
  Flight flight(scene, { { 0, 0, 9 }, { 1, 0, 8 }, { 1, 0, -5 }, { 2, 0, -6 } });
  flight.SetTimes({ 0, 1, 1, 2 });
  const auto values = flight.Run();
  CHECK(values[0] == Approx(8));
  CHECK(values[1] == Approx(8)); // does not intersect
  CHECK(values[2] == Approx(5));
  CHECK(values[3] == Approx(6));
  Flight tripod(scene, { { 0, 0, 2 } });
  CHECK(tripod.Run()[0] == Approx(2));
  tripod.Path->GetPoints()->SetPoint(0, 0, 0, 0); // on the ground
  tripod.Path->Modified();
  CHECK(tripod.Run()[0] == 0.0);
  tripod.Filter->SetDirectionToDown();
  CHECK(tripod.Run()[0] == 0.0);
  tripod.Path->GetPoints()->SetPoint(0, 50, 0, 3); // beside it
  tripod.Path->Modified();
  CHECK(tripod.Run()[0] == None);
}

TEST_CASE(
  "Clearance: counts values below the minimum, and names the first and the smallest", "[Clearance]")
{
  helios::Soup scene;
  AddRectangle(scene, { -10, -10, 0 }, { 20, 0, 0 }, { 0, 20, 0 });
  Flight flight(scene, { { 0, 0, 9 }, { 1, 0, 9 }, { 2, 0, 4.5 }, { 2, 1, 9 }, { 2, 2, 3 } });
  flight.Filter->SetMinimumClearance(5);
  CHECK(flight.Run().size() == 5);
  CHECK(flight.Filter->GetNumberBelowMinimum() == 4);
  CHECK(flight.Filter->GetFirstBelowMinimum() == 1);
  CHECK(flight.Log->HasWarning(
    "4 of 5 samples are closer to the scene than MinimumClearance (5 m): the first is sample 1 at "
    "x 1, y 0, z 9 with 4.5 m, the nearest sample 3 at x 2, y 1, z 9 with 3 m; move the "
    "trajectory away, or lower MinimumClearance."));
  flight.Filter->FailBelowMinimumOn();
  CHECK(flight.Run().empty());
  CHECK(flight.Log->HasError("4 of 5 samples are closer to the scene than MinimumClearance (5 m)"));
  flight.Filter->SetMinimumClearance(3);
  CHECK(flight.Run().size() == 5);
  CHECK(flight.Filter->GetNumberBelowMinimum() == 0);
  CHECK(flight.Filter->GetFirstBelowMinimum() == -1);
}

TEST_CASE("Clearance: bad input is an error", "[Clearance]")
{
  helios::Soup scene;
  AddRectangle(scene, { -10, -10, 0 }, { 20, 0, 0 }, { 0, 20, 0 });
  Flight flight(scene, { { 0, 0, 9 }, { 1, 0, std::nan("") } });
  CHECK(flight.Run().empty());
  CHECK(flight.Log->HasError("Sample 0 or 1 is not finite; correct it."));
  flight.Path->GetPoints()->SetPoint(1, 0, 0, 0);
  flight.Path->Modified();
  vtkNew<vtkPolyData> empty;
  flight.Filter->SetInputData(1, empty);
  CHECK(flight.Run().empty());
  CHECK(flight.Log->HasError("The scene on port 1 is empty; connect the surfaces"));
  scene.Points[0][0] = std::nan("");
  flight.Filter->SetInputData(1, scene.GetPolyData());
  CHECK(flight.Run().empty());
  CHECK(flight.Log->HasError(
    "The scene on port 1 is not valid: cell 0 of the scene has a corner that is not finite"));
  scene.Points[0][0] = -10;
  flight.Filter->SetInputData(1, scene.GetPolyData());
  CHECK(flight.Run().size() == 2);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* filter, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1); });
  flight.Filter->AddObserver(vtkCommand::ProgressEvent, stop);
  flight.Filter->Modified();
  CHECK(flight.Run().empty());
  CHECK(flight.Log->HasError("Aborted at sample 0; update again to complete the trajectory."));
}
