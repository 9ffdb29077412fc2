// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPCLOutlierRemoval.h"

#include "heliosOutliers.h"
#include "heliosPclInput.h"
#include "heliosPointSelection.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <vector>

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
  if (input.GetSize() < 3) // too few for outliers
  {
    helios::SelectPoints(
      input.GetData(), this->SelectOutliers ? std::vector<vtkIdType>() : input.GetIds(), output);
    return true;
  }
  const std::vector<float> distances = helios::GetNeighborDistances(input.GetCloud(),
    std::min(this->NumberOfNeighbors, input.GetSize() - 1),
    [this](double share) { return this->GoOn(0.1 + 0.8 * share); });
  if (distances.empty())
  {
    return false;
  }
  const double limit = helios::GetDistanceLimit(distances, this->StandardDeviations);
  pcl::Indices kept;
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    const bool isInlier = !(static_cast<double>(distances[i]) > limit);
    if (isInlier != this->SelectOutliers)
    {
      kept.push_back(static_cast<pcl::index_t>(i));
    }
  }
  helios::SelectPoints(input.GetData(), input.GetIds(kept), output);
  return true;
}
