// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Compares scenes whose parts move with copies of them at rest.
#include "heliosMovingInstances.h"

#include "heliosConeGroup.h"
#include "heliosConeProbe.h"
#include "heliosMessages.h"
#include "heliosSceneGeometry.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosRayCasterFactory.h"
#include "vtkHeliosScene.h"
#include "vtkHeliosSceneMotion.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using helios::Motion;
using helios::MotionKind;
using helios::MotionSequence;
using helios::Vec3;

namespace
{

/// Random triangles of three parts in a box, each with a duplicate in the next part at the same
/// place; and a separate one of part 1. Part 1 is raised by lift.
vtkSmartPointer<vtkPolyData> MakeScene(double lift, bool onlyMoving)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-10.0, 10.0);
  std::uniform_real_distribution<double> size(-2.0, 2.0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkHeliosArrayNames::PartIds);
  for (int i = 0; i < 200; ++i)
  {
    const double p[3] = { place(random), place(random), place(random) };
    double corners[3][3];
    for (auto& corner : corners)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        corner[axis] = p[axis] + size(random);
      }
    }
    for (const int part : { i % 3, (i + 1) % 3 })
    {
      vtkIdType cell[3];
      for (int k = 0; k < 3; ++k)
      {
        const double up = part == 1 ? lift : 0.0;
        cell[k] = points->InsertNextPoint(corners[k][0], corners[k][1], corners[k][2] + up);
      }
      polys->InsertNextCell(3, cell);
      ids->InsertNextValue(onlyMoving ? 1 : part);
    }
  }
  const vtkIdType lone[3] = { points->InsertNextPoint(30, 0, lift),
    points->InsertNextPoint(40, 0, lift), points->InsertNextPoint(30, 10, lift) };
  polys->InsertNextCell(3, lone);
  ids->InsertNextValue(1);
  auto scene = vtkSmartPointer<vtkPolyData>::New();
  scene->SetPoints(points);
  scene->SetPolys(polys);
  scene->GetCellData()->AddArray(ids);
  return scene;
}

/// Makes instances of the triangles at three places; cell ids of two of them are between the ids of
/// the mesh.
vtkSmartPointer<vtkPolyData> MakeInstances(double lift, bool onlyMoving)
{
  auto scene = vtkSmartPointer<vtkHeliosScene>::New();
  scene->ShallowCopy(MakeScene(lift, onlyMoving));
  scene->AddPrototype(MakeScene(0.0, false));
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  places->InsertNextPoint(0.0, 0.0, 0.0); // triangles at the place of the mesh
  places->InsertNextPoint(3.0, 1.0, -5.0);
  places->InsertNextPoint(-8.0, 2.0, 9.0);
  vtkNew<vtkIdTypeArray> first;
  first->SetName(vtkHeliosArrayNames::FirstCellIds);
  const vtkIdType count = scene->GetNumberOfPolys();
  first->InsertNextValue(20);
  first->InsertNextValue(100 + count);
  first->InsertNextValue(3 * count);
  vtkNew<vtkIntArray> prototypes;
  prototypes->SetName(vtkHeliosArrayNames::PrototypeIds);
  prototypes->SetNumberOfValues(3);
  prototypes->Fill(0);
  vtkNew<vtkPolyData> instances;
  instances->SetPoints(places);
  instances->GetPointData()->AddArray(first);
  instances->GetPointData()->AddArray(prototypes);
  scene->SetInstances(instances);
  return scene;
}

/// Rays from below, four per beam.
std::vector<vtkHeliosRay> MakeRays()
{
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(-10.0, 10.0);
  std::uniform_real_distribution<double> slope(-0.01, 0.01);
  std::vector<vtkHeliosRay> rays;
  for (int i = 0; i < 2000; ++i)
  {
    const double x = place(random);
    const double y = place(random);
    for (int k = 0; k < 4; ++k)
    {
      rays.push_back({ { x, y, -30.0 }, { slope(random), slope(random), 1.0 } });
    }
  }
  rays.push_back({ { 33.0, 3.0, -50.0 }, { 0.0, 0.0, 1.0 } }); // to the separate triangle
  rays.insert(rays.end(), 3, rays.back());
  return rays;
}

/// A scene of three parts, of which part 1 steps at every tenth pulse.
helios::SceneData MakeData(const std::vector<MotionSequence>& sequences, bool isContinuous)
{
  helios::SceneData data;
  data.Parts.resize(3);
  data.Parts[1].Motion.Sequences = sequences;
  data.Parts[1].Motion.Pulses = 10;
  data.Parts[1].Motion.IsContinuous = isContinuous;
  return data;
}

std::vector<MotionSequence> Repeat(const std::vector<Motion>& motions)
{
  MotionSequence sequence;
  sequence.Motions = motions;
  return { sequence };
}

Motion MakeMotion(MotionKind kind, const Vec3& vector, double angle = 0.0, bool isSelf = false)
{
  Motion motion;
  motion.Kind = kind;
  motion.Vector = vector;
  motion.Angle = angle;
  motion.IsSelf = isSelf;
  return motion;
}

/// The mesh of a scene, whose part 1 has made some steps.
vtkSmartPointer<vtkPolyData> MoveMesh(
  vtkPolyData* scene, const std::vector<MotionSequence>& sequences, vtkIdType step)
{
  vtkNew<vtkPolyData> mesh; // without instances
  mesh->ShallowCopy(scene);
  vtkNew<vtkHeliosSceneMotion> filter;
  filter->SetInputData(mesh);
  filter->SetMotion(1, sequences);
  filter->SetStep(1, step);
  filter->Update();
  auto moved = vtkSmartPointer<vtkPolyData>::Take(scene->NewInstance());
  moved->ShallowCopy(scene);
  moved->SetPoints(filter->GetOutput()->GetPoints());
  return moved;
}

} // namespace

TEST_CASE("MovingInstances: hits and cones equal those of copies at every step, to the last bit",
  "[MovingInstances]")
{
  const bool onlyMoving = GENERATE(false, true);
  const bool hasInstances = GENERATE(false, true);
  const std::vector<MotionSequence> sequences =
    GENERATE(Repeat({ MakeMotion(MotionKind::Translation, Vec3(0.3, -0.1, 1.5)) }),
      Repeat({ MakeMotion(MotionKind::Rotation, Vec3(1, 2, 3), 25.0),
        MakeMotion(MotionKind::Translation, Vec3(0.01, 0, 0.5)) }),
      Repeat({ MakeMotion(MotionKind::Rotation, Vec3(0, 1, 0), -40.0, true) }),
      Repeat({ MakeMotion(MotionKind::RotaryReflection, Vec3(1, 0, 1), 30.0) }));
  const auto scene =
    hasInstances && !onlyMoving ? MakeInstances(0.0, false) : MakeScene(0.0, onlyMoving);
  const auto data = MakeData(sequences, false);
  vtkNew<vtkObject> owner;
  helios::Messages log(owner);
  const helios::MovingInstances parts(data, scene, {}, helios::AngleConvention::Arinc705, log);
  REQUIRE(parts.IsMoving());
  const auto kind =
    vtkSmartPointer<vtkHeliosRayCaster>::Take(vtkHeliosRayCasterFactory::Create("beam"));
  const auto base =
    vtkSmartPointer<vtkHeliosRayCaster>::Take(vtkHeliosRayCasterFactory::Create("beam"));
  REQUIRE(base->Build(parts.GetScene()));
  const auto moving = base->MakeMoving(parts.MakeMotions({ 0, 0.0, 1000.0 }));
  REQUIRE(moving);
  const helios::ConeProbe* ofMoving = moving->GetConeProbe();
  REQUIRE(ofMoving);
  const auto rays = MakeRays();
  const auto count = static_cast<vtkIdType>(rays.size());
  std::vector<vtkHeliosHit> expected(rays.size());
  std::vector<vtkHeliosHit> hits(rays.size());
  const double up[3] = { 0, 0, 1 };
  for (const vtkIdType step : { 0, 1, 7, 30, 2 })
  {
    INFO("step " << step);
    REQUIRE(kind->Build(MoveMesh(scene, sequences, step)));
    const vtkIdType pulse = 10 * step + 3;
    moving->MoveTo({ pulse, 0.001 * static_cast<double>(pulse) });
    kind->Intersect(rays.data(), expected.data(), count);
    int wrong = 0;
    int numberOfHits = 0;
    for (const int raysPerBeam : { 1, 4 })
    {
      moving->IntersectBeams(rays.data(), hits.data(), raysPerBeam, count / raysPerBeam);
      for (std::size_t i = 0; i < hits.size(); ++i)
      {
        const bool isSame =
          hits[i].CellId == expected[i].CellId && hits[i].Range == expected[i].Range;
        wrong += isSame ? 0 : 1;
        numberOfHits += hits[i].CellId >= 0 ? 1 : 0;
      }
    }
    CHECK(wrong == 0);
    CHECK(numberOfHits > 100);
    std::vector<unsigned char> occluded(rays.size());
    moving->Occluded(rays.data(), occluded.data(), count);
    int numberOfCones = 0;
    const helios::ConeProbe* ofKind = kind->GetConeProbe();
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      const vtkHeliosConeHit whole = ofKind->Probe(rays[i].Origin, up, 0.001, 0.01);
      const vtkHeliosConeHit hit = ofMoving->Probe(rays[i].Origin, up, 0.001, 0.01);
      const vtkIdType cell = expected[i].CellId;
      const bool isSame = (occluded[i] != 0) == (cell >= 0) && hit.Kind == whole.Kind &&
        hit.CellId == whole.CellId && hit.Range == whole.Range &&
        (cell < 0 || moving->GetGeometry().GetNormal(cell) == kind->GetGeometry().GetNormal(cell));
      wrong += isSame ? 0 : 1;
      numberOfCones += hit.Kind == vtkHeliosConeHit::PlanarFootprint ? 1 : 0;
    }
    CHECK(wrong == 0);
    CHECK(numberOfCones > 0);
  }
}

TEST_CASE("MovingInstances: a part that moves continuously is where it is at the pulse's time",
  "[MovingInstances]")
{
  const auto scene = MakeScene(0.0, false);
  const auto sequences = Repeat({ MakeMotion(MotionKind::Rotation, Vec3(0, 0, 1), 90.0, true),
    MakeMotion(MotionKind::Translation, Vec3(1.0, 0, 2.0)) });
  vtkNew<vtkObject> owner;
  helios::Messages log(owner);
  const helios::MovingInstances parts(
    MakeData(sequences, true), scene, {}, helios::AngleConvention::Arinc705, log);
  const auto motions = parts.MakeMotions({ 0, 0.0, 1000.0 });
  const auto track = motions->MakeTrack(0);
  helios::Similarity first, second;
  const double own[6] = { -10, 10, -10, 10, -10, 10 };
  for (const double time : { 0.0, 0.0004, 0.0123, 0.5 })
  {
    const auto pulse = static_cast<vtkIdType>(time * 1000.0);
    track->Move({ pulse, time }, first);
    const helios::Pose pose = track->GetPose({ pulse, time });
    CHECK((pose.Position - time * 100.0 * Vec3(1.0, 0.0, 2.0)).Norm() < 1e-12);
    const double angle = time * 100.0 * vtkMath::Pi() / 2.0;
    CHECK(
      std::abs(pose.Orientation.GetW()) == Approx(std::abs(std::cos(0.5 * angle))).margin(1e-9));
    // velocities are derivatives
    const Vec3 p(3.0, -4.0, 5.0);
    Vec3 before, after;
    const double h = 1e-7;
    first.Apply(p.GetData(), before.GetData());
    track->Move({ pulse, time + h }, second);
    second.Apply(p.GetData(), after.GetData());
    const Vec3 velocity = track->GetVelocity({ pulse, time }, before);
    CHECK(((1.0 / h) * (after - before) - velocity).Norm() < 0.3);
    CHECK(velocity.Norm() > 100.0);
    // boxes hold it all over a span
    double box[6];
    const helios::MomentSpan span = motions->GetSpan({ pulse, time }, 16);
    REQUIRE(span.Has({ pulse, time }));
    track->ComputeBounds(span, own, box);
    for (int i = 0; i <= 50; ++i)
    {
      track->Move({ pulse, span.Start + i * (span.End - span.Start) / 50.0 }, first);
      for (int corner = 0; corner < 8; ++corner)
      {
        const double q[3] = { corner & 1 ? 10.0 : -10.0, corner & 2 ? 10.0 : -10.0,
          corner & 4 ? 10.0 : -10.0 };
        Vec3 at;
        first.Apply(q, at.GetData());
        for (int axis = 0; axis < 3; ++axis)
        {
          REQUIRE(at[axis] >= box[2 * axis]);
          REQUIRE(at[axis] <= box[2 * axis + 1]);
        }
      }
    }
  }
}

TEST_CASE("MovingInstances: a group of cones meets what moves only while it is at rest",
  "[MovingInstances]")
{
  // a plate of part 1 above a floor of part 0
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkHeliosArrayNames::PartIds);
  for (const int part : { 0, 1 })
  {
    const double half = part == 0 ? 50.0 : 1.0;
    const vtkIdType first = points->InsertNextPoint(-3 * half, -half, part);
    points->InsertNextPoint(3 * half, -half, part);
    points->InsertNextPoint(0, 3 * half, part);
    polys->InsertNextCell({ first, first + 1, first + 2 });
    ids->InsertNextValue(part);
  }
  vtkNew<vtkPolyData> scene;
  scene->SetPoints(points);
  scene->SetPolys(polys);
  scene->GetCellData()->AddArray(ids);
  const bool isContinuous = GENERATE(false, true);
  const auto data =
    MakeData(Repeat({ MakeMotion(MotionKind::Translation, Vec3(0, 0, 0.1)) }), isContinuous);
  vtkNew<vtkObject> owner;
  helios::Messages log(owner);
  const helios::MovingInstances parts(data, scene, {}, helios::AngleConvention::Arinc705, log);
  const auto base =
    vtkSmartPointer<vtkHeliosRayCaster>::Take(vtkHeliosRayCasterFactory::Create("beam"));
  REQUIRE(base->Build(parts.GetScene()));
  const auto moving = base->MakeMoving(parts.MakeMotions({ 0, 0.0, 1000.0 }));
  const auto find = [&](double x, vtkIdType first, vtkIdType last)
  {
    const helios::ConeAxis cones[2] = { { { x, 0, 20 }, { 0, 0, -1 } },
      { { x + 0.1, 0, 20 }, { 0, 0, -1 } } };
    helios::ConeGroup group;
    const auto getTime = [](vtkIdType pulse) { return 0.001 * static_cast<double>(pulse); };
    moving->MoveTo({ first, getTime(first) });
    const bool isFound = moving->GetConeProbe()->FindGroup(
      cones, 2, 0.01, { first, last, getTime(first), getTime(last) }, group);
    return isFound ? group.GetNumberOfTriangles() : 0;
  };
  CHECK(find(0.0, 11, 19) == (isContinuous ? 0 : 2)); // within a step of ten pulses
  CHECK(find(0.0, 11, 20) == 0);
  CHECK(find(20.0, 11, 20) == 1);      // beside the plate
  CHECK(find(20.0, 11, 1 << 30) == 0); // beyond the boxes
}

TEST_CASE("MovingInstances: a scene at rest is not touched", "[MovingInstances]")
{
  const auto scene = MakeScene(0.0, false);
  vtkNew<vtkObject> owner;
  helios::Messages log(owner);
  const helios::MovingInstances parts(
    MakeData({}, true), scene, {}, helios::AngleConvention::Arinc705, log);
  CHECK_FALSE(parts.IsMoving());
  CHECK(parts.GetScene() == scene);
  CHECK_FALSE(parts.MakeMotions({}));
}

TEST_CASE("MovingInstances: a wheel turns on a car that drives", "[MovingInstances]")
{
  const auto scene = MakeScene(0.0, false);
  auto data =
    MakeData(Repeat({ MakeMotion(MotionKind::Rotation, Vec3(0, 1, 0), 90.0, true) }), true);
  data.Parts[1].Motion.Mount = "car";
  data.Parts[2].Name = "car";
  data.Parts[2].Motion = data.Parts[1].Motion;
  data.Parts[2].Motion.Mount = "";
  data.Parts[2].Motion.Sequences =
    Repeat({ MakeMotion(MotionKind::Rotation, Vec3(0, 0, 1), 10.0) });
  data.Parts[0].Name = "driver";
  data.Parts[0].Motion.Mount = "car";
  vtkNew<vtkObject> owner;
  helios::Messages log(owner);
  const helios::MovingInstances parts(data, scene, {}, helios::AngleConvention::Arinc705, log);
  const auto motions = parts.MakeMotions({ 0, 0.0, 1000.0 });
  // the first triangles of the parts: 0, 1, 2 from cells 0, 1, 3
  const auto driver = motions->MakeTrack(0);
  const auto wheel = motions->MakeTrack(1);
  helios::Similarity ofDriver, ofWheel, before;
  const Vec3 p(3.0, -4.0, 5.0);
  for (const double time : { 0.0, 0.004, 0.013 })
  {
    const helios::SceneMoment moment{ static_cast<vtkIdType>(time * 1000.0), time };
    const helios::Rotation turn(helios::AxisAngle(Vec3(0, 0, 1), 1000.0 * time));
    const helios::Rotation spin(helios::AxisAngle(Vec3(0, 1, 0), 9000.0 * time));
    driver->Move(moment, ofDriver);
    wheel->Move(moment, ofWheel);
    Vec3 at;
    ofDriver.Apply(p.GetData(), at.GetData());
    CHECK((at - turn * p).Norm() < 1e-12);
    const Vec3 c = ofWheel.Pivot; // the centroid of the wheel
    if (time > 0.0)
    {
      ofWheel.Apply(p.GetData(), at.GetData());
      CHECK((at - turn * (c + spin * (p - c))).Norm() < 1e-11);
      const double h = 1e-7;
      Vec3 later;
      wheel->Move({ moment.Pulse, time + h }, before);
      before.Apply(p.GetData(), later.GetData());
      CHECK(((1.0 / h) * (later - at) - wheel->GetVelocity(moment, at)).Norm() < 0.3);
    }
    double box[6];
    const double own[6] = { -10, 10, -10, 10, -10, 10 };
    const helios::MomentSpan span = motions->GetSpan(moment, 8);
    wheel->ComputeBounds(span, own, box);
    for (int i = 0; i <= 40; ++i)
    {
      wheel->Move({ moment.Pulse, span.Start + i * (span.End - span.Start) / 40.0 }, before);
      const double q[3] = { 10.0, -10.0, 10.0 };
      before.Apply(q, at.GetData());
      for (int axis = 0; axis < 3; ++axis)
      {
        REQUIRE(at[axis] >= box[2 * axis]);
        REQUIRE(at[axis] <= box[2 * axis + 1]);
      }
    }
  }
}

TEST_CASE("MovingInstances: speeds of a part that drives, then waits", "[MovingInstances]")
{
  const bool isContinuous = GENERATE(false, true);
  auto sequences = Repeat({ MakeMotion(MotionKind::Translation, Vec3(0.3, 0.0, 0.4)) });
  sequences.front().Loop = 100; // steps of 10 ms
  sequences.front().Next = 1;
  sequences.push_back(Repeat({ MakeMotion(MotionKind::Identity, Vec3()) }).front());
  vtkNew<vtkObject> owner;
  helios::Messages log(owner);
  helios::SceneData data = MakeData(sequences, isContinuous);
  data.Parts[1].Name = "car";
  helios::MovingInstances parts(
    data, MakeScene(0.0, false), {}, helios::AngleConvention::Arinc705, log);
  const helios::LegClock drives = { { 0, 0.0, 1000.0 }, 0.9 };
  const helios::LegClock waits = { { 1500, 1.5, 1000.0 }, 2.0 };
  const auto speeds = parts.GetSpeeds({ drives, waits });
  REQUIRE(speeds.size() == 1);
  CHECK(speeds[0].Name == "car");
  CHECK(speeds[0].Motion == (isContinuous ? "continuous" : "in steps of 10 pulses"));
  CHECK(speeds[0].Minimum == 0.0);
  CHECK(speeds[0].Maximum == Approx(50.0).epsilon(1e-9));
  CHECK(parts.GetSpeeds({ drives })[0].Minimum == Approx(50.0).epsilon(1e-9));
  parts.StandStill();
  CHECK_FALSE(parts.IsMoving());
  CHECK(parts.GetSpeeds({ drives }).empty());
}

TEST_CASE("MovingInstances: parts that share points cannot be placed", "[MovingInstances]")
{
  const auto scene = MakeScene(0.0, false);
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2 });
  polys->InsertNextCell({ 2, 3, 4 });
  scene->SetPolys(polys);
  vtkNew<vtkObject> owner;
  helios::Messages log(owner);
  helios::MovingInstances parts(
    MakeData(Repeat({ MakeMotion(MotionKind::Translation, Vec3(1, 0, 0)) }), true), scene, {},
    helios::AngleConvention::Arinc705, log);
  REQUIRE(parts.IsMoving());
  parts.StandStill();
  CHECK(log.GetLastError().find("point 2 belongs to a part that moves, part 1, and to another one; "
                                "compose the parts with vtkHeliosSceneComposer") == 0);
}
