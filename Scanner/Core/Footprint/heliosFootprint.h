// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The returns of a beam from the exact visible areas of the surfaces in it.

#ifndef heliosFootprint_h
#define heliosFootprint_h

#include "heliosBeamEllipse.h"
#include "heliosBeamEnergy.h"
#include "heliosConeProbe.h"
#include "heliosFacets.h"
#include "heliosFootprintRaster.h"
#include "heliosVisibleSurfaces.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace helios
{

/// A visible part of a surface, as a sub-ray: through its centroid, with its energy.
struct FootprintPart
{
  vtkIdType Cell;
  double Range;        ///< [m]
  double Direction[3]; ///< from the origin of the beam to the centroid, a unit vector
  double Energy;       ///< fraction of the beam
};

struct FootprintSettings
{
  /// half angle of the beam at 1/e^2, along the major axis [rad]
  double HalfAngle = 0.0;
  double Truncation = 1.5;            ///< truncation of the beam, in half angles
  double ApexOffset = 0.0;            ///< Rayleigh range of the waist, at the origin [m]
  double Depth = 1.0;                 ///< largest spread of the ranges of a part [m]
  double Gate[2] = { 0.0, HUGE_VAL }; ///< ranges that are limits of parts [m]
  /// error of small parts, as a fraction of the beam
  double EnergyError = BeamEnergy::DefaultError;
  double Ratio = 1.0; ///< ratio of the minor axis to the major one
  /// Whether so many surfaces, that cover the beam so often, are sampled; if set, these are not joined
  /// to facets.
  std::function<bool(std::size_t surfaces, double layers)> IsCrowd;
  /// Largest tilt between two triangles of a crowd that are one surface [rad]; 0: none are.
  double PairTilt = 0.0;
};

/// Half space beyond a plane: n . p > c, in the world.
struct BeyondPlane
{
  double Nearest; ///< depth of the plane in the beam [m]
  double Normal[3];
  double Constant;
};

/**
 * Divides the visible surfaces of a beam into parts whose ranges spread over no more than a depth.
 * The energy and the centroid of each are exact. A part is two returns, at its mean range -+
 * its standard deviation, unless that is negligible. One per thread.
 */
class VTKHELIOSSCANNERCORE_EXPORT Footprint
{
public:
  /// Sets the settings; coplanar triangles of the same response count as one surface.
  explicit Footprint(const FootprintSettings& settings, FacetMaker::AreAlike areAlike = {});

  /**
   * Collects the surfaces in a beam from an origin along a unit axis, for the methods below. False
   * if these are more than MaximumTriangles triangles, or if the beam is too wide. minor is a unit
   * vector along the minor axis of an elliptical beam. With a plane, only what lies beyond it.
   */
  bool Collect(const ConeProbe& probe, const double origin[3], const double axis[3],
    const double minor[3] = nullptr, const BeyondPlane* beyond = nullptr);

  /// Returns whether the edges in the beam are straight: not near a waist. Otherwise the surfaces
  /// can be neither divided nor sampled.
  bool AreEdgesStraight() const { return this->Surfaces.AreEdgesStraight(); }

  /// Returns whether ranges at one depth are equal within the beam: not if it is wide, and far from
  /// the surfaces. Otherwise these can only be divided.
  bool IsFlat() const { return this->TilesAcross == 1; }

  /// Returns whether the surfaces are a crowd, which can only be sampled.
  bool IsCrowd() const { return this->Crowded.Surfaces > 0; }

  /// Returns whether no cone test within a distance would find one plane or one layer: a corner in the
  /// beam is before all planes that the axis may meet. Of a crowd only; the tangent is that of the cone.
  bool IsMixed(double tangent, double distance) const;

  /// Returns whether a limit of the range gate lies among the surfaces; not of a crowd.
  bool MeetsGate() const;

  /// Returns the number of surfaces: flat polygons.
  std::size_t GetNumberOfFaces() const
  {
    return this->IsCrowd() ? this->Crowded.Surfaces : this->Surfaces.GetNumberOfFaces();
  }

  /// Returns how often they cover the beam, roughly; not of a crowd.
  double GetLayers() const { return this->Surfaces.GetLayers(); }

  /// Returns whether a predicate holds for the cell of any surface; not of a crowd.
  template <typename PredicateT>
  bool AnyCell(PredicateT holds) const
  {
    bool any = false;
    for (std::size_t i = 0; !any && i < this->Surfaces.GetNumberOfFaces(); ++i)
    {
      any = holds(this->Surfaces.GetFace(i).Cell);
    }
    return any;
  }

  /// Computes the exact visible parts. False if they are too many for this method.
  bool Divide(std::vector<FootprintPart>& parts);

  /// Computes the visible parts by a grid of so many cells across the beam, a multiple of 8.
  void Sample(int across, std::vector<FootprintPart>& parts);

  static constexpr std::size_t MaximumTriangles = 30000; ///< in a beam

private:
  /// Depths [m].
  struct Interval
  {
    double Near, Far;
  };
  /// A visible part of a face.
  struct Visible
  {
    Polygon Outline;
    PolygonBounds Bounds;
    PolygonCircle Circle;
    EnergyMoments Moments;
  };
  /// Range of a face's parts in the list of all.
  struct Share
  {
    std::size_t First = 0;
    std::size_t Last = 0;
  };
  /// Cuts of a face, and places of its strips, in the lists of all.
  struct Strips
  {
    std::size_t FirstCut = 0, FirstStrip = 0, Count = 0; ///< numbers of cuts
  };
  bool CollectCrowd();
  bool ClipFacets(const BeyondPlane& beyond, const double apex[3]);
  void StretchFacets();
  int GetNumberOfTiles(double farthest) const;
  void SetTiles();
  void AddTiles(const FacePlane& face, const Polygon& polygon, std::vector<FootprintPart>& parts);
  /// Ratio of the depths of a part: its powers vary with 1 / depth^2.
  static constexpr double LargestRatio = 0.1;
  bool HasNoCuts(const FacePlane& face) const;
  void SetStrips();
  std::size_t FindStrip(std::size_t face, double x, double y) const;
  bool AddSurface(std::size_t face, std::vector<FootprintPart>& parts);
  void AddVisible(
    std::size_t face, const Polygon* visible, std::size_t count, std::vector<FootprintPart>& parts);
  bool AddBackdrop(std::size_t face, std::vector<FootprintPart>& parts);
  EnergyMoments GetHidden(const Polygon& polygon) const;
  Interval GetSpread(const FacePlane& face, const Share& share) const;
  Interval GetSpread(const FacePlane& face) const;
  void SetCuts(const FacePlane& face, const Interval& part);
  template <typename UseT>
  void ForEachStrip(const FacePlane& face, const Polygon& polygon, UseT use);
  void AddTiledStrips(const FacePlane& face, const Share& share, std::vector<FootprintPart>& parts);
  /// Mean and deviation of depths [m].
  struct Spread
  {
    double Mean, Deviation;
  };
  Spread GetDepths(const FacePlane& face, const EnergyMoments& moments) const;
  vtkIdType FindCell(const FacePlane& face, const double direction[3]) const;
  void AddPart(
    const FacePlane& face, const EnergyMoments& moments, std::vector<FootprintPart>& parts);

  FootprintSettings Settings;
  BeamEnergy Beam;
  BeamEllipse Ellipse;
  BeamProjection Projection;
  FacetMaker Maker;
  VisibleSurfaces Surfaces;
  FootprintFaces Faces; ///< faces that are sampled
  Crowd Crowded;        ///< without surfaces, if there is none
  ConeView View;
  std::vector<Facet> Facets;
  std::vector<Visible> AllVisible;
  std::vector<Share> Shares;               ///< shares of the faces
  std::vector<std::size_t> Backdrops;      ///< faces
  std::vector<double> Cuts;                ///< depths between strips of a face [m]
  std::vector<EnergyMoments> StripMoments; ///< strips of a face
  int TilesAcross = 1; ///< tiles of a wide beam: within one, ranges at one depth are equal
  std::map<int, FootprintRaster> Rasters; ///< rasters by cells across
  std::vector<Strips> AllStrips;          ///< strips of the faces
  std::vector<double> AllCuts;            ///< [m]
  FootprintRaster::Targets Targets;       ///< strips of the faces that have one
  std::vector<EnergyMoments> Sampled;     ///< sampled moments of the strips
};

} // namespace helios

#endif
