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

  /// Returns the pieces of a block, which are written one after the other.
  virtual vtkIdType GetPiecesPerBlock() const { return 1; }

  /// Computes, reads or receives one of the count equal pieces of a leg, while the one before is
  /// written; false after an error, or to stop.
  virtual bool Compute(const LegPlan& plan, vtkIdType piece, vtkIdType count) = 0;

  /// Returns the piece for each output. It stays valid while the next piece is computed.
  virtual LegPiece Collect(const LegOutputs& outputs) = 0;

  /// Adds the counts of that piece, other than pulses, and releases its memory.
  virtual void Count(ScanCounts& counts) = 0;
};

} // namespace helios

#endif
