// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTurbidBoxes.h"

#include "heliosMaterialColors.h"
#include "heliosMaterialTable.h"
#include "vtkHeliosArrayNames.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace helios::viewer
{
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double SmallestEdge = 0.2; // share of its cell
constexpr vtkIdType Corners = 8;
constexpr double MaximumSums = 2e6; // approximate: blocks of an almost empty grid

// Corners of the faces, counter-clockwise from outside; corner 1 is along x, 2 y, 4 z.
constexpr double Shades[6] = { 0.75, 0.8, 0.85, 0.9, 0.6,
  1.0 }; // west, east, south, north, below, above
constexpr vtkIdType Faces[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
  { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };

/// The cells of a grid in cubes of n x n x n; those at the end may have fewer.
class Blocks
{
public:
  Blocks(vtkImageData* grid, vtkDataArray* densities)
    : Grid(grid)
    , Densities(densities)
  {
    int points[3];
    grid->GetDimensions(points);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Cells[axis] = std::max(0, points[axis] - 1);
    }
  }

  vtkIdType CountCells() const
  {
    vtkIdType count = 0;
    for (vtkIdType cell = 0; cell < this->Densities->GetNumberOfTuples(); ++cell)
    {
      count += this->Densities->GetComponent(cell, 0) > 0.0 ? 1 : 0; // nor NaN
    }
    return count;
  }

  /// Sums densities; returns the number of blocks that have any.
  vtkIdType Gather(int edge);

  /// Enlarges the blocks until at most a number of them are filled.
  void Fit(vtkIdType maximum);

  void MakeBoxes(const std::vector<Rgb>& colors, const Vec3& origin, vtkPolyData* boxes) const;

private:
  struct Box
  {
    double Low[3];
    double High[3];
    double Density;
  };

  Box GetBox(std::size_t block) const;
  double FindFull() const;

  vtkImageData* Grid;
  vtkDataArray* Densities;
  int Cells[3];
  int Edge = 1; // edge of a block, in cells
  int Count[3]; // number of blocks
  std::vector<double> Sums;
  std::vector<vtkIdType> FirstCells; // with a density; their material is used
};

//------------------------------------------------------------------------------
vtkIdType Blocks::Gather(int edge)
{
  this->Edge = edge;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Count[axis] = (this->Cells[axis] + edge - 1) / edge;
  }
  const std::size_t size = static_cast<std::size_t>(this->Count[0]) *
    static_cast<std::size_t>(this->Count[1]) * static_cast<std::size_t>(this->Count[2]);
  this->Sums.assign(size, 0.0);
  this->FirstCells.assign(size, -1);
  vtkIdType cell = 0;
  vtkIdType filled = 0;
  for (int k = 0; k < this->Cells[2]; ++k)
  {
    for (int j = 0; j < this->Cells[1]; ++j)
    {
      const std::size_t row =
        (static_cast<std::size_t>(k / edge) * static_cast<std::size_t>(this->Count[1]) +
          static_cast<std::size_t>(j / edge)) *
        static_cast<std::size_t>(this->Count[0]);
      for (int i = 0; i < this->Cells[0]; ++i, ++cell)
      {
        const double density = this->Densities->GetComponent(cell, 0);
        if (density > 0.0)
        {
          const std::size_t block = row + static_cast<std::size_t>(i / edge);
          filled += this->FirstCells[block] < 0 ? 1 : 0;
          this->FirstCells[block] = this->FirstCells[block] < 0 ? cell : this->FirstCells[block];
          this->Sums[block] += density;
        }
      }
    }
  }
  return filled;
}

//------------------------------------------------------------------------------
void Blocks::Fit(vtkIdType maximum)
{
  const double filled = static_cast<double>(this->CountCells()) / static_cast<double>(maximum);
  const double all = static_cast<double>(this->Densities->GetNumberOfTuples()) / MaximumSums;
  int edge = std::max(1, static_cast<int>(std::cbrt(std::max(filled, all))));
  while (this->Gather(edge) > maximum)
  {
    ++edge;
  }
}

//------------------------------------------------------------------------------
/// Returns the box in cells, with the mean density of its block.
Blocks::Box Blocks::GetBox(std::size_t block) const
{
  const auto nx = static_cast<std::size_t>(this->Count[0]);
  const auto ny = static_cast<std::size_t>(this->Count[1]);
  const std::size_t index[3] = { block % nx, block / nx % ny, block / nx / ny };
  Box box;
  box.Density = this->Sums[block];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int low = static_cast<int>(index[axis]) * this->Edge;
    const int high = std::min(low + this->Edge, this->Cells[axis]);
    box.Low[axis] = low;
    box.High[axis] = high;
    box.Density /= high - low;
  }
  return box;
}

//------------------------------------------------------------------------------
/// Returns the density of a box that fills its block.
double Blocks::FindFull() const
{
  std::vector<double> densities;
  for (std::size_t block = 0; block < this->Sums.size(); ++block)
  {
    if (this->FirstCells[block] >= 0)
    {
      densities.push_back(this->GetBox(block).Density);
    }
  }
  if (densities.empty())
  {
    return 1.0;
  }
  const auto last = static_cast<double>(densities.size() - 1);
  const auto place = densities.begin() + std::lround(0.98 * last);
  std::nth_element(densities.begin(), place, densities.end());
  return *place;
}

//------------------------------------------------------------------------------
void Blocks::MakeBoxes(const std::vector<Rgb>& colors, const Vec3& origin, vtkPolyData* boxes) const
{
  vtkDataArray* materials = this->Grid->GetCellData()->GetArray(names::MaterialIds);
  const int* extent = this->Grid->GetExtent();
  const double full = this->FindFull();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkUnsignedCharArray> rgb;
  rgb->SetNumberOfComponents(3);
  for (std::size_t block = 0; block < this->Sums.size(); ++block)
  {
    if (this->FirstCells[block] < 0)
    {
      continue;
    }
    const Box box = this->GetBox(block);
    const double edge = std::clamp(std::cbrt(box.Density / full), SmallestEdge, 1.0);
    const vtkIdType first = points->GetNumberOfPoints();
    for (vtkIdType corner = 0; corner < Corners; ++corner)
    {
      double at[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        const double side = (corner >> axis & 1) != 0 ? 0.5 : -0.5;
        at[axis] = extent[2 * axis] + 0.5 * (box.Low[axis] + box.High[axis]) +
          side * edge * (box.High[axis] - box.Low[axis]);
      }
      double place[3];
      this->Grid->TransformContinuousIndexToPhysicalPoint(at, place);
      points->InsertNextPoint((Vec3(place) - origin).GetData());
    }
    const auto row = static_cast<std::size_t>(
      materials ? std::max(0.0, materials->GetComponent(this->FirstCells[block], 0)) : 0.0);
    const Rgb& color = colors[std::min(row, colors.size() - 1)];
    for (std::size_t k = 0; k < 6; ++k)
    {
      const auto& face = Faces[k];
      const vtkIdType ids[4] = { first + face[0], first + face[1], first + face[2],
        first + face[3] };
      quads->InsertNextCell(4, ids);
      for (const std::uint8_t value : color)
      {
        rgb->InsertNextValue(static_cast<unsigned char>(Shades[k] * value));
      }
    }
  }
  boxes->SetPoints(points);
  boxes->SetPolys(quads);
  boxes->GetCellData()->SetScalars(rgb);
}

/// Returns the colours; the default is the colour of leaves.
std::vector<Rgb> GetColors(vtkImageData* grid)
{
  std::vector<Rgb> colors;
  for (Material material : GetMaterials(grid))
  {
    material.Name = material.Name == Material().Name ? "leaf" : material.Name;
    colors.push_back(GetMaterialColor(material, colors.size()));
  }
  return colors;
}

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeTurbidBoxes(
  vtkImageData* grid, vtkIdType maximum, const Vec3& origin)
{
  auto boxes = vtkSmartPointer<vtkPolyData>::New();
  vtkDataArray* densities = grid->GetCellData()->GetArray(names::PAD);
  if (densities && densities->GetNumberOfTuples() == grid->GetNumberOfCells())
  {
    Blocks blocks(grid, densities);
    blocks.Fit(std::max<vtkIdType>(1, maximum));
    blocks.MakeBoxes(GetColors(grid), origin, boxes);
  }
  return boxes;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeTurbidBoxes(
  const std::vector<vtkSmartPointer<vtkImageData>>& grids, vtkIdType maximum, const Vec3& origin)
{
  double cells = 0.0;
  for (vtkImageData* grid : grids)
  {
    cells += static_cast<double>(grid->GetNumberOfCells());
  }
  vtkNew<vtkAppendPolyData> all;
  for (vtkImageData* grid : grids)
  {
    const double share = static_cast<double>(grid->GetNumberOfCells()) / cells;
    all->AddInputData(
      MakeTurbidBoxes(grid, static_cast<vtkIdType>(share * static_cast<double>(maximum)), origin));
  }
  grids.empty() ? void() : all->Update();
  return all->GetOutput();
}

} // namespace helios::viewer
