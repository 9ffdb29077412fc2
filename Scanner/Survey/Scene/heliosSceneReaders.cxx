// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneReaders.h"

#include "vtkHeliosCityJSONReader.h"
#include "vtkHeliosGLTFSceneReader.h"
#include "vtkHeliosGeoTiffSceneReader.h"
#include "vtkHeliosObjSceneReader.h"
#include "vtkHeliosPLYSceneReader.h"
#include "vtkHeliosSTLSceneReader.h"

namespace helios
{

namespace
{

const char* GetTextOrNull(const std::string& text)
{
  return text.empty() ? nullptr : text.c_str();
}

vtkSmartPointer<vtkPolyDataAlgorithm> MakeGeoTiffReader(const std::string& file)
{
  auto reader = vtkSmartPointer<vtkHeliosGeoTiffSceneReader>::New();
  reader->SetFileName(file.c_str());
  return reader;
}

vtkSmartPointer<vtkHeliosSceneReader> MakeCityReader(const PartData& part)
{
  auto reader = vtkSmartPointer<vtkHeliosCityJSONReader>::New();
  reader->SetLevelOfDetail(GetTextOrNull(part.LevelOfDetail));
  reader->SetMaterialFileName(GetTextOrNull(part.Material.File));
  return reader;
}

vtkSmartPointer<vtkHeliosSceneReader> MakeObjReader(bool withColors)
{
  auto reader = vtkSmartPointer<vtkHeliosObjSceneReader>::New();
  reader->SetReadColors(withColors);
  return reader;
}

vtkSmartPointer<vtkHeliosSceneReader> MakeGltfReader(const PartData& part)
{
  auto reader = vtkSmartPointer<vtkHeliosGLTFSceneReader>::New();
  reader->SetMaterialFileName(GetTextOrNull(part.Material.File));
  if (part.Frames.IsGiven())
  {
    reader->SetAnimation(part.Frames.Animation.empty() ? "0" : part.Frames.Animation.c_str());
  }
  return reader;
}

vtkSmartPointer<vtkHeliosSceneReader> MakeMeshReader(const PartData& part, bool withColors)
{
  switch (part.Type)
  {
    case Loader::Ply:
      return vtkSmartPointer<vtkHeliosPLYSceneReader>::New();
    case Loader::Stl:
      return vtkSmartPointer<vtkHeliosSTLSceneReader>::New();
    case Loader::CityJson:
      return MakeCityReader(part);
    case Loader::Gltf:
      return MakeGltfReader(part);
    default:
      return MakeObjReader(withColors);
  }
}

} // namespace

//------------------------------------------------------------------------------
SceneReaderKey MakeSceneReaderKey(const PartData& part, const std::string& file)
{
  return { part.Type, file, part.UpIsY, part.LevelOfDetail,
    HasOwnMaterials(part) ? part.Material.File : std::string(), part.Frames.IsGiven() };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyDataAlgorithm> MakeSceneReader(
  const PartData& part, const std::string& file, bool withColors)
{
  if (part.Type == Loader::GeoTiff)
  {
    return MakeGeoTiffReader(file);
  }
  const vtkSmartPointer<vtkHeliosSceneReader> reader = MakeMeshReader(part, withColors);
  reader->SetFileName(file.c_str());
  reader->SetKeepAll(part.Frames.IsGiven());
  const bool isUpY = part.UpIsY || part.Type == Loader::Gltf;
  reader->SetUpAxis(isUpY ? vtkHeliosSceneReader::UP_AXIS_Y : vtkHeliosSceneReader::UP_AXIS_Z);
  return reader;
}

//------------------------------------------------------------------------------
bool HasObjects(const PartData& part)
{
  return part.Type == Loader::CityJson;
}

//------------------------------------------------------------------------------
bool HasOwnMaterials(const PartData& part)
{
  return part.Type == Loader::CityJson || part.Type == Loader::Gltf;
}

} // namespace helios
