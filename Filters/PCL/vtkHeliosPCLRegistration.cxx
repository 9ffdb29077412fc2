// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPCLRegistration.h"

#include "heliosPclIcp.h"
#include "heliosPclInput.h"
#include "heliosPointSelection.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosPCLArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <exception>
#include <new>
#include <vector>

vtkStandardNewMacro(vtkHeliosPCLRegistration);

namespace names = vtkHeliosArrayNames;

namespace
{

using Points = std::vector<Eigen::Vector3d>;

/// Returns the points of a cloud, in double, relative to an origin.
Points GetLocalPoints(const helios::PclInput& input, const double origin[3])
{
  Points points;
  points.reserve(input.GetIds().size());
  for (const vtkIdType id : input.GetIds())
  {
    Eigen::Vector3d p;
    input.GetData()->GetPoint(id, p.data());
    points.push_back(p - Eigen::Vector3d(origin));
  }
  return points;
}

void MovePoints(
  const Points& local, const Eigen::Isometry3d& motion, const double origin[3], vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(local.size()));
  for (std::size_t i = 0; i < local.size(); ++i)
  {
    const Eigen::Vector3d p = motion * local[i] + Eigen::Vector3d(origin);
    points->SetPoint(static_cast<vtkIdType>(i), p.data());
  }
  output->SetPoints(points);
}

void TurnVectors(const Eigen::Isometry3d& motion, vtkPointData* data)
{
  for (const char* name : { names::Normals, names::Normal, names::Direction })
  {
    vtkDataArray* array = data->GetArray(name);
    for (vtkIdType i = 0; array && array->GetNumberOfComponents() == 3; ++i)
    {
      if (i == array->GetNumberOfTuples())
      {
        break;
      }
      Eigen::Vector3d v;
      array->GetTuple(i, v.data());
      v = motion.linear() * v;
      array->SetTuple(i, v.data());
    }
  }
}

/// Converts a motion about an origin to one about 0.
void SetMatrix(const Eigen::Isometry3d& motion, const double origin[3], vtkMatrix4x4* matrix)
{
  const Eigen::Vector3d centre(origin);
  const Eigen::Vector3d shift = centre + motion.translation() - motion.linear() * centre;
  matrix->Identity();
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      matrix->SetElement(i, j, motion.linear()(i, j));
    }
    matrix->SetElement(i, 3, shift[i]);
  }
}

void AddMatrix(vtkMatrix4x4* matrix, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(vtkHeliosPCLArrayNames::RegistrationMatrix);
  array->SetNumberOfComponents(16);
  array->InsertNextTuple(matrix->GetData());
  output->GetFieldData()->AddArray(array);
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosPCLRegistration::vtkHeliosPCLRegistration()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkHeliosPCLRegistration::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumDistance: " << this->MaximumDistance << " m\n"
     << indent << "MaximumNumberOfIterations: " << this->MaximumNumberOfIterations << "\n"
     << indent << "PointToPlane: " << this->PointToPlane << "\n"
     << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n"
     << indent << "MaximumCurvature: " << this->MaximumCurvature << "\n"
     << indent << "Residual: " << this->Residual << " m\n"
     << indent << "NumberOfPairs: " << this->NumberOfPairs << "\n"
     << indent << "Matrix:\n";
  this->Matrix->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
int vtkHeliosPCLRegistration::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLRegistration::ReadInput(int port, vtkPolyData* data, helios::PclInput& input)
{
  helios::Status status = input.Read(data, 1.0);
  if (status.IsOk() && input.GetSize() == 0)
  {
    status = helios::Status::Error("there are no finite points; connect a scan");
  }
  if (!status.IsOk())
  {
    vtkErrorMacro(<< "Input " << port << ": " << status.Message());
    return false;
  }
  if (input.GetNumberOfDropped() > 0)
  {
    vtkWarningMacro(<< "Input " << port << ": " << input.GetNumberOfDropped()
                    << " points are not finite: dropped");
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLRegistration::Align(vtkPolyData* fixed, vtkPolyData* moving, vtkPolyData* output)
{
  helios::PclInput inputs[2];
  if (!this->ReadInput(0, fixed, inputs[0]) || !this->ReadInput(1, moving, inputs[1]))
  {
    return false;
  }
  const double* origin = inputs[0].GetOrigin();

  helios::PclIcp icp;
  icp.MaximumDistance = this->MaximumDistance;
  icp.MaximumNumberOfIterations = this->MaximumNumberOfIterations;
  icp.PointToPlane = this->PointToPlane;
  icp.NumberOfNeighbors = this->NumberOfNeighbors;
  icp.MaximumCurvature = this->MaximumCurvature;
  double progress = 0.0;
  icp.OnProgress = [this, &progress](double iterations)
  {
    progress = iterations / (1 + this->MaximumNumberOfIterations);
    this->UpdateProgress(progress);
    return !this->AbortExecute;
  };
  icp.SetFixed(inputs[0].GetCloud());
  icp.SetMoving(GetLocalPoints(inputs[1], origin), inputs[1].GetCloud());
  const helios::Status status = icp.Run();
  if (icp.IsStopped())
  {
    vtkErrorMacro(<< "The work was aborted at " << 100.0 * progress
                  << " %; update again to complete it");
    return false;
  }
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return false;
  }
  if (!icp.HasSettled())
  {
    vtkWarningMacro(<< "MaximumNumberOfIterations is " << this->MaximumNumberOfIterations
                    << ", and the registration has not converged; set a larger one");
  }
  this->Residual = icp.GetResidual();
  this->NumberOfPairs = static_cast<vtkIdType>(icp.GetNumberOfPairs());
  SetMatrix(icp.GetMotion(), origin, this->Matrix);
  helios::SelectPoints(moving, inputs[1].GetIds(), output);
  MovePoints(icp.GetMoving(), icp.GetMotion(), origin, output);
  TurnVectors(icp.GetMotion(), output->GetPointData());
  AddMatrix(this->Matrix, output);
  return true;
}

//------------------------------------------------------------------------------
int vtkHeliosPCLRegistration::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Matrix->Identity();
  this->Residual = 0.0;
  this->NumberOfPairs = 0;
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  bool isGood = false;
  try
  {
    isGood = this->Align(
      vtkPolyData::GetData(inputVector[0]), vtkPolyData::GetData(inputVector[1]), output);
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro(<< "Not enough memory for the points of the inputs; thin them out "
                  << "(vtkHeliosPCLVoxelGrid)");
  }
  catch (const std::exception& error) // thrown by PCL
  {
    vtkErrorMacro(<< "PCL cannot process the inputs: " << error.what());
  }
  if (!isGood)
  {
    output->Initialize();
  }
  return isGood ? 1 : 0;
}
