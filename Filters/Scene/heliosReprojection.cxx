// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosReprojection.h"

#include "heliosPose.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <atomic>

namespace helios
{

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr vtkIdType BlockSize = 1 << 18; // points between two progress reports
constexpr vtkIdType None = VTK_ID_MAX;

void StoreSmallest(std::atomic<vtkIdType>& smallest, vtkIdType value)
{
  vtkIdType current = smallest;
  while (value < current && !smallest.compare_exchange_weak(current, value))
  {
  }
}

vtkSmartPointer<vtkDataArray> Copy(vtkDataArray* array)
{
  auto copy = vtk::TakeSmartPointer(array->NewInstance());
  copy->DeepCopy(array);
  return copy;
}

/// Returns the mean of the points of every cell.
vtkSmartPointer<vtkDoubleArray> GetCentres(vtkPointSet* data)
{
  auto centres = vtkSmartPointer<vtkDoubleArray>::New();
  centres->SetNumberOfComponents(3);
  centres->SetNumberOfTuples(data->GetNumberOfCells());
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    data->GetCellPoints(i, corners);
    const vtkIdType count = std::max<vtkIdType>(corners->GetNumberOfIds(), 1);
    Vec3 sum(0.0, 0.0, 0.0);
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      sum = sum + Vec3(data->GetPoint(corners->GetId(k)));
    }
    centres->SetTuple3(i, sum[0] / count, sum[1] / count, sum[2] / count);
  }
  return centres;
}

/// Transforms the surface normal with a coordinate change: by the inverse transpose.
bool TurnNormal(const double jacobian[3][3], const double normal[3], double turned[3])
{
  double inverse[3][3];
  const double determinant = vtkMath::Determinant3x3(jacobian);
  if (!std::isfinite(determinant) || determinant == 0.0)
  {
    return false;
  }
  vtkMath::Invert3x3(jacobian, inverse);
  vtkMath::Transpose3x3(inverse, inverse);
  vtkMath::Multiply3x3(inverse, normal, turned);
  vtkMath::Normalize(turned);
  return true;
}

} // namespace

//------------------------------------------------------------------------------
Reprojection::Reprojection(const CoordinateTransform& transform, Watcher watcher)
  : Transform(transform)
  , Transforms(transform)
  , Watch(std::move(watcher))
{
}

//------------------------------------------------------------------------------
Status Reprojection::Run(vtkDataArray* places, const Work& work, const std::string& what)
{
  auto* doubles = vtkDoubleArray::FastDownCast(places);
  const vtkIdType count = places->GetNumberOfTuples();
  std::atomic<vtkIdType> failed{ None };
  const auto block = [&](vtkIdType begin, vtkIdType end)
  {
    CoordinateTransform& transform = this->Transforms.Local();
    double p[3];
    for (vtkIdType i = begin; i < end && i < failed; ++i)
    {
      doubles ? doubles->GetTypedTuple(i, p) : places->GetTuple(i, p);
      if (!work(transform, p, i))
      {
        StoreSmallest(failed, i);
      }
    }
  };
  for (vtkIdType first = 0; first < count && failed == None && !this->Aborted; first += BlockSize)
  {
    vtkSMPTools::For(first, std::min(first + BlockSize, count), block);
    this->Aborted = !this->Watch(static_cast<double>(std::min(first + BlockSize, count)) / count);
  }
  if (failed == None)
  {
    return {};
  }
  double p[3];
  places->GetTuple(failed, p);
  double ignored[3];
  this->Transform.Forward(p, ignored, 1); // to get the error reason
  return Status::Error(what + this->Transform.DescribeFailure(failed, p));
}

//------------------------------------------------------------------------------
Status Reprojection::TurnNormals(
  vtkDataArray* places, vtkDataArray* normals, const std::string& what)
{
  const auto work = [&](CoordinateTransform& transform, const double place[3], vtkIdType i)
  {
    double jacobian[3][3];
    double normal[3];
    double turned[3];
    normals->GetTuple(i, normal);
    const bool isTurned =
      transform.GetJacobian(place, jacobian) && TurnNormal(jacobian, normal, turned);
    if (isTurned)
    {
      normals->SetTuple(i, turned);
    }
    return isTurned;
  };
  return this->Run(places, work, what);
}

//------------------------------------------------------------------------------
Status Reprojection::TurnVectors(vtkDataArray* places, vtkDataArray* vectors)
{
  const auto work = [&](CoordinateTransform& transform, const double place[3], vtkIdType i)
  {
    double rotation[3][3];
    double vector[3];
    if (!transform.GetRotation(place, rotation))
    {
      return false;
    }
    vectors->GetTuple(i, vector);
    vtkMath::Multiply3x3(rotation, vector, vector);
    vectors->SetTuple(i, vector);
    return true;
  };
  return this->Run(places, work, std::string(vectors->GetName()) + " cannot be rotated: ");
}

//------------------------------------------------------------------------------
Status Reprojection::TurnFrames(vtkDataArray* places, vtkDataArray* quaternions)
{
  const auto work = [&](CoordinateTransform& transform, const double place[3], vtkIdType i)
  {
    double rotation[3][3];
    double turn[4];
    double frame[4];
    if (!transform.GetRotation(place, rotation))
    {
      return false;
    }
    vtkMath::Matrix3x3ToQuaternion(rotation, turn);
    quaternions->GetTuple(i, frame);
    vtkMath::MultiplyQuaternion(turn, frame, frame);
    quaternions->SetTuple(i, frame);
    return true;
  };
  return this->Run(places, work, std::string(quaternions->GetName()) + " cannot be rotated: ");
}

//------------------------------------------------------------------------------
Status Reprojection::Move(vtkDataArray* places, vtkDataArray* images)
{
  const auto work = [&](CoordinateTransform& transform, const double place[3], vtkIdType i)
  {
    double image[3];
    const bool isMoved = transform.Forward(place, image, 1) < 0;
    if (isMoved)
    {
      images->SetTuple(i, image);
    }
    return isMoved;
  };
  return this->Run(places, work, "");
}

//------------------------------------------------------------------------------
Status Reprojection::TransformCells(vtkPointSet* from, vtkPointSet* to)
{
  vtkDataArray* normals = from->GetCellData()->GetNormals();
  if (!normals)
  {
    return {};
  }
  const auto turned = Copy(normals);
  Status status = this->TurnNormals(GetCentres(from), turned, "Normals of cells: ");
  to->GetCellData()->SetNormals(turned);
  return status;
}

//------------------------------------------------------------------------------
Status Reprojection::TransformPointData(vtkPointSet* from, vtkPointSet* to)
{
  vtkDataArray* places = from->GetPoints()->GetData();
  Status status;
  if (vtkDataArray* normals = from->GetPointData()->GetNormals())
  {
    const auto turned = Copy(normals);
    status = this->TurnNormals(places, turned, "Normals of points: ");
    to->GetPointData()->SetNormals(turned);
  }
  const auto replace = [&](const char* name, int components, const auto& change)
  {
    vtkDataArray* array = from->GetPointData()->GetArray(name);
    if (status.IsOk() && array && array->GetNumberOfComponents() == components)
    {
      const auto changed = Copy(array);
      status = change(changed);
      to->GetPointData()->AddArray(changed);
    }
  };
  for (const char* name : { names::Velocity, names::Direction, names::Normal })
  {
    replace(name, 3, [&](vtkDataArray* array) { return this->TurnVectors(places, array); });
  }
  replace(
    names::Orientation, 4, [&](vtkDataArray* array) { return this->TurnFrames(places, array); });
  replace(names::TruePoint, 3, [&](vtkDataArray* array) { return this->Move(array, array); });
  return status;
}

//------------------------------------------------------------------------------
Status Reprojection::TransformPoints(vtkPointSet* from, vtkPointSet* to)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(from->GetNumberOfPoints());
  double* images = vtkDoubleArray::FastDownCast(points->GetData())->GetPointer(0);
  const auto work = [images](CoordinateTransform& transform, const double place[3], vtkIdType i)
  { return transform.Forward(place, images + 3 * i, 1) < 0; };
  Status status = this->Run(from->GetPoints()->GetData(), work, "");
  to->SetPoints(points);
  return status;
}

} // namespace helios
