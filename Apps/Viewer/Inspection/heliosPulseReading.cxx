// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPulseReading.h"

#include "heliosConstants.h"
#include "heliosSceneView.h"
#include "heliosStatus.h"
#include "heliosWaveformTable.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosGaussianDecomposition.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>

namespace helios::viewer
{
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double SmallestShare = 0.01; // minimum of a Gaussian, of the largest sample

double Get(vtkDataSetAttributes* data, const char* name, vtkIdType row, double missing)
{
  vtkDataArray* array = data->GetArray(name);
  return array ? array->GetTuple1(row) : missing;
}

int GetId(vtkDataSetAttributes* data, const char* name, vtkIdType row, int missing)
{
  return static_cast<int>(Get(data, name, row, missing));
}

bool IsOf(vtkDataSetAttributes* data, vtkIdType row, std::int64_t pulse)
{
  return static_cast<std::int64_t>(Get(data, names::PulseIds, row, -1.0)) == pulse;
}

void ReadEchoes(vtkPolyData* echoes, PulseReading& reading)
{
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  vtkPointData* data = echoes->GetPointData();
  for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
  {
    if (IsOf(data, i, reading.Pulse))
    {
      PulseEcho echo;
      echo.Position = Vec3(echoes->GetPoint(i));
      echo.ReturnNumber = GetId(data, names::ReturnNumber, i, 0);
      echo.NumberOfReturns = GetId(data, names::NumberOfReturns, i, 0);
      echo.Class = GetId(data, names::ClassificationIds, i, 0);
      echo.Part = GetId(data, names::PartIds, i, -1);
      echo.GpsTime = Get(data, names::GpsTime, i, unknown);
      echo.Range = Get(data, names::Range, i, unknown);
      echo.Amplitude = Get(data, names::Amplitude, i, unknown);
      echo.Width = Get(data, names::EchoWidth, i, unknown);
      echo.IncidenceAngle = Get(data, names::IncidenceAngle, i, unknown);
      reading.Echoes.push_back(echo);
    }
  }
}

void ReadOrigin(vtkPolyData* pulses, PulseReading& reading)
{
  vtkDataArray* directions = pulses->GetPointData()->GetArray(names::Direction);
  for (vtkIdType i = 0; directions && i < pulses->GetNumberOfPoints(); ++i)
  {
    if (IsOf(pulses->GetPointData(), i, reading.Pulse))
    {
      reading.Origin = Vec3(pulses->GetPoint(i));
      reading.Direction = Vec3(directions->GetTuple3(i));
      reading.HasOrigin = true;
    }
  }
}

void ReadSubRays(vtkPolyData* hits, const SceneView* scene, PulseReading& reading)
{
  vtkPointData* data = hits->GetPointData();
  for (vtkIdType i = 0; i < hits->GetNumberOfPoints(); ++i)
  {
    if (IsOf(data, i, reading.Pulse))
    {
      const auto cell = static_cast<vtkIdType>(Get(data, names::CellIds, i, -1.0));
      reading.SubRays.push_back({ Vec3(hits->GetPoint(i)), Get(data, names::Weight, i, 0.0),
        scene ? scene->GetPart(cell) : -1 });
    }
  }
}

/// Fits the Gaussians of the echoes; their sum is the waveform.
void FitGaussians(const std::vector<float>& samples, double startTime, PulseReading& reading)
{
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  const double largest = *std::max_element(reading.Samples.begin(), reading.Samples.end());
  detector->SetDetectionThreshold(std::max(1e-15, SmallestShare * largest));
  std::vector<vtkHeliosDetectedEcho> found;
  detector->Detect({ samples.data(), static_cast<vtkIdType>(samples.size()), reading.BinSize,
                     reading.PulseLength },
    found);
  for (const vtkHeliosDetectedEcho& echo : found)
  {
    reading.Gaussians.push_back({ 0.5 * SpeedOfLight * (startTime + echo.Time), echo.Amplitude,
      0.5 * SpeedOfLight * echo.Width / FwhmPerSigma });
  }
}

void ReadSamples(const WaveformTable& table, vtkIdType row, PulseReading& reading)
{
  const double startTime = table.StartTime.GetNumber(row);
  reading.BinSize = table.BinSize.GetNumber(row);
  for (int i = 0; i < 3; ++i)
  {
    reading.Origin[i] = table.Origin.GetNumber(row, i);
    reading.Direction[i] = table.Direction.GetNumber(row, i);
  }
  reading.HasOrigin = true;
  const vtkIdType first = table.Offset.GetInteger(row);
  std::vector<float> samples;
  for (vtkIdType i = 0; i < table.Count.GetInteger(row); ++i)
  {
    reading.Ranges.push_back(
      0.5 * SpeedOfLight * (startTime + static_cast<double>(i) * reading.BinSize));
    reading.Samples.push_back(table.Samples.GetNumber(first + i));
    samples.push_back(static_cast<float>(reading.Samples.back()));
  }
  if (!samples.empty())
  {
    FitGaussians(samples, startTime, reading);
  }
}

void ReadWaveform(vtkTable* waveforms, PulseReading& reading)
{
  WaveformTable table;
  const Status status = table.Set(waveforms);
  if (!status.IsOk())
  {
    reading.Problem = "the waveform " + status.Message();
    return;
  }
  vtkDataArray* length = waveforms->GetFieldData()->GetArray(names::PulseLength);
  reading.PulseLength = length && length->GetNumberOfTuples() > 0 ? length->GetTuple1(0) : 0.0;
  for (vtkIdType row = 0; row < table.NumberOfRows; ++row)
  {
    if (table.PulseIds.GetInteger(row) == reading.Pulse && reading.Samples.empty())
    {
      ReadSamples(table, row, reading);
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
double GetTwoWayTime(double range)
{
  return 2.0 * range / SpeedOfLight;
}

//------------------------------------------------------------------------------
PulseReading ReadPulse(const PulseRecord& record, std::int64_t pulse, const SceneView* scene)
{
  PulseReading reading;
  reading.Pulse = pulse;
  if (record.Echoes)
  {
    ReadEchoes(record.Echoes, reading);
  }
  if (record.Pulse)
  {
    ReadOrigin(record.Pulse, reading);
  }
  if (record.SubRays)
  {
    ReadSubRays(record.SubRays, scene, reading);
  }
  if (record.Waveform)
  {
    ReadWaveform(record.Waveform, reading);
  }
  return reading;
}

} // namespace helios::viewer
