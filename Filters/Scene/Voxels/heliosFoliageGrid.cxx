// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFoliageGrid.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

constexpr double Units = 1073741824.0; // 2^30
constexpr double Spent = 1e-9;         // energy of a beam that is used up, with rounding errors

/// The sums of a cell, in the order of FoliageSums.
enum Sum : std::uint8_t
{
  Beams,
  ShadowedBeams,
  Entering,
  Intercepted,
  InterceptedSquare,
  PathLength,
  FreePath,
  HitPath,
  PotentialPath,
  PotentialPathSquare
};

std::int64_t ToUnits(double value)
{
  return static_cast<std::int64_t>(value * Units + 0.5);
}

} // namespace

//------------------------------------------------------------------------------
void FoliageGrid::Add(const FoliageBeams& beams, vtkIdType begin, vtkIdType end)
{
  vtkSMPTools::For(begin, end,
    [this, &beams](vtkIdType first, vtkIdType last)
    {
      std::vector<CellSums>& sums = this->Sums.Local();
      if (sums.empty())
      {
        sums.assign(static_cast<std::size_t>(this->Cells.GetNumberOfCells()), CellSums{});
      }
      for (vtkIdType index = first; index < last; ++index)
      {
        this->AddBeam(beams, index, sums.data());
      }
    });
}

//------------------------------------------------------------------------------
void FoliageGrid::AddBeam(const FoliageBeams& beams, vtkIdType index, CellSums* sums) const
{
  const Vec3 direction = beams.GetDirection(index);
  Beam beam{ 1.0, 1.0, beams.BeginHits(index), beams.EndHits(index) };
  if (!this->UsesIncidence && this->Leaves.IsSpherical())
  {
    beam.Projection = LeafProjection::Spherical;
  }
  else if (!this->UsesIncidence)
  {
    const Vec3 d = this->Cells.ToAxes(direction);
    beam.Projection = this->Leaves.Get(std::atan2(std::hypot(d[0], d[1]), std::abs(d[2])));
  }
  this->Cells.Traverse(beams.GetOrigin(index), direction, this->MaximumRange,
    [this, &beam, sums](vtkIdType cell, double from, double to)
    {
      for (; beam.Hit < beam.End && beam.Hit->Range < from; ++beam.Hit) // before the grid
      {
        beam.Energy -= beam.Hit->Energy;
      }
      if (beam.Energy < Spent)
      {
        ++sums[cell][ShadowedBeams];
      }
      else
      {
        this->AddChord(beam, from, to, sums[cell]);
      }
      return true;
    });
}

//------------------------------------------------------------------------------
/// Returns the path times G; of elements of a size the effective one of Pimont et al. 2018.
double FoliageGrid::GetPath(double length, double projection) const
{
  if (this->ElementAttenuation > 0.0)
  {
    const double attenuation = this->ElementAttenuation * projection;
    return -std::log1p(-attenuation * length) / this->ElementAttenuation /
      this->Cells.GetDiagonal();
  }
  return projection * length / this->Cells.GetDiagonal();
}

//------------------------------------------------------------------------------
void FoliageGrid::AddChord(Beam& beam, double from, double to, CellSums& sums) const
{
  const double entering = beam.Energy;
  const double chord = to - from;
  const double chordPath = this->GetPath(chord, beam.Projection);
  double intercepted = 0.0;
  double length = 0.0; // free ones, times energy
  double free = 0.0;
  double hit = 0.0;
  double potential = entering * chordPath;
  double square = entering * chordPath * chordPath;
  for (; beam.Hit < beam.End && beam.Hit->Range <= to; ++beam.Hit)
  {
    const double energy = std::min(beam.Hit->Energy, beam.Energy);
    const double passed = beam.Hit->Range - from;
    const double path = this->GetPath(passed, beam.Projection);
    beam.Energy -= energy;
    length += energy * passed;
    free += energy * path;
    intercepted += energy * beam.Hit->Weight;
    hit += energy * energy * beam.Hit->Weight * path;
    if (beam.Hit->Weight == 0.0) // not a plant: the path would end there
    {
      potential -= energy * (chordPath - path);
      square -= energy * (chordPath * chordPath - path * path);
    }
  }
  beam.Energy = beam.Energy < Spent ? 0.0 : beam.Energy;
  ++sums[Beams];
  sums[Entering] += ToUnits(entering);
  sums[Intercepted] += ToUnits(intercepted);
  sums[InterceptedSquare] += ToUnits(intercepted * intercepted);
  sums[PathLength] += ToUnits((length + beam.Energy * chord) / this->Cells.GetDiagonal());
  sums[FreePath] += ToUnits(free + beam.Energy * chordPath);
  sums[HitPath] += ToUnits(hit);
  sums[PotentialPath] += ToUnits(potential);
  sums[PotentialPathSquare] += ToUnits(square);
}

//------------------------------------------------------------------------------
void FoliageGrid::GetSums(std::vector<FoliageSums>& sums)
{
  const double diagonal = this->Cells.GetDiagonal();
  const double energy = 1.0 / Units;
  const double path = diagonal / Units;
  std::vector<const CellSums*> threads;
  for (auto it = this->Sums.begin(); it != this->Sums.end(); ++it)
  {
    threads.push_back((*it).data());
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(sums.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        CellSums whole{};
        for (const CellSums* thread : threads)
        {
          std::transform(whole.begin(), whole.end(), thread[cell].begin(), whole.begin(),
            [](std::int64_t a, std::int64_t b) { return a + b; });
        }
        const auto get = [&whole](Sum sum) { return static_cast<double>(whole[sum]); };
        FoliageSums& cellSums = sums[static_cast<std::size_t>(cell)];
        cellSums.Beams += get(Beams);
        cellSums.ShadowedBeams += get(ShadowedBeams);
        cellSums.Entering += energy * get(Entering);
        cellSums.Intercepted += energy * get(Intercepted);
        cellSums.InterceptedSquare += energy * get(InterceptedSquare);
        cellSums.PathLength += path * get(PathLength);
        cellSums.FreePath += path * get(FreePath);
        cellSums.HitPath += path * get(HitPath);
        cellSums.PotentialPath += path * get(PotentialPath);
        cellSums.PotentialPathSquare += path * diagonal * get(PotentialPathSquare);
      }
    });
}

} // namespace helios
