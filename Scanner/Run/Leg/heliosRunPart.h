// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A part of a run: consecutive blocks of its pulses.

#ifndef heliosRunPart_h
#define heliosRunPart_h

#include <vtkType.h>

#include <string>
#include <vector>

namespace helios
{

struct LegPlan;

/// Part Number of Count; without a count, the whole run.
struct RunPart
{
  int Number = 1;
  int Count = 0;
  std::string Command; ///< how to run it, for those who join parts

  bool IsSet() const { return this->Count > 0; }

  /// Returns the part as in options: "2/4".
  std::string GetText() const
  {
    return std::to_string(this->Number) + "/" + std::to_string(this->Count);
  }
};

/// Divides legs into blocks of at most this many pulses, and at least one block.
void DivideIntoBlocks(std::vector<LegPlan>& plans, vtkIdType pulsesPerBlock);

/// Returns the blocks of all legs.
vtkIdType CountBlocks(const std::vector<LegPlan>& plans);

/// Returns the legs with the blocks of a part. The parts have as many blocks, or one more or less,
/// and in order they are the whole run; if there are more parts than blocks, some have no leg.
std::vector<LegPlan> SelectPart(const std::vector<LegPlan>& plans, const RunPart& part);

} // namespace helios

#endif
