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

/// The data shared by all records of a leg.
struct ScanIds
{
  int Leg;
  int Channel; // the deflector's channel 0
};

/// Adds the records of a scan to the data objects of a scanner, which are initially empty.
class ScanOutput
{
public:
  /// The model must outlive it. The arrays are allocated for this many pulses with one echo each.
  ScanOutput(
    const ScanModel& model, const ScanIds& ids, vtkIdType pulses, vtkInformationVector* outputs);

  /// Adds the records of chunks that the model requests, in order.
  void Add(const std::vector<ChunkResult>& chunks);

  /// Releases unused memory.
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
