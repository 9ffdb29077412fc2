// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosStaticPlatform.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <cmath>

vtkStandardNewMacro(vtkHeliosStaticPlatform);

//------------------------------------------------------------------------------
bool vtkHeliosStaticPlatform::Move(vtkPolyData* waypoints, std::vector<State>& path)
{
  if (waypoints->GetNumberOfPoints() != 1)
  {
    vtkErrorMacro(<< "A static platform needs exactly one waypoint, the input has "
                  << waypoints->GetNumberOfPoints() << "; run it once per position.");
    return false;
  }
  const double heading = vtkMath::RadiansFromDegrees(this->Heading);
  State state{};
  state.Time = this->StartTime;
  waypoints->GetPoint(0, state.Position);
  HeadingToOrientation(std::sin(heading), std::cos(heading), state.Orientation);
  state.LegId = GetLegId(waypoints, 0);
  path.push_back(state);
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosStaticPlatform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Heading: " << this->Heading << "\n";
}
