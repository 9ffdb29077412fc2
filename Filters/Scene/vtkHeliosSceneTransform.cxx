// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSceneTransform.h"

#include "heliosPose.h"
#include "heliosSimilarity.h"
#include "heliosStatus.h"
#include "heliosTriangleMesh.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHeliosSceneTransform);

namespace
{

struct MovePoints
{
  vtkDataArray* From;
  double* To;
  const helios::Similarity& Motion;

  void operator()(vtkIdType begin, vtkIdType end) const
  {
    auto* doubles = vtkDoubleArray::FastDownCast(this->From);
    double p[3];
    for (vtkIdType i = begin; i < end; ++i)
    {
      doubles ? doubles->GetTypedTuple(i, p) : this->From->GetTuple(i, p);
      this->Motion.Apply(p, this->To + 3 * i);
    }
  }
};

vtkSmartPointer<vtkPoints> Move(vtkPoints* from, const helios::Similarity& motion)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(from->GetNumberOfPoints());
  double* to = vtkDoubleArray::FastDownCast(points->GetData())->GetPointer(0);
  MovePoints move{ from->GetData(), to, motion };
  vtkSMPTools::For(0, from->GetNumberOfPoints(), move);
  return points;
}

void RotateNormals(vtkDataSetAttributes* attributes, const helios::Rotation& rotation)
{
  vtkDataArray* normals = attributes->GetNormals();
  if (!normals)
  {
    return;
  }
  vtkSmartPointer<vtkDataArray> rotated = vtk::TakeSmartPointer(normals->NewInstance());
  rotated->DeepCopy(normals);
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    const helios::Vec3 normal(normals->GetTuple3(i));
    rotated->SetTuple(i, (rotation * normal).GetData());
  }
  attributes->SetNormals(rotated);
}

} // namespace

//------------------------------------------------------------------------------
bool vtkHeliosSceneTransform::CheckProperties()
{
  const double* q = this->Rotation;
  const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  if (!std::isfinite(length) || length == 0.0)
  {
    vtkErrorMacro(<< "Rotation is (" << q[0] << ", " << q[1] << ", " << q[2] << ", " << q[3]
                  << "), which is not a rotation; set a quaternion w, x, y, z, finite and not 0");
    return false;
  }
  if (!std::isfinite(this->Scale) || this->Scale <= 0.0)
  {
    vtkErrorMacro(<< "Scale is " << this->Scale << "; set a number greater than 0");
    return false;
  }
  const double* t = this->Translation;
  if (!std::isfinite(t[0]) || !std::isfinite(t[1]) || !std::isfinite(t[2]))
  {
    vtkErrorMacro(<< "Translation is (" << t[0] << ", " << t[1] << ", " << t[2]
                  << "); set finite numbers");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkHeliosSceneTransform::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->CheckProperties())
  {
    return 0;
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  if (const helios::Status status = helios::CheckNoInstances(input); !status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(input);

  const helios::Similarity motion(this->Rotation, this->Scale, this->Translation);
  vtkPoints* points = input->GetPoints();
  if (points && (!motion.IsIdentity() || points->GetDataType() != VTK_DOUBLE))
  {
    output->SetPoints(Move(points, motion));
  }
  if (motion.HasRotation)
  {
    RotateNormals(output->GetPointData(), motion.Turn);
    RotateNormals(output->GetCellData(), motion.Turn);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosSceneTransform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Rotation: " << this->Rotation[0] << " " << this->Rotation[1] << " "
     << this->Rotation[2] << " " << this->Rotation[3] << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "Translation: " << this->Translation[0] << " " << this->Translation[1] << " "
     << this->Translation[2] << "\n";
}
