// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRasterGround.h"

#include "heliosHeightField.h"
#include "heliosRasterMesh.h"
#include "heliosSimilarity.h"
#include "heliosStatus.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace helios
{

namespace
{

/// The pixels of an upright raster at positions in the scene: p = Place(Transform(column, row)).
class PixelFinder
{
public:
  PixelFinder(const HeightGrid& grid, const Similarity& place)
    : Grid(grid)
    , Place(place)
  {
    const double* t = grid.Transform;
    const Vec3 column = place.Scale * place.Rotate(Vec3(t[1], t[4], 0.0));
    const Vec3 row = place.Scale * place.Rotate(Vec3(t[2], t[5], 0.0));
    const double half[2] = { 0.5 * (std::abs(column[0]) + std::abs(row[0])),
      0.5 * (std::abs(column[1]) + std::abs(row[1])) };
    const double area = std::abs(column[0] * row[1] - column[1] * row[0]);
    this->Reach[0] = (std::abs(row[1]) * half[0] + std::abs(row[0]) * half[1]) / area + Slack;
    this->Reach[1] = (std::abs(column[1]) * half[0] + std::abs(column[0]) * half[1]) / area + Slack;
  }

  /// Adds the slots of all cells whose bounding box has the position in it.
  void AddSlots(const std::array<double, 2>& position, std::vector<std::int64_t>& slots) const
  {
    const double scene[3] = { position[0], position[1], 0.0 };
    double p[3];
    this->Place.ApplyInverseToPoint(scene, p);
    const double* t = this->Grid.Transform;
    const double x = p[0] - t[0];
    const double y = p[1] - t[3];
    const double area = t[1] * t[5] - t[2] * t[4];
    const double middle[2] = { (t[5] * x - t[2] * y) / area - 1.0,
      (t[1] * y - t[4] * x) / area - 1.0 }; // place of the cell, from the middle of the first one
    std::int64_t first[2], last[2];
    const std::int64_t count[2] = { this->Grid.Columns - 1, this->Grid.Rows - 1 };
    for (int i = 0; i < 2; ++i)
    {
      first[i] = Clamp(std::ceil(middle[i] - this->Reach[i]), count[i]);
      last[i] = Clamp(std::floor(middle[i] + this->Reach[i]) + 1.0, count[i]);
    }
    for (std::int64_t row = first[1]; row < last[1]; ++row)
    {
      for (std::int64_t column = first[0]; column < last[0]; ++column)
      {
        const std::int64_t slot = 2 * (row * count[0] + column);
        slots.insert(slots.end(), { slot, slot + 1 });
      }
    }
  }

private:
  static constexpr double Slack = 0.5; ///< in pixels: exceeds the rounding of any geotransform

  static std::int64_t Clamp(double cell, std::int64_t count)
  {
    return static_cast<std::int64_t>(std::min(std::max(cell, 0.0), static_cast<double>(count)));
  }

  const HeightGrid& Grid;
  const Similarity& Place;
  double Reach[2]; ///< half sides of a bounding box, in pixels
};

bool IsUpright(const Similarity& place)
{
  const auto& m = place.Turn.M;
  return !place.HasRotation || (m[2][0] == 0.0 && m[2][1] == 0.0 && m[2][2] > 0.0);
}

} // namespace

//------------------------------------------------------------------------------
Status ExtractRasterGround(const HeightField& field, const Similarity& place,
  const std::vector<std::array<double, 2>>& positions, vtkPolyData* mesh)
{
  if (!IsUpright(place))
  {
    return MakeRasterMesh(field.GetGrid(), mesh);
  }
  std::vector<std::int64_t> slots;
  const PixelFinder finder(field.GetGrid(), place);
  for (const std::array<double, 2>& position : positions)
  {
    finder.AddSlots(position, slots);
  }
  std::sort(slots.begin(), slots.end());
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  for (const std::int64_t slot : slots)
  {
    if (!field.HasTriangle(slot))
    {
      continue;
    }
    double corners[3][3];
    field.GetSlotCorners(slot, corners);
    polys->InsertNextCell(3);
    for (const auto& corner : corners)
    {
      polys->InsertCellPoint(points->InsertNextPoint(corner));
    }
  }
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return {};
}

} // namespace helios
