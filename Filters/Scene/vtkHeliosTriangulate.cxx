// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosTriangulate.h"

#include "heliosPolygonTriangulator.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <limits>

vtkStandardNewMacro(vtkHeliosTriangulate);

namespace
{

/// Returns the points in double precision, of a mesh that may have none.
vtkSmartPointer<vtkDoubleArray> GetDoubles(vtkPolyData* mesh)
{
  vtkDataArray* given = mesh->GetPoints() ? mesh->GetPoints()->GetData() : nullptr;
  if (auto* doubles = vtkDoubleArray::SafeDownCast(given))
  {
    return doubles;
  }
  auto copy = vtkSmartPointer<vtkDoubleArray>::New();
  given ? copy->DeepCopy(given) : copy->SetNumberOfComponents(3);
  return copy;
}

/// The triangles of a mesh, and the cell that each is made of.
class TriangleMaker
{
public:
  explicit TriangleMaker(vtkPolyData* mesh)
    : Mesh(mesh)
    , Points(GetDoubles(mesh))
  {
    this->Triangles->Use32BitStorage();
  }

  void Make()
  {
    vtkIdType cell = this->Mesh->GetNumberOfVerts() + this->Mesh->GetNumberOfLines();
    this->Visit(this->Mesh->GetPolys(), cell, &TriangleMaker::AddPolygon);
    this->Visit(this->Mesh->GetStrips(), cell, &TriangleMaker::AddStrip);
  }

  void MoveTo(vtkPolyData* output) const
  {
    output->SetPoints(this->Mesh->GetPoints());
    output->GetPointData()->PassData(this->Mesh->GetPointData());
    output->SetFieldData(this->Mesh->GetFieldData());
    output->SetPolys(this->Triangles);
    vtkCellData* from = this->Mesh->GetCellData();
    output->GetCellData()->CopyAllocate(from, static_cast<vtkIdType>(this->Cells.size()));
    for (std::size_t i = 0; i < this->Cells.size(); ++i)
    {
      output->GetCellData()->CopyData(from, this->Cells[i], static_cast<vtkIdType>(i));
    }
  }

  vtkIdType NumberOfCrossed = 0;
  vtkIdType FirstCrossed = -1;

private:
  using Ids = const vtkIdType*;

  void Visit(
    vtkCellArray* cells, vtkIdType& cell, void (TriangleMaker::*add)(vtkIdType, vtkIdType, Ids))
  {
    auto each = vtk::TakeSmartPointer(cells->NewIterator());
    for (each->GoToFirstCell(); !each->IsDoneWithTraversal(); each->GoToNextCell(), ++cell)
    {
      vtkIdType count = 0;
      Ids ids = nullptr;
      each->GetCurrentCell(count, ids);
      (this->*add)(cell, count, ids);
    }
  }

  void AddPolygon(vtkIdType cell, vtkIdType count, Ids ids)
  {
    if (count == 3)
    {
      this->AddTriangle(cell, ids[0], ids[1], ids[2]);
      return;
    }
    this->Rings.front().assign(ids, ids + count);
    if (!this->Triangulator.Triangulate(this->Points->GetPointer(0), this->Rings))
    {
      this->FirstCrossed = this->NumberOfCrossed++ == 0 ? cell : this->FirstCrossed;
    }
    const std::vector<vtkTypeInt32>& corners = this->Triangulator.GetCorners();
    for (std::size_t i = 0; i < corners.size(); i += 3)
    {
      this->AddTriangle(cell, corners[i], corners[i + 1], corners[i + 2]);
    }
  }

  /// Adds the triangles of a strip; every second one is turned.
  void AddStrip(vtkIdType cell, vtkIdType count, Ids ids)
  {
    for (vtkIdType i = 0; i + 2 < count; ++i)
    {
      const vtkIdType odd = i % 2;
      this->AddTriangle(cell, ids[i + odd], ids[i + 1 - odd], ids[i + 2]);
    }
  }

  void AddTriangle(vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c)
  {
    this->Triangles->InsertNextCell({ a, b, c });
    this->Cells.push_back(cell);
  }

  vtkPolyData* Mesh;
  vtkSmartPointer<vtkDoubleArray> Points;
  helios::PolygonRings Rings{ {} };
  helios::PolygonTriangulator Triangulator;
  vtkNew<vtkCellArray> Triangles;
  std::vector<vtkIdType> Cells;
};

} // namespace

//------------------------------------------------------------------------------
bool vtkHeliosTriangulate::HasOnlyTriangles(vtkPolyData* mesh)
{
  return mesh->GetNumberOfCells() == mesh->GetNumberOfPolys() &&
    (mesh->GetNumberOfPolys() == 0 || mesh->GetPolys()->IsHomogeneous() == 3);
}

//------------------------------------------------------------------------------
int vtkHeliosTriangulate::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->NumberOfCrossedPolygons = 0;
  if (HasOnlyTriangles(mesh))
  {
    output->ShallowCopy(mesh);
    return 1;
  }
  if (mesh->GetNumberOfPoints() > std::numeric_limits<vtkTypeInt32>::max())
  {
    vtkErrorMacro("The mesh has " << mesh->GetNumberOfPoints()
                                  << " points, above 2^31 - 1; split it into several meshes");
    return 0;
  }
  TriangleMaker maker(mesh);
  maker.Make();
  maker.MoveTo(output);
  this->NumberOfCrossedPolygons = maker.NumberOfCrossed;
  if (maker.NumberOfCrossed > 0)
  {
    vtkWarningMacro("The sides of polygon "
      << maker.FirstCrossed << " cross, so its triangles may be wrong (" << maker.NumberOfCrossed
      << " such polygons in this mesh); correct it");
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosTriangulate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfCrossedPolygons: " << this->NumberOfCrossedPolygons << "\n";
}
