// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosVoxelCubes.h"

#include "heliosMaterialTable.h"
#include "heliosMemoryCheck.h"
#include "heliosMeshBuilder.h"
#include "heliosRandom.h"
#include "heliosStatus.h"
#include "heliosVoxelMesh.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHeliosVoxelCubes);

namespace names = vtkHeliosArrayNames;

namespace
{

/// The values of the cells of a grid.
class CellValues
{
public:
  explicit CellValues(vtkImageData* grid)
    : Pad(grid->GetCellData()->GetArray(names::PAD))
    , Transmittance(grid->GetCellData()->GetArray(names::Transmittance))
  {
    vtkDataArray* given = grid->GetFieldData()->GetArray(names::MaximumPAD);
    this->MaximumPad = given && given->GetNumberOfTuples() > 0 ? given->GetTuple1(0) : 0.0;
    for (vtkIdType i = 0; !(this->MaximumPad > 0.0) && i < this->Pad->GetNumberOfTuples(); ++i)
    {
      this->LargestPad = std::max(this->LargestPad, this->GetPad(i));
    }
    this->MaximumPad = this->MaximumPad > 0.0 ? this->MaximumPad : this->LargestPad;
  }

  /// Returns the density of a cell; 0 if unknown.
  double GetPad(vtkIdType cell) const
  {
    const double pad = this->Pad->GetComponent(cell, 0);
    return pad > 0.0 ? pad : 0.0;
  }

  bool IsOpaque(vtkIdType cell) const
  {
    return this->Transmittance ? this->Transmittance->GetComponent(cell, 0) < 1.0
                               : this->GetPad(cell) > 0.0;
  }

  /// Returns the ratio of the cube's edge to the edge of its cell.
  double GetScale(vtkIdType cell, double exponent) const
  {
    return std::min(1.0, std::pow(this->GetPad(cell) / this->MaximumPad, exponent));
  }

private:
  vtkDataArray* Pad;
  vtkDataArray* Transmittance;
  double MaximumPad = 0.0;
  double LargestPad = 0.0;
};

/// Computes the index of a cell along each axis.
void GetIndex(vtkImageData* grid, vtkIdType cell, std::int64_t index[3])
{
  int n[3];
  grid->GetDimensions(n);
  index[0] = cell % (n[0] - 1);
  index[1] = cell / (n[0] - 1) % (n[1] - 1);
  index[2] = cell / (n[0] - 1) / (n[1] - 1);
}

/// Maps points from cell indices to the position of the grid.
void PlacePoints(vtkImageData* grid, vtkPolyData* scene)
{
  int extent[6];
  grid->GetExtent(extent);
  auto* points = static_cast<double*>(scene->GetPoints()->GetVoidPointer(0));
  vtkSMPTools::For(0, scene->GetNumberOfPoints(),
    [grid, points, &extent](vtkIdType begin, vtkIdType end)
    {
      for (double* p = points + 3 * begin; p != points + 3 * end; p += 3)
      {
        const double index[3] = { p[0] + extent[0], p[1] + extent[2], p[2] + extent[4] };
        grid->TransformContinuousIndexToPhysicalPoint(index, p);
      }
    });
}

/// Writes the materials, and the material of each triangle.
template <typename GetCell>
void SetMaterialsInTurn(vtkPolyData* scene, int count, GetCell&& getCell)
{
  vtkNew<vtkIntArray> ids;
  ids->SetName(names::MaterialIds);
  ids->SetNumberOfValues(scene->GetNumberOfPolys());
  for (vtkIdType i = 0; i < scene->GetNumberOfPolys(); ++i)
  {
    ids->SetValue(i, static_cast<int>(getCell(i) % count));
  }
  scene->GetCellData()->AddArray(ids);
  helios::MaterialTable materials(static_cast<std::size_t>(count));
  for (int i = 0; count > 1 && i < count; ++i)
  {
    materials[static_cast<std::size_t>(i)].Name += '.' + std::to_string(i);
  }
  helios::SetMaterials(scene, materials);
}

} // namespace

//------------------------------------------------------------------------------
int vtkHeliosVoxelCubes::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosVoxelCubes::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  info->Set(Pipeline::UPDATE_EXTENT(), info->Get(Pipeline::WHOLE_EXTENT()), 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosVoxelCubes::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* grid = vtkImageData::GetData(inputVector[0]);
  vtkDataArray* pad = grid->GetCellData()->GetArray(names::PAD);
  if (!pad || pad->GetNumberOfComponents() != 1)
  {
    vtkErrorMacro(<< "the image has no cell array " << names::PAD
                  << " of one component; give it the plant area density of its cells [m2/m3]");
    return 0;
  }
  const CellValues values(grid);
  std::vector<vtkIdType> cells;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (values.IsOpaque(cell) && (this->Mode == FIXED || values.GetPad(cell) > 0.0))
    {
      cells.push_back(cell);
    }
  }
  this->NumberOfCubes = static_cast<vtkIdType>(cells.size());
  int n[3];
  grid->GetDimensions(n);
  if (this->NumberOfCubes > this->MaximumNumberOfCubes ||
    *std::max_element(n, n + 3) > helios::MaximumVoxelsAlongAxis)
  {
    vtkErrorMacro(
      << "the image has " << this->NumberOfCubes << " opaque cells, and "
      << *std::max_element(n, n + 3) - 1
      << " along its longest axis, more than MaximumNumberOfCubes (" << this->MaximumNumberOfCubes
      << ") or 2097148; use fewer cells, or use them as a turbid medium (input 2 of the scanner)");
    return 0;
  }
  const helios::Status status = helios::CheckMemory("cubes of twelve triangles",
    static_cast<double>(this->NumberOfCubes), 12.0 * helios::BytesPerTriangle);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  vtkPolyData* scene = vtkPolyData::GetData(outputVector);
  this->Mode == FIXED ? this->WriteFixed(grid, cells, scene)
                      : this->WriteScaled(grid, cells, scene);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosVoxelCubes::WriteFixed(
  vtkImageData* grid, const std::vector<vtkIdType>& cells, vtkPolyData* scene)
{
  std::vector<helios::VoxelMap::Entry> entries;
  entries.reserve(cells.size());
  for (const vtkIdType cell : cells)
  {
    std::int64_t index[3];
    GetIndex(grid, cell, index);
    entries.push_back({ helios::MakeVoxelKey(index), 0 });
  }
  const helios::VoxelMesh mesh(entries);
  const double origin[3] = { 0.0, 0.0, 0.0 };
  mesh.Write(origin, 1.0, scene);
  PlacePoints(grid, scene);
  scene->GetFieldData()->PassData(grid->GetFieldData());
  std::vector<vtkIdType> owners;
  owners.reserve(static_cast<std::size_t>(mesh.GetNumberOfTriangles()));
  mesh.ForEachTriangle([&](std::size_t cube, int) { owners.push_back(cells[cube]); });
  SetMaterialsInTurn(scene, this->NumberOfMaterials,
    [&owners](vtkIdType triangle) { return owners[static_cast<std::size_t>(triangle)]; });
}

//------------------------------------------------------------------------------
void vtkHeliosVoxelCubes::WriteScaled(
  vtkImageData* grid, const std::vector<vtkIdType>& cells, vtkPolyData* scene)
{
  const CellValues values(grid);
  helios::MeshBuilder builder;
  builder.Reserve(8 * this->NumberOfCubes, 12 * this->NumberOfCubes);
  for (const vtkIdType cell : cells)
  {
    const double scale = values.GetScale(cell, this->Exponent);
    const auto u = helios::Uniform4(static_cast<std::uint64_t>(this->Seed),
      helios::RandomStream::VoxelShift, static_cast<std::uint64_t>(cell), 0);
    std::int64_t index[3];
    GetIndex(grid, cell, index);
    helios::Vec3 low;
    helios::Vec3 high;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double share = this->RandomShift ? u[static_cast<std::size_t>(axis)] : 0.5;
      low[axis] = static_cast<double>(index[axis]) + share * (1.0 - scale);
      high[axis] = low[axis] + scale;
    }
    builder.AddBox(low, high);
  }
  const double offset[3] = { 0.0, 0.0, 0.0 };
  builder.Finish(scene, offset);
  PlacePoints(grid, scene);
  scene->GetFieldData()->PassData(grid->GetFieldData());
  SetMaterialsInTurn(scene, this->NumberOfMaterials,
    [&cells](vtkIdType triangle) { return cells[static_cast<std::size_t>(triangle / 12)]; });
}

//------------------------------------------------------------------------------
void vtkHeliosVoxelCubes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << (this->Mode == FIXED ? "Fixed" : "Scaled") << '\n'
     << indent << "Exponent: " << this->Exponent << '\n'
     << indent << "RandomShift: " << this->RandomShift << '\n'
     << indent << "Seed: " << this->Seed << '\n'
     << indent << "NumberOfMaterials: " << this->NumberOfMaterials << '\n'
     << indent << "MaximumNumberOfCubes: " << this->MaximumNumberOfCubes << '\n'
     << indent << "NumberOfCubes: " << this->NumberOfCubes << '\n';
}
