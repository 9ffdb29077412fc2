// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A grid of cells with random attenuation: leaves too small and too many to be triangles.

#ifndef heliosTurbidGrid_h
#define heliosTurbidGrid_h

#include "heliosCellGrid.h"
#include "heliosLeafProjection.h"
#include "heliosPose.h"
#include "heliosStatus.h"
#include "vtkHeliosScannerRayCastingModule.h"

#include <vtkDoubleArray.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <utility>

class vtkImageData;

namespace helios
{

/// The stop of a ray; Cell is -1 if it is not stopped.
struct TurbidHit
{
  double Range;
  vtkIdType Cell;
};

/**
 * The cells of an image with their plant area density PAD [m2/m3]. A ray along d is stopped in ds
 * with the probability k ds, k = PAD G(d): G is the projection of a unit of leaf area, 0.5 for
 * randomly oriented leaves. So the optical depth, the sum of k s over the cells, is exponential
 * with mean 1 (Beer and Lambert; Ross 1981, The Radiation Regime and Architecture of Plant Stands).
 */
class VTKHELIOSSCANNERRAYCASTING_EXPORT TurbidGrid
{
public:
  /// Reads an image and keeps its array alive.
  Status Set(vtkImageData* grid);

  vtkIdType GetNumberOfCells() const { return this->Pad->GetNumberOfValues(); }

  /// Returns G for a direction of any length: linear in its angle from the grid's z axis, symmetric
  /// about the horizontal.
  double GetProjection(const Vec3& direction) const;

  /// Calls visit(cell, from, to) for the cells that a ray passes: CellGrid::Traverse().
  template <typename Visitor>
  void Traverse(const Vec3& origin, const Vec3& direction, double end, Visitor&& visit) const
  {
    this->Cells.Traverse(origin, direction, end, std::forward<Visitor>(visit));
  }

  /// Finds the point where a ray with a unit direction has passed an optical depth, at most to a
  /// range.
  TurbidHit FindDepth(const Vec3& origin, const Vec3& direction, double end, double depth) const;

  /// Returns the optical depth of a ray with a unit direction up to a range.
  double GetDepth(const Vec3& origin, const Vec3& direction, double end) const;

  /// Returns false if nothing near a ray can hit the grid: CellGrid::MayMeet().
  bool MayMeet(const Vec3& origin, const Vec3& direction, double tangent, double apexOffset) const
  {
    return this->Cells.MayMeet(origin, direction, tangent, apexOffset);
  }

private:
  Status CheckDensities() const;

  vtkSmartPointer<vtkDoubleArray> Pad;
  CellGrid Cells;
  LeafProjection Leaves;
};

} // namespace helios

#endif
