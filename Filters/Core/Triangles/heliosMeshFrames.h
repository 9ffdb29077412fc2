// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A mesh that deforms: its points in frames, and between two of them.

#ifndef heliosMeshFrames_h
#define heliosMeshFrames_h

#include "heliosPose.h"
#include "heliosSimilarity.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <array>
#include <cstddef>
#include <vector>

namespace helios
{

/// Where the points of a mesh are between two frames: each moves on a straight line.
struct MeshShape
{
  const double* From = nullptr; ///< points of the frame before
  const double* To = nullptr;   ///< points of the frame after
  double Fraction = 0.0;        ///< within [0, 1]
  double Rate = 0.0;            ///< fractions per second; 0: it stands still
  double Hold = 0.0;            ///< the fraction for which it stands still at a time; 0: none

  /// Computes one coordinate. It ascends or descends with the fraction, rounding included.
  static double Interpolate(double from, double to, double fraction)
  {
    return from + fraction * (to - from);
  }

  void GetPoint(vtkIdType point, double place[3]) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const vtkIdType i = 3 * point + axis;
      place[axis] = Interpolate(this->From[i], this->To[i], this->Fraction);
    }
  }

  /// Returns the velocity of a point [m/s].
  Vec3 GetVelocity(vtkIdType point) const
  {
    return this->Rate * (Vec3(this->To + 3 * point) - Vec3(this->From + 3 * point));
  }
};

/// A follower of the shape of a mesh: it is fitted to it when that is used.
class ShapeFollower
{
public:
  ShapeFollower() = default;
  virtual ~ShapeFollower() = default;
  ShapeFollower(const ShapeFollower&) = delete;
  void operator=(const ShapeFollower&) = delete;

  virtual void Follow() = 0;
};

/// Frames with the same triangles.
class VTKHELIOSFILTERSCORE_EXPORT MeshFrames
{
public:
  /// Adds a frame, with double points; all have the triangles of the first.
  void Add(vtkPolyData* frame);

  std::size_t GetCount() const { return this->Frames.size(); }
  vtkPolyData* GetFrame(std::size_t frame) const { return this->Frames[frame]; }
  const double* GetPoints(std::size_t frame) const { return this->Points[frame]; }

  /// Returns the box of the points that triangles use: x0 x1 y0 y1 z0 z1; of a frame, of all.
  /// @{
  const std::array<double, 6>& GetBounds(std::size_t frame) const { return this->Bounds[frame]; }
  std::array<double, 6> GetBounds() const;
  ///@}

  /// Returns the frame with the longest diagonal of its box.
  std::size_t FindLargest() const;

  /// Returns the frames moved to a place, with the points from the first to the last that triangles use.
  MeshFrames MakePlaced(const Similarity& place) const;

  /// Bytes of the points.
  std::size_t GetMemorySize() const;

private:
  std::vector<vtkSmartPointer<vtkPolyData>> Frames;
  std::vector<const double*> Points;
  std::vector<std::array<double, 6>> Bounds;
};

} // namespace helios

#endif
