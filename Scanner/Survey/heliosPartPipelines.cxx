// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPartPipelines.h"

#include "heliosMessages.h"
#include "vtkHeliosGeoTiffSceneReader.h"
#include "vtkHeliosMaterialReader.h"
#include "vtkHeliosMeshRepair.h"
#include "vtkHeliosObjSceneReader.h"
#include "vtkHeliosPointVoxelizer.h"
#include "vtkHeliosReproject.h"
#include "vtkHeliosSceneComposer.h"
#include "vtkHeliosSceneTransform.h"
#include "vtkHeliosXyzReader.h"

#if VTK_MODULE_ENABLE_vtkHelios_FiltersSimplify
#include "vtkHeliosMeshSimplify.h"
#endif

namespace helios
{

namespace
{

vtkSmartPointer<vtkHeliosXyzReader> MakePointReader(const PartData& part)
{
  const VoxelData& voxels = part.Voxels;
  auto reader = vtkSmartPointer<vtkHeliosXyzReader>::New();
  for (const std::string& file : part.Files)
  {
    reader->AddFileName(file.c_str());
  }
  reader->SetSeparators(voxels.Separators + " \t");
  reader->SetReadNormals(voxels.ReadNormals);
  reader->SetNormalXIndex(voxels.NormalIndex[0]);
  reader->SetNormalYIndex(voxels.NormalIndex[1]);
  reader->SetNormalZIndex(voxels.NormalIndex[2]);
  return reader;
}

vtkSmartPointer<vtkAlgorithm> MakeGeoTiffReader(const std::string& file)
{
  auto reader = vtkSmartPointer<vtkHeliosGeoTiffSceneReader>::New();
  reader->SetFileName(file.c_str());
  return reader;
}

vtkSmartPointer<vtkAlgorithm> MakeObjReader(const PartData& part, const std::string& file)
{
  auto reader = vtkSmartPointer<vtkHeliosObjSceneReader>::New();
  reader->SetFileName(file.c_str());
  reader->SetUpAxis(
    part.UpIsY ? vtkHeliosObjSceneReader::UP_AXIS_Y : vtkHeliosObjSceneReader::UP_AXIS_Z);
  return reader;
}

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHeliosSceneTransform> PartPipelines::Make(const PartData& part)
{
  const bool isPoints = part.Type == Loader::Xyz;
  this->Where = part.Where;
  Filter last = isPoints ? this->MakeVoxels(part) : this->AddCrs(part, this->MakeMesh(part));
  last = this->AddMeshCare(part, this->AddMaterial(part.Material, last));
  const Quaternion& q = part.Rotation;
  auto transform = vtkSmartPointer<vtkHeliosSceneTransform>::New();
  transform->SetRotation(q.GetW(), q.GetX(), q.GetY(), q.GetZ());
  transform->SetScale(part.Scale);
  transform->SetTranslation(part.Translation[0], part.Translation[1], part.Translation[2]);
  this->Connect(transform, last);
  return transform;
}

//------------------------------------------------------------------------------
bool PartPipelines::ReadFiles(const StepCallback& onStep)
{
  for (const auto& reader : this->Readers)
  {
    if (!onStep("reading " + reader.first))
    {
      return false;
    }
    reader.second->Update();
  }
  return !this->Log.HasError();
}

//------------------------------------------------------------------------------
PartPipelines::Filter PartPipelines::MakeMesh(const PartData& part)
{
  if (part.Files.size() == 1)
  {
    return this->GetReader(part, part.Files.front());
  }
  auto composer = vtkSmartPointer<vtkHeliosSceneComposer>::New();
  this->Log.Listen(composer, this->Where);
  for (const std::string& file : part.Files)
  {
    composer->AddInputConnection(this->GetReader(part, file)->GetOutputPort());
  }
  return composer;
}

//------------------------------------------------------------------------------
PartPipelines::Filter PartPipelines::MakeVoxels(const PartData& part)
{
  Vec3 normal = part.Voxels.DefaultNormal;
  auto voxelizer = vtkSmartPointer<vtkHeliosPointVoxelizer>::New();
  voxelizer->SetVoxelSize(part.Voxels.Size);
  voxelizer->SetEstimateNormals(part.Voxels.EstimateNormals);
  voxelizer->SetSnapNeighborNormal(part.Voxels.SnapNeighborNormal);
  voxelizer->SetDefaultNormal(normal.GetData());
  const auto reader = MakePointReader(part);
  this->Log.Listen(reader, this->Where);
  this->Readers.emplace_back(part.Files.front(), voxelizer);
  return this->Connect(voxelizer, this->AddCrs(part, reader)); // cells lie along the target's axes
}

//------------------------------------------------------------------------------
PartPipelines::Filter PartPipelines::GetReader(const PartData& part, const std::string& file)
{
  Filter& reader = this->MeshReaders[{ file, part.UpIsY }];
  if (!reader)
  {
    reader = part.Type == Loader::GeoTiff ? MakeGeoTiffReader(file) : MakeObjReader(part, file);
    this->Log.Listen(reader, this->Where);
    this->Readers.emplace_back(file, reader);
  }
  return reader;
}

//------------------------------------------------------------------------------
PartPipelines::Filter PartPipelines::AddMaterial(const MaterialData& material, Filter before)
{
  if (material.File.empty())
  {
    return before;
  }
  auto reader = vtkSmartPointer<vtkHeliosMaterialReader>::New();
  reader->SetFileName(material.File.c_str());
  reader->SetMaterialName(material.Name.empty() ? nullptr : material.Name.c_str());
  return this->Connect(reader, before);
}

//------------------------------------------------------------------------------
PartPipelines::Filter PartPipelines::AddCrs(const PartData& part, Filter before)
{
  for (const CrsData& crs : part.Crs)
  {
    auto reproject = vtkSmartPointer<vtkHeliosReproject>::New();
    reproject->SetSourceCRS(crs.Source.empty() ? nullptr : crs.Source.c_str());
    reproject->SetTargetCRS(crs.Target.c_str());
    before = this->Connect(reproject, before);
  }
  return before;
}

//------------------------------------------------------------------------------
PartPipelines::Filter PartPipelines::AddMeshCare(const PartData& part, Filter before)
{
  if (part.Repair)
  {
    before = this->Connect(vtkSmartPointer<vtkHeliosMeshRepair>::New(), before);
  }
#if VTK_MODULE_ENABLE_vtkHelios_FiltersSimplify
  if (part.SimplifyDistance > 0.0)
  {
    auto simplify = vtkSmartPointer<vtkHeliosMeshSimplify>::New();
    simplify->SetMaximumDistance(part.SimplifyDistance);
    before = this->Connect(simplify, before);
  }
#else
  if (part.SimplifyDistance > 0.0)
  {
    this->Log.Error(part.Where + ": filter simplify is not in this build; build it with CGAL, or " +
      "take the filter out");
  }
#endif
  return before;
}

//------------------------------------------------------------------------------
PartPipelines::Filter PartPipelines::Connect(Filter filter, const Filter& before)
{
  filter->SetInputConnection(before->GetOutputPort());
  this->Log.Listen(filter, this->Where);
  return filter;
}

} // namespace helios
