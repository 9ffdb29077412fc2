// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosGroundSnap.h"

#include "heliosGround.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <string>
#include <vector>

namespace names = vtkHeliosArrayNames;

vtkStandardNewMacro(vtkHeliosGroundSnap);

vtkHeliosGroundSnap::vtkHeliosGroundSnap()
{
  this->SetNumberOfInputPorts(2);
}

void vtkHeliosGroundSnap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HeightAboveGround: " << this->HeightAboveGround << "\n"
     << indent << "AllowMissing: " << this->AllowMissing << "\n";
}

int vtkHeliosGroundSnap::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkHeliosGroundSnap::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* scene = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(input);
  const vtkIdType count = input->GetNumberOfPoints();
  if (count == 0)
  {
    return 1;
  }
  std::vector<double> heights;
  const helios::Status status = helios::GetGroundHeights(input, scene, true, heights);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  points->SetNumberOfPoints(count);
  vtkDataArray* onGround = input->GetPointData()->GetArray(names::OnGround);
  vtkNew<vtkUnsignedCharArray> found;
  found->SetName(names::OnGround);
  found->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    input->GetPoint(i, p);
    bool isSnapped = !onGround || onGround->GetComponent(i, 0) != 0.0;
    const bool isMissing = isSnapped && std::isnan(heights[i]);
    isSnapped = isSnapped && !isMissing;
    found->SetValue(i, isSnapped);
    if (isMissing && !this->AllowMissing)
    {
      vtkErrorMacro(<< "The scene has no ground above or below " << helios::DescribePlace(input, i)
                    << "; move the point into the scene or clear its " << names::OnGround << ".");
      return 0;
    }
    p[2] = isSnapped ? heights[i] + this->HeightAboveGround : p[2];
    points->SetPoint(i, p);
  }
  output->SetPoints(points);
  if (this->AllowMissing)
  {
    output->GetPointData()->AddArray(found);
  }
  return 1;
}
