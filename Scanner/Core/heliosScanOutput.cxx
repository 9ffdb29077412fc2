// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScanOutput.h"

#include "vtkHeliosArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkTable.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

/// Where the records of each chunk go; the last entry is the number of all.
template <typename RecordT>
std::vector<vtkIdType> GetOffsets(
  const std::vector<ChunkResult>& chunks, std::vector<RecordT> ChunkResult::*records)
{
  std::vector<vtkIdType> offsets(1, 0);
  for (const ChunkResult& chunk : chunks)
  {
    offsets.push_back(offsets.back() + static_cast<vtkIdType>((chunk.*records).size()));
  }
  return offsets;
}

/// Adds arrays to the attributes of one data object, all of the same length.
class Columns
{
public:
  Columns(vtkFieldData* target, vtkIdType count)
    : Target(target)
    , Count(count)
  {
  }

  template <typename ArrayT>
  typename ArrayT::ValueType* Add(const char* name, int components = 1)
  {
    vtkNew<ArrayT> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(this->Count);
    this->Target->AddArray(array);
    return array->GetPointer(0);
  }

  void AddConstant(const char* name, int value)
  {
    int* column = this->Add<vtkIntArray>(name);
    std::fill_n(column, this->Count, value);
  }

private:
  vtkFieldData* Target;
  vtkIdType Count;
};

double* AddPoints(vtkPolyData* output, vtkIdType count)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  output->SetPoints(points);
  return static_cast<double*>(points->GetVoidPointer(0));
}

void Put(double* column, vtkIdType row, const Vec3& value)
{
  std::copy_n(value.GetData(), 3, column + 3 * row);
}

/// Calls put(record, row) for all records of all chunks; chunks go in parallel.
template <typename RecordT, typename PutT>
void ForEachRecord(const std::vector<ChunkResult>& chunks,
  std::vector<RecordT> ChunkResult::*records, const std::vector<vtkIdType>& offsets, PutT put)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(chunks.size()), 1,
    [&chunks, &offsets, records, put](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType c = begin; c < end; ++c)
      {
        vtkIdType row = offsets[static_cast<std::size_t>(c)];
        for (const RecordT& record : chunks[static_cast<std::size_t>(c)].*records)
        {
          put(record, row++);
        }
      }
    });
}

} // namespace

void FillEchoes(const std::vector<ChunkResult>& chunks, const ScanIds& ids, vtkPolyData* output)
{
  const auto offsets = GetOffsets(chunks, &ChunkResult::Echoes);
  const vtkIdType count = offsets.back();
  double* points = AddPoints(output, count);
  Columns columns(output->GetPointData(), count);
  double* times = columns.Add<vtkDoubleArray>(names::GpsTime);
  auto* pulses = columns.Add<vtkTypeInt64Array>(names::PulseIds);
  unsigned char* numbers = columns.Add<vtkUnsignedCharArray>(names::ReturnNumber);
  unsigned char* totals = columns.Add<vtkUnsignedCharArray>(names::NumberOfReturns);
  double* ranges = columns.Add<vtkDoubleArray>(names::Range);
  double* amplitudes = columns.Add<vtkDoubleArray>(names::Amplitude);
  double* widths = columns.Add<vtkDoubleArray>(names::EchoWidth);
  double* angles = columns.Add<vtkDoubleArray>(names::ScanAngle);
  int* classes = columns.Add<vtkIntArray>(names::ClassificationIds);
  int* materials = columns.Add<vtkIntArray>(names::MaterialIds);
  int* parts = columns.Add<vtkIntArray>(names::PartIds);
  auto* cells = columns.Add<vtkTypeInt64Array>(names::CellIds);
  double* incidences = columns.Add<vtkDoubleArray>(names::IncidenceAngle);
  auto* waveforms = columns.Add<vtkTypeInt64Array>(names::WaveformIds);
  columns.AddConstant(names::LegIds, ids.Leg);
  int* channels = columns.Add<vtkIntArray>(names::ChannelIds);
  const int firstChannel = ids.Channel;
  const bool hasWaveforms = ids.HasWaveforms;
  ForEachRecord(chunks, &ChunkResult::Echoes, offsets,
    [=](const EchoRecord& e, vtkIdType row)
    {
      Put(points, row, e.Point);
      times[row] = e.Time;
      pulses[row] = e.PulseId;
      channels[row] = firstChannel + e.Channel;
      numbers[row] = e.ReturnNumber;
      totals[row] = e.NumberOfReturns;
      ranges[row] = e.Range;
      amplitudes[row] = e.Amplitude;
      widths[row] = e.Width;
      angles[row] = e.ScanAngle;
      classes[row] = e.Classification;
      materials[row] = e.MaterialId;
      parts[row] = e.PartId;
      cells[row] = e.CellId;
      incidences[row] = e.Incidence;
      waveforms[row] = hasWaveforms ? e.PulseId : -1;
    });
  if (ids.HasDeviations)
  {
    double* deviations = columns.Add<vtkDoubleArray>(names::Deviation);
    ForEachRecord(chunks, &ChunkResult::Echoes, offsets,
      [=](const EchoRecord& e, vtkIdType row) { deviations[row] = e.Deviation; });
  }
}

/// What no instrument knows, beside the echoes.
void FillTruths(const std::vector<ChunkResult>& chunks, vtkPolyData* output)
{
  const auto offsets = GetOffsets(chunks, &ChunkResult::Truths);
  Columns columns(output->GetPointData(), offsets.back());
  double* points = columns.Add<vtkDoubleArray>(names::TruePoint, 3);
  double* normals = columns.Add<vtkDoubleArray>(names::Normal, 3);
  ForEachRecord(chunks, &ChunkResult::Truths, offsets,
    [=](const TruthRecord& t, vtkIdType row)
    {
      Put(points, row, t.Point);
      Put(normals, row, t.Normal);
    });
}

void FillPulses(const std::vector<ChunkResult>& chunks, const ScanIds& ids, vtkPolyData* output)
{
  const auto offsets = GetOffsets(chunks, &ChunkResult::Pulses);
  const vtkIdType count = offsets.back();
  double* origins = AddPoints(output, count);
  Columns columns(output->GetPointData(), count);
  double* directions = columns.Add<vtkDoubleArray>(names::Direction, 3);
  double* times = columns.Add<vtkDoubleArray>(names::GpsTime);
  auto* pulses = columns.Add<vtkTypeInt64Array>(names::PulseIds);
  double* angles = columns.Add<vtkDoubleArray>(names::ScanAngle);
  unsigned char* hits = columns.Add<vtkUnsignedCharArray>(names::Hit);
  columns.AddConstant(names::LegIds, ids.Leg);
  int* channels = columns.Add<vtkIntArray>(names::ChannelIds);
  const int firstChannel = ids.Channel;
  ForEachRecord(chunks, &ChunkResult::Pulses, offsets,
    [=](const PulseRecord& p, vtkIdType row)
    {
      Put(origins, row, p.Origin);
      Put(directions, row, p.Direction);
      times[row] = p.Time;
      pulses[row] = p.PulseId;
      angles[row] = p.ScanAngle;
      channels[row] = firstChannel + p.Channel;
      hits[row] = p.Hit ? 1 : 0;
    });
}

void FillSubRays(const std::vector<ChunkResult>& chunks, vtkPolyData* output)
{
  const auto offsets = GetOffsets(chunks, &ChunkResult::SubRays);
  const vtkIdType count = offsets.back();
  double* points = AddPoints(output, count);
  Columns columns(output->GetPointData(), count);
  auto* pulses = columns.Add<vtkTypeInt64Array>(names::PulseIds);
  auto* cells = columns.Add<vtkTypeInt64Array>(names::CellIds);
  double* weights = columns.Add<vtkDoubleArray>(names::Weight);
  double* ranges = columns.Add<vtkDoubleArray>(names::Range);
  double* incidences = columns.Add<vtkDoubleArray>(names::IncidenceAngle);
  ForEachRecord(chunks, &ChunkResult::SubRays, offsets,
    [=](const SubRayRecord& s, vtkIdType row)
    {
      Put(points, row, s.Point);
      pulses[row] = s.PulseId;
      cells[row] = s.CellId;
      weights[row] = s.Weight;
      ranges[row] = s.Range;
      incidences[row] = s.Incidence;
    });
}

void FillWaveforms(const std::vector<ChunkResult>& chunks, const ScanIds& ids, double binSize,
  double pulseLength, vtkTable* output)
{
  const auto offsets = GetOffsets(chunks, &ChunkResult::Waveforms);
  const vtkIdType count = offsets.back();
  Columns columns(output->GetRowData(), count);
  auto* pulses = columns.Add<vtkTypeInt64Array>(names::PulseIds);
  columns.AddConstant(names::LegIds, ids.Leg);
  int* channels = columns.Add<vtkIntArray>(names::ChannelIds);
  const int firstChannel = ids.Channel;
  double* origins = columns.Add<vtkDoubleArray>(names::Origin, 3);
  double* directions = columns.Add<vtkDoubleArray>(names::Direction, 3);
  double* times = columns.Add<vtkDoubleArray>(names::GpsTime);
  double* starts = columns.Add<vtkDoubleArray>(names::StartTime);
  double* bins = columns.Add<vtkDoubleArray>(names::BinSize);
  auto* firsts = columns.Add<vtkTypeInt64Array>(names::Offset);
  auto* counts = columns.Add<vtkTypeInt64Array>(names::Count);
  ForEachRecord(chunks, &ChunkResult::Waveforms, offsets,
    [=](const WaveformRecord& w, vtkIdType row)
    {
      pulses[row] = w.PulseId;
      Put(origins, row, w.Origin);
      Put(directions, row, w.Direction);
      times[row] = w.Time;
      starts[row] = w.StartTime;
      bins[row] = binSize;
      counts[row] = w.Count;
      channels[row] = firstChannel + w.Channel;
    });
  vtkIdType total = 0;
  for (vtkIdType row = 0; row < count; ++row)
  {
    firsts[row] = total;
    total += counts[row];
  }
  Columns fields(output->GetFieldData(), total);
  float* samples = fields.Add<vtkFloatArray>(names::Samples);
  for (const ChunkResult& chunk : chunks)
  {
    samples = std::copy(chunk.Samples.begin(), chunk.Samples.end(), samples);
  }
  *Columns(output->GetFieldData(), 1).Add<vtkDoubleArray>(names::PulseLength) = pulseLength;
}

} // namespace helios
