// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The soil of a field: a triangulated height grid.

#ifndef heliosCropGround_h
#define heliosCropGround_h

#include "vtkHeliosFiltersSceneModule.h"

#include <vtkType.h>

#include <vector>

namespace helios
{

class MeshBuilder;

class VTKHELIOSFILTERSSCENE_EXPORT CropGround
{
public:
  /**
   * A rectangle about the z axis with cells at most spacing wide. The clods are waves of up to 3 m
   * with heights within +/- half the roughness. Without roughness it is one cell.
   */
  CropGround(double width, double length, double spacing, double roughness, vtkIdType seed);

  /// Returns the z of the triangles at a position; outside the ground, the z of its edge.
  double GetHeight(double x, double y) const;

  double GetHighest() const { return this->Highest; }

  vtkIdType GetNumberOfTriangles() const
  {
    return 2 * vtkIdType{ this->Cells[0] } * this->Cells[1];
  }
  vtkIdType GetNumberOfPoints() const
  {
    return (this->Cells[0] + vtkIdType{ 1 }) * (this->Cells[1] + vtkIdType{ 1 });
  }

  void AddTo(MeshBuilder& mesh) const;

private:
  double GetX(int i) const;
  double GetY(int j) const;
  double GetZ(int i, int j) const;

  double Size[2];
  int Cells[2];
  double Highest = 0.0;
  std::vector<double> Heights; // row by row along x; empty: flat
};

} // namespace helios

#endif
