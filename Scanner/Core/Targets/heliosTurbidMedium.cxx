// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTurbidMedium.h"

#include "heliosRandom.h"
#include "heliosStatus.h"

#include <algorithm>
#include <iterator>

namespace helios
{

//------------------------------------------------------------------------------
Status TurbidMedium::Add(vtkImageData* image, vtkIdType firstCell)
{
  Entry entry;
  Status status = entry.Grid.Set(image);
  entry.FirstCell = firstCell;
  this->Grids.push_back(std::move(entry));
  return status;
}

//------------------------------------------------------------------------------
bool TurbidMedium::MayMeet(
  const Vec3& origin, const Vec3& direction, double tangent, double apexOffset) const
{
  return std::any_of(this->Grids.begin(), this->Grids.end(),
    [&](const Entry& entry) { return entry.Grid.MayMeet(origin, direction, tangent, apexOffset); });
}

//------------------------------------------------------------------------------
void TurbidMedium::Intercept(std::uint64_t seed, vtkIdType pulseId, const vtkHeliosRay* rays,
  std::size_t count, vtkHeliosHit* hits) const
{
  const std::size_t grids = this->Grids.size();
  for (std::size_t k = 0; k < count; ++k)
  {
    const auto draw = [seed, pulseId, k, grids](std::size_t g)
    {
      return Uniform4(seed, RandomStream::TurbidMedium, static_cast<std::uint64_t>(pulseId),
        static_cast<std::uint32_t>(k * grids + g))[0];
    };
    this->Stop(Vec3(rays[k].Origin), Vec3(rays[k].Direction), rays[k].MaximumRange, draw, hits[k]);
  }
}

//------------------------------------------------------------------------------
double TurbidMedium::GetDepth(const Vec3& origin, const Vec3& direction, double range) const
{
  double sum = 0.0;
  for (const Entry& entry : this->Grids)
  {
    sum += entry.Grid.GetDepth(origin, direction, range);
  }
  return sum;
}

//------------------------------------------------------------------------------
double TurbidMedium::GetProjection(vtkIdType cell, const Vec3& direction) const
{
  const auto next = std::upper_bound(this->Grids.begin(), this->Grids.end(), cell,
    [](vtkIdType id, const Entry& entry) { return id < entry.FirstCell; });
  return std::prev(next)->Grid.GetProjection(direction);
}

} // namespace helios
