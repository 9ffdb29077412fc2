// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneBuilder.h"

#include "heliosEpochs.h"
#include "heliosMemoryCheck.h"
#include "heliosMessages.h"
#include "heliosStatus.h"
#include "heliosSurveyCrs.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosGroundSnap.h"
#include "vtkHeliosSceneComposer.h"
#include "vtkHeliosSceneTransform.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace helios
{

namespace
{

/// The lowest vertex of a mesh; false if it has no triangles.
bool FindLowestCorner(vtkPolyData* data, Vec3& lowest)
{
  TriangleMesh mesh;
  if (!mesh.Set(data).IsOk() || mesh.GetNumberOfTriangles() == 0)
  {
    return false;
  }
  const double* best = mesh.GetCorner(0, 0);
  for (vtkIdType corner = 0; corner < 3 * mesh.GetNumberOfTriangles(); ++corner)
  {
    const double* p = mesh.GetCorner(corner / 3, static_cast<int>(corner % 3));
    best = p[2] < best[2] ? p : best;
  }
  lowest = Vec3(best);
  return true;
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
  this->MakeParts(epoch);
  this->Pipelines.SetOnProgress(&onStep);
  const bool isReady =
    this->Pipelines.ReadFiles(onStep) && onStep("assembling the scene") && this->PlaceOnGround();
  auto scene = isReady ? this->Compose(true) : nullptr;
  this->Pipelines.SetOnProgress(nullptr);
  this->Log.Mute(false);
  return this->Pipelines.WasStopped() ? nullptr : scene;
}

//------------------------------------------------------------------------------
void SceneBuilder::MakeParts(int epoch)
{
  this->Parts.clear();
  std::vector<const PartData*> all;
  for (const PartData& part : this->Scene.Parts)
  {
    if (const PartData* data = FindPart(part, epoch))
    {
      all.push_back(data);
      this->Parts.push_back({ data, &part.Name, this->Pipelines.Make(*data) });
    }
  }
  this->Pipelines.RemoveOthers(all);
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
  int count = 0;
  for (const Part& part : this->Parts)
  {
    if (!part.Data->IsTurbid() && (withPartsOnGround || !part.Data->OnGround))
    {
      composer->AddInputConnection(part.Place->GetOutputPort());
      composer->SetPartName(count, part.Name->c_str());
      ++count;
    }
  }
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
  auto scene = vtkSmartPointer<vtkPolyData>::New(); // detached from the pipeline
  scene->ShallowCopy(composer->GetOutput());
  return SetSceneCrs(scene, this->Scene, this->Log) ? scene : nullptr;
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
      this->Parts[i].Place->Update();
      if (FindLowestCorner(this->Parts[i].Place->GetOutput(), point))
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
