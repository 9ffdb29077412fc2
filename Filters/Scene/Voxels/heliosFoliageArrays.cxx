// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFoliageArrays.h"

#include "heliosLeafProjection.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFoliageArrayNames.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <limits>

namespace names = vtkHeliosArrayNames;
namespace foliage = vtkHeliosFoliageArrayNames;

namespace helios
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Ratio of the mean square to the mean of |cos| of random directions: what leaves of one size that
/// are hit more than once add to the variance, times the hits of a square leaf-on.
constexpr double HitsOfOneLeaf = 2.0 / 3.0;

enum State : unsigned char
{
  NoBeam,
  Seen,
  Shadowed,
  Saturated
};

struct Column
{
  const char* Name;
  double FoliageSums::*Member;
};

constexpr Column Columns[] = { { foliage::PathLength, &FoliageSums::PathLength },
  { foliage::EnteringEnergy, &FoliageSums::Entering },
  { foliage::InterceptedEnergy, &FoliageSums::Intercepted },
  { foliage::InterceptedSquare, &FoliageSums::InterceptedSquare },
  { foliage::FreePath, &FoliageSums::FreePath }, { foliage::HitPath, &FoliageSums::HitPath },
  { foliage::PotentialPath, &FoliageSums::PotentialPath },
  { foliage::PotentialPathSquare, &FoliageSums::PotentialPathSquare } };

constexpr Column Counts[] = { { foliage::NumberOfBeams, &FoliageSums::Beams },
  { foliage::NumberOfShadowedBeams, &FoliageSums::ShadowedBeams } };

template <typename ArrayT>
ArrayT* AddColumn(vtkImageData* grid, const char* name)
{
  vtkNew<ArrayT> column;
  column->SetName(name);
  column->SetNumberOfValues(grid->GetNumberOfCells());
  grid->GetCellData()->AddArray(column);
  return column;
}

State GetState(const FoliageSums& sums, const FoliageSettings& settings, FoliageDensity& density)
{
  if (!(sums.PathLength >= settings.MinimumPath && sums.PathLength > 0.0))
  {
    density = { NaN, NaN };
    return sums.Beams + sums.ShadowedBeams > 0.0 ? Shadowed : NoBeam;
  }
  return density.IsSaturated ? Saturated : Seen;
}

} // namespace

//------------------------------------------------------------------------------
std::vector<FoliageSums> ReadSums(vtkImageData* grid)
{
  std::vector<FoliageSums> sums(static_cast<std::size_t>(grid->GetNumberOfCells()));
  const auto read = [&sums, grid](const Column& column)
  {
    vtkDataArray* array = grid->GetCellData()->GetArray(column.Name);
    for (std::size_t i = 0; array && i < sums.size(); ++i)
    {
      sums[i].*column.Member = array->GetTuple1(static_cast<vtkIdType>(i));
    }
  };
  std::for_each(std::begin(Columns), std::end(Columns), read);
  std::for_each(std::begin(Counts), std::end(Counts), read);
  return sums;
}

//------------------------------------------------------------------------------
void AddFoliageArrays(
  const std::vector<FoliageSums>& sums, const FoliageSettings& settings, vtkImageData* grid)
{
  double* const pads = AddColumn<vtkDoubleArray>(grid, names::PAD)->GetPointer(0);
  double* const errors = AddColumn<vtkDoubleArray>(grid, foliage::DensityError)->GetPointer(0);
  unsigned char* const states =
    AddColumn<vtkUnsignedCharArray>(grid, foliage::CellState)->GetPointer(0);
  double* const passing = AddColumn<vtkDoubleArray>(grid, names::Transmittance)->GetPointer(0);
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    const FoliageSums& cell = sums[i];
    const double overdispersion =
      1.0 + HitsOfOneLeaf * settings.ElementArea * cell.PathLength / settings.CellVolume;
    FoliageDensity density = EstimateDensity(settings.Estimator, cell, overdispersion);
    states[i] = GetState(cell, settings, density);
    pads[i] = density.Value;
    errors[i] = density.Error;
    const double share = cell.Entering > 0.0 ? cell.Intercepted / cell.Entering : NaN;
    passing[i] = share > 1.0 ? 0.0 : 1.0 - share;
  }
  for (const Column& column : Counts)
  {
    auto* const values = AddColumn<vtkTypeInt64Array>(grid, column.Name)->GetPointer(0);
    std::transform(sums.begin(), sums.end(), values,
      [&column](const FoliageSums& cell)
      { return static_cast<vtkTypeInt64>(cell.*column.Member); });
  }
  for (const Column& column : Columns)
  {
    double* const values = AddColumn<vtkDoubleArray>(grid, column.Name)->GetPointer(0);
    std::transform(sums.begin(), sums.end(), values,
      [&column](const FoliageSums& cell) { return cell.*column.Member; });
  }
  grid->GetCellData()->SetActiveScalars(names::PAD);
}

//------------------------------------------------------------------------------
void AddLeafTable(const LeafProjection& leaves, vtkImageData* grid)
{
  if (leaves.IsSpherical())
  {
    return;
  }
  vtkNew<vtkDoubleArray> table;
  table->SetName(names::LeafProjection);
  table->SetNumberOfComponents(4);
  for (const auto& [angle, projection] : leaves.GetRows())
  {
    const double row[] = { std::sin(angle), 0.0, std::cos(angle), projection };
    table->InsertNextTuple(row);
  }
  grid->GetFieldData()->AddArray(table);
}

} // namespace helios
