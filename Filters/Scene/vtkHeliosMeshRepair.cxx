// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosMeshRepair.h"

#include "heliosMeshRecords.h"
#include "heliosPointMerger.h"
#include "heliosSceneSubset.h"
#include "heliosStatus.h"
#include "heliosTriangleArea.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeliosMeshRepair);

namespace names = vtkHeliosArrayNames;

/// The mesh under repair. Vectors with one element per triangle shrink with the triangles.
struct vtkHeliosMeshRepair::Mesh
{
  vtkSmartPointer<vtkDoubleArray> Points;
  std::vector<vtkIdType> Cells;      ///< remaining cells of the input
  std::vector<vtkTypeInt32> Corners; ///< three per cell
  std::vector<vtkTypeInt32> Places;  ///< three per cell: the lowest point at the corner
  std::vector<int> Parts;            ///< one per cell
  std::vector<unsigned char> Defects;
  vtkIdType NumberOfTriangles = 0; ///< number of triangles of the input

  vtkIdType GetSize() const { return static_cast<vtkIdType>(this->Cells.size()); }
  const double* GetPoint(vtkTypeInt32 id) const
  {
    return this->Points->GetPointer(3 * static_cast<vtkIdType>(id));
  }
  helios::Triangles GetPlaces() const
  {
    return { this->Places.data(), this->Parts.data(), this->GetSize(),
      this->Points->GetNumberOfTuples() };
  }

  /// Keeps the cells i with keep(i); returns the number dropped.
  template <typename FilterT>
  vtkIdType FilterCells(FilterT keep)
  {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < this->Cells.size(); ++i)
    {
      if (keep(i))
      {
        this->Cells[kept] = this->Cells[i];
        this->Parts[kept] = this->Parts[i];
        std::copy_n(&this->Corners[3 * i], 3, &this->Corners[3 * kept]);
        std::copy_n(&this->Places[3 * i], 3, &this->Places[3 * kept]);
        ++kept;
      }
    }
    const std::size_t dropped = this->Cells.size() - kept;
    this->Cells.resize(kept);
    this->Parts.resize(kept);
    this->Corners.resize(3 * kept);
    this->Places.resize(3 * kept);
    return static_cast<vtkIdType>(dropped);
  }
};

namespace
{

/// Returns the corners of all cells, or the first cell with an invalid corner id.
template <typename ArrayT>
vtkIdType CopyCorners(ArrayT* from, vtkIdType numberOfPoints, std::vector<vtkTypeInt32>& corners)
{
  const auto* ids = from->GetPointer(0);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    if (ids[i] < 0 || ids[i] >= numberOfPoints)
    {
      return static_cast<vtkIdType>(i / 3);
    }
    corners[i] = static_cast<vtkTypeInt32>(ids[i]);
  }
  return -1;
}

std::vector<int> GetParts(vtkDataArray* ids, vtkIdType count)
{
  std::vector<int> parts(static_cast<std::size_t>(count), 0);
  auto* ints = vtkIntArray::SafeDownCast(ids);
  for (vtkIdType i = 0; ids && i < count; ++i)
  {
    parts[static_cast<std::size_t>(i)] =
      ints ? ints->GetValue(i) : static_cast<int>(ids->GetComponent(i, 0));
  }
  return parts;
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosMeshRepair::ResetCounters()
{
  this->NumberOfNonFiniteTriangles = 0;
  this->NumberOfDegenerateTriangles = 0;
  this->NumberOfDuplicateTriangles = 0;
  this->NumberOfUnusedPoints = 0;
  this->NumberOfMergedPoints = 0;
  this->NumberOfBoundaryEdges = 0;
  this->NumberOfNonManifoldEdges = 0;
  this->NumberOfInconsistentEdges = 0;
}

//------------------------------------------------------------------------------
bool vtkHeliosMeshRepair::Read(vtkPolyData* input, Mesh& mesh)
{
  vtkCellArray* polys = input->GetPolys();
  const vtkIdType count = polys->GetNumberOfCells();
  const vtkIdType numberOfPoints = input->GetNumberOfPoints();
  if (input->GetNumberOfCells() != count || polys->IsHomogeneous() != 3)
  {
    vtkErrorMacro(
      << "The scene has cells that are not triangles; pass it through vtkTriangleFilter first");
    return false;
  }
  if (std::max(numberOfPoints, 3 * count) > std::numeric_limits<vtkTypeInt32>::max())
  {
    vtkErrorMacro(<< "The scene has " << numberOfPoints << " points and " << count
                  << " triangles, more than 2^31 points or corners; split it into several scenes");
    return false;
  }
  const helios::Status shortArray = helios::FindShortArray(input);
  if (!shortArray.IsOk())
  {
    vtkErrorMacro(<< shortArray.Message());
    return false;
  }
  mesh.Corners.resize(3 * static_cast<std::size_t>(count));
  const vtkIdType bad = polys->IsStorage64Bit()
    ? CopyCorners(polys->GetConnectivityArray64(), numberOfPoints, mesh.Corners)
    : CopyCorners(polys->GetConnectivityArray32(), numberOfPoints, mesh.Corners);
  if (bad >= 0)
  {
    vtkErrorMacro(<< "Triangle " << bad << " has a corner that is not one of the scene's "
                  << numberOfPoints << " points; corners are point ids from 0");
    return false;
  }
  mesh.NumberOfTriangles = count;
  mesh.Points = helios::GetDoublePoints(input);
  mesh.Parts = GetParts(input->GetCellData()->GetArray(names::PartIds), count);
  mesh.Places = mesh.Corners;
  mesh.Cells.resize(static_cast<std::size_t>(count));
  std::iota(mesh.Cells.begin(), mesh.Cells.end(), 0);
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosMeshRepair::DropNonFinite(Mesh& mesh)
{
  this->NumberOfNonFiniteTriangles = mesh.FilterCells(
    [&mesh](std::size_t i)
    {
      return std::all_of(&mesh.Corners[3 * i], &mesh.Corners[3 * i] + 3,
        [&mesh](vtkTypeInt32 corner)
        {
          const double* p = mesh.GetPoint(corner);
          return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
        });
    });
}

//------------------------------------------------------------------------------
void vtkHeliosMeshRepair::FindPlaces(Mesh& mesh)
{
  const vtkIdType count = mesh.Points->GetNumberOfTuples();
  std::vector<vtkIdType> users(
    static_cast<std::size_t>(count), -1); // the first triangle of a point
  for (std::size_t i = mesh.Corners.size(); i-- > 0;)
  {
    users[mesh.Corners[i]] = static_cast<vtkIdType>(i / 3);
  }
  helios::PointMerger merger(
    mesh.Points->GetPointer(0), count, this->MergePoints ? this->MergeTolerance : 0.0);
  std::vector<vtkTypeInt32> places(static_cast<std::size_t>(count));
  vtkIdType merged = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const auto point = static_cast<vtkTypeInt32>(i);
    places[i] = users[i] < 0 ? point : merger.Add(point, mesh.Parts[users[i]]);
    merged += places[i] != point;
  }
  for (vtkTypeInt32& place : mesh.Places)
  {
    place = places[place];
  }
  if (this->MergePoints)
  {
    this->NumberOfMergedPoints = merged;
    mesh.Corners = mesh.Places;
  }
}

//------------------------------------------------------------------------------
void vtkHeliosMeshRepair::DropDegenerate(Mesh& mesh)
{
  this->NumberOfDegenerateTriangles = mesh.FilterCells(
    [&mesh](std::size_t i)
    {
      const vtkTypeInt32* c = &mesh.Places[3 * i];
      return c[0] != c[1] && c[1] != c[2] && c[2] != c[0] &&
        helios::SpansArea(mesh.GetPoint(c[0]), mesh.GetPoint(c[1]), mesh.GetPoint(c[2]));
    });
}

//------------------------------------------------------------------------------
void vtkHeliosMeshRepair::DropDuplicates(Mesh& mesh)
{
  const std::vector<helios::FaceRecord> faces = helios::SortFaces(mesh.GetPlaces());
  std::vector<bool> isDuplicate(mesh.Cells.size(), false);
  for (std::size_t i = 1; i < faces.size(); ++i)
  {
    isDuplicate[faces[i].Cell] = faces[i].IsSameFace(faces[i - 1]);
  }
  this->NumberOfDuplicateTriangles =
    mesh.FilterCells([&isDuplicate](std::size_t i) { return !isDuplicate[i]; });
}

//------------------------------------------------------------------------------
void vtkHeliosMeshRepair::CheckEdges(Mesh& mesh)
{
  mesh.Defects.assign(mesh.Cells.size(), 0);
  helios::ForEachEdge(helios::SortSides(mesh.GetPlaces()),
    [this, &mesh](const helios::SideRecord* first, const helios::SideRecord* last)
    {
      const vtkTypeInt32* corners = mesh.Places.data();
      const auto uses = last - first;
      const bool isInconsistent = uses == 2 &&
        helios::IsAscending(first[0], corners) == helios::IsAscending(first[1], corners);
      this->NumberOfBoundaryEdges += uses == 1;
      this->NumberOfNonManifoldEdges += uses > 2;
      this->NumberOfInconsistentEdges += isInconsistent;
      const int defect = uses == 1 ? BOUNDARY
        : uses > 2                 ? NON_MANIFOLD
        : isInconsistent           ? INCONSISTENT
                                   : 0;
      for (; first != last; ++first)
      {
        mesh.Defects[first->Use / 3] |= static_cast<unsigned char>(defect);
      }
    });
}

//------------------------------------------------------------------------------
void vtkHeliosMeshRepair::Write(const Mesh& mesh, vtkPolyData* input, vtkPolyData* output)
{
  const bool isWhole = mesh.GetSize() == mesh.NumberOfTriangles && this->NumberOfMergedPoints == 0;
  const vtkIdType points = helios::ExtractTriangles(input, mesh.Cells, mesh.Corners, output);
  this->NumberOfUnusedPoints = input->GetNumberOfPoints() - points - this->NumberOfMergedPoints;
  if (isWhole && this->NumberOfUnusedPoints == 0)
  {
    output->SetPolys(input->GetPolys());
  }
  if (this->GenerateEdgeDefects)
  {
    vtkNew<vtkUnsignedCharArray> defects;
    defects->SetName(names::EdgeDefects);
    defects->SetNumberOfValues(mesh.GetSize());
    std::copy(mesh.Defects.begin(), mesh.Defects.end(), defects->GetPointer(0));
    output->GetCellData()->AddArray(defects);
  }
}

//------------------------------------------------------------------------------
int vtkHeliosMeshRepair::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  if (const helios::Status status = helios::CheckNoInstances(input); !status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->ResetCounters();
  if (!std::isfinite(this->MergeTolerance))
  {
    vtkErrorMacro(<< "MergeTolerance is " << this->MergeTolerance
                  << "; set a finite length of at least 0 m");
    return 0;
  }
  if (input->GetNumberOfCells() == 0)
  {
    output->ShallowCopy(input);
    output->SetPoints(vtkSmartPointer<vtkPoints>::Take(vtkPoints::New(VTK_DOUBLE)));
    output->GetPointData()->Initialize();
    this->NumberOfUnusedPoints = input->GetNumberOfPoints();
    return 1;
  }
  Mesh mesh;
  if (!this->Read(input, mesh))
  {
    return 0;
  }
  using Step = void (vtkHeliosMeshRepair::*)(Mesh&);
  const Step steps[] = { &vtkHeliosMeshRepair::DropNonFinite, &vtkHeliosMeshRepair::FindPlaces,
    &vtkHeliosMeshRepair::DropDegenerate, &vtkHeliosMeshRepair::DropDuplicates,
    &vtkHeliosMeshRepair::CheckEdges };
  double progress = 0.1;
  for (const Step step : steps)
  {
    (this->*step)(mesh);
    this->UpdateProgress(progress += 0.15);
    if (this->GetAbortExecute())
    {
      vtkErrorMacro(<< "The work was aborted at " << 100.0 * progress
                    << " %; update again to complete it");
      return 0;
    }
  }
  this->Write(mesh, input, output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosMeshRepair::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergePoints: " << this->MergePoints << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "GenerateEdgeDefects: " << this->GenerateEdgeDefects << "\n";
  os << indent << "NumberOfNonFiniteTriangles: " << this->NumberOfNonFiniteTriangles << "\n";
  os << indent << "NumberOfDegenerateTriangles: " << this->NumberOfDegenerateTriangles << "\n";
  os << indent << "NumberOfDuplicateTriangles: " << this->NumberOfDuplicateTriangles << "\n";
  os << indent << "NumberOfUnusedPoints: " << this->NumberOfUnusedPoints << "\n";
  os << indent << "NumberOfMergedPoints: " << this->NumberOfMergedPoints << "\n";
  os << indent << "NumberOfBoundaryEdges: " << this->NumberOfBoundaryEdges << "\n";
  os << indent << "NumberOfNonManifoldEdges: " << this->NumberOfNonManifoldEdges << "\n";
  os << indent << "NumberOfInconsistentEdges: " << this->NumberOfInconsistentEdges << "\n";
}
