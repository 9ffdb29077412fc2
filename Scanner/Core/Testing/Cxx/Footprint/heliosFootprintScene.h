// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene in one beam, divided into parts and traced by sub-rays, for tests.

#ifndef heliosFootprintScene_h
#define heliosFootprintScene_h

#include "heliosConeProbe.h"
#include "heliosFootprint.h"
#include "vtkHeliosBeamRayCaster.h"
#include "vtkHeliosBeamSampler.h"

#include <catch2/catch.hpp>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>
#include <map>
#include <tuple>
#include <vector>

namespace helios::testing
{

/// Result of sub-rays, or parts, for a cell.
struct Cell
{
  double Energy = 0.0;
  double Mean = 0.0;   // mean of the ranges
  double Square = 0.0; // square of their deviations from the mean
};
using Cells = std::map<vtkIdType, Cell>;

/// Sums over sub-rays, or parts, of each cell.
template <typename ItemsT>
Cells Summarize(const ItemsT& items)
{
  Cells cells;
  for (const auto& [id, energy, range] : items)
  {
    cells[id].Energy += energy;
    cells[id].Mean += energy * range;
  }
  for (auto& [id, cell] : cells)
  {
    cell.Mean /= cell.Energy;
  }
  for (const auto& [id, energy, range] : items)
  {
    cells[id].Square += energy * (range - cells[id].Mean) * (range - cells[id].Mean);
  }
  return cells;
}

inline Cells SummarizeParts(const std::vector<FootprintPart>& parts)
{
  std::vector<std::tuple<vtkIdType, double, double>> items;
  for (const FootprintPart& part : parts)
  {
    items.emplace_back(part.Cell, part.Energy, part.Range);
  }
  return Summarize(items);
}

/// A scene along y, and a beam along y from the origin.
class FootprintScene
{
public:
  explicit FootprintScene(double w = 1e-3)
  {
    this->Points->SetDataTypeToDouble();
    this->Settings.HalfAngle = w;
  }

  void AddTriangle(const double (&corners)[3][3])
  {
    this->Polys->InsertNextCell({ this->Points->InsertNextPoint(corners[0]),
      this->Points->InsertNextPoint(corners[1]), this->Points->InsertNextPoint(corners[2]) });
  }

  /// A wall at y, its upper or left part beyond an edge through x, z.
  void AddWall(double y, double left, double low)
  {
    constexpr double far = 50.0;
    this->AddTriangle({ { left, y, low }, { left + far, y, low }, { left + far, y, low + far } });
    this->AddTriangle({ { left, y, low }, { left + far, y, low + far }, { left, y, low + far } });
  }

  void Build()
  {
    this->Mesh->SetPoints(this->Points);
    this->Mesh->SetPolys(this->Polys);
    REQUIRE(this->Caster->Build(this->Mesh));
  }

  std::vector<FootprintPart> FindParts()
  {
    std::vector<FootprintPart> parts;
    Footprint footprint(this->Settings, this->AreAlike);
    REQUIRE(footprint.Collect(*this->Caster->GetConeProbe(), Origin, Axis, this->Minor));
    REQUIRE(footprint.Divide(parts));
    return parts;
  }

  /// Samples by cells.
  Cells Sample(int across)
  {
    std::vector<FootprintPart> parts;
    Footprint footprint(this->Settings, this->AreAlike);
    REQUIRE(footprint.Collect(*this->Caster->GetConeProbe(), Origin, Axis, this->Minor));
    footprint.Sample(across, parts);
    return SummarizeParts(parts);
  }

  /// Returns the surfaces of a crowd; 0 if there is none.
  std::size_t CountCrowd()
  {
    Footprint footprint(this->Settings, this->AreAlike);
    REQUIRE(footprint.Collect(*this->Caster->GetConeProbe(), Origin, Axis, this->Minor));
    return footprint.IsCrowd() ? footprint.GetNumberOfFaces() : 0;
  }

  /// Returns whether a crowd is known to be mixed, for a cone test within a distance.
  bool IsMixed(double distance)
  {
    Footprint footprint(this->Settings, this->AreAlike);
    REQUIRE(footprint.Collect(*this->Caster->GetConeProbe(), Origin, Axis, this->Minor));
    return footprint.IsMixed(this->GetTangent(), distance);
  }

  /// Returns whether a cone test within a distance finds one plane or one layer.
  bool IsResolved(double distance) const
  {
    PlaneLimits limits(distance);
    limits.OfLayer.Distance = distance;
    ConeLayer layer;
    const vtkHeliosConeHit hit =
      this->Caster->GetConeProbe()->Probe(Origin, Axis, this->GetTangent(), limits, &layer);
    return hit.Kind != vtkHeliosConeHit::Unresolved || layer.Size > 0;
  }

  bool Collect() const
  {
    return Footprint(this->Settings).Collect(*this->Caster->GetConeProbe(), Origin, Axis);
  }

  bool IsFlat() const
  {
    Footprint footprint(this->Settings);
    REQUIRE(footprint.Collect(*this->Caster->GetConeProbe(), Origin, Axis));
    return footprint.IsFlat() && footprint.AreEdgesStraight();
  }

  Cells GetFootprint() { return SummarizeParts(this->FindParts()); }

  /// Samples by sub-rays.
  Cells Trace() { return Summarize(this->TraceAll()); }

  double GetEnergyBetween(double near, double far)
  {
    double sum = 0.0;
    for (const auto& [id, energy, range] : this->TraceAll())
    {
      sum += range > near && range < far ? energy : 0.0;
    }
    return sum;
  }

  static constexpr double Origin[3] = { 0, 0, 0 };
  static constexpr double Axis[3] = { 0, 1, 0 };
  double Minor[3] = { 0, 0, 1 }; ///< minor axis, across y
  FootprintSettings Settings;
  helios::FacetMaker::AreAlike AreAlike; ///< none: no triangles are joined
  vtkNew<vtkPolyData> Mesh;

private:
  double GetTangent() const
  {
    return std::tan(this->Settings.HalfAngle * this->Settings.Truncation);
  }

  std::vector<std::tuple<vtkIdType, double, double>> TraceAll()
  {
    vtkNew<vtkHeliosBeamSampler> sampler;
    sampler->SetBeamDivergence(2.0 * this->Settings.HalfAngle);
    sampler->SetTruncation(this->Settings.Truncation);
    sampler->SetDivergenceRatio(this->Settings.Ratio);
    sampler->SetPatternToVogel();
    sampler->SetNumberOfSubRays(65536);
    std::vector<std::tuple<vtkIdType, double, double>> items;
    for (int k = 0; k < sampler->GetNumberOfSubRays(); ++k)
    {
      double d[3];
      sampler->GetDirection(k, d);
      const double* minor = this->Minor; // the major axis is y x minor
      vtkHeliosRay ray{ { 0, 0, 0 },
        { d[0] * minor[2] + d[2] * minor[0], d[1], d[2] * minor[2] - d[0] * minor[0] } };
      vtkHeliosHit hit;
      this->Caster->Intersect(&ray, &hit, 1);
      if (hit.CellId >= 0)
      {
        items.emplace_back(hit.CellId, sampler->GetWeight(k), hit.Range);
      }
    }
    return items;
  }

  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Polys;
  vtkNew<vtkHeliosBeamRayCaster> Caster;
};

} // namespace helios::testing

#endif
