// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The points of a data set as a voxel grid takes them.

#ifndef heliosVoxelInput_h
#define heliosVoxelInput_h

#include "heliosVoxelGrid.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPointSet;

namespace helios
{

/// Double points and normals are borrowed, all else is copied.
class VoxelInput
{
public:
  /// Says in words what is wrong with the attributes, or returns an empty text.
  std::string Set(vtkPointSet* data, bool withNormals);

  /// Of the points only those from first to before end, for Get and GetNumberOfPoints.
  void SetRange(vtkIdType first, vtkIdType end);

  VoxelPoints Get() const { return this->Range; }
  vtkIdType GetNumberOfPoints() const { return this->Range.Count; }
  /// The precision that the coordinates are stored in.
  double GetEpsilon() const { return this->Epsilon; }

private:
  std::string SetColors(vtkDataArray* colors);

  VoxelPoints Points;
  VoxelPoints Range;
  double Epsilon = 0x1p-52;
  std::vector<double> OwnPoints;
  std::vector<double> OwnNormals;
  std::vector<std::uint16_t> OwnColors;
};

/// What points span, and how many have which attributes.
struct VoxelBounds
{
  double Low[3];
  double High[3];
  vtkIdType Count = 0;
  vtkIdType NormalCount = 0;
  vtkIdType ColorCount = 0;
  double Epsilon = 0x1p-52;

  VoxelBounds();

  /// The place of the first point that is not finite, or -1.
  vtkIdType Add(const VoxelInput& input);

  /// Whether another one can be of some of the same points.
  bool Holds(const VoxelBounds& other) const;

  /// The largest distance from zero along any axis.
  double GetMagnitude() const;
};

} // namespace helios

#endif
