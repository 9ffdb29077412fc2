// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPointVoxelizer.h"

#include "heliosMemoryCheck.h"
#include "heliosStatus.h"
#include "heliosVoxelInput.h"
#include "heliosVoxelScene.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosMemoryLimit.h"

#include <vtkAlgorithmOutput.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>
#include <new>

vtkStandardNewMacro(vtkHeliosPointVoxelizer);

namespace names = vtkHeliosArrayNames;
using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace
{

constexpr double BytesPerCell = 500.0;     // at most, with its triangles
constexpr int ProbePieces = 65536;         // power of 4: a small share of any source
constexpr vtkIdType PointsPerStep = 65536; // between two checks of AbortExecute
constexpr double SharePerVisit = 0.45;     // share of the progress; the rest is for the triangles

bool CanBePieces(vtkInformation* inInfo)
{
  return inInfo->Get(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST()) != 0;
}

} // namespace

int vtkHeliosPointVoxelizer::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

// States that the output is always complete, even if the input comes in pieces.
int vtkHeliosPointVoxelizer::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Remove(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST());
  return 1;
}

int vtkHeliosPointVoxelizer::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  vtkInformation* inInfo = inputVector[0]->GetInformationObject(0);
  const int pieces = this->NumberOfPieces > 0 ? this->NumberOfPieces : ProbePieces;
  inInfo->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  inInfo->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), CanBePieces(inInfo) ? pieces : 1);
  inInfo->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  return 1;
}

bool vtkHeliosPointVoxelizer::CheckProperties()
{
  if (!std::isfinite(this->VoxelSize) || this->VoxelSize <= 0.0)
  {
    vtkErrorMacro(<< "VoxelSize is " << this->VoxelSize << " m; set a number greater than 0");
    return false;
  }
  const double* n = this->DefaultNormal;
  if (!std::isfinite(n[0]) || !std::isfinite(n[1]) || !std::isfinite(n[2]))
  {
    vtkErrorMacro(<< "DefaultNormal is (" << n[0] << ", " << n[1] << ", " << n[2]
                  << "); set finite numbers, 0 0 0 for none");
    return false;
  }
  return true;
}

// Updates the input to a piece; a source without pieces delivers everything.
bool vtkHeliosPointVoxelizer::FetchPiece(vtkInformation* inInfo, int piece, int count)
{
  if (!CanBePieces(inInfo))
  {
    return true;
  }
  vtkAlgorithmOutput* source = this->GetInputConnection(0, 0);
  vtkNew<vtkInformation> wanted;
  wanted->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
  wanted->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), count);
  wanted->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  vtkNew<vtkInformationVector> requests;
  requests->SetInformationObject(source->GetIndex(), wanted);
  return source->GetProducer()->Update(source->GetIndex(), requests) != 0;
}

// Reads the first of fewer and fewer pieces, until it has enough points and grew with its share.
// Returns 0 if a piece cannot be read.
int vtkHeliosPointVoxelizer::ChooseNumberOfPieces(vtkInformation* inInfo)
{
  if (!CanBePieces(inInfo) || this->NumberOfPieces > 0)
  {
    return std::max(1, CanBePieces(inInfo) ? this->NumberOfPieces : 1);
  }
  constexpr vtkIdType enough = 1000;
  vtkIdType last = 0;
  for (int count = ProbePieces; count > 1; count /= 4)
  {
    if (!this->FetchPiece(inInfo, 0, count))
    {
      return 0;
    }
    auto* data = vtkPointSet::GetData(inInfo);
    const vtkIdType found = data ? data->GetNumberOfPoints() : 0;
    if (last > 0 && found >= enough && found >= 2 * last)
    {
      const double pieces = static_cast<double>(found) * count / this->PointsPerPiece;
      return static_cast<int>(std::clamp(std::ceil(pieces), 1.0, 1e6));
    }
    last = found;
  }
  return 1;
}

bool vtkHeliosPointVoxelizer::IsAborted(double progress)
{
  this->UpdateProgress(progress);
  if (this->AbortExecute)
  {
    vtkErrorMacro(<< "Voxelizing was aborted at " << static_cast<int>(100.0 * progress)
                  << " %; update again to complete it");
    return true;
  }
  return false;
}

bool vtkHeliosPointVoxelizer::ForEachPiece(
  vtkInformation* inInfo, int count, double progress, const PieceVisitor& visit)
{
  helios::VoxelInput input;
  for (int piece = 0; piece < count; ++piece)
  {
    if (!this->FetchPiece(inInfo, piece, count))
    {
      return false; // the source has reported the error
    }
    const helios::Status status = input.Set(vtkPointSet::GetData(inInfo), !this->EstimateNormals);
    if (!status.IsOk())
    {
      vtkErrorMacro(<< "Input: " << status.Message());
      return false;
    }
    const vtkIdType size = input.GetNumberOfPoints();
    vtkIdType done = 0;
    do
    {
      const vtkIdType end = std::min(size, done + PointsPerStep);
      input.SetRange(done, end);
      if (!visit(input))
      {
        return false;
      }
      done = end;
      const double share = size > 0 ? static_cast<double>(done) / static_cast<double>(size) : 1.0;
      if (this->IsAborted(progress + SharePerVisit * (piece + share) / count))
      {
        return false;
      }
    } while (done < size);
  }
  return true;
}

bool vtkHeliosPointVoxelizer::CheckBounds(const helios::VoxelBounds& bounds)
{
  if (bounds.Count == 0)
  {
    vtkErrorMacro(<< "Input has no points; connect a source of points, such as vtkHeliosXyzReader");
    return false;
  }
  const double finest = 16.0 * bounds.Epsilon * bounds.GetMagnitude();
  if (this->VoxelSize < finest)
  {
    vtkErrorMacro(<< "VoxelSize is " << this->VoxelSize
                  << " m, below the resolution of coordinates of this size; set " << finest
                  << " m or more");
    return false;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double cells = (bounds.High[axis] - bounds.Low[axis]) / this->VoxelSize;
    if (!(cells < static_cast<double>(helios::MaximumVoxelsAlongAxis)))
    {
      vtkErrorMacro(<< "VoxelSize is " << this->VoxelSize << " m, which makes " << cells
                    << " cells along "
                    << "xyz"[axis] << "; the maximum is " << helios::MaximumVoxelsAlongAxis
                    << ": set a larger one, or remove outliers");
      return false;
    }
  }
  return true;
}

bool vtkHeliosPointVoxelizer::CheckAttributes(const helios::VoxelBounds& bounds)
{
  for (const vtkIdType some : { bounds.NormalCount, bounds.ColorCount })
  {
    if (some > 0 && some < bounds.Count)
    {
      vtkErrorMacro(<< "Input: " << some << " of " << bounds.Count << " points have "
                    << (some == bounds.NormalCount ? names::Normals : names::RGB)
                    << "; give them for all points or for none");
      return false;
    }
  }
  if (this->SnapNeighborNormal && !this->EstimateNormals && bounds.NormalCount == 0)
  {
    vtkErrorMacro(<< "SnapNeighborNormal is on, but the points have no " << names::Normals
                  << "; read them (ReadNormals of the reader), or switch it off");
    return false;
  }
  return true;
}

// Finds the bounds of the points: first pass.
bool vtkHeliosPointVoxelizer::Measure(
  vtkInformation* inInfo, int count, helios::VoxelBounds& bounds, vtkPolyData* scene)
{
  const auto measure = [&](const helios::VoxelInput& input)
  {
    if (bounds.Count == 0 && input.GetNumberOfPoints() > 0)
    {
      scene->GetFieldData()->PassData(vtkPointSet::GetData(inInfo)->GetFieldData());
    }
    const vtkIdType known = bounds.Count;
    const vtkIdType bad = bounds.Add(input);
    if (bad >= 0)
    {
      const double* p = input.Get().Points + 3 * bad;
      vtkErrorMacro(<< "Input point " << known + bad << " is (" << p[0] << ", " << p[1] << ", "
                    << p[2] << "), which is not finite; remove it");
    }
    return bad < 0;
  };
  return this->ForEachPiece(inInfo, count, 0.0, measure) && this->CheckBounds(bounds) &&
    this->CheckAttributes(bounds);
}

// Gathers the cells of the points: second pass.
bool vtkHeliosPointVoxelizer::Gather(
  vtkInformation* inInfo, int count, const helios::VoxelBounds& bounds, helios::VoxelGrid& grid)
{
  helios::VoxelBounds again;
  const auto fails = [&]
  {
    vtkErrorMacro(<< "Input changed while it was read; leave its file unchanged and update again");
    return false;
  };
  const double available = 1048576.0 * vtkHeliosMemoryLimit::GetAvailable() / BytesPerCell;
  const auto maximum = static_cast<vtkIdType>(std::min(available, 4e9));
  const auto gather = [&](const helios::VoxelInput& input)
  {
    if (again.Add(input) >= 0 || !bounds.Holds(again))
    {
      return fails();
    }
    const bool fits = grid.Add(input.Get(), std::min(this->MaximumNumberOfCells, maximum));
    if (!fits && maximum < this->MaximumNumberOfCells)
    {
      vtkErrorMacro(<< "VoxelSize is " << this->VoxelSize << " m: "
                    << helios::CheckMemory(
                         "cells or more", static_cast<double>(maximum + 1), BytesPerCell)
                         .Message()
                    << "; a larger VoxelSize gives fewer");
      return false;
    }
    if (!fits)
    {
      vtkErrorMacro(
        << "VoxelSize is " << this->VoxelSize
        << " m, which makes more cells than MaximumNumberOfCells, " << this->MaximumNumberOfCells
        << "; set a larger one, split the cloud, or allow more, at 250 to 500 bytes each");
    }
    return fits;
  };
  return this->ForEachPiece(inInfo, count, SharePerVisit, gather) &&
    (again.Count == bounds.Count || fails());
}

bool vtkHeliosPointVoxelizer::MakeScene(
  helios::VoxelGrid& grid, const helios::VoxelBounds& bounds, vtkPolyData* scene)
{
  const std::vector<helios::VoxelMap::Entry> cells = grid.ReleaseCells(this->MinimumNumberOfPoints);
  if (cells.empty())
  {
    vtkErrorMacro(<< "No cell of VoxelSize " << this->VoxelSize << " m has "
                  << this->MinimumNumberOfPoints
                  << " points; lower MinimumNumberOfPoints, or set larger cells");
    return false;
  }
  const helios::VoxelMesh mesh(cells);
  const vtkIdType count = mesh.GetNumberOfTriangles();
  if (3 * count > VTK_TYPE_INT32_MAX)
  {
    vtkErrorMacro(<< "VoxelSize is " << this->VoxelSize << " m, which makes " << count
                  << " triangles; the maximum is " << VTK_TYPE_INT32_MAX / 3
                  << ": set a larger one, or split the cloud");
    return false;
  }
  helios::VoxelSceneOptions options;
  options.NumberOfMaterials = this->NumberOfMaterials;
  options.HasVoxelIds = this->GenerateVoxelIds;
  options.HasNormals = this->EstimateNormals || bounds.NormalCount > 0;
  options.HasColors = bounds.ColorCount > 0;
  options.DefaultNormal = helios::GetUnit(helios::Vec3(this->DefaultNormal));
  helios::WriteVoxelScene(grid, cells, mesh, options, scene);
  this->NumberOfPoints = bounds.Count;
  this->NumberOfVoxels = static_cast<vtkIdType>(cells.size());
  return true;
}

int vtkHeliosPointVoxelizer::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->NumberOfPoints = this->NumberOfVoxels = 0;
  vtkInformation* inInfo = inputVector[0]->GetInformationObject(0);
  vtkPolyData* scene = vtkPolyData::GetData(outputVector);
  const int count = this->CheckProperties() ? this->ChooseNumberOfPieces(inInfo) : 0;
  helios::VoxelBounds bounds;
  if (count == 0 || !this->Measure(inInfo, count, bounds, scene))
  {
    return 0;
  }
  helios::VoxelGrid::Contents contents;
  contents.Counts = this->MinimumNumberOfPoints > 1;
  contents.Planes = this->EstimateNormals;
  contents.Nearest = bounds.NormalCount > 0 && this->SnapNeighborNormal;
  contents.Normals = bounds.NormalCount > 0 && !this->SnapNeighborNormal;
  contents.Colors = bounds.ColorCount > 0;
  try
  {
    helios::VoxelGrid grid(bounds.Low, this->VoxelSize, bounds.Epsilon, contents);
    return this->Gather(inInfo, count, bounds, grid) && this->MakeScene(grid, bounds, scene);
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro(<< "Not enough memory for the cells of VoxelSize " << this->VoxelSize
                  << " m; set a larger one, or split the cloud");
    return 0;
  }
}

void vtkHeliosPointVoxelizer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VoxelSize: " << this->VoxelSize << "\n";
  os << indent << "MinimumNumberOfPoints: " << this->MinimumNumberOfPoints << "\n";
  os << indent << "EstimateNormals: " << this->EstimateNormals << "\n";
  os << indent << "SnapNeighborNormal: " << this->SnapNeighborNormal << "\n";
  os << indent << "DefaultNormal: " << this->DefaultNormal[0] << ' ' << this->DefaultNormal[1]
     << ' ' << this->DefaultNormal[2] << "\n";
  os << indent << "NumberOfMaterials: " << this->NumberOfMaterials << "\n";
  os << indent << "GenerateVoxelIds: " << this->GenerateVoxelIds << "\n";
  os << indent << "NumberOfPieces: " << this->NumberOfPieces << "\n";
  os << indent << "PointsPerPiece: " << this->PointsPerPiece << "\n";
  os << indent << "MaximumNumberOfCells: " << this->MaximumNumberOfCells << "\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "NumberOfVoxels: " << this->NumberOfVoxels << "\n";
}
