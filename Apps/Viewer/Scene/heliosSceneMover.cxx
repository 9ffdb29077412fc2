// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneMover.h"

#include "heliosSceneView.h"
#include "heliosSimulation.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"

#include <vtkBoundingBox.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace helios::viewer
{
namespace names = vtkHeliosArrayNames;

namespace
{

/// Returns a moment of a leg: the displayed time, and the last pulse of a channel emitted by then.
SceneMoment FindMoment(const SimulatedLeg& leg, double time)
{
  const double within = std::clamp(time, leg.StartTime, leg.EndTime);
  const double pulses = (within - leg.StartTime) * leg.Clock.Rate;
  return { static_cast<vtkIdType>(std::floor(pulses + 1e-6)), within };
}

bool IsSame(const Similarity& a, const Similarity& b)
{
  return a.Translation == b.Translation && a.HasRotation == b.HasRotation && a.Pivot == b.Pivot &&
    std::equal(&a.Turn.M[0][0], &a.Turn.M[0][0] + 9, &b.Turn.M[0][0]);
}

/// Adds the corners of the triangles of a mesh to a box.
void AddCells(vtkPolyData* mesh, vtkBoundingBox& box)
{
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetPolys()->GetNumberOfCells(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, corners);
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      box.AddPoint(mesh->GetPoint(corners->GetId(k)));
    }
  }
}

bool IsSame(const MeshShape& a, const MeshShape& b)
{
  return a.From == b.From && a.To == b.To && a.Fraction == b.Fraction;
}

/// A point of the moving mesh, and the point of the part's own mesh that it is.
struct PartPoint
{
  vtkIdType Shown;
  vtkIdType Own;
};

/// Returns the points of the triangles of a part, each once. A part that deforms has one own mesh, with
/// the same triangles.
std::vector<PartPoint> FindPoints(vtkPolyData* mesh, int part, vtkPolyData* own)
{
  std::vector<bool> isKnown(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  vtkDataArray* ids = mesh->GetCellData()->GetArray(names::PartIds);
  std::vector<PartPoint> points;
  vtkNew<vtkIdList> corners, ownCorners;
  vtkIdType next = 0; // triangle of its own
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    if (ids && static_cast<int>(ids->GetComponent(cell, 0)) != part)
    {
      continue;
    }
    mesh->GetPolys()->GetCellAtId(cell, corners);
    own ? own->GetPolys()->GetCellAtId(next++, ownCorners) : ownCorners->DeepCopy(corners);
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      const vtkIdType shown = corners->GetId(k);
      isKnown[static_cast<std::size_t>(shown)] ? void()
                                               : points.push_back({ shown, ownCorners->GetId(k) });
      isKnown[static_cast<std::size_t>(shown)] = true;
    }
  }
  return points;
}

} // namespace

/// A part, with the points that it has in the moving mesh, and in the scene that is cast at.
struct SceneMover::Part
{
  int Id;
  int Motion;
  vtkPolyData* Own; // its mesh, if it deforms; else null
  std::vector<PartPoint> Points;
  std::unique_ptr<InstanceTrack> Track;
  Similarity Place;
  MeshShape Shape;

  /// Moves it to a moment; false: unchanged.
  bool MoveTo(const SceneMoment& moment)
  {
    Similarity place = this->Place;
    MeshShape shape = this->Shape;
    this->Track->Move(moment, place);
    this->Own ? this->Track->FindShape(moment, shape) : void();
    const bool isMoved = !IsSame(place, this->Place) || !IsSame(shape, this->Shape);
    this->Place = place;
    this->Shape = shape;
    return isMoved;
  }

  /// Finds where a point is, which is at a place in the scene.
  void FindPoint(vtkIdType own, const double atRest[3], double place[3]) const
  {
    double p[3] = { atRest[0], atRest[1], atRest[2] };
    this->Shape.From ? this->Shape.GetPoint(own, p) : void();
    this->Place.Apply(p, place);
  }
};

//------------------------------------------------------------------------------
SceneMover::SceneMover(const SurveyData& survey, vtkPolyData* mesh, const SceneFrames& frames)
  : Log(Owner)
{
  vtkNew<vtkCallbackCommand> nobody;
  nobody->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  this->Owner->AddObserver(vtkCommand::ErrorEvent, nobody);
  this->Owner->AddObserver(vtkCommand::WarningEvent, nobody);
  this->Instances =
    std::make_unique<MovingInstances>(survey.Scene, mesh, frames, survey.Convention, this->Log);
  if (!this->Instances->IsMoving())
  {
    this->Instances.reset();
    return;
  }
  auto* scene = vtkHeliosScene::SafeDownCast(this->Instances->GetScene());
  vtkPolyData* places = scene->GetInstances();
  vtkDataArray* prototypes = places->GetPointData()->GetArray(names::PrototypeIds);
  vtkDataArray* motions = places->GetPointData()->GetArray(names::MotionIds);
  vtkDataArray* parts = places->GetPointData()->GetArray(names::PartIds);
  for (vtkIdType i = 0; i < places->GetNumberOfPoints(); ++i)
  {
    const auto id = static_cast<int>(parts->GetComponent(i, 0));
    const auto motion = static_cast<int>(motions->GetComponent(i, 0));
    const bool isKnown = std::any_of(
      this->Parts.begin(), this->Parts.end(), [id](const Part& part) { return part.Id == id; });
    if (motion >= 0 && !isKnown) // all runs of triangles of a part move alike
    {
      const auto prototype = static_cast<int>(prototypes->GetComponent(i, 0));
      auto* own =
        frames.count(id) > 0 ? vtkPolyData::SafeDownCast(scene->GetPrototype(prototype)) : nullptr;
      this->Parts.push_back({ id, motion, own, {}, nullptr, {}, {} });
    }
  }
}

//------------------------------------------------------------------------------
SceneMover::~SceneMover() = default;

//------------------------------------------------------------------------------
/// Makes the paths of a leg.
void SceneMover::Begin(const SimulatedLeg& leg)
{
  this->Leg = &leg;
  const auto motions = this->Instances->MakeMotions(leg.Clock);
  for (Part& part : this->Parts)
  {
    part.Track = motions->MakeTrack(part.Motion);
  }
}

//------------------------------------------------------------------------------
bool SceneMover::GetBounds(const SimulatedLeg& leg, double bounds[6])
{
  if (!this->Instances)
  {
    return false;
  }
  this->Begin(leg);
  this->Leg = nullptr; // its paths are used up
  auto* scene = vtkHeliosScene::SafeDownCast(this->Instances->GetScene());
  vtkPolyData* places = scene->GetInstances();
  vtkDataArray* prototypes = places->GetPointData()->GetArray(names::PrototypeIds);
  vtkDataArray* parts = places->GetPointData()->GetArray(names::PartIds);
  vtkBoundingBox box;
  AddCells(scene, box);
  for (vtkIdType i = 0; i < places->GetNumberOfPoints(); ++i)
  {
    const auto id = static_cast<int>(parts->GetComponent(i, 0));
    const auto part = std::find_if(
      this->Parts.begin(), this->Parts.end(), [id](const Part& one) { return one.Id == id; });
    vtkDataSet* mesh = scene->GetPrototype(static_cast<int>(prototypes->GetComponent(i, 0)));
    part->MoveTo(FindMoment(leg, leg.StartTime));
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
      double at[3];
      part->FindPoint(p, mesh->GetPoint(p), at);
      box.AddPoint(at);
    }
  }
  box.GetBounds(bounds);
  return true;
}

//------------------------------------------------------------------------------
void SceneMover::SetView(SceneView& view)
{
  if (!this->Instances)
  {
    return;
  }
  std::vector<int> ids;
  for (const Part& part : this->Parts)
  {
    ids.push_back(part.Id);
  }
  view.SetMovingParts(ids);
  this->View = &view;
  this->Leg = nullptr;
  this->AtRest = view.GetMovingMesh() ? view.GetMovingMesh()->GetPoints() : nullptr;
  for (Part& part : this->Parts)
  {
    part.Place = Similarity();
    part.Shape = MeshShape();
    part.Points = this->AtRest ? FindPoints(view.GetMovingMesh(), part.Id, part.Own) : part.Points;
  }
}

//------------------------------------------------------------------------------
bool SceneMover::MoveTo(const std::vector<SimulatedLeg>& legs, double time)
{
  const bool isMoving =
    this->AtRest && this->View->GetMovingMesh(); // the scene may have been changed
  const SimulatedLeg* leg = isMoving ? FindLeg(legs, time) : nullptr;
  const SceneMoment moment = leg ? FindMoment(*leg, time) : SceneMoment();
  if (!leg ||
    (leg == this->Leg && moment.Pulse == this->Shown.Pulse && moment.Time == this->Shown.Time))
  {
    return false;
  }
  leg == this->Leg ? void() : this->Begin(*leg);
  this->Shown = moment;
  vtkSmartPointer<vtkPoints> points; // null: nothing has moved
  for (Part& part : this->Parts)
  {
    if (!part.MoveTo(moment))
    {
      continue;
    }
    if (!points)
    {
      points = vtkSmartPointer<vtkPoints>::New();
      points->SetDataTypeToDouble(); // the copy keeps this type
      points->DeepCopy(this->View->GetMovingMesh()->GetPoints());
    }
    for (const PartPoint& point : part.Points)
    {
      double p[3];
      part.FindPoint(point.Own, this->AtRest->GetPoint(point.Shown), p);
      points->SetPoint(point.Shown, p);
    }
  }
  if (points)
  {
    vtkNew<vtkPolyData> mesh;
    mesh->ShallowCopy(this->View->GetMovingMesh());
    mesh->SetPoints(points);
    this->View->Move(mesh);
  }
  return points != nullptr;
}

} // namespace helios::viewer
