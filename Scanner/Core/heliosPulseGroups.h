// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles that the beams of consecutive pulses of a group (heliosScanRun.h) may meet, found for many of them at once.

#ifndef heliosPulseGroups_h
#define heliosPulseGroups_h

#include "heliosConeGroup.h"
#include "heliosInstanceMotion.h"
#include "heliosPulse.h"

#include <cstddef>
#include <vector>

namespace helios
{

struct ScanModel;

/// One per thread. How many pulses it groups depends on the pulses before; what it returns for a pulse has the
/// same triangles that touch its beam, whatever their number.
class PulseGroups
{
public:
  explicit PulseGroups(const ScanModel& model);

  /// Begins a group of pulses, given by their indices, too, which must outlive their use.
  void Start(const std::vector<Pulse>& pulses, const std::vector<vtkIdType>& indices);

  /// Returns a span with the pulses [first, last).
  MomentSpan GetSpan(std::size_t first, std::size_t last) const;

  /// Returns the triangles about a pulse; null if they are too many, if pulses are not grouped, or if instances move
  /// there. Pulses are asked for in order, when the instances are where they are at the pulse.
  const ConeGroup* Get(std::size_t slot);

  /// Returns what ScanModel::ProbeCone() does if the beam of a pulse meets nothing, or one triangle of the group that
  /// covers it; else Unresolved.
  vtkHeliosConeHit FindOnly(std::size_t slot);

private:
  bool Find(std::size_t first, std::size_t last);
  void Extend(std::size_t slot);

  const ScanModel& Model;
  const bool IsOn;
  const std::vector<Pulse>* Pulses = nullptr;
  const std::vector<vtkIdType>* Indices = nullptr;
  std::vector<ConeAxis> Cones;
  ConeGroup Group;
  std::size_t End = 0;      ///< end of the pulses of the current answer
  bool IsFound = false;     ///< whether it is the group
  std::size_t Span;         ///< pulses asked for next
  std::size_t Pause = 0;    ///< pulses that are skipped next
  std::size_t Failures = 0; ///< in a row, with the smallest span
};

} // namespace helios

#endif
