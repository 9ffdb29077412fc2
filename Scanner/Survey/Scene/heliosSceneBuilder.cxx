// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneBuilder.h"

#include "heliosEpochs.h"
#include "heliosMemoryCheck.h"
#include "heliosMessages.h"
#include "heliosSimilarity.h"
#include "heliosStatus.h"
#include "heliosSurveyCrs.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosGroundSnap.h"
#include "vtkHeliosSceneComposer.h"
#include "vtkHeliosSceneTransform.h"

#include <vtkAlgorithm.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

/// The first lowest corner of a mesh along a direction; false if it has no triangles.
bool FindLowestCorner(vtkPolyData* data, const double up[3], Vec3& lowest)
{
  TriangleMesh mesh;
  if (!mesh.Set(data).IsOk() || mesh.GetNumberOfTriangles() == 0)
  {
    return false;
  }
  const auto getHeight = [up](const double* p)
  { return up[0] * p[0] + up[1] * p[1] + up[2] * p[2]; };
  const double* best = mesh.GetCorner(0, 0);
  for (vtkIdType corner = 0; corner < 3 * mesh.GetNumberOfTriangles(); ++corner)
  {
    const double* p = mesh.GetCorner(corner / 3, static_cast<int>(corner % 3));
    best = getHeight(p) < getHeight(best) ? p : best;
  }
  lowest = Vec3(best);
  return true;
}

constexpr double Upwards[3] = { 0.0, 0.0, 1.0 };

Similarity GetSimilarity(vtkHeliosSceneTransform* place)
{
  return Similarity(place->GetRotation(), place->GetScale(), place->GetTranslation());
}

vtkAlgorithm* GetSource(vtkHeliosSceneTransform* place)
{
  return place->GetInputAlgorithm(0, 0);
}

/// The instances of a composer under construction.
class InstanceList
{
public:
  InstanceList()
  {
    this->Points->SetDataTypeToDouble();
    this->Prototypes->SetName(names::PrototypeIds);
    this->Orientations->SetName(names::Orientation);
    this->Orientations->SetNumberOfComponents(4);
    this->Scales->SetName(names::Scale);
    this->PartIds->SetName(names::PartIds);
    this->Names->SetName(names::PartName);
  }

  void Add(int connection, vtkHeliosSceneTransform* place, int part, const std::string& name)
  {
    this->Points->InsertNextPoint(place->GetTranslation());
    this->Prototypes->InsertNextValue(connection);
    this->Orientations->InsertNextTuple(place->GetRotation());
    this->Scales->InsertNextValue(place->GetScale());
    this->PartIds->InsertNextValue(part);
    this->Names->InsertNextValue(name);
  }

  bool IsEmpty() const { return this->Points->GetNumberOfPoints() == 0; }

  vtkSmartPointer<vtkPolyData> Get() const
  {
    auto instances = vtkSmartPointer<vtkPolyData>::New();
    instances->SetPoints(this->Points);
    for (vtkAbstractArray* array :
      { static_cast<vtkAbstractArray*>(this->Prototypes),
        static_cast<vtkAbstractArray*>(this->Orientations),
        static_cast<vtkAbstractArray*>(this->Scales), static_cast<vtkAbstractArray*>(this->PartIds),
        static_cast<vtkAbstractArray*>(this->Names) })
    {
      instances->GetPointData()->AddArray(array);
    }
    return instances;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkIntArray> Prototypes;
  vtkNew<vtkDoubleArray> Orientations;
  vtkNew<vtkDoubleArray> Scales;
  vtkNew<vtkIntArray> PartIds;
  vtkNew<vtkStringArray> Names;
};

} // namespace

//------------------------------------------------------------------------------
SceneBuilder::SceneBuilder(const SceneData& scene, Messages& log, vtkIdType seed)
  : Scene(scene)
  , Log(log)
  , Pipelines(log, seed)
{
}

//------------------------------------------------------------------------------
SceneBuilder::~SceneBuilder() = default;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SceneBuilder::Build(const StepCallback& onStep, int epoch)
{
  this->Pipelines.SetOnProgress(&onStep);
  const bool isReady =
    this->ReadParts(onStep, epoch) && onStep("assembling the scene") && this->PlaceOnGround();
  auto scene = isReady ? this->Compose(true) : nullptr;
  this->Pipelines.SetOnProgress(nullptr);
  this->Log.Mute(false);
  return this->Pipelines.WasStopped() ? nullptr : scene;
}

//------------------------------------------------------------------------------
bool SceneBuilder::ReadParts(const StepCallback& onStep, int epoch)
{
  this->MakeParts(epoch);
  bool areRead = this->Pipelines.ReadFiles(onStep);
  if (areRead && !this->Pipelines.CheckRasters())
  {
    this->MakeParts(epoch);
    areRead = this->Pipelines.ReadFiles(onStep);
  }
  return areRead;
}

//------------------------------------------------------------------------------
void SceneBuilder::MakeParts(int epoch)
{
  this->Parts.clear();
  std::vector<const PartData*> all;
  bool areStill = true;
  for (const PartData& part : this->Scene.Parts)
  {
    const PartData* data = FindPart(part, epoch);
    areStill = areStill && !(data && data->Motion.IsMoving());
  }
  const bool areShared = this->MakesInstances && areStill;
  this->Pipelines.SetSharing(areShared);
  for (const PartData& part : this->Scene.Parts)
  {
    if (const PartData* data = FindPart(part, epoch))
    {
      all.push_back(data);
      this->Parts.push_back({ data, &part.Name, this->Pipelines.Make(*data) });
    }
  }
  this->Pipelines.RemoveOthers(all);
  this->Uses.clear();
  this->Lowest.clear();
  for (const Part& part : this->Parts)
  {
    this->Uses[GetSource(part.Place)] += areShared ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
bool SceneBuilder::IsInstance(const Part& part) const
{
  return !part.Data->IsTurbid() &&
    (this->Pipelines.IsRaster(*part.Data) || this->Uses.at(GetSource(part.Place)) > 1);
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkImageData>> SceneBuilder::GetGrids()
{
  std::vector<vtkSmartPointer<vtkImageData>> all;
  for (const Part& part : this->Parts)
  {
    if (part.Data->IsTurbid())
    {
      const auto grids = this->Pipelines.GetGrids(*part.Data, *part.Name, part.Place);
      all.insert(all.end(), grids.begin(), grids.end());
    }
  }
  return all;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SceneBuilder::Compose(bool withPartsOnGround)
{
  vtkNew<vtkHeliosSceneComposer> composer;
  this->Log.Listen(composer, this->Scene.Where);
  this->AddParts(composer, withPartsOnGround);
  const int count = composer->GetNumberOfInputConnections(0);
  const Status status = CheckMemory(
    "triangles of all parts", this->Pipelines.CountTriangles(composer), BytesPerTriangle);
  if (!status.IsOk())
  {
    this->Log.Error(this->Scene.Where + ": " + status.Message());
  }
  else if (count > 0) // else there are only voxels
  {
    composer->Update();
  }
  if (this->Log.HasError())
  {
    return nullptr;
  }
  vtkPolyData* composed = composer->GetOutput();
  auto scene = vtk::TakeSmartPointer(composed->NewInstance()); // detached from the pipeline
  scene->ShallowCopy(composed);
  return SetSceneCrs(scene, this->Scene, this->Log) ? scene : nullptr;
}

//------------------------------------------------------------------------------
void SceneBuilder::AddParts(vtkHeliosSceneComposer* composer, bool withPartsOnGround) const
{
  InstanceList instances;
  std::map<const vtkAlgorithm*, int> prototypes;
  int id = 0;
  for (const Part& part : this->Parts)
  {
    if (part.Data->IsTurbid() || (!withPartsOnGround && part.Data->OnGround))
    {
      continue;
    }
    const int connection = composer->GetNumberOfInputConnections(0);
    if (!this->IsInstance(part))
    {
      composer->AddInputConnection(part.Place->GetOutputPort());
      composer->SetPartName(connection, part.Name->c_str());
      composer->SetPartId(connection, id);
    }
    else
    {
      vtkAlgorithm* source = GetSource(part.Place);
      const auto [known, isNew] = prototypes.emplace(source, connection);
      if (isNew)
      {
        composer->AddInputConnection(source->GetOutputPort());
      }
      instances.Add(known->second, part.Place, id, *part.Name);
    }
    ++id;
  }
  if (!instances.IsEmpty())
  {
    composer->SetInputDataObject(1, instances.Get());
  }
}

//------------------------------------------------------------------------------
/// The lowest corner of a part in the scene; false if it has no triangles.
bool SceneBuilder::FindLowest(const Part& part, Vec3& lowest)
{
  if (!this->IsInstance(part))
  {
    part.Place->Update();
    return FindLowestCorner(part.Place->GetOutput(), Upwards, lowest);
  }
  vtkAlgorithm* source = GetSource(part.Place);
  source->Update();
  auto* mesh = vtkPolyData::SafeDownCast(source->GetOutputDataObject(0));
  const Similarity place = GetSimilarity(part.Place);
  const double* up = place.Turn.M[2];
  const bool isUpright = up[0] == 0.0 && up[1] == 0.0 && up[2] > 0.0;
  const auto known = this->Lowest.find(source);
  Vec3 corner = known == this->Lowest.end() ? Vec3(0.0, 0.0, 0.0) : known->second;
  if ((!isUpright || known == this->Lowest.end()) &&
    !FindLowestCorner(mesh, isUpright ? Upwards : up, corner))
  {
    return false;
  }
  if (isUpright)
  {
    this->Lowest.emplace(source, corner);
  }
  place.Apply(corner.GetData(), lowest.GetData());
  return true;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SceneBuilder::MakeGround()
{
  const auto isNotOnGround = [](const Part& part)
  { return !part.Data->OnGround && !part.Data->IsTurbid(); };
  if (std::any_of(this->Parts.begin(), this->Parts.end(), isNotOnGround))
  {
    return this->Compose(false);
  }
  this->Log.Error(this->Scene.Where +
    ": every part has onGround, so no part is the ground; remove onGround from one");
  return nullptr;
}

//------------------------------------------------------------------------------
bool SceneBuilder::PlaceOnGround()
{
  vtkNew<vtkPoints> lowest;
  lowest->SetDataTypeToDouble();
  std::vector<std::size_t> snapped;
  std::string places;
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    Vec3 point;
    const PartData& part = *this->Parts[i].Data;
    if (part.OnGround)
    {
      if (this->FindLowest(this->Parts[i], point))
      {
        lowest->InsertNextPoint(point.GetData());
        snapped.push_back(i);
        places += (places.empty() ? "" : ", ") + part.Where;
      }
    }
  }
  if (snapped.empty())
  {
    return !this->Log.HasError();
  }
  const vtkSmartPointer<vtkPolyData> ground = this->MakeGround();
  if (!ground)
  {
    return false;
  }
  vtkNew<vtkPolyData> points;
  points->SetPoints(lowest);
  vtkNew<vtkHeliosGroundSnap> snap;
  this->Log.Listen(snap);
  snap->SetInputDataObject(0, points);
  snap->SetInputDataObject(1, ground);
  snap->Update();
  if (this->Log.HasError())
  {
    this->Log.Error(
      "Parts with onGround need ground below their lowest corner; point 0, 1 ... are the "
      "lowest corners of the parts at " +
      places);
    return false;
  }
  for (std::size_t k = 0; k < snapped.size(); ++k)
  {
    const auto id = static_cast<vtkIdType>(k);
    vtkHeliosSceneTransform* place = this->Parts[snapped[k]].Place;
    Vec3 translation(place->GetTranslation());
    translation[2] += snap->GetOutput()->GetPoint(id)[2] - lowest->GetPoint(id)[2];
    place->SetTranslation(translation.GetData());
  }
  return true;
}

} // namespace helios
