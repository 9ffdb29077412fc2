// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The visible parts of faces, in cells of equal energy over the cross-section of a beam.

#ifndef heliosFootprintRaster_h
#define heliosFootprintRaster_h

#include "heliosBeamEnergy.h"
#include "heliosFootprintFaces.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <cstddef>
#include <vector>

namespace helios
{

/**
 * A beam as a small camera. Faces are drawn, the nearest ones first, onto a square grid of cells; a
 * cell belongs to the face that is nearest at its centre, as if a sub-ray met it there. Tiles of
 * 8 x 8 cells are one word each, a bit per cell, and have a list of the faces that they see with
 * their bits (Carpenter, "The A-buffer", 1984): most of what is hidden costs one test per tile.
 *
 * The centres are the quantiles of the intensity along x and along y, so that all cells have the
 * same energy; those outside the circle are not used. In a wide beam tiles have weights. Along a
 * row, the place x is column N (1 + W(x)) / 2, with W(x) = erf(sqrt(a) x) / erf(sqrt(a)) as a
 * polynomial. Faces with a common edge leave no gap and share no cell. Of coincident faces the one
 * with the lowest id is visible. One per thread.
 */
class VTKHELIOSSCANNERCORE_EXPORT FootprintRaster
{
public:
  /// The visible part of a face in a tile.
  struct Spot
  {
    int Face;
    double Energy; ///< fraction of the beam
    float X, Y;    ///< its centroid
    float XX, YY;  ///< variances about that, of a whole tile

    void AddTo(EnergyMoments& m) const
    {
      const double x = this->X;
      const double y = this->Y;
      m.Energy += this->Energy;
      m.X += this->Energy * x;
      m.Y += this->Energy * y;
      m.XX += this->Energy * (x * x + this->XX);
      m.XY += this->Energy * x * y;
      m.YY += this->Energy * (y * y + this->YY);
    }
  };

  /// Where the moments of a face are set: at a place of a list, or -1 for a spot per tile.
  using Targets = std::vector<int>;

  static constexpr int MaximumAcross = 2048; ///< cells
  static constexpr std::size_t MaximumFaces = 65535;

  /// Draws all faces, which are sorted, onto a grid of so many cells across, a multiple of 8, and
  /// sets sums to the moments of their visible parts.
  void Draw(const FootprintFaces& faces, const BeamEnergy& beam, int across, const Targets& targets,
    std::vector<EnergyMoments>& sums);

  /// Returns the visible parts of faces without a target, tile by tile.
  const std::vector<Spot>& GetSpots() const { return this->Spots; }

private:
  static constexpr int Side = 8; ///< side of a tile, in cells
  struct Tile
  {
    vtkTypeUInt64 Covered; ///< cells that are covered, or outside the circle
    float Minimum;         ///< inverse depth of its farthest corner, or less
    int Last;              ///< fragment drawn last, or -1
  };
  /// The cells of a face in a tile; those of one face follow each other.
  struct Fragment
  {
    vtkTypeUInt64 Bits;
    int Before; ///< in the tile; -1: none
    vtkTypeUInt16 Tile;
    vtkTypeUInt16 Face;
  };
  /// The columns of a face in the rows of a tile: from First to before Last.
  struct Spans
  {
    int First[Side], Last[Side];
    int FirstOfAny, LastOfAny;
    int FirstOfAll, LastOfAll;
  };

  void SetGrid(const BeamEnergy& beam, int across);
  void SetWarp(double exponent);
  void SetTiles(const BeamEnergy& beam);
  double GetPlace(double column) const;
  int GetTileRow(float place, int after) const;
  void DrawFaces(const FootprintFaces& faces);
  void SetSpans(const FootprintFaces::Face& face, const FootprintFaces::Line* lines, int row,
    Spans& spans) const;
  vtkTypeUInt64 Uncover(
    const FootprintFaces& faces, int face, std::size_t tile, vtkTypeUInt64 bits);
  vtkTypeUInt64 GetNearer(const InverseDepth& difference, std::size_t tile) const;
  template <typename UseT>
  void ForEachSpot(std::size_t face, UseT use) const;
  void AddSpots(const Targets& targets, std::vector<EnergyMoments>& sums);

  double Exponent = 0.0;
  int Across = 0;
  std::vector<float> Warp;   ///< W(x) / x by powers of x^2
  std::vector<float> Places; ///< places of columns and rows
  struct TileSide
  {
    float Mean, Step, Variance; ///< moments of the places; their change per cell
  };
  std::vector<int> TileRows;    ///< rows of tiles, by steps of places
  std::vector<TileSide> Sides;  ///< tiles along a row
  std::vector<Tile> EmptyTiles; ///< tiles before the first face
  std::vector<double> Weights;  ///< energies of a cell, by tiles
  std::vector<Spans> AllSpans;  ///< spans of a face, by rows of tiles
  std::vector<Tile> Tiles;
  std::vector<Fragment> Fragments;
  std::vector<std::size_t> FirstFragments; ///< by faces
  std::vector<Spot> Spots;
};

} // namespace helios

#endif
