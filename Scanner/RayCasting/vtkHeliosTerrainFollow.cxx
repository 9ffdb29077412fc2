// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosTerrainFollow.h"

#include "heliosGround.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double MaximumWaypoints = 1e7;

/// Returns the distance from a point to the next in x, y.
double GetDistance(vtkPolyData* waypoints, vtkIdType i)
{
  double a[3], b[3];
  waypoints->GetPoint(i, a);
  waypoints->GetPoint(i + 1, b);
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

/// Adds the ids of the legs, from the input or consecutive.
void AddLegIds(vtkPointData* data, vtkIdType count)
{
  if (!data->HasArray(names::LegIds))
  {
    vtkNew<vtkIntArray> legs;
    legs->SetName(names::LegIds);
    for (vtkIdType i = 0; i < count; ++i)
    {
      legs->InsertNextValue(static_cast<int>(i));
    }
    data->AddArray(legs);
  }
}

/// Raises heights to limit the slope, in both directions.
void LimitSlope(std::vector<double>& heights, const std::vector<double>& distances, double slope)
{
  for (std::size_t i = 1; i < heights.size(); ++i)
  {
    heights[i] = std::max(heights[i], heights[i - 1] - slope * distances[i - 1]);
  }
  for (std::size_t i = heights.size(); i-- > 1;)
  {
    heights[i - 1] = std::max(heights[i - 1], heights[i] - slope * distances[i - 1]);
  }
}

} // namespace

vtkStandardNewMacro(vtkHeliosTerrainFollow);

//------------------------------------------------------------------------------
vtkHeliosTerrainFollow::vtkHeliosTerrainFollow()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkHeliosTerrainFollow::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosTerrainFollow::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (input->GetPointData()->HasArray(names::GpsTime))
  {
    vtkErrorMacro(<< "The input on port 0 is a trajectory, it has " << names::GpsTime
                  << "; connect waypoints, and the platform after this filter.");
    return 0;
  }
  output->GetFieldData()->PassData(input->GetFieldData());
  if (input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  if (!this->Insert(input, output) || !this->SetHeights(vtkPolyData::GetData(inputs[1]), output))
  {
    output->Initialize();
    return 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
// The waypoints and those between them, at provisional heights.
bool vtkHeliosTerrainFollow::Insert(vtkPolyData* waypoints, vtkPolyData* output)
{
  const vtkIdType count = waypoints->GetNumberOfPoints();
  std::vector<double> pieces(static_cast<std::size_t>(count), 1.0);
  double sum = 1.0;
  for (vtkIdType i = 0; i + 1 < count && this->Spacing > 0.0; ++i)
  {
    const double needed = std::ceil(GetDistance(waypoints, i) / this->Spacing);
    pieces[static_cast<std::size_t>(i)] = std::max(1.0, needed);
    sum += pieces[static_cast<std::size_t>(i)];
  }
  if (sum > MaximumWaypoints)
  {
    vtkErrorMacro(<< "Spacing " << this->Spacing << " m results in " << sum
                  << " waypoints; give one that results in fewer than " << MaximumWaypoints << ".");
    return false;
  }

  vtkNew<vtkPointData> data;
  data->ShallowCopy(waypoints->GetPointData());
  AddLegIds(data, count);
  output->GetPointData()->CopyAllocate(data);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < count; ++i)
  {
    double a[3], b[3];
    waypoints->GetPoint(i, a);
    waypoints->GetPoint(std::min(i + 1, count - 1), b);
    const double number = i + 1 < count ? pieces[static_cast<std::size_t>(i)] : 1.0;
    for (double k = 0.0; k < number; ++k)
    {
      const double s = k / number;
      const double x = k > 0.0 ? a[0] + s * (b[0] - a[0]) : a[0];
      const double y = k > 0.0 ? a[1] + s * (b[1] - a[1]) : a[1];
      const vtkIdType id = points->InsertNextPoint(x, y, 0.0);
      output->GetPointData()->CopyData(data, i, id);
    }
  }
  output->SetPoints(points);
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosTerrainFollow::SetHeights(vtkPolyData* scene, vtkPolyData* output)
{
  std::vector<double> heights;
  const helios::Status status =
    helios::GetGroundHeights(output, scene, this->Surface == GROUND, heights);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return false;
  }
  const auto none =
    std::find_if(heights.begin(), heights.end(), [](double height) { return std::isnan(height); });
  if (none != heights.end())
  {
    vtkErrorMacro(<< "The scene has no ground above or below "
                  << helios::DescribePlace(output, none - heights.begin())
                  << ", between two waypoints; keep the path over the scene.");
    return false;
  }
  std::vector<double> distances;
  for (vtkIdType i = 0; i + 1 < output->GetNumberOfPoints(); ++i)
  {
    distances.push_back(GetDistance(output, i));
  }
  if (this->MaximumSlope < 90.0)
  {
    LimitSlope(heights, distances, std::tan(vtkMath::RadiansFromDegrees(this->MaximumSlope)));
  }
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    output->GetPoints()->SetPoint(
      i, p[0], p[1], heights[static_cast<std::size_t>(i)] + this->Height);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosTerrainFollow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Height: " << this->Height << " m\n"
     << indent << "Surface: " << (this->Surface == TOP ? "Top" : "Ground") << "\n"
     << indent << "Spacing: " << this->Spacing << " m\n"
     << indent << "MaximumSlope: " << this->MaximumSlope << " deg\n";
}
