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

/// Gives the blocks of the legs in order.
class BlockSource
{
public:
  virtual ~BlockSource() = default;

  /// Computes, reads or receives a block of a leg, while the one before is flushed to disk; false
  /// after an error, or to stop.
  virtual bool Compute(const LegPlan& plan, vtkIdType block) = 0;

  /// What the outputs of a run have of that block.
  virtual LegPiece Collect(const LegOutputs& outputs) = 0;

  /// Adds the counts of that block, other than pulses, and releases its memory.
  virtual void Count(ScanCounts& counts) = 0;
};

} // namespace helios

#endif
