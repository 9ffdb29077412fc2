// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPCLOutlierRemoval.h"

#include "heliosPclInput.h"
#include "heliosPointSelection.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <pcl/filters/statistical_outlier_removal.h>

#include <algorithm>

vtkStandardNewMacro(vtkHeliosPCLOutlierRemoval);

//------------------------------------------------------------------------------
void vtkHeliosPCLOutlierRemoval::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n"
     << indent << "StandardDeviations: " << this->StandardDeviations << "\n"
     << indent << "SelectOutliers: " << this->SelectOutliers << "\n";
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLOutlierRemoval::Process(helios::PclInput& input, vtkPolyData* output)
{
  if (input.GetSize() < 3) // none of them lies apart from the others
  {
    helios::SelectPoints(
      input.GetData(), this->SelectOutliers ? std::vector<vtkIdType>() : input.GetIds(), output);
    return true;
  }
  pcl::StatisticalOutlierRemoval<pcl::PointXYZ> filter;
  filter.setInputCloud(input.GetCloud());
  filter.setMeanK(std::min(this->NumberOfNeighbors, input.GetSize() - 1));
  filter.setStddevMulThresh(this->StandardDeviations);
  filter.setNegative(this->SelectOutliers);
  pcl::Indices kept;
  filter.filter(kept);
  helios::SelectPoints(input.GetData(), input.GetIds(kept), output);
  return true;
}
