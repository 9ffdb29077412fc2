// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The records of a run as VTK data.

#ifndef heliosScanOutput_h
#define heliosScanOutput_h

#include "heliosPulseKernel.h"

#include <vector>

class vtkPolyData;
class vtkTable;

namespace helios
{

/// The ids that all records of a leg share.
struct ScanIds
{
  int Leg;
  int Channel;
  bool HasWaveforms;
};

/// Each takes the records of chunks, in order, into an empty data object.
void FillEchoes(std::vector<ChunkResult>& chunks, const ScanIds& ids, vtkPolyData* output);
void FillPulses(std::vector<ChunkResult>& chunks, const ScanIds& ids, vtkPolyData* output);
void FillSubRays(std::vector<ChunkResult>& chunks, vtkPolyData* output);
void FillWaveforms(
  std::vector<ChunkResult>& chunks, const ScanIds& ids, double binSize, vtkTable* output);

} // namespace helios

#endif
