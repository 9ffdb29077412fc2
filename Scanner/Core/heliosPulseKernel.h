// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The fused kernel: pulses to sub-rays to hits to waveforms to echoes, a chunk of pulses at a time.

#ifndef heliosPulseKernel_h
#define heliosPulseKernel_h

#include "heliosPulse.h"
#include "heliosRadiometry.h"
#include "heliosReturn.h"
#include "heliosSceneSurfaces.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosRayCaster.h"

#include <cstdint>
#include <vector>

namespace helios
{

/// Everything a pulse needs to know; constant while the scanner runs.
struct ScanModel
{
  PulseSource Source;
  const vtkHeliosRayCaster* Caster;
  const vtkHeliosEchoDetector* Detector;
  std::vector<Vec3> SubRays; // directions in the frame of the beam
  std::vector<double> Weights;

  SceneSurfaces Surfaces;

  double PulseLength;
  double BinSize;
  double Power;
  LidarEquation Equation;
  double RangeMin;
  double RangeMax;
  double RangeAccuracy;
  int MaximumNumberOfReturns; // 0: all
  std::uint64_t Seed;
  vtkIdType FirstPulseId;

  bool WantsWaveforms;
  bool WantsPulses;
  bool WantsSubRays;
};

struct EchoRecord
{
  Vec3 Point;
  double Time;
  vtkIdType PulseId;
  vtkIdType CellId;
  double Range;
  double Amplitude;
  double Width;
  double ScanAngle;
  double Incidence; // [deg]
  int MaterialId;
  int PartId;
  int Classification;
  unsigned char ReturnNumber;
  unsigned char NumberOfReturns;
};

struct PulseRecord
{
  Vec3 Origin;
  Vec3 Direction;
  double Time;
  vtkIdType PulseId;
  double ScanAngle;
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
};

/// What a chunk of pulses gives, in the order of the pulses.
struct ChunkResult
{
  std::vector<EchoRecord> Echoes;
  std::vector<PulseRecord> Pulses;
  std::vector<SubRayRecord> SubRays;
  std::vector<WaveformRecord> Waveforms;
  std::vector<float> Samples;
};

/// Sums over pulses, whatever thread they ran in.
struct ScanCounts
{
  vtkIdType PulsesFired = 0;
  vtkIdType PulsesHit = 0;      // with a surface in the measured ranges
  vtkIdType HitsOutOfRange = 0; // sub-rays that met a surface outside the measured ranges
  vtkIdType CutWaveforms = 0;
  double LargestAmplitude = 0.0; // of what the pulses that hit sent back [W]
};

/// One a thread; all its memory is scratch.
class PulseKernel
{
public:
  explicit PulseKernel(const ScanModel& model);

  /// Runs the pulses [first, last) of the scan.
  void Run(vtkIdType first, vtkIdType last, ChunkResult& result);

  const ScanCounts& GetCounts() const { return this->Counts; }

private:
  void AimPulses(vtkIdType first, vtkIdType last);
  void CollectReturns(const vtkHeliosRay* rays, const vtkHeliosHit* hits);
  void FinishPulse(std::size_t slot, ChunkResult& result);
  void StoreEchoes(const Pulse& pulse, vtkIdType index, ChunkResult& result);
  void StoreWaveform(const Pulse& pulse, vtkIdType id, ChunkResult& result);
  void StoreSubRays(const vtkHeliosRay* rays, vtkIdType id, ChunkResult& result);
  const Vec3& GetNormal(vtkIdType cell);

  const ScanModel& Model;
  Receiver Signal;
  Trajectory::Cursor Cursor;
  ScanCounts Counts;

  std::vector<Pulse> Pulses;
  std::vector<vtkIdType> Indices;
  std::vector<vtkHeliosRay> Rays;
  std::vector<vtkHeliosHit> Hits;
  std::vector<SubReturn> Returns;
  std::vector<Echo> Echoes;
  Waveform Wave;
  vtkIdType NormalCell = -1;
  Vec3 Normal;
};

} // namespace helios

#endif
