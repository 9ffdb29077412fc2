// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Samples of a trajectory as SBET records.

#ifndef heliosSbetEncoder_h
#define heliosSbetEncoder_h

#include "heliosColumn.h"
#include "heliosCoordinateSystem.h"
#include "heliosCoordinateTransform.h"
#include "heliosSbetFile.h"
#include "heliosStatus.h"

#include <vtkType.h>

#include <string>
#include <vector>

namespace helios
{

/// The arrays of a block; Velocities may be unset.
struct SbetSamples
{
  vtkIdType Count = 0;
  Column Points, Times, Orientations, Velocities;
};

class SbetEncoder
{
public:
  /// Sets the system of the samples and the geographic one of the file.
  Status SetSystems(const std::string& crs, const std::string& fileCrs);

  /// Appends the records of a block; message with the row after an error.
  Status Encode(const SbetSamples& samples, std::vector<SbetRecord>& records);

private:
  Status EncodeRow(const SbetSamples& samples, vtkIdType row, SbetRecord& record);

  std::string Crs;               // the text of the system
  CoordinateTransform Transform; // from samples to the file
  CoordinateTransform Inverse;
  bool HasTime = false;
  double LastTime = 0.0;
};

} // namespace helios

#endif
