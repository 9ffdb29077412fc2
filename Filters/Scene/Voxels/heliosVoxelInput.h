// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The points of a data set as input of a voxel grid.

#ifndef heliosVoxelInput_h
#define heliosVoxelInput_h

#include "heliosStatus.h"
#include "heliosVoxelGrid.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPointSet;

namespace helios
{

/// Double points and normals are referenced, all others are copied.
class VoxelInput
{
public:
  /// Returns an error if an attribute is not valid.
  Status Set(vtkPointSet* data, bool withNormals);

  /// Restricts Get and GetNumberOfPoints to the points [first, end).
  void SetRange(vtkIdType first, vtkIdType end);

  VoxelPoints Get() const { return this->Range; }
  vtkIdType GetNumberOfPoints() const { return this->Range.Count; }
  /// Returns the storage precision of the coordinates.
  double GetEpsilon() const { return this->Epsilon; }

private:
  Status SetColors(vtkDataArray* colors);

  VoxelPoints Points;
  VoxelPoints Range;
  double Epsilon = 0x1p-52;
  std::vector<double> OwnPoints;
  std::vector<double> OwnNormals;
  std::vector<std::uint16_t> OwnColors;
};

/// Bounds of points, and the number with each attribute.
struct VoxelBounds
{
  double Low[3];
  double High[3];
  vtkIdType Count = 0;
  vtkIdType NormalCount = 0;
  vtkIdType ColorCount = 0;
  double Epsilon = 0x1p-52;

  VoxelBounds();

  /// Returns the index of the first point that is not finite, or -1.
  vtkIdType Add(const VoxelInput& input);

  /// Returns whether other can be of a subset of the same points.
  bool Holds(const VoxelBounds& other) const;

  /// Returns the largest distance from zero along any axis.
  double GetMagnitude() const;
};

} // namespace helios

#endif
