// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPlantAreaDensity.h"

#include "heliosCellGrid.h"
#include "heliosFoliageArrays.h"
#include "heliosFoliageBeams.h"
#include "heliosFoliageColumns.h"
#include "heliosFoliageGrid.h"
#include "heliosLeafProjection.h"
#include "heliosMemoryCheck.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkBoundingBox.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <vector>

vtkStandardNewMacro(vtkHeliosPlantAreaDensity);

namespace names = vtkHeliosArrayNames;

namespace
{

enum Ports
{
  ECHOES,
  PULSES,
  HITS,
  TRAJECTORY,
  GRID,
  NUMBER_OF_PORTS
};

constexpr vtkIdType BeamsPerStep = 1 << 20; // between two checks of AbortExecute
constexpr double BytesPerCell = 200.0;      // sums and output arrays, besides those of threads

/// Returns the data of an input port; null if nothing is connected.
template <typename DataT>
DataT* FindInput(vtkInformationVector** inputVector, int port)
{
  return inputVector[port]->GetNumberOfInformationObjects() > 0 ? DataT::GetData(inputVector[port])
                                                                : nullptr;
}

/// Computes the bounds of the hits that are counted.
vtkBoundingBox ComputeBounds(const helios::FoliageBeams& beams)
{
  vtkBoundingBox box;
  for (vtkIdType beam = 0; beam < beams.GetNumberOfBeams(); ++beam)
  {
    for (const auto* hit = beams.BeginHits(beam); hit != beams.EndHits(beam); ++hit)
    {
      if (hit->Weight > 0.0)
      {
        helios::Vec3 point = beams.GetOrigin(beam) + hit->Range * beams.GetDirection(beam);
        box.AddPoint(point.GetData());
      }
    }
  }
  return box;
}

} // namespace

/// Classes and materials that are counted.
class vtkHeliosPlantAreaDensity::Internals
{
public:
  std::vector<int> Classes;
  std::vector<int> Materials;
};

//------------------------------------------------------------------------------
vtkHeliosPlantAreaDensity::vtkHeliosPlantAreaDensity()
  : Counted(new Internals)
{
  this->SetNumberOfInputPorts(NUMBER_OF_PORTS);
  std::fill_n(this->BeamOrigin, 3, std::numeric_limits<double>::quiet_NaN());
}

vtkHeliosPlantAreaDensity::~vtkHeliosPlantAreaDensity() = default;

//------------------------------------------------------------------------------
void vtkHeliosPlantAreaDensity::AddCountedClass(int id)
{
  this->Counted->Classes.push_back(id);
  this->Modified();
}

void vtkHeliosPlantAreaDensity::AddCountedMaterial(int id)
{
  this->Counted->Materials.push_back(id);
  this->Modified();
}

bool vtkHeliosPlantAreaDensity::IsPlantClass(int id)
{
  return helios::IsPlantClass(id);
}

void vtkHeliosPlantAreaDensity::RemoveAllCounted()
{
  *this->Counted = {};
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkHeliosPlantAreaDensity::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == GRID ? "vtkImageData" : "vtkPolyData");
  if (port != ECHOES)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
/// The extent of the output is known once the echoes are.
int vtkHeliosPlantAreaDensity::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Remove(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST());
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosPlantAreaDensity::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int port = 0; port < NUMBER_OF_PORTS; ++port)
  {
    vtkInformation* info = inputVector[port]->GetInformationObject(0);
    if (info && port == GRID && info->Has(Pipeline::WHOLE_EXTENT()))
    {
      info->Set(Pipeline::UPDATE_EXTENT(), info->Get(Pipeline::WHOLE_EXTENT()), 6);
    }
    else if (info)
    {
      info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
      info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkHeliosPlantAreaDensity::BuildBeams(
  vtkInformationVector** inputVector, helios::FoliageBeams& beams)
{
  helios::FoliageInput input;
  input.Echoes = FindInput<vtkPolyData>(inputVector, ECHOES);
  input.Pulses = FindInput<vtkPolyData>(inputVector, PULSES);
  input.Hits = FindInput<vtkPolyData>(inputVector, HITS);
  input.Trajectory = FindInput<vtkPolyData>(inputVector, TRAJECTORY);
  const bool hasOrigin =
    std::all_of(this->BeamOrigin, this->BeamOrigin + 3, [](double x) { return std::isfinite(x); });
  input.Origin = hasOrigin ? this->BeamOrigin : nullptr;
  input.EchoShares = static_cast<helios::FoliageInput::Shares>(this->EchoShares);
  input.ElementReflectance = this->ElementReflectance;
  input.Classes = this->Counted->Classes;
  input.Materials = this->Counted->Materials;
  input.UsesIncidence = this->LeafAngleDistribution == INCIDENCE_ANGLES;
  if (input.UsesIncidence && this->Estimator < MAXIMUM_LIKELIHOOD)
  {
    return "Estimator is not one of maximum likelihood, which INCIDENCE_ANGLES needs; choose "
           "another LeafAngleDistribution or Estimator";
  }
  if (!input.Echoes->GetPoints() || (input.Pulses && !input.Pulses->GetPoints()) ||
    (input.Hits && !input.Hits->GetPoints()))
  {
    return "echoes, pulses or hits have no points; give clouds with points";
  }
  return beams.Build(input).Message();
}

//------------------------------------------------------------------------------
std::string vtkHeliosPlantAreaDensity::SetGrid(
  const helios::FoliageBeams& beams, vtkImageData* given, vtkImageData* grid)
{
  if (given)
  {
    grid->CopyStructure(given);
  }
  else
  {
    const double* b = this->GridBounds;
    vtkBoundingBox box;
    const bool isSet = b[0] < b[1] && b[2] < b[3] && b[4] < b[5];
    box = isSet ? vtkBoundingBox(b) : ComputeBounds(beams);
    if (!box.IsValid())
    {
      return "no echo is of a plant that is counted, so that the grid has no bounds; correct the "
             "counted classes and materials, or set GridBounds";
    }
    int count[3];
    double corner[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = box.GetMinPoint()[axis];
      const double size = this->VoxelSize;
      corner[axis] = isSet ? low : size * std::floor(low / size);
      const double cells = (box.GetMaxPoint()[axis] - corner[axis]) / size;
      const double whole = isSet ? std::ceil(cells * (1.0 - 1e-12)) : std::floor(cells) + 1.0;
      if (!(whole < 2e9))
      {
        return "the grid has " + std::to_string(cells) + " cells along an axis; raise VoxelSize (" +
          std::to_string(size) + " m) or set GridBounds";
      }
      count[axis] = static_cast<int>(whole);
    }
    grid->SetDimensions(count[0] + 1, count[1] + 1, count[2] + 1);
    grid->SetOrigin(corner);
    grid->SetSpacing(this->VoxelSize, this->VoxelSize, this->VoxelSize);
  }
  int points[3];
  grid->GetDimensions(points);
  const double cells = std::max(points[0] - 1.0, 0.0) * std::max(points[1] - 1.0, 0.0) *
    std::max(points[2] - 1.0, 0.0);
  if (cells > static_cast<double>(this->MaximumNumberOfCells) || cells < 1.0)
  {
    return "the grid has " + std::to_string(static_cast<vtkIdType>(cells)) +
      " cells, expected 1 to MaximumNumberOfCells (" + std::to_string(this->MaximumNumberOfCells) +
      "); change VoxelSize or the bounds";
  }
  const double threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  return helios::CheckMemory(
    "cells", cells, BytesPerCell + threads * helios::FoliageGrid::BytesPerCell)
    .Message();
}

//------------------------------------------------------------------------------
std::string vtkHeliosPlantAreaDensity::SetLeaves(
  vtkImageData* given, helios::LeafProjection& leaves)
{
  if (this->LeafAngleDistribution == TABLE)
  {
    vtkDataArray* table = given ? given->GetFieldData()->GetArray(names::LeafProjection) : nullptr;
    return table ? leaves.Set(table).Message()
                 : std::string("input 4 has no field array ") + names::LeafProjection +
        ", the table of LeafAngleDistribution; give it rows x y z G, or choose a distribution";
  }
  if (this->LeafAngleDistribution != INCIDENCE_ANGLES)
  {
    leaves.Set(static_cast<helios::LeafProjection::Distribution>(this->LeafAngleDistribution),
      this->EllipsoidRatio);
  }
  return {};
}

//------------------------------------------------------------------------------
std::string vtkHeliosPlantAreaDensity::AddBeams(const helios::FoliageBeams& beams,
  const helios::LeafProjection& leaves, vtkImageData* given, vtkImageData* grid)
{
  helios::CellGrid cells;
  if (const helios::Status status = cells.Set(grid); !status.IsOk())
  {
    return status.Message();
  }
  helios::FoliageSettings settings;
  settings.Estimator = static_cast<helios::FoliageEstimator>(this->Estimator);
  settings.ElementArea = this->ElementArea;
  const double* size = grid->GetSpacing();
  settings.CellVolume = size[0] * size[1] * size[2];
  settings.MinimumPath = this->MinimumNumberOfBeams * std::cbrt(settings.CellVolume);
  const double attenuation = this->ElementArea / settings.CellVolume;
  if (attenuation * cells.GetDiagonal() > 0.5)
  {
    return "ElementArea is " + std::to_string(this->ElementArea) + " m2, too large for cells of " +
      std::to_string(settings.CellVolume) + " m3, which it fills; give larger cells";
  }
  helios::FoliageGrid sums(cells, leaves, this->LeafAngleDistribution == INCIDENCE_ANGLES);
  sums.SetElementAttenuation(attenuation);
  sums.SetMaximumRange(this->MaximumRange);
  const vtkIdType count = beams.GetNumberOfBeams();
  for (vtkIdType begin = 0; begin < count && !this->AbortExecute; begin += BeamsPerStep)
  {
    sums.Add(beams, begin, std::min(begin + BeamsPerStep, count));
    this->UpdateProgress(static_cast<double>(begin) / static_cast<double>(count));
  }
  if (this->AbortExecute)
  {
    return "it was aborted; update again to complete it";
  }
  std::vector<helios::FoliageSums> all = helios::ReadSums(given ? given : grid);
  sums.GetSums(all);
  helios::AddFoliageArrays(all, settings, grid);
  helios::AddLeafTable(leaves, grid);
  return {};
}

//------------------------------------------------------------------------------
int vtkHeliosPlantAreaDensity::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* given = FindInput<vtkImageData>(inputVector, GRID);
  vtkImageData* grid = vtkImageData::GetData(outputVector);
  std::string error;
  try
  {
    helios::FoliageBeams beams;
    helios::LeafProjection leaves;
    error = this->BuildBeams(inputVector, beams);
    error = error.empty() ? this->SetGrid(beams, given, grid) : error;
    error = error.empty() ? this->SetLeaves(given, leaves) : error;
    error = error.empty() ? this->AddBeams(beams, leaves, given, grid) : error;
    this->NumberOfBeams = error.empty() ? beams.GetNumberOfBeams() : 0;
  }
  catch (const std::bad_alloc&)
  {
    error = "not enough memory for the beams and the grid; give fewer beams or larger cells";
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  outputVector->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), grid->GetExtent(), 6);
  if (vtkFieldData* field = FindInput<vtkPolyData>(inputVector, ECHOES)->GetFieldData())
  {
    if (vtkAbstractArray* crs = field->GetAbstractArray(names::CRS))
    {
      grid->GetFieldData()->AddArray(crs);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosPlantAreaDensity::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Estimator: " << this->Estimator << '\n'
     << indent << "LeafAngleDistribution: " << this->LeafAngleDistribution << '\n'
     << indent << "EllipsoidRatio: " << this->EllipsoidRatio << '\n'
     << indent << "EchoShares: " << this->EchoShares << '\n'
     << indent << "ElementReflectance: " << this->ElementReflectance << '\n'
     << indent << "VoxelSize: " << this->VoxelSize << '\n'
     << indent << "ElementArea: " << this->ElementArea << '\n'
     << indent << "MaximumRange: " << this->MaximumRange << '\n'
     << indent << "MinimumNumberOfBeams: " << this->MinimumNumberOfBeams << '\n'
     << indent << "MaximumNumberOfCells: " << this->MaximumNumberOfCells << '\n'
     << indent << "NumberOfBeams: " << this->NumberOfBeams << '\n';
}
