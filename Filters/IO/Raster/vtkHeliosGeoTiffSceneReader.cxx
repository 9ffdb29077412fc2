// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosGeoTiffSceneReader.h"

#include "heliosMaterialTable.h"
#include "heliosMemoryCheck.h"
#include "heliosRasterFile.h"
#include "heliosRasterMesh.h"
#include "heliosRasterRows.h"
#include "heliosSceneCrs.h"
#include "heliosStatus.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>

#include <algorithm>
#include <memory>
#include <new>

vtkStandardNewMacro(vtkHeliosGeoTiffSceneReader);

namespace
{

// Returns whether the mesh fits in 32-bit cells: the last cell offset is the largest number.
bool IsSmall(const helios::RasterFile& file)
{
  const std::int64_t blocks = (file.GetNumberOfColumns() - 1) * (file.GetNumberOfRows() - 1);
  return blocks <= std::numeric_limits<vtkTypeInt32>::max() / 6;
}

} // namespace

vtkHeliosGeoTiffSceneReader::vtkHeliosGeoTiffSceneReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkHeliosGeoTiffSceneReader::~vtkHeliosGeoTiffSceneReader()
{
  this->SetFileName(nullptr);
}

int vtkHeliosGeoTiffSceneReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->FileName || !*this->FileName)
  {
    return this->Fail("FileName is not set; give the GeoTIFF file with SetFileName");
  }
  std::unique_ptr<helios::RasterFile> file;
  helios::Status status = helios::MakeRasterFile(file);
  if (!status.IsOk())
  {
    return this->Fail(std::string(this->FileName) + ": " + status.Message());
  }
  status = file->Open(this->FileName, { this->Band, this->HeightUnit, this->NoDataValue });
  if (!status.IsOk())
  {
    return this->Fail(status.Message());
  }
  vtkPolyData* scene = vtkPolyData::GetData(outputVector);
  try
  {
    if (!(IsSmall(*file) ? this->ReadMesh<vtkTypeInt32Array>(*file, scene)
                         : this->ReadMesh<vtkTypeInt64Array>(*file, scene)))
    {
      return 0;
    }
  }
  catch (const std::bad_alloc&)
  {
    return this->Fail(std::string(this->FileName) +
      ": not enough memory for its mesh; free some, or cut out a part with gdal_translate -srcwin");
  }
  helios::SetMaterials(scene, { helios::Material() });
  helios::SetCRS(scene, file->GetCrs());
  for (const std::string& warning : file->GetWarnings())
  {
    vtkWarningMacro(<< warning);
  }
  return 1;
}

template <typename IndexArrayT>
bool vtkHeliosGeoTiffSceneReader::ReadMesh(helios::RasterFile& file, vtkPolyData* scene)
{
  const std::string place = file.GetPath() + ": ";
  const double pixels = file.CountPixels();
  if (const helios::Status status =
        helios::CheckMemory("pixels of two triangles", pixels, 2.0 * helios::BytesPerTriangle);
      !status.IsOk())
  {
    return this->Fail(place + status.Message() + "; gdal_translate -srcwin cuts out a part");
  }
  helios::RasterMesh<IndexArrayT> mesh(file.GetNumberOfColumns(), file.GetTransform());
  bool hasRoom = true;
  const auto add = [&](const double* heights) { return hasRoom = mesh.AddRow(heights); };
  const auto goOn = [this](double part)
  {
    this->UpdateProgress(0.9 * part);
    return !this->AbortExecute;
  };
  if (pixels > 0.0)
  {
    if (const helios::Status status = helios::ReadRows(file, add, goOn); !status.IsOk())
    {
      return this->Fail(status.Message());
    }
  }
  if (!hasRoom || !mesh.Finish())
  {
    return this->Fail(place + "more than 2^31 points; cut it into parts with gdal_retile.py");
  }
  file.CheckHeights(mesh.GetHeights()[0], mesh.GetHeights()[1]);
  mesh.MoveTo(scene);
  if (scene->GetNumberOfPolys() == 0)
  {
    vtkWarningMacro(<< place << "no triangles, so the scene is empty; four neighbours with height "
                    << "make two (the raster is " << file.GetNumberOfColumns() << " x "
                    << file.GetNumberOfRows() << ")");
  }
  return true;
}

bool vtkHeliosGeoTiffSceneReader::Fail(const std::string& message)
{
  vtkErrorMacro(<< message);
  return false;
}

void vtkHeliosGeoTiffSceneReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Band: " << this->Band << "\n";
  os << indent << "HeightUnit: " << this->HeightUnit << "\n";
  os << indent << "NoDataValue: " << this->NoDataValue << "\n";
}
