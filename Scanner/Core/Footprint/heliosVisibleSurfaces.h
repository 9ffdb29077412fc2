// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The visible parts of the triangles in a beam.

#ifndef heliosVisibleSurfaces_h
#define heliosVisibleSurfaces_h

#include "heliosBeamProjection.h"
#include "heliosFacets.h"
#include "heliosPolygon.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <cmath>
#include <cstddef>
#include <vector>

namespace helios
{

/// 1 / depth of a plane, which is linear over the cross-section of a beam: X x + Y y + One.
struct InverseDepth
{
  double X, Y, One;

  double operator()(double x, double y) const { return this->X * x + this->Y * y + this->One; }
};

/// The plane of a facet in a beam.
struct FacePlane
{
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  InverseDepth Inverse;
  double Minimum, Maximum; ///< inverse depths of its corners
  vtkIdType Cell;
  std::size_t Facet = None; ///< None: a triangle of one cell, or a pair
  std::size_t Pair = None;  ///< first of two successive triangles of a view that are one face
};

/**
 * Determines which part of each facet in a beam is visible: exactly in a cone, and in a beam with
 * a waist but for the curvature of its edges within the beam. The facets are projected onto the
 * cross-section. A facet B hides that part of a facet A where both overlap and B is nearer, which is
 * one side of a line, since their inverse depths are linear: a convex polygon. It is subtracted from
 * A, which leaves convex polygons. Facets that intersect or overlap in a cycle need no other
 * treatment; of coincident ones the one with the lowest id is visible. Facets of one surface share
 * the projections of their corners, so that there are no gaps. One per thread: it owns scratch
 * memory.
 */
class VTKHELIOSSCANNERCORE_EXPORT VisibleSurfaces
{
public:
  /// The projection of a facet.
  struct Face : FacePlane
  {
    Polygon Outline;
  };

  /// Projects facets onto the cross-section of a beam.
  void Project(const std::vector<Facet>& facets, const BeamProjection& beam);

  /// Sorts the faces by depth, for FindHiding().
  void Sort();

  /// Returns whether the edges in the beam are straight lines in its cross-section: without a
  /// waist, and nearly so if their depths differ little, or are far beyond the Rayleigh range.
  bool AreEdgesStraight() const { return this->LargestBend <= MaximumBend; }

  /// Returns how often the faces cover the beam, roughly.
  double GetLayers() const { return this->Layers; }

  std::size_t GetNumberOfFaces() const { return this->Faces.size(); }
  const Face& GetFace(std::size_t face) const { return this->Faces[face]; }

  /**
   * Returns whether the faces cover the beam once, so that none hides another: no edge in the beam
   * belongs to one facet only, and the facets on both sides of every edge face the apex. Not tested
   * for more than 64 facets.
   */
  bool AreOneLayer() const;

  /**
   * Finds the faces that hide something of a face. Those of which much is hidden, such as the ground
   * under leaves, and that hide nothing themselves, are backdrops.
   */
  void FindHiding(std::size_t face);
  bool IsBackdrop() const { return this->IsBehindAll; }

  /// @{
  /// Return properties of the face of the last FindHiding().
  const std::vector<std::size_t>& GetHiding() const { return this->Hiding; }

  /// Returns the visible parts, until the next call; null if they are too many.
  const std::vector<Polygon>* FindVisible();

  /// Returns whether all of another face is nearer.
  bool IsNearer(std::size_t by) const;

  /// Returns the part of a polygon of another face that hides it.
  Polygon GetNearer(const Polygon& polygon, std::size_t by) const;
  ///@}

private:
  void ProjectFacet(const Facet& facet, std::size_t index);
  void AddEdges(const Facet& facet);
  void AddBend(const Facet& facet);
  static bool Split(Polygon& inside, const HalfPlane& side, Polygon& outside);
  bool Subtract(const Polygon& hidden);
  bool HidesAny(std::size_t face) const;
  bool IsNearerSomewhere(const Face& a, const Face& b) const;

  /// The faces from the nearest to the farthest, by their nearest corners, and their bounds, rounded
  /// outwards.
  struct Order
  {
    std::vector<std::size_t> Faces;
    std::vector<double> Maximum;
    std::vector<float> Low[2], High[2];
    std::vector<unsigned char> Overlaps;  ///< with the bounds of a face; padded to whole words
    std::vector<std::size_t> Overlapping; ///< places in this order

    void SetOverlaps(const PolygonBounds& bounds);

    /// Finds those that overlap with bounds.
    void FindOverlapping(const PolygonBounds& bounds);
  };
  /// A face to be sorted.
  struct Key
  {
    double Maximum;
    vtkIdType Cell;
    std::size_t Face;
  };
  static constexpr double MaximumBend = 1e-3; ///< relative change of the radius
  double LargestBend = 0.0;
  double Layers = 0.0;
  BeamProjection Beam;
  std::vector<Face> Faces;
  vtkTypeUInt64 EdgeSum = 0; ///< sum of edges in the beam; opposite directions cancel
  bool HasFacetAtApex = false;
  bool IsLayer = false; ///< whether the facets may be one layer
  std::vector<Key> Keys;
  Order Nearest;
  std::size_t Current = 0;
  std::vector<std::size_t> Hiding;
  bool IsBehindAll = false;
  std::vector<Polygon> Parts;
  std::vector<PolygonBounds> PartBounds;
};

} // namespace helios

#endif
