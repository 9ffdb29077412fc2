// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the blocks of a run are from.

#ifndef heliosBlockSource_h
#define heliosBlockSource_h

#include "heliosLegOutput.h"

#include <vtkType.h>

namespace helios
{

struct LegPlan;
struct ScanCounts;

/// Gives the blocks of the legs in order. Functions return false after an error.
class BlockSource
{
public:
  virtual ~BlockSource() = default;

  /// Computes or reads a block of a leg, while the one before is flushed to disk.
  virtual bool Compute(const LegPlan& plan, vtkIdType block) = 0;

  /// Writes that block.
  virtual bool Write(const LegOutputs& outputs) = 0;

  /// Adds the counts of that block, other than pulses, and releases its memory.
  virtual void Count(ScanCounts& counts) = 0;
};

} // namespace helios

#endif
