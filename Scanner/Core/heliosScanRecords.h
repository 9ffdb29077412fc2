// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The results of a chunk of pulses, before they become VTK data.

#ifndef heliosScanRecords_h
#define heliosScanRecords_h

#include "heliosErrorTerms.h"
#include "heliosPose.h"

#include <vtkType.h>

#include <algorithm>
#include <vector>

namespace helios
{

struct EchoRecord
{
  Vec3 Point;
  double Time;
  vtkIdType PulseId;
  vtkIdType CellId;
  double Range;
  double Amplitude;
  double Width;
  double Deviation;
  double ScanAngle;
  double Incidence; // [deg]
  int Channel;
  int MaterialId;
  int PartId;
  int Classification;
  unsigned char ReturnNumber;
  unsigned char NumberOfReturns;
};

/// Of the echo at the same place.
struct TruthRecord
{
  Vec3 Point;
  Vec3 Normal;
};

struct PulseRecord
{
  Vec3 Origin;
  Vec3 Direction;
  double Time;
  vtkIdType PulseId;
  double ScanAngle;
  int Channel;
  bool Hit;
};

struct SubRayRecord
{
  Vec3 Point;
  vtkIdType PulseId;
  vtkIdType CellId;
  double Weight;
  double Range;
  double Incidence; // [deg]
};

struct WaveformRecord
{
  Vec3 Origin;
  Vec3 Direction;
  double Time;
  vtkIdType PulseId;
  double StartTime; // [ns]
  vtkIdType Count;  // samples
  int Channel;
};

/// The results of a chunk, in the order of the pulses.
struct ChunkResult
{
  std::vector<EchoRecord> Echoes;
  std::vector<TruthRecord> Truths; // empty if not requested
  std::vector<PulseRecord> Pulses;
  std::vector<SubRayRecord> SubRays;
  std::vector<WaveformRecord> Waveforms;
  std::vector<float> Samples;

  /// Keeps the memory.
  void Clear()
  {
    this->Echoes.clear();
    this->Truths.clear();
    this->Pulses.clear();
    this->SubRays.clear();
    this->Waveforms.clear();
    this->Samples.clear();
  }
};

/// Sums over pulses, independent of threads.
struct ScanCounts
{
  vtkIdType PulsesFired = 0;
  vtkIdType PulsesHit = 0;         // with a surface in the range gate
  vtkIdType PulsesOnPlane = 0;     // with a planar footprint
  vtkIdType PulsesWithoutBins = 0; // whose maxima were found by Newton's method
  vtkIdType PulsesBinned = 0;
  vtkIdType SubRays = 0; // traced
  vtkIdType Echoes = 0;
  vtkIdType HitsOutOfRange = 0; // sub-rays that hit a surface outside the range gate
  vtkIdType CutWaveforms = 0;
  TermFaults Faults;             // of the error model
  double LargestAmplitude = 0.0; // of the returned signals [W]

  void Add(const ScanCounts& other)
  {
    for (vtkIdType ScanCounts::*count :
      { &ScanCounts::PulsesFired, &ScanCounts::PulsesHit, &ScanCounts::PulsesOnPlane,
        &ScanCounts::PulsesWithoutBins, &ScanCounts::PulsesBinned, &ScanCounts::SubRays,
        &ScanCounts::Echoes, &ScanCounts::HitsOutOfRange, &ScanCounts::CutWaveforms })
    {
      this->*count += other.*count;
    }
    for (std::size_t term = 0; term < this->Faults.size(); ++term)
    {
      this->Faults[term].Add(other.Faults[term]);
    }
    this->LargestAmplitude = std::max(this->LargestAmplitude, other.LargestAmplitude);
  }
};

} // namespace helios

#endif
