// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPclTesting.h"
#include "vtkHeliosPCLRegistration.h"

#include <vtkCallbackCommand.h>
#include <vtkFloatArray.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkTransform.h>

#include <catch2/catch.hpp>

#include <limits>

namespace names = vtkHeliosArrayNames;

namespace
{

/// Hits of a scanner in a room of 12 x 8 x 3 m with two boxes: rays by equal angles, so that no two
/// scans have a point in common.
helios::Triples ScanRoom(const helios::Triple& scanner, int rows, double turn)
{
  struct Box
  {
    double Bounds[6];
  };
  const Box room = { { -6, 6, -4, 4, 0, 3 } };
  const std::vector<Box> things = { { { 2, 3, -1, 2, 0, 1 } }, { { -4, -3, 1, 2.5, 0, 2 } } };
  helios::Triples points;
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < 2 * rows; ++j)
    {
      const double polar = M_PI * (i + 0.5) / rows;
      const double azimuth = M_PI * j / rows + turn;
      const double d[3] = { std::sin(polar) * std::cos(azimuth),
        std::sin(polar) * std::sin(azimuth), std::cos(polar) };
      const auto cross = [&scanner, &d](const Box& box, double& enter, double& leave)
      {
        enter = -1e9;
        leave = 1e9;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          double t[2];
          for (std::size_t side = 0; side < 2; ++side)
          {
            t[side] = (box.Bounds[2 * axis + side] - scanner[axis]) / d[axis];
          }
          enter = std::max(enter, std::min(t[0], t[1]));
          leave = std::min(leave, std::max(t[0], t[1]));
        }
        return enter < leave;
      };
      double enter = 0.0;
      double range = 0.0;
      cross(room, enter, range);
      for (const Box& thing : things)
      {
        double leave = 0.0;
        if (cross(thing, enter, leave) && enter > 0.0)
        {
          range = std::min(range, enter);
        }
      }
      points.push_back(
        helios::Utm + scanner + helios::Triple{ range * d[0], range * d[1], range * d[2] });
    }
  }
  return points;
}

struct Registering : helios::Filtering<vtkHeliosPCLRegistration>
{
  Registering(vtkPolyData* fixed, vtkPolyData* moving)
    : Filtering(fixed)
  {
    this->Filter->SetInputDataObject(1, moving);
  }
};

/// A rotation about the position in UTM, and a translation.
vtkSmartPointer<vtkTransform> MakeMotion(double degrees, const helios::Triple& shift)
{
  auto motion = vtkSmartPointer<vtkTransform>::New();
  motion->PostMultiply();
  motion->Translate(-helios::Utm[0], -helios::Utm[1], -helios::Utm[2]);
  motion->RotateWXYZ(degrees, 0.1, -0.2, 1.0);
  motion->Translate(helios::Utm.data());
  motion->Translate(shift.data());
  return motion;
}

vtkSmartPointer<vtkPolyData> Move(const helios::Triples& points, vtkTransform* motion)
{
  helios::Triples moved = points;
  for (helios::Triple& p : moved)
  {
    motion->TransformPoint(p.data(), p.data());
  }
  return helios::MakeCloud(moved);
}

/// The largest distance of the output points from their position before the motion.
double GetLargestError(Registering& run, const helios::Triples& truth)
{
  REQUIRE(run.Count() == static_cast<vtkIdType>(truth.size()));
  double largest = 0.0;
  for (vtkIdType i = 0; i < run.Count(); ++i)
  {
    double p[3];
    run.Output()->GetPoint(i, p);
    largest = std::max(largest,
      std::sqrt(vtkMath::Distance2BetweenPoints(p, truth[static_cast<std::size_t>(i)].data())));
  }
  return largest;
}

} // namespace

TEST_CASE(
  "PCLRegistration: scans from two positions, misaligned by 0.3 m and 3 degrees, to below 1 mm",
  "[PCLRegistration]")
{
  const helios::Triples truth = ScanRoom({ 3.5, -2.5, 1.6 }, 110, 0.3);
  const auto fixed = helios::MakeCloud(ScanRoom({ -1.0, -1.0, 1.5 }, 140, 0.0));
  const auto motion = MakeMotion(3.0, { 0.2, -0.2, 0.1 });
  Registering run(fixed, Move(truth, motion));
  const bool isGood = run.Run();
  INFO(run.Log->Errors);
  REQUIRE(isGood);
  CHECK(run.Log->Warnings.empty());
  const double error = GetLargestError(run, truth);
  CHECK(error < 1e-3);
  CHECK(run.Filter->GetNumberOfPairs() > 10000);

  // the matrix agrees: inverse of the motion
  double p[4] = { helios::Utm[0] + 3.0, helios::Utm[1], helios::Utm[2], 1.0 };
  double q[4] = { 0.0, 0.0, 0.0, 1.0 };
  motion->TransformPoint(p, q);
  run.Filter->GetMatrix()->MultiplyPoint(q, q);
  CHECK(std::sqrt(vtkMath::Distance2BetweenPoints(p, q)) < 1e-3);
  vtkDataArray* row = run.GetField(vtkHeliosPCLArrayNames::RegistrationMatrix);
  REQUIRE((row && row->GetNumberOfComponents() == 16));
  CHECK(row->GetComponent(0, 7) == run.Filter->GetMatrix()->GetElement(1, 3));
}

TEST_CASE("PCLRegistration: point to point registers a copy", "[PCLRegistration]")
{
  const helios::Triples truth = ScanRoom({ -1.0, -1.0, 1.5 }, 60, 0.0);
  Registering run(helios::MakeCloud(truth), Move(truth, MakeMotion(1.0, { 0.05, 0.02, -0.03 })));
  run.Filter->PointToPlaneOff();
  REQUIRE(run.Run());
  CHECK(GetLargestError(run, truth) < 1e-3);
  CHECK(run.Filter->GetResidual() < 1e-4);
}

TEST_CASE("PCLRegistration: vectors rotate with the points", "[PCLRegistration]")
{
  const helios::Triples truth = ScanRoom({ -1.0, -1.0, 1.5 }, 60, 0.0);
  const auto moving = Move(truth, MakeMotion(5.0, { 0.0, 0.0, 0.0 }));
  vtkNew<vtkFloatArray> normals;
  normals->SetName(names::Normals);
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(moving->GetNumberOfPoints());
  for (vtkIdType i = 0; i < moving->GetNumberOfPoints(); ++i)
  {
    normals->SetTuple3(i, 1.0, 0.0, 0.0);
  }
  moving->GetPointData()->SetNormals(normals);
  Registering run(helios::MakeCloud(truth), moving);
  run.Filter->PointToPlaneOn();
  REQUIRE(run.Run());
  CHECK(GetLargestError(run, truth) < 1e-3);
  double expected[3] = { 1.0, 0.0, 0.0 };
  MakeMotion(-5.0, { 0.0, 0.0, 0.0 })->TransformVector(expected, expected);
  for (int axis = 0; axis < 3; ++axis)
  {
    CHECK(std::abs(run.Get(names::Normals)->GetComponent(17, axis) - expected[axis]) < 1e-4);
  }
  CHECK(normals->GetComponent(17, 0) == 1.0); // the input's are unchanged
}

TEST_CASE("PCLRegistration: bad input is an error", "[PCLRegistration]")
{
  const helios::Triples room = ScanRoom({ -1.0, -1.0, 1.5 }, 30, 0.0);
  const auto cloud = helios::MakeCloud(room);
  SECTION("no points")
  {
    Registering run(cloud, helios::MakeCloud({}));
    CHECK(run.FailsWith("Input 1: there are no finite points; connect a scan"));
    Registering other(helios::MakeCloud({}), cloud);
    CHECK(other.FailsWith("Input 0: there are no finite points; connect a scan"));
  }
  SECTION("too far apart")
  {
    Registering run(cloud, Move(room, MakeMotion(0.0, { 100.0, 0.0, 0.0 })));
    CHECK(run.FailsWith("only 0 points of input 1 have a point of input 0 within MaximumDistance, "
                        "and 0 of these pairs lie on one plane; align the scans better first"));
  }
  SECTION("no planes")
  {
    helios::Uniform uniform(9);
    helios::Triples leaves;
    for (int i = 0; i < 500; ++i)
    {
      leaves.push_back({ uniform(0, 5), uniform(0, 5), uniform(0, 5) });
    }
    Registering run(helios::MakeCloud(leaves), helios::MakeCloud(leaves));
    run.Filter->SetMaximumCurvature(0.0);
    CHECK(run.FailsWith("only 500 points of input 1 have a point of input 0 within "
                        "MaximumDistance, and 0 of these pairs lie on one plane"));
  }
  SECTION("planes of one orientation")
  {
    helios::Triples floor;
    for (int i = 0; i < 2500; ++i)
    {
      floor.push_back(helios::Utm + helios::Triple{ 0.1 * (i % 50), 0.1 * (i / 50), 0.0 });
    }
    Registering run(helios::MakeCloud(floor), Move(floor, MakeMotion(0.0, { 0.03, 0.02, 0.1 })));
    CHECK(
      run.FailsWith("pairs of points do not determine the motion; scans need surfaces in three"));
  }
  SECTION("too few iterations")
  {
    Registering run(cloud, Move(room, MakeMotion(3.0, { 0.3, 0.2, 0.1 })));
    run.Filter->SetMaximumNumberOfIterations(2);
    REQUIRE(run.Run());
    CHECK(run.Log->HasWarning(
      "MaximumNumberOfIterations is 2, and the registration has not converged; set a larger one"));
  }
  SECTION("points that are not finite")
  {
    helios::Triples some = room;
    some[0][1] = std::numeric_limits<double>::quiet_NaN();
    Registering run(cloud, helios::MakeCloud(some));
    REQUIRE(run.Run());
    CHECK(run.Log->HasWarning("Input 1: 1 points are not finite: dropped"));
    CHECK(run.Count() == cloud->GetNumberOfPoints() - 1);
  }
  SECTION("an abort")
  {
    Registering run(cloud, Move(room, MakeMotion(3.0, { 0.3, 0.2, 0.1 })));
    vtkNew<vtkCallbackCommand> abort;
    abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
      { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
    run.Filter->AddObserver(vtkCommand::ProgressEvent, abort);
    CHECK(run.FailsWith("The work was aborted at 0 %; update again to complete it"));
  }
}
