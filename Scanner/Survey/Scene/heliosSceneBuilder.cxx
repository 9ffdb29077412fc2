// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneBuilder.h"

#include "heliosEpochs.h"
#include "heliosGround.h"
#include "heliosMemoryCheck.h"
#include "heliosMessages.h"
#include "heliosSceneTrees.h"
#include "heliosSimilarity.h"
#include "heliosStatus.h"
#include "heliosSurveyCrs.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosSceneComposer.h"
#include "vtkHeliosSceneTransform.h"

#include <vtkAlgorithm.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

const Vec3 Upwards(0.0, 0.0, 1.0);

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

  void Add(int connection, const PartData& data, const Vec3& translation, int part,
    const std::string& name)
  {
    this->Points->InsertNextPoint(translation.GetData());
    this->Prototypes->InsertNextValue(connection);
    this->Orientations->InsertNextTuple(data.Rotation.GetData());
    this->Scales->InsertNextValue(data.Scale);
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

/// Returns the triangles of the readers of a filter; a mesh used twice is counted twice.
double CountTriangles(vtkAlgorithm* filter)
{
  const int count =
    filter->GetNumberOfInputPorts() > 0 ? filter->GetNumberOfInputConnections(0) : 0;
  auto* mesh = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  const double own = mesh ? static_cast<double>(mesh->GetNumberOfPolys()) : 0.0;
  if (count == 0 || own > 0.0)
  {
    return own;
  }
  double sum = 0.0;
  for (int i = 0; i < count; ++i)
  {
    sum += CountTriangles(filter->GetInputAlgorithm(0, i));
  }
  return sum;
}

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
  std::map<const vtkAlgorithm*, int> uses; // number of uses of a filter by instances
  this->Pipelines.SetSharing(this->MakesInstances);
  for (const PartData& part : this->Scene.Parts)
  {
    if (const PartData* data = FindPart(part, epoch))
    {
      all.push_back(data);
      vtkAlgorithm* source = this->Pipelines.GetSource(*data);
      this->Parts.push_back({ data, &part.Name, source, data->Translation, nullptr });
      uses[source] += this->MakesInstances ? 1 : 0;
    }
  }
  this->Pipelines.RemoveOthers(all);
  this->Lowest.Clear();
  for (Part& part : this->Parts)
  {
    const bool isInstance =
      !part.Data->IsTurbid() && (this->Pipelines.IsRaster(*part.Data) || uses.at(part.Source) > 1);
    part.Place = isInstance ? nullptr : this->Pipelines.Make(*part.Data);
  }
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
SceneFrames SceneBuilder::GetFrames() const
{
  SceneFrames all;
  int id = 0;
  for (const Part& part : this->Parts)
  {
    double rate = 0.0;
    if (const auto frames = this->Pipelines.GetFrames().Get(*part.Data, rate))
    {
      const PartData& data = *part.Data;
      auto made = std::make_shared<PartFrames>();
      made->Frames = frames;
      made->Data = data.Frames;
      made->First = std::filesystem::path(data.Files.front()).filename().string();
      made->Last = std::filesystem::path(data.Files.back()).filename().string();
      made->Place = Similarity(data.Rotation.GetData(), data.Scale, part.Translation.GetData());
      made->Rate = rate;
      made->IsClosed = data.Type != Loader::Gltf;
      all[id] = made;
    }
    id += part.Data->IsTurbid() ? 0 : 1;
  }
  return all;
}

//------------------------------------------------------------------------------
void SceneBuilder::SetColors(bool areRead)
{
  this->HasColors = areRead;
  this->Pipelines.SetColors(areRead);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SceneBuilder::Compose(bool withPartsOnGround)
{
  vtkNew<vtkHeliosSceneComposer> composer;
  composer->SetPassColors(this->HasColors);
  this->Log.Listen(composer, this->Scene.Where);
  this->AddParts(composer, withPartsOnGround);
  const int count = composer->GetNumberOfInputConnections(0);
  const Status status =
    CheckMemory("triangles of all parts", CountTriangles(composer), BytesPerTriangle);
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
  if (withPartsOnGround && !this->AddTreesTo(scene))
  {
    return nullptr;
  }
  this->AddFramesTo(scene);
  return SetSceneCrs(scene, this->Scene, this->Log) ? scene : nullptr;
}

//------------------------------------------------------------------------------
/// Adds the trees of all parts, by part id: of meshes, of their objects, of the files of turbid
/// voxels. False after an error.
bool SceneBuilder::AddTreesTo(vtkPolyData* scene) const
{
  std::vector<const PartData*> meshes;
  std::vector<const PartData*> grids;
  for (const Part& part : this->Parts)
  {
    const std::size_t files = part.Data->IsTurbid() ? part.Data->Files.size() : 0;
    grids.insert(grids.end(), files, part.Data);
    part.Data->IsTurbid() ? void() : meshes.push_back(part.Data);
  }
  vtkAbstractArray* known = scene->GetFieldData()->GetAbstractArray(names::PartName);
  meshes.resize(known ? static_cast<std::size_t>(known->GetNumberOfValues()) : 0, nullptr);
  meshes.insert(meshes.end(), grids.begin(), grids.end());
  const Status status = AddTrees(meshes, scene);
  if (!status.IsOk())
  {
    this->Log.Error(status.Message());
  }
  return status.IsOk();
}

//------------------------------------------------------------------------------
/// Adds notes on the parts that deform.
void SceneBuilder::AddFramesTo(vtkPolyData* scene) const
{
  vtkNew<vtkStringArray> notes;
  notes->SetName(names::Notes);
  if (vtkAbstractArray* given = scene->GetFieldData()->GetAbstractArray(names::Notes))
  {
    notes->DeepCopy(given);
  }
  const SceneFrames all = this->GetFrames();
  auto* partNames =
    vtkStringArray::SafeDownCast(scene->GetFieldData()->GetAbstractArray(names::PartName));
  for (const auto& [id, frames] : all)
  {
    notes->InsertNextValue(
      "part " + std::string(partNames->GetValue(id)) + " " + frames->Describe());
  }
  if (!all.empty())
  {
    scene->GetFieldData()->AddArray(notes);
  }
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
    if (!part.IsInstance())
    {
      composer->AddInputConnection(part.Place->GetOutputPort());
      composer->SetPartName(connection, part.Name->c_str());
      composer->SetPartId(connection, id);
      composer->SetPartIsSplit(connection, HasObjects(*part.Data) && !part.Data->IsMoving());
    }
    else
    {
      const auto [known, isNew] = prototypes.emplace(part.Source, connection);
      if (isNew)
      {
        composer->AddInputConnection(part.Source->GetOutputPort());
      }
      instances.Add(known->second, *part.Data, part.Translation, id, *part.Name);
    }
    ++id;
  }
  if (!instances.IsEmpty())
  {
    composer->SetInputDataObject(1, instances.Get());
  }
}

//------------------------------------------------------------------------------
/// Finds the lowest corner of a part in the scene; false if it has no triangles.
bool SceneBuilder::FindLowest(const Part& part, Vec3& lowest)
{
  if (!part.IsInstance())
  {
    part.Place->Update();
    return FindLowestCorner(part.Place->GetOutput(), Upwards, lowest);
  }
  part.Source->Update();
  auto* mesh = vtkPolyData::SafeDownCast(part.Source->GetOutputDataObject(0));
  const Similarity place(
    part.Data->Rotation.GetData(), part.Data->Scale, part.Translation.GetData());
  const Vec3 up(place.Turn.M[2]);
  const bool isUpright = up[0] == 0.0 && up[1] == 0.0 && up[2] > 0.0;
  Vec3 corner;
  if (!this->Lowest.Find(mesh, isUpright ? Upwards : up, corner))
  {
    return false;
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
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    Vec3 point;
    if (this->Parts[i].Data->OnGround && this->FindLowest(this->Parts[i], point))
    {
      lowest->InsertNextPoint(point.GetData());
      snapped.push_back(i);
    }
  }
  if (snapped.empty())
  {
    return !this->Log.HasError();
  }
  std::vector<double> heights;
  if (!this->FindGround(snapped, lowest, heights))
  {
    return false;
  }
  for (std::size_t k = 0; k < snapped.size(); ++k)
  {
    Part& part = this->Parts[snapped[k]];
    part.Translation[2] += heights[k] - lowest->GetPoint(static_cast<vtkIdType>(k))[2];
    part.IsInstance() ? void() : part.Place->SetTranslation(part.Translation.GetData());
  }
  return true;
}

//------------------------------------------------------------------------------
/// Finds the heights of the ground at the lowest corners of parts; false after an error.
bool SceneBuilder::FindGround(
  const std::vector<std::size_t>& parts, vtkPoints* lowest, std::vector<double>& heights)
{
  const vtkSmartPointer<vtkPolyData> ground = this->MakeGround();
  if (!ground)
  {
    return false;
  }
  vtkNew<vtkPolyData> points;
  points->SetPoints(lowest);
  const Status status = GetGroundHeights(points, ground, true, heights);
  if (!status.IsOk())
  {
    this->Log.Error(this->Scene.Where + ": " + status.Message());
    return false;
  }
  const auto isMissing = [](double height) { return std::isnan(height); };
  const auto missing = std::find_if(heights.begin(), heights.end(), isMissing);
  if (missing != heights.end())
  {
    const auto index = missing - heights.begin();
    const double* p = lowest->GetPoint(index);
    const Part& part = this->Parts[parts[static_cast<std::size_t>(index)]];
    MessageBuilder text;
    text << part.Data->Where << ": part " << *part.Name
         << " is on the ground, but there is no ground above or below its lowest corner at x "
         << p[0] << ", y " << p[1] << "; move the part, or give its height without onGround";
    this->Log.Error(text.str());
  }
  return missing == heights.end();
}

} // namespace helios
