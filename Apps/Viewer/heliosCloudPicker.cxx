// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCloudPicker.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>
#include <vtkSMPThreadLocal.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace helios
{

namespace
{

/// From coordinates less the origin to pixels and depth.
class PixelMap
{
public:
  explicit PixelMap(vtkRenderer* renderer)
  {
    vtkMatrix4x4* m = renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      renderer->GetTiledAspectRatio(), -1.0, 1.0);
    std::copy(m->GetData(), m->GetData() + 16, this->M);
    const int* origin = renderer->GetOrigin();
    const int* size = renderer->GetSize();
    for (int i = 0; i < 2; ++i)
    {
      this->Half[i] = 0.5 * size[i];
      this->Middle[i] = origin[i] + this->Half[i];
    }
  }

  /// False for a point behind the camera or outside its depth range.
  bool Map(double x, double y, double z, double pixel[3]) const
  {
    const double* m = this->M;
    const double w = m[12] * x + m[13] * y + m[14] * z + m[15];
    const double depth = m[8] * x + m[9] * y + m[10] * z + m[11];
    pixel[0] = this->Middle[0] + this->Half[0] * (m[0] * x + m[1] * y + m[2] * z + m[3]) / w;
    pixel[1] = this->Middle[1] + this->Half[1] * (m[4] * x + m[5] * y + m[6] * z + m[7]) / w;
    pixel[2] = depth / w;
    return w > 0.0 && std::abs(depth) <= w;
  }

  /// Whether a box may have points within a radius of a spot.
  bool MayShow(const double box[6], const PickSpot& spot) const
  {
    double low[2] = { HUGE_VAL, HUGE_VAL }, high[2] = { -HUGE_VAL, -HUGE_VAL };
    for (int corner = 0; corner < 8; ++corner)
    {
      const double x = box[corner & 1], y = box[2 + ((corner >> 1) & 1)],
                   z = box[4 + (corner >> 2)];
      if (this->M[12] * x + this->M[13] * y + this->M[14] * z + this->M[15] <= 0.0)
      {
        return true; // it reaches behind the camera
      }
      double pixel[3];
      this->Map(x, y, z, pixel);
      for (int i = 0; i < 2; ++i)
      {
        low[i] = std::min(low[i], pixel[i]);
        high[i] = std::max(high[i], pixel[i]);
      }
    }
    const double reach = spot.Radius + spot.PointSize;
    return spot.X >= low[0] - reach && spot.X <= high[0] + reach && spot.Y >= low[1] - reach &&
      spot.Y <= high[1] + reach;
  }

private:
  double M[16];
  double Half[2];
  double Middle[2];
};

/// The best first: a point that covers the spot, then the nearest, then the closest to the camera.
struct Candidate
{
  double Distance = HUGE_VAL; ///< [pixels], 0: it covers the spot
  double Depth = HUGE_VAL;
  vtkIdType Row = -1;

  bool operator<(const Candidate& b) const
  {
    return std::tie(this->Distance, this->Depth, this->Row) < std::tie(b.Distance, b.Depth, b.Row);
  }
};

struct Search
{
  const Cloud& Points;
  const CloudWindow& Window;
  const PixelMap Pixels;
  const PickSpot Spot;
  vtkSMPThreadLocal<Candidate> Best;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    Candidate& best = this->Best.Local();
    for (vtkIdType c = begin; c < end; ++c)
    {
      const CloudChunk& chunk = *this->Points.GetChunks()[static_cast<std::size_t>(c)];
      if (!this->Window.IsOutside(chunk) && this->Pixels.MayShow(chunk.Bounds, this->Spot))
      {
        this->Scan(chunk, best);
      }
    }
  }

  void Scan(const CloudChunk& chunk, Candidate& best) const
  {
    const float* xyz = chunk.GetXyz();
    for (vtkIdType i = 0; i < chunk.GetSize(); ++i, xyz += 3)
    {
      double pixel[3];
      if (!this->Pixels.Map(xyz[0], xyz[1], xyz[2], pixel))
      {
        continue;
      }
      const double dx = std::abs(pixel[0] - this->Spot.X), dy = std::abs(pixel[1] - this->Spot.Y);
      const double distance = std::hypot(dx, dy);
      const bool covers = std::max(dx, dy) <= 0.5 * this->Spot.PointSize;
      if (!covers && distance > this->Spot.Radius)
      {
        continue;
      }
      const Candidate candidate{ covers ? 0.0 : distance, pixel[2], chunk.FirstRow + i };
      if (candidate < best && this->Window.Contains(chunk, i))
      {
        best = candidate;
      }
    }
  }
};

} // namespace

//------------------------------------------------------------------------------
bool CloudWindow::IsOutside(const CloudChunk& chunk) const
{
  if (chunk.FirstTime > this->TimeLimit)
  {
    return true;
  }
  for (int axis = 0; this->HasBox && axis < 3; ++axis)
  {
    if (chunk.Bounds[2 * axis] > this->Box[2 * axis + 1] ||
      chunk.Bounds[2 * axis + 1] < this->Box[2 * axis])
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool CloudWindow::Contains(const CloudChunk& chunk, vtkIdType i) const
{
  if (chunk.GetTime(i) > this->TimeLimit) // false for a point without time
  {
    return false;
  }
  const float* p = chunk.GetXyz() + 3 * i;
  for (int axis = 0; this->HasBox && axis < 3; ++axis)
  {
    const auto at = static_cast<double>(p[axis]);
    if (at < this->Box[2 * axis] || at > this->Box[2 * axis + 1])
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
vtkIdType PickPoint(
  const Cloud& cloud, const CloudWindow& window, vtkRenderer* renderer, const PickSpot& spot)
{
  Search search{ cloud, window, PixelMap(renderer), spot, {} };
  vtkSMPTools::For(0, static_cast<vtkIdType>(cloud.GetChunks().size()), 1, search);
  Candidate best;
  for (const Candidate& candidate : search.Best)
  {
    best = std::min(best, candidate);
  }
  return best.Row;
}

} // namespace helios
