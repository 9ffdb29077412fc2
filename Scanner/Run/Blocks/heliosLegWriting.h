// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes the output of a leg while its next piece is computed.

#ifndef heliosLegWriting_h
#define heliosLegWriting_h

#include "heliosLegOutput.h"
#include "heliosRunProgress.h"
#include "heliosStatus.h"

#include <cstddef>
#include <future>
#include <optional>

namespace helios
{

class Messages;
class RunJournal;

/// Reports the failure of a run, if any, with the remedy; returns whether there was none.
bool CheckRun(const Status& status, Messages& log);

/**
 * Writes pieces of the output of a leg in their order, and journals its blocks. With several threads
 * a piece is written while the next one is computed, and at most one waits; blocks are flushed to
 * disk meanwhile. Errors are reported by the next call.
 */
class LegWriting
{
public:
  LegWriting(const LegOutputs& outputs, RunJournal& journal, std::size_t leg, Messages& log);
  LegWriting(const LegWriting&) = delete;
  void operator=(const LegWriting&) = delete;

  /// Writes a piece, after the one before; false if that one could not be written. The last piece of
  /// a block has the progress that is journaled once it is on the disk.
  bool Write(LegPiece piece, const std::optional<LegProgress>& progress);

  /// Waits until all is written and flushed to disk; false after an error.
  bool Finish();

  /// Finishes, and journals the pieces of a block that is not complete.
  bool Finish(const LegProgress& progress);

private:
  struct Result
  {
    bool IsWritten = true; ///< else the log has deferred the reason
    Status Journaled;
  };

  Result WritePiece(const LegPiece& piece, std::optional<LegProgress> progress);
  bool FinishPiece();
  Status FinishBlock();
  void BeginCommit(LegProgress progress);

  const LegOutputs& Outputs;
  RunJournal& Journal;
  std::size_t Leg;
  Messages& Log;
  std::launch Policy;
  std::future<Status> Block; // used by the thread of the piece; waits at the end
  std::future<Result> Piece;
};

} // namespace helios

#endif
