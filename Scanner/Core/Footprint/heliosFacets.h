// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles of a beam that form one flat, convex polygon, such as a leaf or a wall.

#ifndef heliosFacets_h
#define heliosFacets_h

#include "heliosConeView.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <cstddef>
#include <functional>
#include <vector>

namespace helios
{

/// A flat, convex polygon in the frame of a cone: counterclockwise, unless behind the apex.
struct Facet
{
  static constexpr int Capacity = 8;

  vtkIdType Cell = -1; ///< cell of its first triangle
  int Size = 0;
  double Corners[Capacity][3];
  std::size_t First = 0; ///< first of its triangles in the view
  std::size_t Last = 0;

  Facet() = default;
  Facet(const Facet& other) { *this = other; }
  Facet& operator=(const Facet& other);
};

/**
 * Joins consecutive triangles of a view into facets. Each shares an edge with those before it, has
 * the same response and normal, and lies in their plane: there is less to hide and to be hidden.
 */
class VTKHELIOSSCANNERCORE_EXPORT FacetMaker
{
public:
  /// Whether two cells have the same response.
  using AreAlike = std::function<bool(vtkIdType, vtkIdType)>;

  /// Sets a maximum distance from a plane, along the axis [m]. Without alike, no triangles are
  /// joined.
  FacetMaker(AreAlike areAlike, double tolerance);

  /// Two triangles as one quadrilateral: its corners in order, of the first one but for Own, and the
  /// corner of the second one that is Own.
  struct Pair
  {
    static constexpr int Own = 3;
    int Corners[4];
    int OfSecond;
    bool IsSameWay; ///< whether both are turned the same way
  };

  /// Returns whether two triangles share an edge, lie in one plane but for a tilt [rad], and have the
  /// same response but for that. Their corners may form no convex quadrilateral.
  bool CanPair(const ConeTriangle& a, const ConeTriangle& b, double tilt, Pair& pair) const;

  /// Replaces facets by the facets of the triangles.
  void Make(const ConeView& view, std::vector<Facet>& facets) const;

private:
  /// A plane n . p = c, with c >= 0.
  struct Plane
  {
    double Normal[3];
    double Constant;
  };
  void Grow(Facet& facet, const Plane& plane, const std::vector<ConeTriangle>& triangles) const;
  bool CanJoin(const Facet& facet, const Plane& plane, const ConeTriangle& other) const;
  bool IsOn(const Plane& plane, const double corner[3]) const;

  AreAlike Alike;
  double Tolerance;
};

} // namespace helios

#endif
