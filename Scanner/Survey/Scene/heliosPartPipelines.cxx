// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPartPipelines.h"

#include "heliosHeightCache.h"
#include "heliosHeightField.h"
#include "heliosMeshKey.h"
#include "heliosMessages.h"
#include "heliosSceneReaders.h"
#include "vtkHeliosGeoTiffHeightReader.h"
#include "vtkHeliosLASReader.h"
#include "vtkHeliosMaterialReader.h"
#include "vtkHeliosMeshRepair.h"
#include "vtkHeliosPointVoxelizer.h"
#include "vtkHeliosReproject.h"
#include "vtkHeliosSceneClassify.h"
#include "vtkHeliosSceneComposer.h"
#include "vtkHeliosSceneTransform.h"
#include "vtkHeliosVoxelCubes.h"
#include "vtkHeliosVoxelReader.h"
#include "vtkHeliosXyzReader.h"

#include "vtkHeliosArrayNames.h"

#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkStringArray.h>
#include <vtkTrivialProducer.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>

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
  reader->SetSeparators(voxels.Separators.empty() ? std::string() : voxels.Separators + " \t");
  reader->SetReadNormals(voxels.ReadNormals);
  reader->SetNormalXIndex(voxels.NormalIndex[0]);
  reader->SetNormalYIndex(voxels.NormalIndex[1]);
  reader->SetNormalZIndex(voxels.NormalIndex[2]);
  return reader;
}

vtkSmartPointer<vtkAlgorithm> MakeVegetationReader(const PartData& part, const std::string& file)
{
  auto reader = vtkSmartPointer<vtkHeliosVoxelReader>::New();
  reader->SetFileName(file.c_str());
  const std::string& table = part.Vegetation.LeafTable;
  reader->SetLeafTableFileName(table.empty() ? nullptr : table.c_str());
  return reader;
}

/// Rotates, scales and moves a grid as a filter does meshes; densities remain per cubic metre.
void Place(vtkHeliosSceneTransform* place, vtkImageData* grid)
{
  const double* q = place->GetRotation();
  Quaternion rotation(q[0], q[1], q[2], q[3]);
  rotation.Normalize();
  const double scale = place->GetScale();
  const Vec3 origin =
    scale * Rotate(rotation, Vec3(grid->GetOrigin())) + Vec3(place->GetTranslation());
  const double* size = grid->GetSpacing();
  Rotation axes(rotation);
  grid->SetSpacing(scale * size[0], scale * size[1], scale * size[2]);
  grid->SetDirectionMatrix(&axes.M[0][0]);
  grid->SetOrigin(origin[0], origin[1], origin[2]);
}

void SetMaterialsInTurn(vtkImageData* grid, int count)
{
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkHeliosArrayNames::MaterialIds);
  ids->SetNumberOfValues(grid->GetNumberOfCells());
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    ids->SetValue(i, static_cast<int>(i % count));
  }
  grid->GetCellData()->AddArray(ids);
}

bool IsRead(vtkAlgorithm* reader)
{
  vtkDataObject* output = reader->GetOutputDataObject(0);
  return output && output->GetDataReleased() == 0 && output->GetUpdateTime() > reader->GetMTime();
}

/// Adds a filter and all filters before it.
void AddPipeline(vtkAlgorithm* filter, std::set<vtkAlgorithm*>& all)
{
  if (!all.insert(filter).second)
  {
    return;
  }
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < filter->GetNumberOfInputConnections(port); ++i)
    {
      AddPipeline(filter->GetInputAlgorithm(port, i), all);
    }
  }
}

template <typename MapT, typename TestT>
void EraseIf(MapT& map, const TestT& test)
{
  for (auto entry = map.begin(); entry != map.end();)
  {
    entry = test(*entry) ? map.erase(entry) : std::next(entry);
  }
}

} // namespace

//------------------------------------------------------------------------------
vtkAlgorithm* PartPipelines::GetSource(const PartData& part)
{
  Filter& source = this->Sources[&part];
  const bool isRaster = this->IsRaster(part);
  if (!source || isRaster != (this->RasterParts.count(&part) > 0))
  {
    this->RasterParts.erase(&part);
    if (isRaster)
    {
      this->RasterParts.insert(&part);
    }
    this->Places.erase(&part);
    source = this->GetPipeline(part);
  }
  return source;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHeliosSceneTransform> PartPipelines::Make(const PartData& part)
{
  const Filter last = this->GetSource(part);
  vtkSmartPointer<vtkHeliosSceneTransform>& place = this->Places[&part];
  if (!place)
  {
    const Quaternion& q = part.Rotation;
    place = vtkSmartPointer<vtkHeliosSceneTransform>::New();
    place->SetRotation(q.GetW(), q.GetX(), q.GetY(), q.GetZ());
    place->SetScale(part.Scale);
    this->Connect(place, last);
  }
  // A part on the ground was moved by the epoch before.
  place->SetTranslation(part.Translation[0], part.Translation[1], part.Translation[2]);
  return place;
}

//------------------------------------------------------------------------------
PartPipelines::Filter PartPipelines::GetPipeline(const PartData& part)
{
  const std::string key = this->IsSharing ? GetMeshKey(part) : std::string();
  if (key.empty())
  {
    return this->MakePipeline(part);
  }
  Filter& shared = this->Shared[key + (this->IsRaster(part) ? "raster" : "")];
  shared = shared ? shared : this->MakePipeline(part);
  return shared;
}

//------------------------------------------------------------------------------
PartPipelines::Filter PartPipelines::MakePipeline(const PartData& part)
{
  this->Where = part.Where;
  if (this->IsRaster(part))
  {
    return this->AddMaterial(part.Material, this->MakeRasterReader(part));
  }
  const Filter mesh =
    part.IsCloud() ? this->MakeVoxels(part) : this->AddCrs(part, this->MakeMesh(part));
  return this->AddMeshCare(part,
    this->AddClass(part, HasOwnMaterials(part) ? mesh : this->AddMaterial(part.Material, mesh)));
}

//------------------------------------------------------------------------------
bool PartPipelines::IsRaster(const PartData& part) const
{
  return this->IsSharing && part.Type == Loader::GeoTiff && part.Files.size() == 1 &&
    part.Crs.empty() && part.Classification < 0 && !part.IsMoving() && !part.Repair &&
    part.SimplifyDistance <= 0.0 && !part.OnGround &&
    this->NoRasters.count(part.Files.front()) == 0;
}

//------------------------------------------------------------------------------
PartPipelines::Filter PartPipelines::MakeRasterReader(const PartData& part)
{
  const std::string& file = part.Files.front();
  Filter& known = this->RasterReaders[file];
  if (!known)
  {
    auto reader = vtkSmartPointer<vtkHeliosGeoTiffHeightReader>::New();
    reader->SetFileName(file.c_str());
    this->Watch.Add(reader, this->Where);
    this->Readers.emplace_back(file, reader);
    known = reader;
  }
  return known;
}

//------------------------------------------------------------------------------
bool PartPipelines::CheckRasters()
{
  bool areFine = true;
  for (const auto& [file, reader] : this->RasterReaders)
  {
    std::shared_ptr<const HeightField> field;
    auto* raster = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
    if (!GetHeightField(raster, field).IsOk())
    {
      this->NoRasters.insert(file);
      areFine = false;
    }
  }
  return areFine;
}

//------------------------------------------------------------------------------
void PartPipelines::RemoveOthers(const std::vector<const PartData*>& parts)
{
  const std::set<const PartData*> kept(parts.begin(), parts.end());
  const auto isGone = [&kept](const PartData* part) { return kept.count(part) == 0; };
  EraseIf(this->Sources, [&isGone](const auto& source) { return isGone(source.first); });
  EraseIf(this->RasterParts, isGone);
  EraseIf(this->Places, [&isGone](const auto& place) { return isGone(place.first); });
  EraseIf(this->GridReaders, [&isGone](const auto& grid) { return isGone(grid.first); });
  std::set<vtkAlgorithm*> used;
  std::set<std::string> meshes;
  for (const auto& source : this->Sources)
  {
    AddPipeline(source.second, used);
    meshes.insert(GetMeshKey(*source.first));
  }
  this->Frames.RemoveOthers(meshes, used);
  const auto isUnused = [&used](const auto& reader) { return used.count(reader.second) == 0; };
  EraseIf(this->MeshReaders, isUnused);
  EraseIf(this->RasterReaders, isUnused);
  EraseIf(this->Shared, isUnused);
  this->Watch.RemoveOthers(used);
  this->Readers.erase(
    std::remove_if(this->Readers.begin(), this->Readers.end(), isUnused), this->Readers.end());
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkImageData>> PartPipelines::GetGrids(
  const PartData& part, const std::string& partName, vtkHeliosSceneTransform* place)
{
  vtkNew<vtkPolyData> nothing;
  auto source = vtkSmartPointer<vtkTrivialProducer>::New();
  source->SetOutput(nothing);
  const Filter material = this->AddClass(part, this->AddMaterial(part.Material, source));
  material->Update();
  vtkNew<vtkStringArray> name;
  name->SetName(vtkHeliosArrayNames::PartName);
  name->InsertNextValue(partName);
  std::vector<vtkSmartPointer<vtkImageData>> grids;
  for (const Filter& reader : this->GridReaders[&part])
  {
    auto grid = vtkSmartPointer<vtkImageData>::New();
    grid->ShallowCopy(reader->GetOutputDataObject(0));
    grid->GetFieldData()->PassData(material->GetOutputDataObject(0)->GetFieldData());
    grid->GetFieldData()->AddArray(name);
    if (part.Material.Count > 1 && !part.Material.File.empty())
    {
      SetMaterialsInTurn(grid, part.Material.Count);
    }
    Place(place, grid);
    grids.push_back(grid);
  }
  return grids;
}

//------------------------------------------------------------------------------
bool PartPipelines::ReadFiles(const StepCallback& onStep)
{
  this->Watch.Restart();
  for (const auto& reader : this->Readers)
  {
    if (IsRead(reader.second))
    {
      continue; // by an epoch before
    }
    this->Watch.BeginStep("reading " + reader.first);
    if (this->Watch.WasStopped() || !onStep(this->Watch.GetStep()))
    {
      return false;
    }
    reader.second->Update();
  }
  for (const auto& source : this->Sources)
  {
    const PartData& part = *source.first;
    this->Where = part.Where;
    if (part.Frames.IsGiven() &&
      !this->Frames.Read(
        part, onStep, [&](const Filter& reader) { return this->AddCrs(part, reader); }))
    {
      return false;
    }
  }
  this->Watch.BeginStep("assembling the scene");
  return !this->Watch.WasStopped() && !this->Log.HasError();
}

//------------------------------------------------------------------------------
PartPipelines::Filter PartPipelines::MakeMesh(const PartData& part)
{
  if (part.Files.size() == 1 || part.Frames.IsGiven())
  {
    return this->GetReader(part, part.Files.front());
  }
  auto composer = vtkSmartPointer<vtkHeliosSceneComposer>::New();
  composer->SetPassColors(this->HasColors);
  this->Watch.Add(composer, this->Where);
  for (const std::string& file : part.Files)
  {
    composer->SetPartIsSplit(composer->GetNumberOfInputConnections(0), HasObjects(part));
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
  voxelizer->SetNumberOfMaterials(part.Material.Count);
  this->Readers.emplace_back(part.Files.front(), voxelizer);
  // Reprojected before: voxels are aligned with the axes of the target.
  if (part.Type == Loader::Las)
  {
    return this->Connect(voxelizer, this->MakeLasReaders(part));
  }
  const auto reader = MakePointReader(part);
  this->Watch.Add(reader, this->Where);
  return this->Connect(voxelizer, this->AddCrs(part, reader));
}

//------------------------------------------------------------------------------
/// Returns the points of all files of a part, each reprojected by itself.
PartPipelines::Filter PartPipelines::MakeLasReaders(const PartData& part)
{
  auto joiner = vtkSmartPointer<vtkAppendPolyData>::New();
  joiner->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  Filter last;
  for (const std::string& file : part.Files)
  {
    auto reader = vtkSmartPointer<vtkHeliosLASReader>::New();
    reader->SetFileName(file.c_str());
    reader->SetClasses(part.Voxels.Classes);
    reader->SkipWithheldOn();
    this->Watch.Add(reader, this->Where);
    last = this->AddCrs(part, reader);
    joiner->AddInputConnection(last->GetOutputPort());
  }
  return part.Files.size() == 1 ? last : Filter(joiner);
}

//------------------------------------------------------------------------------
PartPipelines::Filter PartPipelines::GetReader(const PartData& part, const std::string& file)
{
  if (part.Type == Loader::Vegetation)
  {
    return this->MakeCubes(part, file);
  }
  Filter& reader = this->MeshReaders[MakeSceneReaderKey(part, file)];
  if (!reader)
  {
    reader = MakeSceneReader(part, file, this->HasColors);
    this->Watch.Add(reader, this->Where);
    this->Readers.emplace_back(file, reader);
  }
  return reader;
}

//------------------------------------------------------------------------------
/// Makes the cubes of a vegetation grid; cubes of a turbid one are made only to find the ground.
PartPipelines::Filter PartPipelines::MakeCubes(const PartData& part, const std::string& file)
{
  const VegetationData& cells = part.Vegetation;
  const Filter reader = MakeVegetationReader(part, file);
  this->Watch.Add(reader, {});
  auto cubes = vtkSmartPointer<vtkHeliosVoxelCubes>::New();
  cubes->SetMode(
    cells.Mode == CellMode::Scaled ? vtkHeliosVoxelCubes::SCALED : vtkHeliosVoxelCubes::FIXED);
  cubes->SetExponent(cells.Exponent);
  cubes->SetRandomShift(cells.RandomShift);
  cubes->SetSeed(this->Seed);
  cubes->SetNumberOfMaterials(part.Material.Count);
  if (part.IsTurbid())
  {
    this->GridReaders[&part].push_back(reader);
  }
  this->Readers.emplace_back(file, part.IsTurbid() ? reader : Filter(cubes));
  return this->Connect(cubes, reader);
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
  reader->SetNumberOfMaterials(material.Count);
  reader->SetRandomRange(material.RandomRange);
  reader->SetSeed(this->Seed);
  reader->SetReadColors(this->HasColors);
  return this->Connect(reader, before);
}

//------------------------------------------------------------------------------
PartPipelines::Filter PartPipelines::AddClass(const PartData& part, Filter before)
{
  if (part.Classification < 0)
  {
    return before;
  }
  auto classify = vtkSmartPointer<vtkHeliosSceneClassify>::New();
  classify->SetClassification(part.Classification);
  return this->Connect(classify, before);
}

//------------------------------------------------------------------------------
PartPipelines::Filter PartPipelines::AddCrs(const PartData& part, Filter before)
{
  for (const CrsData& crs : part.Crs)
  {
    auto reproject = vtkSmartPointer<vtkHeliosReproject>::New();
    reproject->SetSourceCRS(crs.Source.empty() ? nullptr : crs.Source.c_str());
    reproject->SetTargetCRS(crs.Target.c_str());
    reproject->SetEpoch(crs.Epoch);
    reproject->SetSourceHeightUnit(crs.HeightUnit);
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
      "remove the filter");
  }
#endif
  return before;
}

//------------------------------------------------------------------------------
PartPipelines::Filter PartPipelines::Connect(Filter filter, const Filter& before)
{
  filter->SetInputConnection(before->GetOutputPort());
  this->Watch.Add(filter, this->Where);
  return filter;
}

} // namespace helios
