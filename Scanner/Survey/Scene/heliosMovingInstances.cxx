// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMovingInstances.h"

#include "heliosMessages.h"
#include "heliosMovingParts.h"
#include "heliosPartMotions.h"
#include "heliosPlacedParts.h"
#include "heliosSceneGeometry.h"
#include "heliosTrajectoryFile.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"
#include "vtkHeliosTrajectoryReader.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

/// Copies some cells of a mesh, with their arrays, whose points begin with a number.
void CopyCells(const TriangleMesh& mesh, vtkPolyData* from, const std::vector<vtkIdType>& cells,
  vtkTypeInt32 firstPoint, vtkPolyData* to)
{
  const auto count = static_cast<vtkIdType>(cells.size());
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  polys->AllocateExact(count, 3 * count);
  to->GetCellData()->CopyAllOn();
  to->GetCellData()->CopyAllocate(from->GetCellData(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType cell = cells[static_cast<std::size_t>(i)];
    const vtkTypeInt32* corners = mesh.GetCorners() + 3 * cell;
    polys->InsertNextCell(
      { corners[0] - firstPoint, corners[1] - firstPoint, corners[2] - firstPoint });
    to->GetCellData()->CopyData(from->GetCellData(), cell, i);
  }
  to->SetPolys(polys);
}

/// Copies a range of the points of a mesh, with their arrays.
void CopyPoints(
  const TriangleMesh& mesh, vtkPolyData* from, vtkIdType first, vtkIdType last, vtkPolyData* to)
{
  const vtkIdType count = last - first;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  std::copy_n(mesh.GetPoints() + 3 * first, 3 * count,
    vtkDoubleArray::FastDownCast(points->GetData())->GetPointer(0));
  to->SetPoints(points);
  to->GetPointData()->CopyAllOn();
  to->GetPointData()->CopyAllocate(from->GetPointData(), count);
  to->GetPointData()->CopyData(from->GetPointData(), 0, count, first);
}

} // namespace

/// Splits a scene into what is at rest and instances of what moves.
class MovingInstances::Split
{
public:
  Split(vtkPolyData* scene, const std::map<int, std::size_t>& parts, const SceneFrames& frames)
    : Whole(scene)
    , Parts(parts)
    , Frames(frames)
    , Sums(parts.size())
  {
  }

  /// Splits it; false if none of its triangles moves.
  bool Run(SceneMotions::Content& motions);

  vtkSmartPointer<vtkPolyData> GetScene() const { return this->Result; }

  /// Returns the centroid of a part; false if it has no triangles.
  bool FindCentroid(std::size_t part, Vec3& centroid) const
  {
    centroid = this->Sums[part].Get();
    return this->HasTriangles[part];
  }

private:
  /// An instance of the result.
  struct Entry
  {
    vtkIdType FirstCell;
    int Prototype;
    int Part;
    int Material;
    double Orientation[4];
    double Scale;
    Vec3 Translation;
    int Motion;
  };

  void FindCells();
  void AddRun(const std::vector<vtkIdType>& cells, std::size_t part, int id);
  const CentroidSum& GetSum(const SceneInstance& instance);
  void AddInstances(SceneMotions::Content& motions);
  std::shared_ptr<const PartFrames> MakePlaced(int id) const;
  vtkSmartPointer<vtkPolyData> MakeInstances() const;

  vtkPolyData* Whole;
  const std::map<int, std::size_t>& Parts;
  const SceneFrames& Frames;
  std::vector<CentroidSum> Sums;
  std::map<int, CentroidSum> PrototypeSums;
  std::vector<bool> HasTriangles;
  SceneGeometry Geometry;
  std::vector<vtkIdType> Resting; ///< cells of the mesh
  std::vector<Entry> Entries;
  std::vector<SceneMotions::Instance> Moving;
  vtkSmartPointer<vtkHeliosScene> Result;
};

//------------------------------------------------------------------------------
bool MovingInstances::Split::Run(SceneMotions::Content& motions)
{
  this->HasTriangles.assign(this->Parts.size(), false);
  if (!this->Geometry.Set(this->Whole).IsOk()) // the ray caster reports why
  {
    return false;
  }
  this->Result = vtkSmartPointer<vtkHeliosScene>::New();
  auto* whole = vtkHeliosScene::SafeDownCast(this->Whole);
  for (int i = 0; whole && i < whole->GetNumberOfPrototypes(); ++i)
  {
    this->Result->AddPrototype(whole->GetPrototype(i));
  }
  this->FindCells();
  this->AddInstances(motions);
  if (this->Moving.empty())
  {
    return false;
  }
  CopyCells(this->Geometry.GetMesh(), this->Whole, this->Resting, 0, this->Result);
  this->Result->SetPoints(this->Whole->GetPoints());
  this->Result->GetPointData()->ShallowCopy(this->Whole->GetPointData());
  this->Result->SetFieldData(this->Whole->GetFieldData());
  this->Result->SetInstances(this->MakeInstances());
  motions.Instances = this->Moving;
  return true;
}

//------------------------------------------------------------------------------
/// Finds the cells of the mesh that are at rest, and adds runs of the others.
void MovingInstances::Split::FindCells()
{
  vtkDataArray* ids = this->Whole->GetCellData()->GetArray(names::PartIds);
  const vtkIdType count = this->Geometry.GetMesh().GetNumberOfTriangles();
  std::vector<vtkIdType> run;
  for (vtkIdType cell = 0; cell < count;)
  {
    const int id = ids ? static_cast<int>(ids->GetComponent(cell, 0)) : 0;
    const auto found = this->Parts.find(id);
    if (found == this->Parts.end())
    {
      this->Resting.push_back(cell++);
      continue;
    }
    run.clear();
    const vtkIdType first = this->Geometry.GetCell(cell);
    while (cell < count && (!ids || static_cast<int>(ids->GetComponent(cell, 0)) == id) &&
      this->Geometry.GetCell(cell) == first + static_cast<vtkIdType>(run.size()))
    {
      run.push_back(cell++);
    }
    this->AddRun(run, found->second, id);
  }
}

//------------------------------------------------------------------------------
/// Adds consecutive cells of a part as a prototype and its instance.
void MovingInstances::Split::AddRun(const std::vector<vtkIdType>& cells, std::size_t part, int id)
{
  const TriangleMesh& mesh = this->Geometry.GetMesh();
  const auto corners = std::minmax_element(
    mesh.GetCorners() + 3 * cells.front(), mesh.GetCorners() + 3 * (cells.back() + 1));
  const vtkTypeInt32 first = *corners.first;
  vtkNew<vtkPolyData> prototype;
  CopyPoints(mesh, this->Whole, first, *corners.second + 1, prototype);
  CopyCells(mesh, this->Whole, cells, first, prototype);
  for (const vtkIdType cell : cells)
  {
    this->Sums[part].Add(mesh.GetCorner(cell, 0), mesh.GetCorner(cell, 1), mesh.GetCorner(cell, 2));
  }
  this->HasTriangles[part] = true;
  this->Entries.push_back(
    { this->Geometry.GetCell(cells.front()), this->Result->GetNumberOfPrototypes(), id, -1,
      { 1.0, 0.0, 0.0, 0.0 }, 1.0, { 0.0, 0.0, 0.0 }, static_cast<int>(this->Moving.size()) });
  this->Moving.push_back({ part, Similarity(), this->MakePlaced(id) });
  this->Result->AddPrototype(prototype);
}

//------------------------------------------------------------------------------
/// Returns the frames of a part at their place; null: it has none.
std::shared_ptr<const PartFrames> MovingInstances::Split::MakePlaced(int id) const
{
  const auto found = this->Frames.find(id);
  if (found == this->Frames.end())
  {
    return nullptr;
  }
  auto placed = std::make_shared<PartFrames>(*found->second);
  placed->Frames = std::make_shared<MeshFrames>(found->second->Frames->MakePlaced(placed->Place));
  return placed;
}

//------------------------------------------------------------------------------
/// Returns the sum of the prototype of an instance, which is computed once.
const CentroidSum& MovingInstances::Split::GetSum(const SceneInstance& instance)
{
  const auto [found, isNew] = this->PrototypeSums.try_emplace(instance.PrototypeId);
  const Prototype& prototype = this->Geometry.GetPrototype(instance);
  for (vtkIdType t = 0; isNew && t < prototype.GetNumberOfTriangles(); ++t)
  {
    double corners[3][3];
    prototype.GetCorners(t, corners);
    found->second.Add(corners[0], corners[1], corners[2]);
  }
  return found->second;
}

//------------------------------------------------------------------------------
/// Adds the instances that the scene has, at rest or not.
void MovingInstances::Split::AddInstances(SceneMotions::Content&)
{
  auto* whole = vtkHeliosScene::SafeDownCast(this->Whole);
  vtkPolyData* given = whole ? whole->GetInstances() : nullptr;
  vtkDataArray* turns = given ? given->GetPointData()->GetArray(names::Orientation) : nullptr;
  const auto& instances = this->Geometry.GetInstances();
  for (std::size_t i = 0; i < instances.size(); ++i)
  {
    const SceneInstance& instance = instances[i];
    const auto found = this->Parts.find(instance.Part);
    Entry entry{ instance.FirstCell, instance.PrototypeId, instance.Part, instance.Material,
      { 1.0, 0.0, 0.0, 0.0 }, instance.Place.Scale, instance.Place.Translation, -1 };
    if (turns)
    {
      turns->GetTuple(static_cast<vtkIdType>(i), entry.Orientation);
    }
    if (found != this->Parts.end())
    {
      entry.Motion = static_cast<int>(this->Moving.size());
      const auto frames = this->Frames.find(instance.Part);
      this->Moving.push_back(
        { found->second, instance.Place, frames == this->Frames.end() ? nullptr : frames->second });
      this->HasTriangles[found->second] = true;
      this->Sums[found->second].Add(this->GetSum(instance), instance.Place);
    }
    this->Entries.push_back(entry);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MovingInstances::Split::MakeInstances() const
{
  std::vector<Entry> sorted = this->Entries;
  std::sort(sorted.begin(), sorted.end(),
    [](const Entry& a, const Entry& b) { return a.FirstCell < b.FirstCell; });
  auto instances = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  instances->SetPoints(points);
  const auto add = [&instances](vtkDataArray* array, const char* name)
  {
    array->SetName(name);
    instances->GetPointData()->AddArray(array);
  };
  vtkNew<vtkIntArray> prototypes, parts, materials, motions;
  vtkNew<vtkDoubleArray> turns, scales;
  vtkNew<vtkIdTypeArray> first;
  turns->SetNumberOfComponents(4);
  for (const Entry& entry : sorted)
  {
    points->InsertNextPoint(entry.Translation.GetData());
    prototypes->InsertNextValue(entry.Prototype);
    parts->InsertNextValue(entry.Part);
    materials->InsertNextValue(entry.Material);
    motions->InsertNextValue(entry.Motion);
    turns->InsertNextTuple(entry.Orientation);
    scales->InsertNextValue(entry.Scale);
    first->InsertNextValue(entry.FirstCell);
  }
  add(prototypes, names::PrototypeIds);
  add(parts, names::PartIds);
  add(materials, names::MaterialIds);
  add(motions, names::MotionIds);
  add(turns, names::Orientation);
  add(scales, names::Scale);
  add(first, names::FirstCellIds);
  return instances;
}

namespace
{

/// Returns a trajectory whose times are those of the survey.
vtkSmartPointer<vtkPolyData> ShiftTimes(vtkPolyData* from, double start)
{
  auto track = vtkSmartPointer<vtkPolyData>::New();
  track->ShallowCopy(from);
  vtkDataArray* times = from->GetPointData()->GetArray(names::GpsTime);
  vtkNew<vtkDoubleArray> shifted;
  shifted->SetName(names::GpsTime);
  for (vtkIdType i = 0; i < times->GetNumberOfTuples(); ++i)
  {
    shifted->InsertNextValue(
      times->GetComponent(i, 0) - (std::isnan(start) ? times->GetComponent(0, 0) : start));
  }
  track->GetPointData()->AddArray(shifted);
  return track;
}

} // namespace

//------------------------------------------------------------------------------
MovingInstances::MovingInstances(const SceneData& scene, vtkPolyData* mesh,
  const SceneFrames& frames, AngleConvention convention, Messages& log)
  : Log(log)
  , Whole(mesh)
  , Scene(mesh)
{
  std::map<int, std::size_t> places; // by the id in the composer: turbid parts are not in the mesh
  auto motions = std::make_shared<SceneMotions::Content>();
  const std::set<std::size_t> moving = FindMoving(scene.Parts);
  int id = 0;
  for (std::size_t i = 0; i < scene.Parts.size(); ++i)
  {
    const PartData& part = scene.Parts[i];
    if (!part.IsTurbid() && moving.count(i) > 0)
    {
      places[id] = motions->Parts.size();
      motions->Parts.emplace_back();
      motions->Parts.back().Id = id;
      motions->Parts.back().Name = part.Name;
      motions->Parts.back().Data = part.Motion;
      const auto shape = frames.find(id);
      motions->Parts.back().Frames = shape == frames.end() ? nullptr : shape->second;
    }
    id += part.IsTurbid() ? 0 : 1;
  }
  if (places.empty() || !mesh)
  {
    return;
  }
  Split split(mesh, places, frames);
  if (!split.Run(*motions))
  {
    return;
  }
  for (std::size_t i = 0; i < motions->Parts.size(); ++i)
  {
    MovingPartData& part = motions->Parts[i];
    split.FindCentroid(i, part.Centroid);
    part.Motion = part.Data.HasOwn()
      ? std::make_shared<PartMotion>(part.Data.Sequences, part.Centroid)
      : nullptr;
  }
  if (this->ReadTracks(scene, convention, *motions))
  {
    FindCarriers(*motions);
    this->Scene = split.GetScene();
    this->Motions = motions;
  }
}

//------------------------------------------------------------------------------
/// Reads the trajectories of parts; false after an error.
bool MovingInstances::ReadTracks(
  const SceneData& scene, AngleConvention convention, SceneMotions::Content& motions)
{
  for (MovingPartData& part : motions.Parts)
  {
    const TrajectoryFileData& file = part.Data.Track;
    if (file.File.empty())
    {
      continue;
    }
    const auto reader = MakeTrajectoryReader(file, convention, scene.Crs);
    this->Log.Listen(reader, file.Where + ": part " + part.Name);
    reader->Update();
    auto track = std::make_shared<Trajectory>();
    Status status;
    if (!this->Log.HasError())
    {
      status = track->Set(ShiftTimes(reader->GetOutput(), file.StartTime));
    }
    if (!status.IsOk())
    {
      this->Log.Error(
        file.Where + ": part " + part.Name + ": " + file.File + ": " + status.Message());
    }
    if (this->Log.HasError())
    {
      return false;
    }
    part.Track = track;
  }
  return true;
}

//------------------------------------------------------------------------------
void MovingInstances::FindCarriers(SceneMotions::Content& motions)
{
  auto& parts = motions.Parts;
  for (MovingPartData& part : parts)
  {
    const auto carrier = std::find_if(parts.begin(), parts.end(),
      [&part](const MovingPartData& other) { return other.Name == part.Data.Mount; });
    if (!part.Data.Mount.empty() && carrier != parts.end())
    {
      part.Carrier = static_cast<std::size_t>(carrier - parts.begin());
    }
  }
}

//------------------------------------------------------------------------------
void MovingInstances::StandStill()
{
  if (!this->Motions)
  {
    return;
  }
  const SceneMotions motions(this->Motions, PulseClock());
  std::map<int, MotionMap> maps;
  for (std::size_t i = 0; i < this->Motions->Parts.size(); ++i)
  {
    motions.MakePath(i)->Move(SceneMoment(), maps[this->Motions->Parts[i].Id]);
  }
  const auto placed = vtkSmartPointer<vtkPolyData>::Take(this->Whole->NewInstance());
  placed->ShallowCopy(this->Whole);
  const Status status = PlaceParts(maps, placed);
  if (!status.IsOk())
  {
    this->Log.Error(status.Message());
  }
  this->Scene = placed;
  this->Motions.reset();
}

//------------------------------------------------------------------------------
std::vector<PartSpeeds> MovingInstances::GetSpeeds(const std::vector<LegClock>& legs) const
{
  return this->Motions ? ComputeSpeeds(this->Motions, legs) : std::vector<PartSpeeds>();
}

//------------------------------------------------------------------------------
bool MovingInstances::CheckSpan(double start, double end) const
{
  constexpr double rounding = 1e-6; // [s]
  for (std::size_t i = 0; this->Motions && i < this->Motions->Parts.size(); ++i)
  {
    const MovingPartData& part = this->Motions->Parts[i];
    const Status status = part.Frames ? part.Frames->CheckSpan(part.Name, start, end) : Status();
    if (!status.IsOk())
    {
      this->Log.Error(status.Message());
      return false;
    }
    const Trajectory* track = part.Track.get();
    if (track && !track->IsStatic() &&
      (track->GetStartTime() > start + rounding || track->GetEndTime() < end - rounding))
    {
      MessageBuilder text;
      text << part.Data.Track.Where << ": part " << part.Name << ": " << part.Data.Track.File
           << " has times of the survey from " << track->GetStartTime() << " s to "
           << track->GetEndTime() << " s, but a leg lasts from " << start << " s to " << end
           << " s; give a longer trajectory, or another tStart";
      this->Log.Error(text.str());
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
MovingInstances::~MovingInstances() = default;

//------------------------------------------------------------------------------
std::shared_ptr<const InstanceMotions> MovingInstances::MakeMotions(const PulseClock& clock) const
{
  return this->Motions ? std::make_shared<SceneMotions>(this->Motions, clock) : nullptr;
}

} // namespace helios
