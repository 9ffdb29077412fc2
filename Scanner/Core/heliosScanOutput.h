// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The records of a run as VTK data.

#ifndef heliosScanOutput_h
#define heliosScanOutput_h

#include "heliosScanRecords.h"

#include <vector>

class vtkDataObject;
class vtkPolyData;
class vtkTable;

namespace helios
{

/// What all records of a leg share.
struct ScanIds
{
  int Leg;
  int Channel; // of the deflector's channel 0
  bool HasWaveforms;
  bool HasDeviations;
};

///@{
/// Each adds the records of chunks, in order, to a data object, at first an empty one; truths go beside
/// echoes.
void FillEchoes(const std::vector<ChunkResult>& chunks, const ScanIds& ids, vtkPolyData* output);
void FillTruths(const std::vector<ChunkResult>& chunks, vtkPolyData* output);
void FillPulses(const std::vector<ChunkResult>& chunks, const ScanIds& ids, vtkPolyData* output);
void FillSubRays(const std::vector<ChunkResult>& chunks, vtkPolyData* output);
void FillWaveforms(const std::vector<ChunkResult>& chunks, const ScanIds& ids, double binSize,
  double pulseLength, vtkTable* output);
///@}

/// Makes room for as many echoes as there are likely to be; memory that is not used is not touched.
void ReserveEchoes(vtkPolyData* output, vtkIdType count);

/// Gives back the memory that is left over once all is added.
void FinishOutput(vtkDataObject* output);

} // namespace helios

#endif
