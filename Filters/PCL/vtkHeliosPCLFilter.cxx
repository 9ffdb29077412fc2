// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPCLFilter.h"

#include "heliosPclInput.h"
#include "heliosPointSelection.h"
#include "heliosStatus.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkPolyData.h>

#include <exception>
#include <new>

namespace
{
constexpr double FarAway = 8192.0; // [m], above which the float error is 0.5 mm
}

//------------------------------------------------------------------------------
void vtkHeliosPCLFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfDroppedPoints: " << this->NumberOfDroppedPoints << "\n";
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLFilter::GoOn(double progress)
{
  this->UpdateProgress(progress);
  if (this->AbortExecute)
  {
    vtkErrorMacro(<< "The work was aborted at " << 100.0 * progress
                  << " %; update again to complete it");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLFilter::Run(vtkPolyData* data, vtkPolyData* output)
{
  helios::PclInput input;
  const helios::Status status = input.Read(data, this->GetStep());
  if (!status.IsOk())
  {
    vtkErrorMacro(<< "Input: " << status.Message());
    return false;
  }
  this->NumberOfDroppedPoints = input.GetNumberOfDropped();
  if (this->NumberOfDroppedPoints > 0)
  {
    vtkWarningMacro(<< "Input: " << this->NumberOfDroppedPoints << " of "
                    << data->GetNumberOfPoints() << " points are not finite: dropped");
  }
  if (input.GetReach() >= FarAway)
  {
    vtkWarningMacro(<< "Input: points are up to " << input.GetReach()
                    << " m from the centre along an axis, where PCL's float coordinates have "
                       "errors of 0.5 mm or more; process them in tiles");
  }
  if (input.GetSize() == 0)
  {
    helios::SelectPoints(data, {}, output);
    return true;
  }
  return this->GoOn(0.1) && this->Process(input, output) && this->GoOn(1.0);
}

//------------------------------------------------------------------------------
int vtkHeliosPCLFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->NumberOfDroppedPoints = 0;
  bool isGood = false;
  try
  {
    isGood = this->CheckProperties() && this->Run(vtkPolyData::GetData(inputVector[0]), output);
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro(<< "Not enough memory for the points of the input; process them in pieces");
  }
  catch (const std::exception& error) // thrown by PCL
  {
    vtkErrorMacro(<< "PCL cannot process the input: " << error.what());
  }
  if (!isGood)
  {
    output->Initialize();
  }
  return isGood ? 1 : 0;
}
