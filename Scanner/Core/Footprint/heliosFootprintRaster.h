// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The nearest face in each cell of a grid over the cross-section of a beam.

#ifndef heliosFootprintRaster_h
#define heliosFootprintRaster_h

#include "heliosVisibleSurfaces.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <cstddef>
#include <vector>

namespace helios
{

/**
 * A beam as a small camera: faces are drawn onto a square grid whose inscribed circle is the rim of
 * the beam. A cell belongs to the face that is nearest at its centre, as if a sub-ray met it there.
 * Faces with a common edge leave no gap and share no cell. Of coincident faces the first one is
 * drawn. One per thread.
 */
class VTKHELIOSSCANNERCORE_EXPORT FootprintRaster
{
public:
  /// Draws all faces onto a grid of so many cells across.
  void Draw(const VisibleSurfaces& surfaces, int across);

  int GetAcross() const { return this->Across; }

  /// Returns the x or y of the centres of a column or row.
  double GetCentre(int index) const { return this->Centres[static_cast<std::size_t>(index)]; }

  /// Returns the first column of a row in the circle; the last is opposite to it.
  int GetFirst(int row) const { return this->Firsts[static_cast<std::size_t>(row)]; }

  /// Returns the faces of a row, by columns; -1: none.
  const int* GetFaces(int row) const
  {
    return this->Owners.data() +
      static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Across);
  }

private:
  /// The part of a row: columns from First to before Last.
  struct Span
  {
    int First, Last;
  };

  void SetGrid(int across);
  void DrawFace(const VisibleSurfaces::Face& face, int index);
  void AddEdge(const Polygon& outline, int edge);
  int GetLine(double place) const;
  void DrawRow(const VisibleSurfaces::Face& face, int row, int index);
  /// Scaled inverse depths along a row.
  struct Slope
  {
    float Start, Slope, Minimum, Maximum;
  };
  static void DrawSpan(const float* columns, float* depths, int* owners, const Span& span,
    const Slope& slope, int index);

  int Across = 0;
  std::vector<double> Centres;
  std::vector<float> Columns;
  std::vector<int> Firsts;
  std::vector<Span> Spans;    ///< spans of the face, by rows
  double Minimum = 0.0;       ///< inverse depth of the farthest corner
  double Scale = 1.0;         ///< scale of inverse depths, to [0, 1]
  std::vector<float> Nearest; ///< scaled inverse depths of the cells
  std::vector<int> Owners;
};

} // namespace helios

#endif
