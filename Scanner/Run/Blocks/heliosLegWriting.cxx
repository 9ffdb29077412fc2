// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegWriting.h"

#include "heliosMessages.h"
#include "heliosRunJournal.h"
#include "heliosStatus.h"
#include "vtkHeliosXMLPieceWriter.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

namespace helios
{
namespace
{

/// Returns whether no file may be written while it is flushed: the pieces of VTK XML and their
/// index.
bool NeedsPause(const LegOutputs& outputs)
{
  return std::any_of(outputs.begin(), outputs.end(),
    [](const LegOutput& output)
    { return vtkHeliosXMLPieceWriter::SafeDownCast(output.Writer) != nullptr; });
}

/// Journals a block once it is fsynced.
Status CommitBlock(
  const LegOutputs& outputs, RunJournal& journal, std::size_t leg, const LegProgress& progress)
{
  for (const LegOutput& output : outputs)
  {
    const std::string problem = output.Writer->Sync();
    if (!problem.empty())
    {
      return Status::Error(problem);
    }
  }
  return journal.Append(leg, progress);
}

} // namespace

//------------------------------------------------------------------------------
bool CheckRun(const Status& status, Messages& log)
{
  if (!status.IsOk())
  {
    log.Error(status.Message() +
      "; check that the output folder exists and has free space, and continue with Resume "
      "(--resume), or run again");
  }
  return status.IsOk();
}

//------------------------------------------------------------------------------
LegWriting::LegWriting(
  const LegOutputs& outputs, RunJournal& journal, std::size_t leg, Messages& log)
  : Outputs(outputs)
  , Journal(journal)
  , Leg(leg)
  , Log(log)
  , Policy(
      vtkSMPTools::GetEstimatedNumberOfThreads() > 1 ? std::launch::async : std::launch::deferred)
{
}

//------------------------------------------------------------------------------
bool LegWriting::Write(LegPiece piece, const std::optional<LegProgress>& progress)
{
  if (!this->FinishPiece())
  {
    return false;
  }
  this->Piece = std::async(this->Policy,
    [this, progress, given = std::move(piece)] { return this->WritePiece(given, progress); });
  if (this->Policy == std::launch::deferred)
  {
    this->Piece.wait(); // writes it
  }
  return true;
}

//------------------------------------------------------------------------------
LegWriting::Result LegWriting::WritePiece(
  const LegPiece& piece, std::optional<LegProgress> progress)
{
  const Messages::DeferredMessages deferral;
  if (!WriteOutputs(this->Outputs, piece) || (progress && !EndBlock(this->Outputs)))
  {
    return { false, {} };
  }
  Status status = progress ? this->FinishBlock() : Status();
  if (!progress || !status.IsOk())
  {
    return { true, status };
  }
  this->BeginCommit(*progress);
  return { true, NeedsPause(this->Outputs) ? this->FinishBlock() : Status() };
}

//------------------------------------------------------------------------------
/// Flushes what is written to the disk, and then journals it.
void LegWriting::BeginCommit(LegProgress progress)
{
  progress.Files = CollectProgress(this->Outputs, false);
  this->Block = std::async(std::launch::async, CommitBlock, std::cref(this->Outputs),
    std::ref(this->Journal), this->Leg, progress);
}

//------------------------------------------------------------------------------
bool LegWriting::Finish(const LegProgress& progress)
{
  if (!this->FinishPiece() || !CheckRun(this->FinishBlock(), this->Log) || !EndBlock(this->Outputs))
  {
    return false;
  }
  this->BeginCommit(progress);
  return this->Finish();
}

//------------------------------------------------------------------------------
bool LegWriting::Finish()
{
  const bool isWritten = this->FinishPiece();
  return CheckRun(this->FinishBlock(), this->Log) && isWritten;
}

//------------------------------------------------------------------------------
/// Waits until the piece is written.
bool LegWriting::FinishPiece()
{
  const Result result = this->Piece.valid() ? this->Piece.get() : Result();
  this->Log.ReportDeferred();
  return CheckRun(result.Journaled, this->Log) && result.IsWritten;
}

//------------------------------------------------------------------------------
/// Waits until the block is on the disk.
Status LegWriting::FinishBlock()
{
  return this->Block.valid() ? this->Block.get() : Status();
}

} // namespace helios
