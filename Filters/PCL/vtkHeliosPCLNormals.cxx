// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPCLNormals.h"

#include "heliosPclInput.h"
#include "heliosPclNormals.h"
#include "heliosPointSelection.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosPCLArrayNames.h"

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>

vtkStandardNewMacro(vtkHeliosPCLNormals);

//------------------------------------------------------------------------------
void vtkHeliosPCLNormals::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const double* v = this->Viewpoint;
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n"
     << indent << "Radius: " << this->Radius << " m\n"
     << indent << "Side: " << (this->Side == Up ? "Up" : "ToViewpoint") << "\n"
     << indent << "Viewpoint: " << v[0] << " " << v[1] << " " << v[2] << "\n";
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLNormals::CheckProperties()
{
  const double* v = this->Viewpoint;
  if (!std::isfinite(v[0]) || !std::isfinite(v[1]) || !std::isfinite(v[2]))
  {
    vtkErrorMacro(<< "Viewpoint is (" << v[0] << ", " << v[1] << ", " << v[2]
                  << "); set finite numbers");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
/// Returns the component of a normal in the required direction; negative if it must be flipped.
double vtkHeliosPCLNormals::GetTowards(const double point[3], const float normal[3]) const
{
  if (this->Side == Up)
  {
    return static_cast<double>(normal[2]);
  }
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    sum += (this->Viewpoint[axis] - point[axis]) * static_cast<double>(normal[axis]);
  }
  return sum;
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLNormals::Process(helios::PclInput& input, vtkPolyData* output)
{
  pcl::PointCloud<pcl::Normal> found;
  if (!helios::EstimateNormals(
        input.GetCloud(), this->Radius, this->NumberOfNeighbors,
        [this](double share) { return this->GoOn(0.1 + 0.8 * share); }, found))
  {
    return false;
  }
  helios::SelectPoints(input.GetData(), input.GetIds(), output);
  vtkNew<vtkFloatArray> normals;
  normals->SetName(vtkHeliosArrayNames::Normals);
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(input.GetSize());
  vtkNew<vtkFloatArray> curvatures;
  curvatures->SetName(vtkHeliosPCLArrayNames::Curvature);
  curvatures->SetNumberOfValues(input.GetSize());
  vtkIdType numberOfNone = 0;
  for (vtkIdType i = 0; i < input.GetSize(); ++i)
  {
    pcl::Normal& normal = found[static_cast<std::size_t>(i)];
    if (!std::isfinite(normal.normal_x + normal.normal_y + normal.normal_z + normal.curvature))
    {
      normal = pcl::Normal(0.0F, 0.0F, 0.0F);
      ++numberOfNone;
    }
    double p[3];
    output->GetPoint(i, p);
    const double sign = this->GetTowards(p, normal.normal) < 0.0 ? -1.0 : 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      normals->SetComponent(i, axis, sign * static_cast<double>(normal.normal[axis]));
    }
    curvatures->SetValue(i, normal.curvature);
  }
  output->GetPointData()->SetNormals(normals);
  output->GetPointData()->AddArray(curvatures);
  if (numberOfNone > 0)
  {
    vtkWarningMacro(<< numberOfNone << " of " << input.GetSize()
                    << " points have too few neighbours for a normal: 0 0 0; set a larger Radius");
  }
  return true;
}
