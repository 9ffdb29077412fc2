// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Point clouds for the voxelizer, complete and in pieces, and measurements on the cells.

#ifndef heliosVoxelTesting_h
#define heliosVoxelTesting_h

#include "heliosErrorObserver.h"
#include "heliosSceneTesting.h"
#include "vtkHeliosPointVoxelizer.h"

#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace helios
{

using Triples = std::vector<std::array<double, 3>>;

inline vtkSmartPointer<vtkDoubleArray> MakeTriples(const char* name, const Triples& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  for (const auto& value : values)
  {
    array->InsertNextTypedTuple(value.data());
  }
  return array;
}

inline vtkSmartPointer<vtkPolyData> MakeCloud(
  const Triples& coordinates, const Triples& normals = {}, const Triples& colors = {})
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(MakeTriples("Points", coordinates));
  cloud->SetPoints(points);
  if (!normals.empty())
  {
    cloud->GetPointData()->SetNormals(MakeTriples(vtkHeliosArrayNames::Normals, normals));
  }
  if (!colors.empty())
  {
    cloud->GetPointData()->AddArray(MakeTriples(vtkHeliosArrayNames::RGB, colors));
  }
  return cloud;
}

/// A cloud that supports pieces, and can fail at a given one.
class PieceSource : public vtkPolyDataAlgorithm
{
public:
  static PieceSource* New();
  vtkTypeMacro(PieceSource, vtkPolyDataAlgorithm);

  vtkSmartPointer<vtkPolyData> Cloud;
  std::set<int> Asked; // piece numbers
  vtkIdType Largest = 0;
  int FailingPiece = -1;
  int BarePiece = -1;                               // piece without attributes
  std::function<void(int, vtkPolyData*)> OnRequest; // may change the piece delivered; counts from 0
  int NumberOfRequests = 0;

protected:
  PieceSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    outputs->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkInformation* info = outputs->GetInformationObject(0);
    const vtkIdType piece = info->Get(Pipeline::UPDATE_PIECE_NUMBER());
    const vtkIdType count = info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
    this->Asked.insert(static_cast<int>(count));
    if (piece == this->FailingPiece)
    {
      vtkErrorMacro(<< "piece " << piece << " is lost");
      return 0;
    }
    const vtkIdType total = this->Cloud->GetNumberOfPoints();
    const vtkIdType begin = total * piece / count;
    const vtkIdType end = total * (piece + 1) / count;
    this->Largest = std::max(this->Largest, end - begin);
    vtkPolyData* output = vtkPolyData::GetData(outputs);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->InsertPoints(0, end - begin, begin, this->Cloud->GetPoints());
    output->SetPoints(points);
    if (piece != this->BarePiece)
    {
      output->GetPointData()->CopyAllOn();
      output->GetPointData()->CopyAllocate(this->Cloud->GetPointData());
      output->GetPointData()->CopyData(this->Cloud->GetPointData(), 0, end - begin, begin);
    }
    output->GetFieldData()->PassData(this->Cloud->GetFieldData());
    if (this->OnRequest)
    {
      this->OnRequest(this->NumberOfRequests++, output);
    }
    return 1;
  }
};
inline vtkStandardNewMacro(PieceSource);

/// A voxelizer with recorded messages.
struct Voxelizing
{
  vtkNew<vtkHeliosPointVoxelizer> Filter;
  vtkSmartPointer<ErrorObserver> Log = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());
  vtkSmartPointer<ErrorObserver> Quiet = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());

  explicit Voxelizing(double size = 1.0)
  {
    this->Log->Watch(this->Filter);
    this->Quiet->Watch(this->Filter->GetExecutive());
    this->Filter->SetVoxelSize(size);
  }

  Voxelizing(vtkPolyData* cloud, double size)
    : Voxelizing(size)
  {
    this->Filter->SetInputData(cloud);
  }

  /// True if there was no error.
  bool Run()
  {
    this->Filter->Update();
    return this->Log->Errors.empty();
  }

  bool FailsWith(const std::string& part)
  {
    this->Log->Clear();
    return !this->Run() && this->Log->HasError(part) && this->Scene()->GetNumberOfCells() == 0;
  }

  vtkPolyData* Scene() { return this->Filter->GetOutput(); }
  vtkIdType FaceCount() { return this->Scene()->GetNumberOfPolys() / 2; }
};

/// Directed edges not matched by as many opposite ones.
inline int CountUnbalancedEdges(vtkPolyData* scene)
{
  TriangleMesh mesh;
  if (!mesh.Set(scene).IsOk())
  {
    return -1;
  }
  std::map<std::pair<int, int>, int> edges;
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    const vtkTypeInt32* c = mesh.GetCorners() + 3 * i;
    for (int k = 0; k < 3; ++k)
    {
      const int a = c[k];
      const int b = c[(k + 1) % 3];
      edges[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  int unbalanced = 0;
  for (const auto& edge : edges)
  {
    unbalanced += edge.second != 0;
  }
  return unbalanced;
}

inline double GetVolume(vtkPolyData* scene)
{
  TriangleMesh mesh;
  return mesh.Set(scene).IsOk() ? GetVolume(mesh) : std::nan("");
}

inline bool HaveSameBytes(vtkDataArray* a, vtkDataArray* b)
{
  return a && b && a->GetDataType() == b->GetDataType() &&
    a->GetNumberOfValues() == b->GetNumberOfValues() &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
      static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize())) == 0;
}

/// Compares points, corners and cell arrays, byte by byte.
inline bool HaveSameBytes(vtkPolyData* a, vtkPolyData* b)
{
  bool isSame = a->GetNumberOfPoints() == b->GetNumberOfPoints() &&
    a->GetCellData()->GetNumberOfArrays() == b->GetCellData()->GetNumberOfArrays() &&
    HaveSameBytes(a->GetPoints()->GetData(), b->GetPoints()->GetData()) &&
    HaveSameBytes(a->GetPolys()->GetConnectivityArray(), b->GetPolys()->GetConnectivityArray());
  for (int i = 0; isSame && i < a->GetCellData()->GetNumberOfArrays(); ++i)
  {
    isSame = HaveSameBytes(a->GetCellData()->GetArray(i), b->GetCellData()->GetArray(i));
  }
  return isSame;
}

} // namespace helios

#endif
