// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The records of a run as VTK data.

#ifndef heliosScanOutput_h
#define heliosScanOutput_h

#include "heliosScanRecords.h"

#include <vector>

class vtkInformationVector;
class vtkPolyData;
class vtkTable;

namespace helios
{

struct ScanModel;

/// What all records of a leg share.
struct ScanIds
{
  int Leg;
  int Channel; // of the deflector's channel 0
};

/// Adds the records of a scan to the data objects of a scanner, which are empty at first.
class ScanOutput
{
public:
  /// The model must stay. The arrays are there at once, with room for an echo of each of so many pulses.
  ScanOutput(
    const ScanModel& model, const ScanIds& ids, vtkIdType pulses, vtkInformationVector* outputs);

  /// Adds what the model wants of the records of chunks, in order.
  void Add(const std::vector<ChunkResult>& chunks);

  /// Gives back the memory that is left over.
  void Finish();

private:
  void Reserve(vtkIdType echoes);

  const ScanModel& Model;
  ScanIds Ids;
  vtkPolyData* Echoes;
  vtkTable* Waveforms;
  vtkPolyData* Pulses;
  vtkPolyData* SubRays;
};

} // namespace helios

#endif
