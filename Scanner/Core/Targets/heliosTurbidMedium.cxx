// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTurbidMedium.h"

#include "heliosRandom.h"
#include "heliosStatus.h"

#include <algorithm>
#include <cmath>

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
    const Vec3 origin(rays[k].Origin);
    const Vec3 direction(rays[k].Direction);
    double end = hits[k].CellId < 0 ? rays[k].MaximumRange : hits[k].Range;
    for (std::size_t g = 0; g < grids; ++g)
    {
      const Entry& entry = this->Grids[g];
      if (!entry.Grid.MayMeet(origin, direction, 0.0, 0.0))
      {
        continue;
      }
      const double u = Uniform4(seed, RandomStream::TurbidMedium,
        static_cast<std::uint64_t>(pulseId), static_cast<std::uint32_t>(k * grids + g))[0];
      const TurbidHit hit = entry.Grid.FindDepth(origin, direction, end, -std::log(u));
      if (hit.Cell >= 0)
      {
        hits[k] = { hit.Range, entry.FirstCell + hit.Cell };
        end = hit.Range;
      }
    }
  }
}

} // namespace helios
