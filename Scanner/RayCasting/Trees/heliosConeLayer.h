// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A continuous surface that fills a cone.

#ifndef heliosConeLayer_h
#define heliosConeLayer_h

#include <vtkType.h>

namespace helios
{

/// A few triangles without gaps or steps between them, in the frame of a cone: the apex is the
/// origin, the axis is z. They hide all others.
struct ConeLayer
{
  static constexpr int Capacity = 24;

  struct Piece
  {
    vtkIdType Cell;
    double Edges[3][3]; ///< planes through the apex and an edge: directions inside are positive
    double Inverse[3];  ///< 1 / depth in the direction (x, y, 1): its product with that
  };

  double Frame[3][3]; ///< in the world: two axes across, the axis
  int Size = 0;       ///< number of the pieces; 0: the cone has no such surface
  Piece Pieces[Capacity];
};

} // namespace helios

#endif
