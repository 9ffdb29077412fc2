// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Maps points to a renderer's pixels.

#ifndef heliosPixelMap_h
#define heliosPixelMap_h

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace helios::viewer
{

/// Coordinates relative to the origin to pixels and depth.
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
      this->Size[i] = size[i];
      this->Half[i] = 0.5 * size[i];
      this->Middle[i] = origin[i] + this->Half[i];
    }
  }

  int GetWidth() const { return this->Size[0]; }
  int GetHeight() const { return this->Size[1]; }

  /// Whether two maps are the same.
  bool operator==(const PixelMap& b) const
  {
    return std::equal(this->M, this->M + 16, b.M) &&
      std::equal(this->Half, this->Half + 2, b.Half) &&
      std::equal(this->Middle, this->Middle + 2, b.Middle);
  }

  /// Returns the pixel of the renderer, row by row from its lower left; -1: outside.
  vtkIdType GetIndex(const double pixel[3]) const
  {
    const auto x = static_cast<vtkIdType>(std::floor(pixel[0] - this->Middle[0] + this->Half[0]));
    const auto y = static_cast<vtkIdType>(std::floor(pixel[1] - this->Middle[1] + this->Half[1]));
    const bool isInside = x >= 0 && x < this->Size[0] && y >= 0 && y < this->Size[1];
    return isInside ? y * this->Size[0] + x : -1;
  }

  /// Maps a point to a pixel; false behind the camera or outside its depth range.
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

  /// Returns whether a box may have points within a distance [pixels] of a pixel.
  bool MayShow(const double box[6], double px, double py, double reach) const
  {
    double low[2] = { HUGE_VAL, HUGE_VAL }, high[2] = { -HUGE_VAL, -HUGE_VAL };
    for (int corner = 0; corner < 8; ++corner)
    {
      const double x = box[corner & 1], y = box[2 + ((corner >> 1) & 1)],
                   z = box[4 + (corner >> 2)];
      if (this->M[12] * x + this->M[13] * y + this->M[14] * z + this->M[15] <= 0.0)
      {
        return true; // extends behind the camera
      }
      double pixel[3];
      this->Map(x, y, z, pixel);
      for (int i = 0; i < 2; ++i)
      {
        low[i] = std::min(low[i], pixel[i]);
        high[i] = std::max(high[i], pixel[i]);
      }
    }
    return px >= low[0] - reach && px <= high[0] + reach && py >= low[1] - reach &&
      py <= high[1] + reach;
  }

private:
  double M[16];
  double Half[2];
  double Middle[2];
  int Size[2];
};

} // namespace helios::viewer

#endif
