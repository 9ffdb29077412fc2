// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFoliageBeams.h"

#include "heliosFoliageColumns.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <string>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

/// Returns a whole number that sorts as the time does.
std::int64_t GetTimeKey(double time)
{
  std::int64_t bits = 0;
  std::memcpy(&bits, &time, sizeof(bits));
  return bits < 0 ? bits ^ std::numeric_limits<std::int64_t>::max() : bits;
}

/// Limits energies to the whole beam: an element that faces it counts as more than one.
void SplitEnergies(FoliageHit* begin, FoliageHit* end)
{
  for (FoliageHit* hit = begin; hit != end; ++hit)
  {
    if (hit->Energy > 1.0)
    {
      hit->Weight *= hit->Energy;
      hit->Energy = 1.0;
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
void FoliageBeams::Sort(Groups& groups)
{
  groups.Rows.resize(groups.Keys.size());
  std::iota(groups.Rows.begin(), groups.Rows.end(), vtkIdType(0));
  if (std::is_sorted(groups.Keys.begin(), groups.Keys.end()))
  {
    return;
  }
  const std::vector<std::int64_t> keys = groups.Keys;
  vtkSMPTools::Sort(groups.Rows.begin(), groups.Rows.end(),
    [&keys](vtkIdType a, vtkIdType b)
    {
      const std::int64_t one = keys[static_cast<std::size_t>(a)];
      const std::int64_t other = keys[static_cast<std::size_t>(b)];
      return one != other ? one < other : a < b;
    });
  std::transform(groups.Rows.begin(), groups.Rows.end(), groups.Keys.begin(),
    [&keys](vtkIdType row) { return keys[static_cast<std::size_t>(row)]; });
}

//------------------------------------------------------------------------------
Status FoliageBeams::GroupByPulse(vtkPolyData* cloud, const char* what, Groups& groups)
{
  vtkDataArray* ids = cloud->GetPointData()->GetArray(names::PulseIds);
  if (!ids && cloud->GetNumberOfPoints() > 0)
  {
    return Status::Error(std::string(what) + " have no array " + names::PulseIds +
      ", which says whose pulse they are; give those of a run, or no pulses");
  }
  groups.Keys.resize(static_cast<std::size_t>(cloud->GetNumberOfPoints()));
  for (std::size_t i = 0; i < groups.Keys.size(); ++i)
  {
    groups.Keys[i] = static_cast<std::int64_t>(ids->GetTuple1(static_cast<vtkIdType>(i)));
  }
  Sort(groups);
  return {};
}

//------------------------------------------------------------------------------
/// Groups the echoes of a cloud without pulses: by pulse, else by time, else each by itself.
Status FoliageBeams::GroupEchoes(vtkPolyData* echoes, Groups& groups)
{
  vtkPointData* data = echoes->GetPointData();
  if (data->GetArray(names::PulseIds))
  {
    return GroupByPulse(echoes, "the echoes", groups);
  }
  vtkDataArray* times = data->GetArray(names::GpsTime);
  double range[2] = { 0.0, 0.0 };
  if (times)
  {
    times->GetRange(range);
  }
  groups.Keys.resize(static_cast<std::size_t>(echoes->GetNumberOfPoints()));
  for (std::size_t i = 0; i < groups.Keys.size(); ++i)
  {
    const auto row = static_cast<vtkIdType>(i);
    groups.Keys[i] = range[0] < range[1] ? GetTimeKey(times->GetTuple1(row)) : row;
  }
  Sort(groups);
  return {};
}

//------------------------------------------------------------------------------
/// Finds the rows of each pulse among sorted groups.
Status FoliageBeams::FindRows(vtkPolyData* pulses, const Groups& groups)
{
  vtkDataArray* ids = pulses->GetPointData()->GetArray(names::PulseIds);
  const auto count = static_cast<std::size_t>(pulses->GetNumberOfPoints());
  this->First.assign(count + 1, 0);
  this->Ends.assign(count, 0);
  std::size_t found = 0;
  std::size_t next = 0;
  const auto& keys = groups.Keys;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto id = static_cast<std::int64_t>(ids->GetTuple1(static_cast<vtkIdType>(i)));
    const bool isNext =
      (next == keys.size() || keys[next] >= id) && (next == 0 || keys[next - 1] < id);
    if (!isNext)
    {
      next =
        static_cast<std::size_t>(std::lower_bound(keys.begin(), keys.end(), id) - keys.begin());
    }
    this->First[i] = next;
    while (next < keys.size() && keys[next] == id)
    {
      ++next;
    }
    this->Ends[i] = next;
    found += next - this->First[i];
  }
  this->First[count] = keys.size();
  if (found != keys.size())
  {
    return Status::Error(std::to_string(keys.size()) + " echoes or hits belong to " +
      std::to_string(found) + " by their " + names::PulseIds + " and those of " +
      std::to_string(count) + " pulses; give the pulses of the same legs, each once");
  }
  return {};
}

//------------------------------------------------------------------------------
Status FoliageBeams::SetPulses(const FoliageInput& input, const Groups& groups)
{
  vtkDataArray* directions = input.Pulses->GetPointData()->GetArray(names::Direction);
  if (!directions || directions->GetNumberOfComponents() != 3 ||
    !input.Pulses->GetPointData()->GetArray(names::PulseIds))
  {
    return Status::Error(std::string("the pulses have no arrays ") + names::Direction +
      " (three components) and " + names::PulseIds + "; give those of a run (--pulses)");
  }
  this->Origins = GetDoubles(input.Pulses->GetPoints()->GetData());
  this->Directions = GetDoubles(directions);
  return this->FindRows(input.Pulses, groups);
}

//------------------------------------------------------------------------------
/// Makes a beam of each group, from its origin through its first echo.
Status FoliageBeams::MakePulses(const FoliageInput& input, const Groups& groups)
{
  this->First.clear();
  for (std::size_t i = 0; i < groups.Keys.size(); ++i)
  {
    if (i == 0 || groups.Keys[i] != groups.Keys[i - 1])
    {
      this->First.push_back(i);
    }
  }
  this->Ends.assign(this->First.begin(), this->First.end());
  this->Ends.erase(this->Ends.begin());
  this->Ends.push_back(groups.Keys.size());
  this->First.push_back(groups.Keys.size());
  if (const Status status = this->SetOrigins(input, groups); !status.IsOk())
  {
    return status;
  }
  this->Directions = vtkSmartPointer<vtkDoubleArray>::New();
  this->Directions->SetNumberOfComponents(3);
  this->Directions->SetNumberOfTuples(this->GetNumberOfBeams());
  for (vtkIdType beam = 0; beam < this->GetNumberOfBeams(); ++beam)
  {
    const vtkIdType row = groups.Rows[this->First[static_cast<std::size_t>(beam)]];
    Vec3 direction = Vec3(input.Echoes->GetPoint(row)) - this->GetOrigin(beam);
    if (!(direction.Normalize() > 0.0))
    {
      return Status::Error("echo " + std::to_string(row) +
        " is at the origin of its beam; correct the origins, or drop it");
    }
    this->Directions->SetTuple(beam, direction.GetData());
  }
  return {};
}

//------------------------------------------------------------------------------
Status FoliageBeams::SetOrigins(const FoliageInput& input, const Groups& groups)
{
  this->Origins = vtkSmartPointer<vtkDoubleArray>::New();
  this->Origins->SetNumberOfComponents(3);
  this->Origins->SetNumberOfTuples(this->GetNumberOfBeams());
  BeamOrigins origins;
  if (const Status status = origins.Set(input); !status.IsOk())
  {
    return status;
  }
  for (vtkIdType beam = 0; beam < this->GetNumberOfBeams(); ++beam)
  {
    const vtkIdType row = groups.Rows[this->First[static_cast<std::size_t>(beam)]];
    double* origin = this->Origins->GetPointer(3 * beam);
    if (const Status status = origins.Get(row, origin); !status.IsOk())
    {
      return status;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
Status FoliageBeams::Build(const FoliageInput& input)
{
  Groups echoes;
  Status status = input.Pulses ? GroupByPulse(input.Echoes, "the echoes", echoes)
                               : GroupEchoes(input.Echoes, echoes);
  status = !status.IsOk() ? status
    : input.Pulses        ? this->SetPulses(input, echoes)
                          : this->MakePulses(input, echoes);
  FoliageColumns columns;
  status = status.IsOk() ? columns.Set(input) : status;
  if (!status.IsOk())
  {
    return status;
  }
  if (!input.Hits)
  {
    this->Hits.resize(echoes.Keys.size());
    vtkSMPTools::For(0, this->GetNumberOfBeams(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType beam = begin; beam < end; ++beam)
        {
          this->AddHits(columns, echoes, beam);
        }
      });
    return {};
  }
  if (!input.Pulses)
  {
    return Status::Error("hits of sub-rays need the pulses of their beams; connect input 1");
  }
  const std::vector<std::size_t> echoFirst = this->First;
  Groups hits;
  status = GroupByPulse(input.Hits, "the hits", hits);
  status = status.IsOk() ? this->FindRows(input.Pulses, hits) : status;
  if (!status.IsOk())
  {
    return status;
  }
  this->Hits.resize(hits.Keys.size());
  vtkSMPTools::For(0, this->GetNumberOfBeams(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType beam = begin; beam < end; ++beam)
      {
        this->AddSubRays(columns, hits, echoes, echoFirst, beam);
      }
    });
  return {};
}

//------------------------------------------------------------------------------
/// Makes hits of the echoes of a beam; those that are noise are left out.
void FoliageBeams::AddHits(const FoliageColumns& columns, const Groups& groups, vtkIdType beam)
{
  const auto index = static_cast<std::size_t>(beam);
  const Vec3 origin = this->GetOrigin(beam);
  const Vec3 direction = this->GetDirection(beam);
  FoliageHit* const begin = this->Hits.data() + this->First[index];
  FoliageHit* end = begin;
  double total = 0.0;
  for (std::size_t i = this->First[index]; i < this->Ends[index]; ++i)
  {
    const vtkIdType row = groups.Rows[i];
    if (columns.IsNoise(row))
    {
      continue;
    }
    const double range = (columns.GetPoint(row) - origin).Dot(direction);
    const double energy = columns.GetEnergy(row, range);
    *end++ = { range, energy, columns.GetWeight(row) };
    total += energy;
  }
  std::sort(begin, end, [](const FoliageHit& a, const FoliageHit& b) { return a.Range < b.Range; });
  if (columns.GetShares() == FoliageInput::Shares::First && end > begin)
  {
    end = begin + 1;
    total = 1.0;
  }
  if (columns.GetShares() == FoliageInput::Shares::Reflectance)
  {
    SplitEnergies(begin, end);
    total = 1.0;
  }
  if (columns.GetShares() == FoliageInput::Shares::Equal && end > begin)
  {
    total = std::max(total, columns.GetNumberOfReturns(groups.Rows[this->First[index]]));
  }
  std::for_each(begin, end,
    [total, begin, end](FoliageHit& hit)
    { hit.Energy = total > 0.0 ? hit.Energy / total : 1.0 / static_cast<double>(end - begin); });
  this->Ends[index] = static_cast<std::size_t>(end - this->Hits.data());
}

//------------------------------------------------------------------------------
/// Makes hits of sub-rays; each has the class and the material of the nearest echo of its beam.
void FoliageBeams::AddSubRays(const FoliageColumns& columns, const Groups& groups,
  const Groups& echoes, const std::vector<std::size_t>& echoFirst, vtkIdType beam)
{
  const auto index = static_cast<std::size_t>(beam);
  const Vec3 origin = this->GetOrigin(beam);
  const Vec3 direction = this->GetDirection(beam);
  const std::int64_t id =
    this->First[index] < groups.Keys.size() ? groups.Keys[this->First[index]] : 0;
  for (std::size_t i = this->First[index]; i < this->Ends[index]; ++i)
  {
    const vtkIdType row = groups.Rows[i];
    const double range = (columns.GetHitPoint(row) - origin).Dot(direction);
    vtkIdType nearest = -1;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t k = echoFirst[index]; k < echoes.Keys.size() && echoes.Keys[k] == id; ++k)
    {
      const Vec3 offset = columns.GetPoint(echoes.Rows[k]) - origin;
      const double away = std::abs(offset.Dot(direction) - range);
      if (away < distance)
      {
        distance = away;
        nearest = echoes.Rows[k];
      }
    }
    this->Hits[i] = { range, columns.GetHitEnergy(row),
      columns.GetHitWeight(row) * (nearest < 0 || columns.IsCounted(nearest) ? 1.0 : 0.0) };
  }
  std::sort(this->Hits.data() + this->First[index], this->Hits.data() + this->Ends[index],
    [](const FoliageHit& a, const FoliageHit& b) { return a.Range < b.Range; });
}

} // namespace helios
