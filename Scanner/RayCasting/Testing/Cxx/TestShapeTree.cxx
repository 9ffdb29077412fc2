// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes that deform: trees that are fitted give the hits of trees that are built.
#include "heliosConeProbe.h"
#include "heliosInstanceMotion.h"
#include "heliosMeshFrames.h"
#include "heliosSceneGeometry.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosBeamRayCaster.h"
#include "vtkHeliosScene.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

using helios::MeshFrames;
using helios::MeshShape;
using helios::MomentSpan;
using helios::SceneMoment;
using helios::Similarity;
using helios::Vec3;

namespace
{

/// A grid of n x n squares, folded at random, whose points move on circles of some size; every frame is
/// further along. With collapsed, a corner is a point in the first frame.
vtkSmartPointer<vtkPolyData> MakeFrame(int n, double angle, double radius, bool isCollapsed)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.4, 0.4);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < (n + 1) * (n + 1); ++i)
  {
    const double x = i % (n + 1) + shift(random);
    const double y = i / (n + 1) + shift(random);
    const double phase = angle + 10.0 * shift(random);
    const double z = 3.0 * shift(random);
    points->InsertNextPoint(
      x + radius * std::cos(phase), y + radius * std::sin(phase), z + radius * std::sin(3 * phase));
  }
  if (isCollapsed)
  {
    for (int i = 0; i < 3 * (n + 1); ++i)
    {
      points->SetPoint(i, 1.0, 1.0, 1.0);
    }
  }
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  for (int i = 0; i < n * n; ++i)
  {
    const vtkIdType p = i / n * (n + 1) + i % n;
    polys->InsertNextCell({ p, p + 1, p + n + 2 });
    polys->InsertNextCell({ p, p + n + 2, p + n + 1 });
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

/// A frame a second; loops. Turns about z by an angle a second.
class Track : public helios::InstanceTrack
{
public:
  Track(const MeshFrames& frames, double turn, double hold)
    : Frames(frames)
    , Turn(turn)
    , Hold(hold)
  {
  }
  void Move(const SceneMoment& moment, Similarity& place) override
  {
    place = GetPlace(this->Turn, moment.Time);
  }
  static Similarity GetPlace(double turn, double time)
  {
    const double half = 0.5 * turn * time;
    const double q[4] = { std::cos(half), 0.0, 0.0, std::sin(half) };
    const double t[3] = { turn == 0.0 ? 0.0 : 100.0, 0.0, 0.0 };
    return turn == 0.0 ? Similarity() : Similarity(q, 1.5, t);
  }
  void ComputeBounds(const MomentSpan&, const double[6], double bounds[6]) override
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = -1e3;
      bounds[2 * axis + 1] = 1e3;
    }
  }
  void FindShape(const SceneMoment& moment, MeshShape& shape) override
  {
    const auto count = this->Frames.GetCount();
    const double place = std::fmod(moment.Time, static_cast<double>(count));
    const auto from = static_cast<std::size_t>(place);
    shape.From = this->Frames.GetPoints(from);
    shape.To = this->Frames.GetPoints((from + 1) % count);
    shape.Fraction = place - std::floor(place);
    shape.Rate = 1.0;
    shape.Hold = this->Hold;
  }
  Vec3 GetVelocity(const SceneMoment&, const Vec3&) override { return { 0.0, 0.0, 0.0 }; }
  helios::Pose GetPose(const SceneMoment&) override { return {}; }

private:
  const MeshFrames& Frames;
  double Turn;
  double Hold;
};

class Motions : public helios::InstanceMotions
{
public:
  Motions(const MeshFrames& frames, double turn, double hold)
    : Frames(frames)
    , Turn(turn)
    , Hold(hold)
  {
  }
  int GetNumberOfTracks() const override { return 1; }
  std::unique_ptr<helios::InstanceTrack> MakeTrack(int) const override
  {
    return std::make_unique<Track>(this->Frames, this->Turn, this->Hold);
  }
  const MeshFrames* GetFrames(int) const override { return &this->Frames; }
  MomentSpan GetSpan(const SceneMoment&, vtkIdType) const override
  {
    return { 0, 1000000, -1.0, 1e6 };
  }
  bool AreAtRest(const MomentSpan&) const override { return false; }

private:
  const MeshFrames& Frames;
  double Turn;
  double Hold;
};

/// A scene of one instance of the first frame, which moves.
vtkSmartPointer<vtkHeliosScene> MakeScene(vtkPolyData* first)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  places->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkIntArray> prototypes, motions;
  prototypes->SetName(vtkHeliosArrayNames::PrototypeIds);
  prototypes->InsertNextValue(0);
  motions->SetName(vtkHeliosArrayNames::MotionIds);
  motions->InsertNextValue(0);
  vtkNew<vtkPolyData> instances;
  instances->SetPoints(places);
  instances->GetPointData()->AddArray(prototypes);
  instances->GetPointData()->AddArray(motions);
  auto scene = vtkSmartPointer<vtkHeliosScene>::New();
  scene->AddPrototype(first);
  scene->SetInstances(instances);
  return scene;
}

/// The mesh at a time, where its track has it.
vtkSmartPointer<vtkPolyData> MakeMesh(const MeshFrames& frames, double turn, double time)
{
  Track track(frames, turn, 0.0);
  MeshShape shape;
  track.FindShape({ 0, time }, shape);
  const Similarity place = Track::GetPlace(turn, time);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < frames.GetFrame(0)->GetNumberOfPoints(); ++i)
  {
    double p[3];
    shape.GetPoint(i, p);
    place.Apply(p, p);
    points->InsertNextPoint(p);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(frames.GetFrame(0)->GetPolys());
  return mesh;
}

/// Beams of four rays from around the mesh to its points.
std::vector<vtkHeliosRay> MakeRays(vtkPolyData* mesh)
{
  std::mt19937 random(6);
  std::uniform_int_distribution<vtkIdType> any(0, mesh->GetNumberOfPoints() - 1);
  std::normal_distribution<double> far(0.0, 30.0), near(0.0, 0.05);
  std::vector<vtkHeliosRay> rays;
  for (int i = 0; i < 1000; ++i)
  {
    const Vec3 target(mesh->GetPoint(any(random)));
    const Vec3 origin = target + Vec3(far(random), far(random), far(random));
    for (int k = 0; k < 4; ++k)
    {
      const Vec3 d = target - origin + Vec3(near(random), near(random), near(random));
      rays.push_back({ { origin[0], origin[1], origin[2] }, { d[0], d[1], d[2] } });
    }
  }
  return rays;
}

} // namespace

TEST_CASE("ShapeTree: hits equal those of a tree that is built, to the last bit", "[ShapeTree]")
{
  const int size = GENERATE(1, 40);
  const double radius = GENERATE(0.05, 3.0);
  const double turn = GENERATE(0.0, 0.7);
  const double hold = GENERATE(0.0, 1.0);
  const bool isCollapsed = GENERATE(false, true);
  MeshFrames frames;
  for (int frame = 0; frame < 3; ++frame)
  {
    frames.Add(MakeFrame(size, 2.0 * frame, radius, isCollapsed && frame == 0));
  }
  const auto scene = MakeScene(frames.GetFrame(0));
  vtkNew<vtkHeliosBeamRayCaster> base;
  REQUIRE(base->Build(scene));
  const auto moving = base->MakeMoving(std::make_shared<Motions>(frames, turn, hold));
  REQUIRE(moving);
  int numberOfHits = 0;
  for (const double time : { 0.0, 0.3, 0.35, 0.9999, 1.0, 2.5, 2.999, 0.1, 4.75 })
  {
    INFO("time " << time << ", size " << size << ", radius " << radius << ", turn " << turn);
    const auto mesh = MakeMesh(frames, turn, time);
    vtkNew<vtkHeliosBeamRayCaster> built;
    REQUIRE(built->Build(mesh));
    const auto rays = MakeRays(mesh);
    const auto count = static_cast<vtkIdType>(rays.size());
    std::vector<vtkHeliosHit> hits(rays.size()), expected(rays.size());
    std::vector<unsigned char> occluded(rays.size());
    built->Intersect(rays.data(), expected.data(), count);
    moving->MoveTo({ 0, time });
    moving->Occluded(rays.data(), occluded.data(), count);
    int wrong = 0;
    for (const int raysPerBeam : { 1, 4 })
    {
      moving->IntersectBeams(rays.data(), hits.data(), raysPerBeam, count / raysPerBeam);
      for (std::size_t i = 0; i < hits.size(); ++i)
      {
        const vtkIdType cell = expected[i].CellId;
        const bool isSame = hits[i].CellId == cell && hits[i].Range == expected[i].Range &&
          (occluded[i] != 0) == (cell >= 0) &&
          (cell < 0 ||
            moving->GetGeometry().GetNormal(cell) == built->GetGeometry().GetNormal(cell));
        wrong += isSame ? 0 : 1;
        numberOfHits += cell >= 0 ? 1 : 0;
      }
    }
    CHECK(wrong == 0);
    int numberOfDoubts =
      0; // cones that one of the trees leaves unresolved, which depends on its order
    for (std::size_t i = 0; i < rays.size(); i += 4)
    {
      Vec3 axis(rays[i].Direction);
      axis.Normalize();
      const auto a = moving->GetConeProbe()->Probe(rays[i].Origin, axis.GetData(), 0.002, 0.01);
      const auto b = built->GetConeProbe()->Probe(rays[i].Origin, axis.GetData(), 0.002, 0.01);
      const bool isDoubt =
        (a.Kind == vtkHeliosConeHit::Unresolved) != (b.Kind == vtkHeliosConeHit::Unresolved);
      numberOfDoubts += isDoubt ? 1 : 0;
      const bool isSame = a.Kind == b.Kind && a.CellId == b.CellId && a.Range == b.Range;
      wrong += isDoubt || isSame ? 0 : 1;
    }
    CHECK(wrong == 0);
    CHECK((isCollapsed || numberOfDoubts < 10));
  }
  CHECK(numberOfHits > 1000);
}
