// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles in a cone.

#ifndef heliosConeView_h
#define heliosConeView_h

#include <vtkType.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace helios
{

/// A triangle in the frame of a cone: the apex is the origin, the axis is z.
struct ConeTriangle
{
  vtkIdType Cell;
  double Corners[3][3];
};

/// The triangles that a cone may touch.
struct ConeView
{
  double Frame[3][3]; ///< in the world: two axes across, the axis
  std::vector<ConeTriangle> Triangles;
  double Farthest = HUGE_VAL; ///< depth beyond which a triangle hides all others

  /// Drops triangles beyond that depth, and sorts by cell: the result does not depend on the order
  /// in which they were found.
  void Finish()
  {
    const auto isHidden = [this](const ConeTriangle& t) {
      return std::min({ t.Corners[0][2], t.Corners[1][2], t.Corners[2][2] }) > this->Farthest;
    };
    this->Triangles.erase(std::remove_if(this->Triangles.begin(), this->Triangles.end(), isHidden),
      this->Triangles.end());
    this->SortByCell();
  }

private:
  /// Sorts keys instead of triangles, which are large.
  void SortByCell()
  {
    const std::size_t count = this->Triangles.size();
    this->Keys.resize(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Keys[i] = { this->Triangles[i].Cell, i };
    }
    std::sort(this->Keys.begin(), this->Keys.end());
    this->Sorted.resize(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Sorted[i] = this->Triangles[this->Keys[i].second];
    }
    this->Triangles.swap(this->Sorted);
  }

  std::vector<std::pair<vtkIdType, std::size_t>> Keys;
  std::vector<ConeTriangle> Sorted;
};

} // namespace helios

#endif
