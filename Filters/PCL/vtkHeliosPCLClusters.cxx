// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPCLClusters.h"

#include "heliosPclInput.h"
#include "heliosPointClusters.h"
#include "heliosPointSelection.h"
#include "vtkHeliosPCLArrayNames.h"

#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkHeliosPCLClusters);

namespace
{

/// Returns the ids of clusters by their first points: 0 for the largest, for ties the first one
/// first; -1: not a first point, or a size out of range.
std::vector<int> NumberClusters(const std::vector<int>& first, int smallest, int largest)
{
  const auto at = [](std::vector<int>& values, int i) -> int&
  { return values[static_cast<std::size_t>(i)]; };
  std::vector<int> sizes(first.size(), 0);
  for (const int i : first)
  {
    ++at(sizes, i);
  }
  std::vector<int> order;
  for (int i = 0; i < static_cast<int>(sizes.size()); ++i)
  {
    if (at(sizes, i) >= smallest && at(sizes, i) <= largest)
    {
      order.push_back(i);
    }
  }
  std::stable_sort(
    order.begin(), order.end(), [&](int a, int b) { return at(sizes, a) > at(sizes, b); });
  std::vector<int> numbers(first.size(), -1);
  for (std::size_t c = 0; c < order.size(); ++c)
  {
    at(numbers, order[c]) = static_cast<int>(c);
  }
  return numbers;
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosPCLClusters::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << " m\n"
     << indent << "MinimumClusterSize: " << this->MinimumClusterSize << "\n"
     << indent << "MaximumClusterSize: " << this->MaximumClusterSize << "\n"
     << indent << "NumberOfClusters: " << this->NumberOfClusters << "\n";
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLClusters::CheckProperties()
{
  this->NumberOfClusters = 0;
  if (this->MinimumClusterSize > this->MaximumClusterSize)
  {
    vtkErrorMacro(<< "MinimumClusterSize is " << this->MinimumClusterSize
                  << ", above MaximumClusterSize, " << this->MaximumClusterSize
                  << "; set a smaller one");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLClusters::Process(helios::PclInput& input, vtkPolyData* output)
{
  const std::vector<int> first = helios::FindClusters(input.GetCloud(), this->Tolerance,
    [this](double share) { return this->GoOn(0.1 + 0.8 * share); });
  if (first.empty())
  {
    return false;
  }
  const std::vector<int> numbers =
    NumberClusters(first, this->MinimumClusterSize, this->MaximumClusterSize);
  this->NumberOfClusters = 1 + *std::max_element(numbers.begin(), numbers.end());

  helios::SelectPoints(input.GetData(), input.GetIds(), output);
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkHeliosPCLArrayNames::ClusterIds);
  ids->SetNumberOfValues(input.GetSize());
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    ids->SetValue(static_cast<vtkIdType>(i), numbers[static_cast<std::size_t>(first[i])]);
  }
  output->GetPointData()->AddArray(ids);
  return true;
}
