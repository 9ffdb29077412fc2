// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosLinearPathPlatform.h"

#include "heliosSum.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace names = vtkHeliosArrayNames;

vtkStandardNewMacro(vtkHeliosLinearPathPlatform);

namespace
{

/// A straight line from one waypoint to the next.
struct Leg
{
  double Start[3];
  double End[3];
  double Way[3];
  double Speed;

  double Length() const { return std::hypot(std::hypot(this->Way[0], this->Way[1]), this->Way[2]); }
  double Duration() const { return this->Length() / this->Speed; }
  bool HasHeading() const { return this->Way[0] != 0.0 || this->Way[1] != 0.0; }
  void GetVelocity(double velocity[3]) const
  {
    const double length = this->Length();
    for (int k = 0; k < 3; ++k)
    {
      velocity[k] = length > 0.0 ? this->Speed * (this->Way[k] / length) : 0.0;
    }
  }
};

std::vector<Leg> MakeLegs(vtkPolyData* waypoints, vtkDataArray* speeds)
{
  std::vector<Leg> legs(static_cast<std::size_t>(waypoints->GetNumberOfPoints() - 1));
  vtkIdType id = 0;
  for (Leg& leg : legs)
  {
    waypoints->GetPoint(id, leg.Start);
    waypoints->GetPoint(id + 1, leg.End);
    vtkMath::Subtract(leg.End, leg.Start, leg.Way);
    leg.Speed = speeds->GetTuple1(id);
    ++id;
  }
  return legs;
}

/// Returns the direction of the first leg with a length in x, y; otherwise north.
std::array<double, 2> FindFirstHeading(const std::vector<Leg>& legs)
{
  const auto leg =
    std::find_if(legs.begin(), legs.end(), [](const Leg& l) { return l.HasHeading(); });
  return leg != legs.end() ? std::array<double, 2>{ leg->Way[0], leg->Way[1] }
                           : std::array<double, 2>{ 0.0, 1.0 };
}

} // namespace

//------------------------------------------------------------------------------
bool vtkHeliosLinearPathPlatform::Move(vtkPolyData* waypoints, std::vector<State>& path)
{
  if (!this->CheckSpeeds(waypoints, "A linear path"))
  {
    return false;
  }
  const std::vector<Leg> legs = MakeLegs(waypoints, FindValues(waypoints, names::Speed));
  const std::array<double, 2> heading = FindFirstHeading(legs);

  State state{};
  state.Time = this->StartTime;
  HeadingToOrientation(heading[0], heading[1], state.Orientation);
  helios::Sum elapsed;
  for (const Leg& leg : legs)
  {
    elapsed.Add(leg.Duration());
    if (!std::isfinite(elapsed.Get()))
    {
      vtkErrorMacro(<< "The leg from waypoint " << path.size() / 2 << " of " << leg.Length()
                    << " m at " << leg.Speed << " m/s never ends; move its waypoints closer or "
                    << "raise " << names::Speed << ".");
      return false;
    }
    if (leg.HasHeading())
    {
      HeadingToOrientation(leg.Way[0], leg.Way[1], state.Orientation);
    }
    leg.GetVelocity(state.Velocity);
    state.LegId = GetLegId(waypoints, static_cast<vtkIdType>(path.size() / 2));
    std::copy_n(leg.Start, 3, state.Position);
    path.push_back(state);
    state.Time = std::max(state.Time, this->StartTime + elapsed.Get());
    std::copy_n(leg.End, 3, state.Position);
    path.push_back(state);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosLinearPathPlatform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
