// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosVoxelReader.h"

#include "heliosMemoryCheck.h"
#include "heliosStatus.h"
#include "heliosVoxelFile.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <new>

vtkStandardNewMacro(vtkHeliosVoxelReader);

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double BytesPerCell = 16.0;

/// Computes the point extent of a grid of cells.
void GetExtent(const helios::VoxelLayout& layout, int extent[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis] = 0;
    extent[2 * axis + 1] = static_cast<int>(layout.Count[axis]);
  }
}

vtkSmartPointer<vtkDoubleArray> MakeColumn(const char* name, vtkIdType count, double value)
{
  auto column = vtkSmartPointer<vtkDoubleArray>::New();
  column->SetName(name);
  if (!column->Resize(count))
  {
    throw std::bad_alloc();
  }
  column->SetNumberOfValues(count);
  std::fill_n(column->GetPointer(0), count, value);
  return column;
}

void AddLeafTable(const std::vector<double>& rows, vtkImageData* grid)
{
  vtkNew<vtkDoubleArray> table;
  table->SetName(names::LeafProjection);
  table->SetNumberOfComponents(4);
  table->SetNumberOfTuples(static_cast<vtkIdType>(rows.size() / 4));
  std::copy(rows.begin(), rows.end(), table->GetPointer(0));
  grid->GetFieldData()->AddArray(table);
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosVoxelReader::vtkHeliosVoxelReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHeliosVoxelReader::~vtkHeliosVoxelReader()
{
  this->SetFileName(nullptr);
  this->SetLeafTableFileName(nullptr);
}

//------------------------------------------------------------------------------
bool vtkHeliosVoxelReader::ReadHead(helios::VoxelFile& file, helios::TextReport& report)
{
  if (!this->FileName || !*this->FileName)
  {
    return report.Fail("FileName is not set; give the .vox file with SetFileName");
  }
  if (!file.ReadHead(this->FileName))
  {
    return false;
  }
  const std::int64_t cells = file.GetLayout().GetNumberOfCells();
  const helios::Status status =
    helios::CheckMemory("cells", static_cast<double>(cells), BytesPerCell);
  if (cells <= this->MaximumNumberOfCells && !status.IsOk())
  {
    return report.Fail(std::string(this->FileName) + ": " + status.Message());
  }
  return cells <= this->MaximumNumberOfCells ||
    report.Fail(std::string(this->FileName) + ": has " + std::to_string(cells) +
      " cells, more than MaximumNumberOfCells (" + std::to_string(this->MaximumNumberOfCells) +
      "); raise it, a cell needs 16 bytes");
}

//------------------------------------------------------------------------------
int vtkHeliosVoxelReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  helios::TextReport report;
  helios::VoxelFile file(this->PADColumn, report);
  if (!this->ReadHead(file, report))
  {
    vtkErrorMacro(<< report.Error);
    return 0;
  }
  const helios::VoxelLayout& layout = file.GetLayout();
  int extent[6];
  GetExtent(layout, extent);
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), layout.Corner, 3);
  info->Set(vtkDataObject::SPACING(), layout.Size, 3);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkHeliosVoxelReader::Read(
  helios::VoxelFile& file, helios::TextReport& report, vtkImageData* grid)
{
  std::vector<double> table;
  const bool hasTable = this->LeafTableFileName && *this->LeafTableFileName;
  if (!this->ReadHead(file, report) ||
    (hasTable && !helios::ReadLeafTable(this->LeafTableFileName, report, table)))
  {
    return false;
  }
  const helios::VoxelLayout& layout = file.GetLayout();
  const vtkIdType cells = layout.GetNumberOfCells();
  const auto pad = MakeColumn(names::PAD, cells, 0.0);
  const auto transmittance =
    MakeColumn(names::Transmittance, layout.HasTransmittance ? cells : 0, 1.0);
  file.GetText().OnBlock = [this](double share)
  {
    this->UpdateProgress(share);
    return !this->AbortExecute;
  };
  if (!file.ReadRows(
        pad->GetPointer(0), layout.HasTransmittance ? transmittance->GetPointer(0) : nullptr))
  {
    return false;
  }
  int extent[6];
  GetExtent(layout, extent);
  grid->SetExtent(extent);
  grid->SetOrigin(layout.Corner);
  grid->SetSpacing(layout.Size);
  grid->GetCellData()->AddArray(pad);
  if (layout.HasTransmittance)
  {
    grid->GetCellData()->AddArray(transmittance);
  }
  if (layout.MaximumPad > 0.0)
  {
    grid->GetFieldData()->AddArray(MakeColumn(names::MaximumPAD, 1, layout.MaximumPad));
  }
  if (hasTable)
  {
    AddLeafTable(table, grid);
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkHeliosVoxelReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  helios::TextReport report;
  bool isRead = false;
  try
  {
    helios::VoxelFile file(this->PADColumn, report);
    isRead = this->Read(file, report, vtkImageData::GetData(outputVector));
  }
  catch (const std::bad_alloc&)
  {
    report.Error = std::string(this->FileName) +
      ": not enough memory for its cells; a cell needs 16 bytes, use a coarser grid";
  }
  if (!isRead)
  {
    vtkErrorMacro(<< report.Error);
  }
  return isRead;
}

//------------------------------------------------------------------------------
void vtkHeliosVoxelReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n'
     << indent
     << "LeafTableFileName: " << (this->LeafTableFileName ? this->LeafTableFileName : "(none)")
     << '\n'
     << indent << "PADColumn: " << this->PADColumn << '\n'
     << indent << "MaximumNumberOfCells: " << this->MaximumNumberOfCells << '\n';
}
