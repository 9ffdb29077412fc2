// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The faces that are drawn into the cells of a beam.

#ifndef heliosFootprintFaces_h
#define heliosFootprintFaces_h

#include "heliosBeamEllipse.h"
#include "heliosConeView.h"
#include "heliosFacets.h"
#include "heliosVisibleSurfaces.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace helios
{

/// Triangles of a beam that have a corner in it: of a crowd, nearly all.
struct Crowd
{
  std::size_t Triangles = 0;
  std::size_t Surfaces = 0;                  ///< successive triangles in one plane are one
  double Layers = 0.0;                       ///< how often they cover the beam, roughly
  double Nearest = HUGE_VAL, Farthest = 0.0; ///< depths of those corners [m]
  /// Least depth, within Reach radii, of the planes of all triangles that the axis may meet [m]; HUGE_VAL:
  /// none.
  double NearestPlane = HUGE_VAL;
  static constexpr double Reach = 1.25;
};

/// Which triangles of a crowd are one face.
struct PairRule
{
  const FacetMaker& Maker;
  double Tilt; ///< largest tilt between them [rad]; 0: none are
};

/**
 * Convex polygons over the cross-section of a beam, as their edges on the left and right: x = X +
 * Slope (y - Y). An edge has the same line in the face on its other side. One per thread.
 */
class VTKHELIOSSCANNERCORE_EXPORT FootprintFaces
{
public:
  struct Line
  {
    float X, Y, Slope;
  };
  struct Face : FacePlane
  {
    float Low, High; ///< limits of y
    int FirstLine;
    int Left, Right; ///< numbers of lines: first those on the left
  };

  void Clear();

  /// Adds a face with an outline.
  void Add(const VisibleSurfaces::Face& face);

  /**
   * Adds the triangles of a view that touch the square about a beam without a waist, and returns what
   * they are; those that are large, or reach behind its apex, are added to facets instead. The beam
   * is where the ellipse is a circle. Two successive ones that pair up to a convex quadrilateral are one
   * face.
   */
  Crowd AddTriangles(const ConeView& view, const BeamEllipse& ellipse, double tangent,
    const PairRule& pairs, std::vector<Facet>& large);

  /// Sorts the faces, the nearest corners first, and of equally near ones the lowest cell.
  void Sort();

  std::size_t GetNumberOfFaces() const { return this->Faces.size(); }
  /// Returns a face in that order.
  const Face& GetFace(std::size_t face) const { return this->Faces[this->Order[face]]; }
  const Line* GetLines(const Face& face) const { return &this->Lines[face.FirstLine]; }

private:
  struct Lanes;
  struct Outline;
  void AddOutline(const Outline& outline);
  void AddNext(const ConeView& view, const PairRule& pairs, const Outline& next, Outline& last);
  static bool Join(const Outline& a, const Outline& b, const FacetMaker::Pair& pair, Outline& both);
  void AddLine(double x, double y, double toX, double toY);

  std::vector<Face> Faces;
  std::vector<Line> Lines;
  std::vector<std::pair<double, std::size_t>> Keys;
  std::vector<std::size_t> Order;
};

} // namespace helios

#endif
