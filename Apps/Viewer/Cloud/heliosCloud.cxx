// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCloud.h"

#include "heliosCloudBlock.h"
#include "heliosCloudCodes.h"
#include "vtkHeliosArrayNames.h"

#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace names = vtkHeliosArrayNames;

namespace helios::viewer
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::int32_t NoPulse = std::numeric_limits<std::int32_t>::min();

/// Returns a text of an array; empty without it.
std::string GetText(vtkStringArray* texts, int index)
{
  const vtkIdType count = texts ? texts->GetNumberOfValues() : 0;
  return index >= 0 && index < count ? texts->GetValue(index) : std::string();
}

template <typename T>
std::size_t GetBytes(const std::vector<T>& values)
{
  return values.capacity() * sizeof(T);
}

} // namespace

//------------------------------------------------------------------------------
bool Cloud::SetOrigin(const Vec3& origin)
{
  if (this->NumberOfPoints > 0)
  {
    return false;
  }
  this->Origin = origin;
  this->HasOrigin = true;
  return true;
}

//------------------------------------------------------------------------------
void Cloud::Append(vtkPolyData* echoes)
{
  if (!echoes || echoes->GetNumberOfPoints() == 0)
  {
    return;
  }
  vtkFieldData* fields = echoes->GetFieldData();
  auto* parts = fields->GetAbstractArray(names::PartName);
  this->PartNames = parts ? vtkStringArray::SafeDownCast(parts) : this->PartNames.GetPointer();
  auto* materials = fields->GetAbstractArray(names::MaterialName);
  this->MaterialNames =
    materials ? vtkStringArray::SafeDownCast(materials) : this->MaterialNames.GetPointer();
  const vtkIdType size = echoes->GetNumberOfPoints();
  for (vtkIdType begin = 0; begin < size; begin += CloudChunk::Capacity)
  {
    this->AppendRows(echoes, begin, std::min(size, begin + CloudChunk::Capacity));
  }
}

//------------------------------------------------------------------------------
std::string Cloud::GetPartName(int part) const
{
  return GetText(this->PartNames, part);
}

//------------------------------------------------------------------------------
std::string Cloud::GetMaterialName(int material) const
{
  return GetText(this->MaterialNames, material);
}

//------------------------------------------------------------------------------
void Cloud::AppendRows(vtkPolyData* echoes, vtkIdType begin, vtkIdType stop)
{
  CloudBlock block(echoes, begin, stop);
  if (!block.Has(CloudColumn::Amplitude))
  {
    vtkDataArray* raw = echoes->GetPointData()->GetArray(names::Intensity);
    raw = raw ? raw : echoes->GetPointData()->GetArray("intensity"); // name in PLY
    block.Read(CloudColumn::Amplitude, raw, echoes->GetNumberOfPoints());
    this->RawAmplitudes = this->RawAmplitudes || raw;
  }
  this->Present[static_cast<int>(CloudColumn::Height)] = true;
  for (int i = 0; i < NumberOfCloudColumns; ++i)
  {
    this->Present[i] = this->Present[i] || block.Has(static_cast<CloudColumn>(i));
  }
  for (vtkIdType row = 0; row < block.GetSize();)
  {
    if (!block.IsFinite(row))
    {
      ++this->NumberOfDropped;
      ++row;
      continue;
    }
    vtkIdType end = row + 1;
    while (end < block.GetSize() && block.IsFinite(end))
    {
      ++end;
    }
    this->AppendRun(block, row, end);
    row = end;
  }
}

//------------------------------------------------------------------------------
void Cloud::AppendRun(const CloudBlock& block, vtkIdType begin, vtkIdType end)
{
  if (!this->HasOrigin)
  {
    const double* p = block.Xyz.data() + 3 * begin;
    this->SetOrigin({ std::round(p[0]), std::round(p[1]), std::round(p[2]) });
  }
  while (begin < end)
  {
    CloudChunk& chunk = this->GetOpenChunk(block, begin);
    vtkIdType stop = std::min(end, begin + CloudChunk::Capacity - chunk.GetSize());
    for (vtkIdType row = begin + 1; row < stop; ++row)
    {
      stop = block.IsNear(row, chunk.PulseBase) ? stop : row;
    }
    this->AppendPlaces(chunk, block, begin, stop);
    this->AppendTimes(chunk, block, begin, stop);
    this->AppendColors(chunk, block, begin, stop);
    this->AppendTags(chunk, block, begin, stop);
    this->NumberOfPoints += stop - begin;
    begin = stop;
  }
}

//------------------------------------------------------------------------------
CloudChunk& Cloud::GetOpenChunk(const CloudBlock& block, vtkIdType row)
{
  if (!this->Chunks.empty())
  {
    CloudChunk& last = *this->Chunks.back();
    if (last.GetSize() < CloudChunk::Capacity && block.IsNear(row, last.PulseBase))
    {
      return last;
    }
    last.Squeeze();
  }
  this->Chunks.push_back(std::make_unique<CloudChunk>());
  CloudChunk& chunk = *this->Chunks.back();
  chunk.FirstRow = this->NumberOfPoints;
  chunk.PulseBase = static_cast<std::int64_t>(block.Get(CloudColumn::Pulse, row, 0.0));
  chunk.TimeBase = block.Get(CloudColumn::Time, row, 0.0);
  chunk.TimeBase = std::isfinite(chunk.TimeBase) ? chunk.TimeBase : 0.0;
  return chunk;
}

//------------------------------------------------------------------------------
void Cloud::AppendPlaces(CloudChunk& chunk, const CloudBlock& block, vtkIdType begin, vtkIdType end)
{
  const vtkIdType size = chunk.GetSize();
  if (size == 0)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      chunk.Bounds[2 * axis] = std::numeric_limits<double>::infinity();
      chunk.Bounds[2 * axis + 1] = -std::numeric_limits<double>::infinity();
    }
  }
  float* xyz = chunk.Xyz->WritePointer(3 * size, 3 * (end - begin));
  for (vtkIdType row = begin; row < end; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto value = static_cast<float>(
        block.Xyz[static_cast<std::size_t>(3 * row + axis)] - this->Origin[axis]);
      *xyz++ = value;
      double* bounds = chunk.Bounds + 2 * axis;
      bounds[0] = std::min(bounds[0], static_cast<double>(value));
      bounds[1] = std::max(bounds[1], static_cast<double>(value));
    }
  }
}

//------------------------------------------------------------------------------
void Cloud::AppendTimes(CloudChunk& chunk, const CloudBlock& block, vtkIdType begin, vtkIdType end)
{
  for (vtkIdType row = begin; row < end; ++row)
  {
    const double time = block.Get(CloudColumn::Time, row, NaN);
    chunk.Times.push_back(static_cast<float>(time - chunk.TimeBase));
    chunk.IsInTimeOrder = chunk.IsInTimeOrder && !(time < chunk.LastTime) && std::isfinite(time);
    chunk.FirstTime = std::fmin(chunk.FirstTime, time);
    chunk.LastTime = std::fmax(chunk.LastTime, time);
  }
}

//------------------------------------------------------------------------------
/// Appends colours, before AppendTags(), which counts the points.
void Cloud::AppendColors(CloudChunk& chunk, const CloudBlock& block, vtkIdType begin, vtkIdType end)
{
  if (!block.Has(CloudColumn::Color) && chunk.Colors.empty())
  {
    return;
  }
  chunk.Colors.resize(static_cast<std::size_t>(chunk.GetSize()), NoColor);
  for (vtkIdType row = begin; row < end; ++row)
  {
    chunk.Colors.push_back(static_cast<std::uint32_t>(block.Get(CloudColumn::Color, row, NoColor)));
  }
}

//------------------------------------------------------------------------------
void Cloud::AppendTags(CloudChunk& chunk, const CloudBlock& block, vtkIdType begin, vtkIdType end)
{
  for (vtkIdType row = begin; row < end; ++row)
  {
    const double pulse = block.Get(CloudColumn::Pulse, row, -1.0);
    chunk.Pulses.push_back(pulse < 0.0
        ? NoPulse
        : static_cast<std::int32_t>(static_cast<std::int64_t>(pulse) - chunk.PulseBase));
    chunk.Ranges.push_back(static_cast<float>(block.Get(CloudColumn::Range, row, NaN)));
    chunk.Amplitudes.push_back(EncodeAmplitude(block.Get(CloudColumn::Amplitude, row, NaN)));
    chunk.ReturnNumbers.push_back(ToByte(block.Get(CloudColumn::ReturnNumber, row, 0.0)));
    chunk.NumbersOfReturns.push_back(ToByte(block.Get(CloudColumn::NumberOfReturns, row, 0.0)));
    chunk.Classes.push_back(ToByte(block.Get(CloudColumn::Class, row, 0.0)));
    chunk.Incidences.push_back(EncodeIncidence(block.Get(CloudColumn::Incidence, row, NaN)));
    chunk.Tags.push_back(this->GetTag({ block.GetId(CloudColumn::Leg, row),
      block.GetId(CloudColumn::Part, row), block.GetId(CloudColumn::Material, row) }));
  }
}

//------------------------------------------------------------------------------
std::size_t Cloud::TagHash::operator()(const Tag& tag) const
{
  std::uint64_t hash = static_cast<std::uint32_t>(tag.Leg);
  hash = hash * 0x9E3779B97F4A7C15u + static_cast<std::uint32_t>(tag.Part);
  hash = hash * 0x9E3779B97F4A7C15u + static_cast<std::uint32_t>(tag.Material);
  return static_cast<std::size_t>(hash ^ (hash >> 29));
}

//------------------------------------------------------------------------------
std::uint32_t Cloud::GetTag(const Tag& tag)
{
  if (this->LastTag < this->Tags.size() && this->Tags[this->LastTag] == tag)
  {
    return this->LastTag;
  }
  const auto added = this->TagRows.emplace(tag, static_cast<std::uint32_t>(this->Tags.size()));
  if (added.second)
  {
    this->Tags.push_back(tag);
  }
  this->LastTag = added.first->second;
  return this->LastTag;
}

//------------------------------------------------------------------------------
void Cloud::Clear()
{
  const Vec3 origin = this->Origin;
  const bool hasOrigin = this->HasOrigin;
  *this = Cloud();
  this->Origin = origin;
  this->HasOrigin = hasOrigin;
}

//------------------------------------------------------------------------------
bool Cloud::GetBounds(double bounds[6]) const
{
  for (int i = 0; i < 6; ++i)
  {
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    double value = sign * std::numeric_limits<double>::infinity();
    for (const auto& chunk : this->Chunks)
    {
      value = sign * std::min(sign * value, sign * chunk->Bounds[i]);
    }
    bounds[i] = value + this->Origin[i / 2];
  }
  return this->NumberOfPoints > 0;
}

//------------------------------------------------------------------------------
bool Cloud::GetTimeRange(double range[2]) const
{
  range[0] = range[1] = NaN;
  for (const auto& chunk : this->Chunks)
  {
    range[0] = std::fmin(range[0], chunk->FirstTime);
    range[1] = std::fmax(range[1], chunk->LastTime);
  }
  return std::isfinite(range[0]);
}

//------------------------------------------------------------------------------
const CloudChunk& Cloud::FindChunk(vtkIdType row) const
{
  const auto after = std::upper_bound(this->Chunks.begin(), this->Chunks.end(), row,
    [](vtkIdType wanted, const std::unique_ptr<CloudChunk>& chunk)
    { return wanted < chunk->FirstRow; });
  return **(after - 1);
}

//------------------------------------------------------------------------------
Echo Cloud::GetEcho(vtkIdType row) const
{
  const CloudChunk& chunk = this->FindChunk(row);
  const auto i = static_cast<std::size_t>(row - chunk.FirstRow);
  const float* xyz = chunk.GetXyz() + 3 * i;
  const Tag& tag = this->Tags[chunk.Tags[i]];
  Echo echo;
  echo.Row = row;
  echo.Position = this->Origin + Vec3(xyz[0], xyz[1], xyz[2]);
  echo.PulseId = chunk.Pulses[i] == NoPulse ? -1 : chunk.PulseBase + chunk.Pulses[i];
  echo.ReturnNumber = chunk.ReturnNumbers[i];
  echo.NumberOfReturns = chunk.NumbersOfReturns[i];
  echo.Class = chunk.Classes[i];
  echo.Part = tag.Part;
  echo.Material = tag.Material;
  echo.Leg = tag.Leg;
  echo.GpsTime = chunk.GetTime(static_cast<vtkIdType>(i));
  echo.Amplitude = DecodeAmplitude(chunk.Amplitudes[i]);
  echo.Range = static_cast<double>(chunk.Ranges[i]);
  echo.IncidenceAngle = DecodeIncidence(chunk.Incidences[i]);
  return echo;
}

//------------------------------------------------------------------------------
void Cloud::GetValues(
  const CloudChunk& chunk, CloudColumn column, vtkIdType begin, vtkIdType end, double* values) const
{
  const auto fill = [&](auto get)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      *values++ = static_cast<double>(get(static_cast<std::size_t>(i)));
    }
  };
  const float* xyz = chunk.GetXyz();
  switch (column)
  {
    case CloudColumn::Height:
      return fill(
        [&](std::size_t i) { return this->Origin[2] + static_cast<double>(xyz[3 * i + 2]); });
    case CloudColumn::Amplitude:
      return fill([&](std::size_t i) { return DecodeAmplitude(chunk.Amplitudes[i]); });
    case CloudColumn::ReturnNumber:
      return fill([&](std::size_t i) { return chunk.ReturnNumbers[i]; });
    case CloudColumn::NumberOfReturns:
      return fill([&](std::size_t i) { return chunk.NumbersOfReturns[i]; });
    case CloudColumn::Class:
      return fill([&](std::size_t i) { return chunk.Classes[i]; });
    case CloudColumn::Time:
      return fill([&](std::size_t i) { return chunk.GetTime(static_cast<vtkIdType>(i)); });
    case CloudColumn::Part:
      return fill([&](std::size_t i) { return this->Tags[chunk.Tags[i]].Part; });
    case CloudColumn::Material:
      return fill([&](std::size_t i) { return this->Tags[chunk.Tags[i]].Material; });
    case CloudColumn::Leg:
      return fill([&](std::size_t i) { return this->Tags[chunk.Tags[i]].Leg; });
    case CloudColumn::Incidence:
      return fill([&](std::size_t i) { return DecodeIncidence(chunk.Incidences[i]); });
    case CloudColumn::Range:
      return fill([&](std::size_t i) { return chunk.Ranges[i]; });
    case CloudColumn::Pulse:
      return fill([&](std::size_t i)
        { return chunk.Pulses[i] == NoPulse ? -1 : chunk.PulseBase + chunk.Pulses[i]; });
    case CloudColumn::Color:
      return fill(
        [&](std::size_t i) { return i < chunk.Colors.size() ? chunk.Colors[i] : NoColor; });
  }
}

//------------------------------------------------------------------------------
std::size_t Cloud::GetMemorySize() const
{
  std::size_t bytes = GetBytes(this->Tags) + GetBytes(this->Chunks) +
    this->TagRows.size() * (sizeof(Tag) + 4 * sizeof(void*));
  for (const auto& chunk : this->Chunks)
  {
    bytes += chunk->GetMemorySize();
  }
  return bytes;
}

} // namespace helios::viewer
