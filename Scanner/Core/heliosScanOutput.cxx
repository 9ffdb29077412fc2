// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScanOutput.h"

#include "heliosScanModel.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosBeamDeflector.h"

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
#include <cmath>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

// Memory for this many echoes is reserved at once, some 140 bytes each; for more on demand.
constexpr vtkIdType EchoesReserved = 4000000;

/// Returns the first output row of each chunk, from a row; the last entry is one past the end.
template <typename RecordT>
std::vector<vtkIdType> GetOffsets(const std::vector<ChunkResult>& chunks,
  std::vector<RecordT> ChunkResult::*records, vtkIdType first)
{
  std::vector<vtkIdType> offsets(1, first);
  for (const ChunkResult& chunk : chunks)
  {
    offsets.push_back(offsets.back() + static_cast<vtkIdType>((chunk.*records).size()));
  }
  return offsets;
}

/// Extends an array; its content is kept.
void Lengthen(vtkDataArray* array, vtkIdType count)
{
  if (count * array->GetNumberOfComponents() > array->GetSize())
  {
    array->Resize(count); // and more, to do so rarely
  }
  array->SetNumberOfTuples(count);
}

/// The arrays of one data object, all of the same length, that receive rows [first, last).
class Columns
{
public:
  Columns(vtkFieldData* target, vtkIdType first, vtkIdType last)
    : Target(target)
    , First(first)
    , Last(last)
  {
  }

  /// Returns all rows of the array with a name.
  template <typename ArrayT>
  typename ArrayT::ValueType* Add(const char* name, int components = 1)
  {
    auto* array = ArrayT::SafeDownCast(this->Target->GetAbstractArray(name));
    if (!array)
    {
      vtkNew<ArrayT> added;
      added->SetName(name);
      added->SetNumberOfComponents(components);
      this->Target->AddArray(added);
      array = added;
    }
    Lengthen(array, this->Last);
    return array->GetPointer(0);
  }

  void AddConstant(const char* name, int value)
  {
    int* column = this->Add<vtkIntArray>(name);
    std::fill(column + this->First, column + this->Last, value);
  }

private:
  vtkFieldData* Target;
  vtkIdType First;
  vtkIdType Last;
};

double* AddPoints(vtkPolyData* output, vtkIdType count)
{
  if (!output->GetPoints())
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    output->SetPoints(points);
  }
  vtkDataArray* points = output->GetPoints()->GetData();
  Lengthen(points, count);
  return vtkDoubleArray::SafeDownCast(points)->GetPointer(0);
}

/// Releases unused memory of arrays.
void Squeeze(vtkFieldData* data)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    data->GetAbstractArray(i)->Squeeze();
  }
}

void Store(double* column, vtkIdType row, const Vec3& value)
{
  std::copy_n(value.GetData(), 3, column + 3 * row);
}

/// Calls store(record, row) for all records of all chunks, in parallel over chunks.
template <typename RecordT, typename StoreT>
void ForEachRecord(const std::vector<ChunkResult>& chunks,
  std::vector<RecordT> ChunkResult::*records, const std::vector<vtkIdType>& offsets, StoreT store)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(chunks.size()), 1,
    [&chunks, &offsets, records, store](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType c = begin; c < end; ++c)
      {
        vtkIdType row = offsets[static_cast<std::size_t>(c)];
        for (const RecordT& record : chunks[static_cast<std::size_t>(c)].*records)
        {
          store(record, row++);
        }
      }
    });
}

void FillEchoes(const std::vector<ChunkResult>& chunks, const ScanModel& model, const ScanIds& ids,
  vtkPolyData* output)
{
  const auto offsets = GetOffsets(chunks, &ChunkResult::Echoes, output->GetNumberOfPoints());
  double* points = AddPoints(output, offsets.back());
  Columns columns(output->GetPointData(), offsets.front(), offsets.back());
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
  const bool hasWaveforms = model.Wants.Waveforms;
  ForEachRecord(chunks, &ChunkResult::Echoes, offsets,
    [=](const EchoRecord& e, vtkIdType row)
    {
      Store(points, row, e.Point);
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
  if (model.Receiver.Detector->GivesDeviation())
  {
    double* deviations = columns.Add<vtkDoubleArray>(names::Deviation);
    ForEachRecord(chunks, &ChunkResult::Echoes, offsets,
      [=](const EchoRecord& e, vtkIdType row) { deviations[row] = e.Deviation; });
  }
}

/// Fills the columns of the last pulses or echoes of a target, from a row on.
void FillColumns(const ScanModel& model, vtkIdType first, vtkPolyData* output)
{
  const vtkIdType last = output->GetNumberOfPoints();
  Columns columns(output->GetPointData(), first, last);
  const auto* pulses = columns.Add<vtkTypeInt64Array>(names::PulseIds);
  auto* ids = columns.Add<vtkTypeInt64Array>(names::ColumnIds);
  const PulseIds all = model.Source.Ids;
  const vtkHeliosBeamDeflector* deflector = model.Source.Deflector;
  vtkSMPTools::For(first, last,
    [=](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        ids[row] = deflector->GetColumn((pulses[row] - all.First) / all.Stride);
      }
    });
}

/// Fills the decibels of the last echoes, from a row on: 10 log10(P / P0), with P0 the detection
/// threshold and the amplitude of a white diffuse plane at the same range.
void FillDecibels(const ScanModel& model, vtkIdType first, vtkPolyData* output)
{
  const vtkIdType last = output->GetNumberOfPoints();
  Columns columns(output->GetPointData(), first, last);
  const double* amplitudes = columns.Add<vtkDoubleArray>(names::Amplitude);
  const double* ranges = columns.Add<vtkDoubleArray>(names::Range);
  double* relatives = columns.Add<vtkDoubleArray>(names::RelativeAmplitude);
  double* reflectances = columns.Add<vtkDoubleArray>(names::Reflectance);
  const double threshold = model.Receiver.Detector->GetDetectionThreshold();
  vtkSMPTools::For(first, last,
    [=, &model](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        const double white = model.GetWhiteAmplitude(ranges[row]);
        relatives[row] = 10.0 * std::log10(amplitudes[row] / threshold);
        reflectances[row] = 10.0 * std::log10(amplitudes[row] / white);
      }
    });
}

/// Fills the ground truth of the echoes.
void FillTruths(const std::vector<ChunkResult>& chunks, vtkPolyData* output)
{
  vtkDataArray* before = output->GetPointData()->GetArray(names::TruePoint);
  const auto offsets =
    GetOffsets(chunks, &ChunkResult::Truths, before ? before->GetNumberOfTuples() : 0);
  Columns columns(output->GetPointData(), offsets.front(), offsets.back());
  double* points = columns.Add<vtkDoubleArray>(names::TruePoint, 3);
  double* normals = columns.Add<vtkDoubleArray>(names::Normal, 3);
  ForEachRecord(chunks, &ChunkResult::Truths, offsets,
    [=](const TruthRecord& t, vtkIdType row)
    {
      Store(points, row, t.Point);
      Store(normals, row, t.Normal);
    });
}

void FillVelocities(const std::vector<ChunkResult>& chunks, vtkIdType before, vtkPolyData* output)
{
  const auto offsets = GetOffsets(chunks, &ChunkResult::Velocities, before);
  Columns columns(output->GetPointData(), offsets.front(), offsets.back());
  double* velocities = columns.Add<vtkDoubleArray>(names::RadialVelocity);
  ForEachRecord(chunks, &ChunkResult::Velocities, offsets,
    [=](double velocity, vtkIdType row) { velocities[row] = velocity; });
}

void FillMotions(const std::vector<ChunkResult>& chunks, vtkIdType before, vtkPolyData* output)
{
  const auto offsets = GetOffsets(chunks, &ChunkResult::Motions, before);
  Columns columns(output->GetPointData(), offsets.front(), offsets.back());
  double* positions = columns.Add<vtkDoubleArray>(names::PartPosition, 3);
  double* orientations = columns.Add<vtkDoubleArray>(names::PartOrientation, 4);
  double* velocities = columns.Add<vtkDoubleArray>(names::PartVelocity, 3);
  ForEachRecord(chunks, &ChunkResult::Motions, offsets,
    [=](const MotionRecord& m, vtkIdType row)
    {
      Store(positions, row, m.Part.Position);
      std::copy_n(m.Part.Orientation.GetData(), 4, orientations + 4 * row);
      Store(velocities, row, m.Velocity);
    });
}

/// Fills the number of mirrors and panes on the way.
void FillSpecularEvents(
  const std::vector<ChunkResult>& chunks, vtkIdType before, vtkPolyData* output)
{
  const auto offsets = GetOffsets(chunks, &ChunkResult::Truths, before);
  Columns columns(output->GetPointData(), offsets.front(), offsets.back());
  int* events = columns.Add<vtkIntArray>(names::SpecularEvents);
  ForEachRecord(chunks, &ChunkResult::Truths, offsets,
    [=](const TruthRecord& t, vtkIdType row) { events[row] = t.SpecularEvents; });
}

/// Fills how much of the amplitude was scattered more than once, and its standard error.
void FillScattered(const std::vector<ChunkResult>& chunks, vtkIdType before, vtkPolyData* output)
{
  const auto offsets = GetOffsets(chunks, &ChunkResult::Scattered, before);
  Columns columns(output->GetPointData(), offsets.front(), offsets.back());
  double* powers = columns.Add<vtkDoubleArray>(names::ScatteredAmplitude);
  double* errors = columns.Add<vtkDoubleArray>(names::ScatteredDeviation);
  ForEachRecord(chunks, &ChunkResult::Scattered, offsets,
    [=](const ScatteredPower& scattered, vtkIdType row)
    {
      powers[row] = scattered.Power;
      errors[row] = scattered.Error;
    });
}

/// Fills red, green and blue of the echoes.
void FillColors(const std::vector<ChunkResult>& chunks, vtkIdType before, vtkPolyData* output)
{
  const auto offsets = GetOffsets(chunks, &ChunkResult::Colors, before);
  Columns columns(output->GetPointData(), offsets.front(), offsets.back());
  float* colors = columns.Add<vtkFloatArray>(names::RGB, 3);
  ForEachRecord(chunks, &ChunkResult::Colors, offsets,
    [=](const ColorRecord& color, vtkIdType row)
    { std::copy(color.begin(), color.end(), colors + 3 * row); });
}

/// Fills the flags of scan lines.
void FillScanFlags(const std::vector<ChunkResult>& chunks, vtkIdType before, vtkPolyData* output)
{
  const auto offsets = GetOffsets(chunks, &ChunkResult::Echoes, before);
  Columns columns(output->GetPointData(), offsets.front(), offsets.back());
  unsigned char* directions = columns.Add<vtkUnsignedCharArray>(names::ScanDirectionFlag);
  unsigned char* edges = columns.Add<vtkUnsignedCharArray>(names::EdgeOfFlightLine);
  ForEachRecord(chunks, &ChunkResult::Echoes, offsets,
    [=](const EchoRecord& e, vtkIdType row)
    {
      directions[row] = e.ScanDirection;
      edges[row] = e.EdgeOfFlightLine;
    });
}

void FillPulses(const std::vector<ChunkResult>& chunks, const ScanIds& ids, vtkPolyData* output)
{
  const auto offsets = GetOffsets(chunks, &ChunkResult::Pulses, output->GetNumberOfPoints());
  double* origins = AddPoints(output, offsets.back());
  Columns columns(output->GetPointData(), offsets.front(), offsets.back());
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
      Store(origins, row, p.Origin);
      Store(directions, row, p.Direction);
      times[row] = p.Time;
      pulses[row] = p.PulseId;
      angles[row] = p.ScanAngle;
      channels[row] = firstChannel + p.Channel;
      hits[row] = p.Hit ? 1 : 0;
    });
}

void FillSubRays(const std::vector<ChunkResult>& chunks, vtkPolyData* output)
{
  const auto offsets = GetOffsets(chunks, &ChunkResult::SubRays, output->GetNumberOfPoints());
  double* points = AddPoints(output, offsets.back());
  Columns columns(output->GetPointData(), offsets.front(), offsets.back());
  auto* pulses = columns.Add<vtkTypeInt64Array>(names::PulseIds);
  auto* cells = columns.Add<vtkTypeInt64Array>(names::CellIds);
  double* weights = columns.Add<vtkDoubleArray>(names::Weight);
  double* ranges = columns.Add<vtkDoubleArray>(names::Range);
  double* incidences = columns.Add<vtkDoubleArray>(names::IncidenceAngle);
  ForEachRecord(chunks, &ChunkResult::SubRays, offsets,
    [=](const SubRayRecord& s, vtkIdType row)
    {
      Store(points, row, s.Point);
      pulses[row] = s.PulseId;
      cells[row] = s.CellId;
      weights[row] = s.Weight;
      ranges[row] = s.Range;
      incidences[row] = s.Incidence;
    });
}

/// Fills the emitted pulse, for detectors.
void FillPulseSamples(const PulseShape& shape, vtkTable* output)
{
  std::vector<double> times;
  std::vector<double> powers;
  shape.GetSamples(times, powers);
  Columns fields(output->GetFieldData(), 0, static_cast<vtkIdType>(times.size()));
  double* samples = fields.Add<vtkDoubleArray>(names::PulseSamples, 2);
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    samples[2 * i] = times[i];
    samples[2 * i + 1] = powers[i];
  }
}

void FillWaveforms(const std::vector<ChunkResult>& chunks, const ReceiverSettings& receiver,
  const ScanIds& ids, vtkTable* output)
{
  const auto offsets = GetOffsets(chunks, &ChunkResult::Waveforms, output->GetNumberOfRows());
  Columns columns(output->GetRowData(), offsets.front(), offsets.back());
  auto* pulses = columns.Add<vtkTypeInt64Array>(names::PulseIds);
  columns.AddConstant(names::LegIds, ids.Leg);
  int* channels = columns.Add<vtkIntArray>(names::ChannelIds);
  const int firstChannel = ids.Channel;
  const double binSize = receiver.BinSize;
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
      Store(origins, row, w.Origin);
      Store(directions, row, w.Direction);
      times[row] = w.Time;
      starts[row] = w.StartTime;
      bins[row] = binSize;
      counts[row] = w.Count;
      channels[row] = firstChannel + w.Channel;
    });
  vtkDataArray* before =
    vtkDataArray::SafeDownCast(output->GetFieldData()->GetAbstractArray(names::Samples));
  const vtkIdType first = before ? before->GetNumberOfTuples() : 0;
  vtkIdType total = first;
  for (vtkIdType row = offsets.front(); row < offsets.back(); ++row)
  {
    firsts[row] = total;
    total += counts[row];
  }
  Columns fields(output->GetFieldData(), first, total);
  float* samples = fields.Add<vtkFloatArray>(names::Samples) + first;
  for (const ChunkResult& chunk : chunks)
  {
    samples = std::copy(chunk.Samples.begin(), chunk.Samples.end(), samples);
  }
  *Columns(output->GetFieldData(), 0, 1).Add<vtkDoubleArray>(names::PulseLength) =
    receiver.Shape.GetLength();
  if (!receiver.Shape.IsGaussian())
  {
    FillPulseSamples(receiver.Shape, output);
  }
}

} // namespace

//------------------------------------------------------------------------------
ScanOutput::ScanOutput(
  const ScanModel& model, const ScanIds& ids, vtkIdType pulses, vtkInformationVector* outputs)
  : Model(model)
  , Ids(ids)
  , Echoes(vtkPolyData::GetData(outputs, 0))
  , Waveforms(vtkTable::GetData(outputs, 1))
  , Pulses(vtkPolyData::GetData(outputs, 2))
  , SubRays(vtkPolyData::GetData(outputs, 3))
{
  this->Add({});
  this->Reserve(std::min(pulses, EchoesReserved));
}

//------------------------------------------------------------------------------
void ScanOutput::Add(const std::vector<ChunkResult>& chunks)
{
  const vtkIdType echoes = this->Echoes->GetNumberOfPoints();
  const vtkIdType pulses = this->Pulses->GetNumberOfPoints();
  FillEchoes(chunks, this->Model, this->Ids, this->Echoes);
  if (this->Model.Wants.ScanFlags)
  {
    FillScanFlags(chunks, echoes, this->Echoes);
  }
  if (this->Model.Wants.Truth)
  {
    FillTruths(chunks, this->Echoes);
  }
  if (this->Model.Wants.Truth && this->Model.Surfaces.HasOptics())
  {
    FillSpecularEvents(chunks, echoes, this->Echoes);
  }
  if (this->Model.Wants.Velocities)
  {
    FillVelocities(chunks, echoes, this->Echoes);
  }
  if (this->Model.Wants.Motion)
  {
    FillMotions(chunks, echoes, this->Echoes);
  }
  if (this->Model.Scattering.Orders > 1)
  {
    FillScattered(chunks, echoes, this->Echoes);
  }
  if (this->Model.Wants.Colors)
  {
    FillColors(chunks, echoes, this->Echoes);
  }
  if (this->Model.Wants.Waveforms)
  {
    FillWaveforms(chunks, this->Model.Receiver, this->Ids, this->Waveforms);
  }
  if (this->Model.Wants.Pulses)
  {
    FillPulses(chunks, this->Ids, this->Pulses);
  }
  if (this->Model.Wants.SubRays)
  {
    FillSubRays(chunks, this->SubRays);
  }
  if (this->Model.Wants.Decibels)
  {
    FillDecibels(this->Model, echoes, this->Echoes);
  }
  if (this->Model.Wants.Columns)
  {
    FillColumns(this->Model, echoes, this->Echoes);
    if (this->Model.Wants.Pulses)
    {
      FillColumns(this->Model, pulses, this->Pulses);
    }
  }
}

//------------------------------------------------------------------------------
/// Reserves memory; unused memory is not touched.
void ScanOutput::Reserve(vtkIdType echoes)
{
  vtkPointData* data = this->Echoes->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    data->GetArray(i)->Resize(echoes);
  }
  this->Echoes->GetPoints()->GetData()->Resize(echoes);
}

//------------------------------------------------------------------------------
void ScanOutput::Finish()
{
  for (vtkPolyData* points : { this->Echoes, this->Pulses, this->SubRays })
  {
    Squeeze(points->GetPointData());
    if (points->GetPoints())
    {
      points->GetPoints()->Squeeze();
    }
  }
  Squeeze(this->Waveforms->GetRowData());
  Squeeze(this->Waveforms->GetFieldData());
}

} // namespace helios
