// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosGeoTiffHeightReader.h"

#include "heliosMaterialTable.h"
#include "heliosMemoryCheck.h"
#include "heliosRasterFile.h"
#include "heliosRasterRows.h"
#include "heliosSceneCrs.h"
#include "heliosScratchArray.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <string>

vtkStandardNewMacro(vtkHeliosGeoTiffHeightReader);

namespace
{

using helios::RasterFile;

constexpr double BytesPerPixel = 12.0; // when the first height that is not a float is read
constexpr double BytesOfPyramid = 1.0; // a pixel, of HeightField, beside the heights

/// Heights in a float array, or a double array from the first that is not a float.
class HeightArray
{
public:
  HeightArray(vtkIdType count, bool isInFile)
    : Count(count)
    , IsInFile(isInFile)
  {
  }

  helios::Status Allocate() { return this->Allocate(this->Floats); }

  helios::Status AddRow(const double* heights, vtkIdType columns)
  {
    helios::Status status;
    this->AreFloats = this->AreFloats && std::all_of(heights, heights + columns, IsFloat);
    if (!this->AreFloats && this->Doubles->GetNumberOfValues() == 0)
    {
      status = this->CopyToDoubles();
    }
    if (!status.IsOk())
    {
      return status;
    }
    for (vtkIdType i = 0; i < columns; ++i)
    {
      const double height = heights[i];
      this->Lowest = height < this->Lowest ? height : this->Lowest; // not for a NaN
      this->Highest = height > this->Highest ? height : this->Highest;
    }
    if (this->AreFloats)
    {
      std::transform(heights, heights + columns, this->Floats->GetPointer(this->Size),
        [](double height) { return static_cast<float>(height); });
    }
    else
    {
      std::copy_n(heights, columns, this->Doubles->GetPointer(this->Size));
    }
    this->Size += columns;
    return status;
  }

  vtkDataArray* Get()
  {
    return this->AreFloats ? static_cast<vtkDataArray*>(this->Floats) : this->Doubles;
  }

  double Lowest = std::numeric_limits<double>::infinity();
  double Highest = -std::numeric_limits<double>::infinity();

private:
  static bool IsFloat(double height)
  {
    constexpr double largest = std::numeric_limits<float>::max();
    return std::isnan(height) ||
      (std::abs(height) <= largest && static_cast<double>(static_cast<float>(height)) == height);
  }

  helios::Status Allocate(vtkDataArray* array) const
  {
    if (this->IsInFile)
    {
      return helios::MapScratchFile(array, static_cast<std::size_t>(this->Count));
    }
    array->SetNumberOfTuples(this->Count);
    return {};
  }

  helios::Status CopyToDoubles()
  {
    const helios::Status status = this->Allocate(this->Doubles);
    if (status.IsOk())
    {
      std::copy_n(this->Floats->GetPointer(0), this->Size, this->Doubles->GetPointer(0));
      this->Floats->Initialize();
    }
    return status;
  }

  vtkIdType Count;
  bool IsInFile;
  vtkIdType Size = 0; // read so far
  bool AreFloats = true;
  vtkNew<vtkFloatArray> Floats;
  vtkNew<vtkDoubleArray> Doubles;
};

/// Where the points of the image are.
struct Lattice
{
  double Origin[3];
  double Spacing[3];
  double Direction[9];

  explicit Lattice(const double t[6])
    : Origin{ t[0] + (t[1] * 0.5 + t[2] * 0.5), t[3] + (t[4] * 0.5 + t[5] * 0.5), 0.0 }
    , Spacing{ std::hypot(t[1], t[4]), std::hypot(t[2], t[5]), 1.0 }
    , Direction{ t[1] / Spacing[0], t[2] / Spacing[1], 0.0, t[4] / Spacing[0], t[5] / Spacing[1],
      0.0, 0.0, 0.0, 1.0 }
  {
  }
};

void SetPlace(const RasterFile& file, vtkImageData* image)
{
  const Lattice lattice(file.GetTransform());
  image->SetDimensions(
    static_cast<int>(file.GetNumberOfColumns()), static_cast<int>(file.GetNumberOfRows()), 1);
  image->SetOrigin(lattice.Origin);
  image->SetSpacing(lattice.Spacing);
  image->SetDirectionMatrix(lattice.Direction);
  vtkNew<vtkDoubleArray> transform;
  transform->SetName(vtkHeliosArrayNames::GeoTransform);
  for (int i = 0; i < 6; ++i)
  {
    transform->InsertNextValue(file.GetTransform()[i]);
  }
  image->GetFieldData()->AddArray(transform);
}

} // namespace

vtkHeliosGeoTiffHeightReader::vtkHeliosGeoTiffHeightReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkHeliosGeoTiffHeightReader::~vtkHeliosGeoTiffHeightReader()
{
  this->SetFileName(nullptr);
}

bool vtkHeliosGeoTiffHeightReader::Open(std::unique_ptr<RasterFile>& file)
{
  if (!this->FileName || !*this->FileName)
  {
    return this->Fail("FileName is not set; give the GeoTIFF file with SetFileName");
  }
  helios::Status status = helios::MakeRasterFile(file);
  if (!status.IsOk())
  {
    return this->Fail(std::string(this->FileName) + ": " + status.Message());
  }
  status = file->Open(this->FileName, { this->Band, this->HeightUnit, this->NoDataValue });
  return status.IsOk() || this->Fail(status.Message());
}

int vtkHeliosGeoTiffHeightReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  std::unique_ptr<RasterFile> file;
  if (!this->Open(file))
  {
    return 0;
  }
  const int extent[6] = { 0, static_cast<int>(file->GetNumberOfColumns()) - 1, 0,
    static_cast<int>(file->GetNumberOfRows()) - 1, 0, 0 };
  Lattice lattice(file->GetTransform());
  vtkInformation* information = outputVector->GetInformationObject(0);
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  information->Set(vtkDataObject::ORIGIN(), lattice.Origin, 3);
  information->Set(vtkDataObject::SPACING(), lattice.Spacing, 3);
  information->Set(vtkDataObject::DIRECTION(), lattice.Direction, 9);
  return 1;
}

int vtkHeliosGeoTiffHeightReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  std::unique_ptr<RasterFile> file;
  vtkImageData* image = vtkImageData::GetData(outputVector);
  try
  {
    if (!this->Open(file) || !this->ReadHeights(*file, image))
    {
      return 0;
    }
  }
  catch (const std::bad_alloc&)
  {
    return this->Fail(file->GetPath() +
      ": not enough memory for its heights; free some, or cut out a part with gdal_translate "
      "-srcwin");
  }
  SetPlace(*file, image);
  helios::SetMaterials(image, { helios::Material() });
  helios::SetCRS(image, file->GetCrs());
  for (const std::string& warning : file->GetWarnings())
  {
    vtkWarningMacro(<< warning);
  }
  return 1;
}

bool vtkHeliosGeoTiffHeightReader::ReadHeights(RasterFile& file, vtkImageData* image)
{
  const auto columns = static_cast<vtkIdType>(file.GetNumberOfColumns());
  const auto count = columns * static_cast<vtkIdType>(file.GetNumberOfRows());
  const bool fits =
    helios::CheckMemory("pixels with a height", static_cast<double>(count), BytesPerPixel).IsOk();
  const helios::Status rest =
    helios::CheckMemory("pixels of a raster", static_cast<double>(count), BytesOfPyramid);
  if (!rest.IsOk())
  {
    return this->Fail(
      file.GetPath() + ": " + rest.Message() + "; gdal_translate -srcwin cuts out a part");
  }
  HeightArray heights(count, !fits);
  helios::Status allocated = heights.Allocate();
  const auto add = [&](const double* row)
  {
    allocated = heights.AddRow(row, columns);
    return allocated.IsOk();
  };
  const auto goOn = [this](double part)
  {
    this->UpdateProgress(part);
    return !this->AbortExecute;
  };
  const helios::Status status =
    allocated.IsOk() ? helios::ReadRows(file, add, goOn) : helios::Status();
  if (!allocated.IsOk())
  {
    return this->Fail(file.GetPath() + ": " + allocated.Message());
  }
  if (!status.IsOk())
  {
    return this->Fail(status.Message());
  }
  file.CheckHeights(heights.Lowest, heights.Highest);
  heights.Get()->SetName(vtkHeliosArrayNames::Heights);
  image->GetPointData()->SetScalars(heights.Get());
  return true;
}

bool vtkHeliosGeoTiffHeightReader::Fail(const std::string& message)
{
  vtkErrorMacro(<< message);
  return false;
}

void vtkHeliosGeoTiffHeightReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Band: " << this->Band << "\n";
  os << indent << "HeightUnit: " << this->HeightUnit << "\n";
  os << indent << "NoDataValue: " << this->NoDataValue << "\n";
}
