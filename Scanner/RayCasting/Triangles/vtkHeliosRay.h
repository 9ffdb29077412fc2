// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays and cones, and their hits: the values that ray casters take and return.

#ifndef vtkHeliosRay_h
#define vtkHeliosRay_h

#include "vtkType.h" // For vtkIdType

#include <limits> // For an unbounded ray

/// A ray: hits count at ranges in (0, MaximumRange]. Range is in units of the direction's length.
struct vtkHeliosRay
{
  double Origin[3];
  double Direction[3];
  double MaximumRange = std::numeric_limits<double>::infinity();
};

/// The first hit of a ray; CellId is -1 where it hits nothing.
struct vtkHeliosHit
{
  double Range;
  vtkIdType CellId;
};

/// The result of a cone probe.
struct vtkHeliosConeHit
{
  enum Kinds
  {
    Empty,           ///< no hit
    PlanarFootprint, ///< one plane over the whole cross-section, and nothing before it
    Unresolved       ///< anything else, or not decidable
  };
  int Kind;
  vtkIdType CellId; ///< hit by the axis
  double Range;     ///< range of this hit
};

#endif
