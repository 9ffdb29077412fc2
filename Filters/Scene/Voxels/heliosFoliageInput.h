// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes, pulses and settings that beams are made of.

#ifndef heliosFoliageInput_h
#define heliosFoliageInput_h

#include <vector>

class vtkPolyData;

namespace helios
{

/// Clouds and settings that beams are made of.
struct FoliageInput
{
  vtkPolyData* Echoes = nullptr;
  vtkPolyData* Pulses = nullptr;     // may be null
  vtkPolyData* Hits = nullptr;       // may be null
  vtkPolyData* Trajectory = nullptr; // may be null
  const double* Origin = nullptr;    // where all beams begin; may be null

  enum class Shares : char
  {
    Equal,
    First,
    Energy,
    Reflectance
  } EchoShares = Shares::Energy;
  double ElementReflectance = 0.5;

  std::vector<int> Classes;   // counted; empty: all but ground, water and noise
  std::vector<int> Materials; // counted; empty: all
  bool UsesIncidence = false;
};

} // namespace helios

#endif
