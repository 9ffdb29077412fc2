// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegRunner.h"

#include "heliosLegWriting.h"
#include "heliosMessages.h"
#include "heliosPulseCount.h"
#include "heliosReceiverSetup.h"
#include "heliosRunJournal.h"
#include "heliosStatus.h"
#include "vtkHeliosPlatform.h"
#include "vtkHeliosRunFiles.h"

#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace helios
{
namespace
{

constexpr vtkIdType SamplesPerBlock = 65536;

/// Pieces of text and LAS files, which do not depend on them: small ones stay in the cache. A piece
/// of VTK XML is a block, since its files, and the files of parts, depend on it.
constexpr vtkIdType PulsesPerPiece = 32768;
constexpr vtkIdType ThreadsPerPiece =
  8; // with more, pieces are joined: every thread has enough pulses

double Now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Limit of a run: eleven days at 1e9 pulses per second.
constexpr vtkIdType MaximumPulses = 1000000000000000;

} // namespace

//------------------------------------------------------------------------------
LegRunner::LegRunner(
  const SurveyData& survey, vtkPolyData* scene, const RunSettings& settings, Messages& log)
  : Survey(survey)
  , Settings(settings)
  , Log(log)
  , Files(survey, settings.Part.IsSet() ? MakeRunPartSettings(settings) : settings)
  , Scene(scene)
  , Scanner(survey, scene, settings, log)
  , Own(this->Scanner, (settings.PulsesPerBlock - 1) / this->GetPulsesPerPiece() + 1)
{
}

//------------------------------------------------------------------------------
LegRunner::~LegRunner() = default;

//------------------------------------------------------------------------------
bool LegRunner::Plan()
{
  if (this->Log.HasError()) // trajectories of parts may have faults
  {
    return false;
  }
  const InputWatch watch(this->Inputs);
  const LegOffsetNoise offsets = { this->Settings.Options.Noise, this->Settings.Options.Seed };
  this->Plans =
    PlanLegs(this->Survey, this->Scene, offsets, this->Settings.Trajectories, this->Log);
  vtkIdType shots = 0;
  for (LegPlan& plan : this->Plans)
  {
    this->Scanner.SetUp(plan);
    plan.FirstPulse = this->NumberOfPulses;
    plan.FirstShot = shots;
    plan.NumberOfPulses = this->Scanner.CountPulses();
    this->NumberOfPulses += plan.NumberOfPulses;
    if (this->NumberOfPulses > MaximumPulses)
    {
      MessageBuilder text;
      text << this->Survey.Legs[plan.Leg].Where << ": " << static_cast<double>(plan.NumberOfPulses)
           << " pulses are more than a leg can have (all legs together: at most "
           << static_cast<double>(MaximumPulses)
           << "); check its pulse frequency, its speed, its length and its duration";
      this->Log.Error(text.str());
      return false;
    }
    shots += plan.NumberOfPulses / static_cast<vtkIdType>(this->Scanner.GetNumberOfChannels());
  }
  this->WarnWithoutNoise();
  DivideIntoBlocks(this->Plans, this->Settings.PulsesPerBlock);
  this->NumberOfPulsesToRun = this->NumberOfPulses;
  if (this->Settings.Part.IsSet())
  {
    this->SelectPart();
  }
  return !this->Log.HasError();
}

//------------------------------------------------------------------------------
/// Warns of scanners that have no noise that their tolerances could follow.
void LegRunner::WarnWithoutNoise()
{
  if (this->Settings.Options.Accuracy.empty() || this->Settings.Options.RangeTolerance > 0.0)
  {
    return;
  }
  for (const ScannerData& scanner : this->Survey.Scanners)
  {
    if (!HasRangeNoise(scanner.Receiver))
    {
      MessageBuilder text;
      text << "Accuracy is \"" << this->Settings.Options.Accuracy << "\", but scanner "
           << scanner.Name << " has no range noise: its beams are sampled within "
           << ChooseSampling(scanner.Receiver, this->Settings.Options).RangeTolerance
           << " m; give it accuracy_m, or RangeTolerance (--range-tolerance)";
      this->Log.Warning(text.str());
    }
  }
}

//------------------------------------------------------------------------------
/// Leaves the blocks of the part.
void LegRunner::SelectPart()
{
  this->Plans = helios::SelectPart(this->Plans, this->Settings.Part);
  this->FirstPulse = this->NumberOfPulsesToRun = 0;
  if (!this->Plans.empty())
  {
    const LegPlan& first = this->Plans.front();
    const LegPlan& last = this->Plans.back();
    this->FirstPulse = first.FirstPulse + first.CountPulsesBefore(first.FirstBlock);
    this->NumberOfPulsesToRun =
      last.FirstPulse + last.CountPulsesBefore(last.EndBlock) - this->FirstPulse;
  }
}

//------------------------------------------------------------------------------
LegScanner& LegRunner::Prepare(const LegPlan& plan)
{
  this->Scanner.SetUp(plan);
  return this->Scanner;
}

//------------------------------------------------------------------------------
LegScanner& LegRunner::Prepare(const LegPlan& plan, const RunOptions& options)
{
  this->Scanner.SetOptions(options);
  return this->Prepare(plan);
}

//------------------------------------------------------------------------------
LegRunner::Outputs LegRunner::MakeOutputs(const LegPlan& plan) const
{
  return this->Files.MakeOutputs(plan);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHeliosStreamWriter> LegRunner::MakeTrajectoryWriter(const LegPlan& plan) const
{
  return this->Files.MakeTrajectoryWriter(plan);
}

//------------------------------------------------------------------------------
/// Returns whether no later leg writes to the same files.
bool LegRunner::EndsFiles(const LegPlan& plan) const
{
  const std::string& strip = this->Survey.Legs[plan.Leg].Strip;
  return strip.empty() ||
    std::none_of(this->Plans.begin(), this->Plans.end(),
      [this, &plan, &strip](const LegPlan& other)
      { return other.Leg > plan.Leg && this->Survey.Legs[other.Leg].Strip == strip; });
}

//------------------------------------------------------------------------------
bool LegRunner::Open(vtkHeliosStreamWriter* writer, const RunJournal& journal)
{
  this->Listen(writer);
  const FileProgress* file = journal.FindFile(GetName(writer));
  if (!file)
  {
    return writer->Open();
  }
  if (!writer->Reopen(file->Size, file->Records, file->Bytes))
  {
    return false;
  }
  if (!writer->RestoreHead(file->Head))
  {
    this->Log.Error(writer->GetFileName() +
      std::string(".part: its header does not match its checksum in ") +
      vtkHeliosRunFiles::GetJournalName() +
      "; the file was changed or is damaged; set Overwrite (--overwrite) to start again");
    writer->Abandon();
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool LegRunner::OpenAll(const Outputs& outputs, const RunJournal& journal)
{
  bool good = true;
  for (const LegOutput& output : outputs)
  {
    good = good && this->Open(output.Writer, journal);
  }
  return good;
}

//------------------------------------------------------------------------------
bool LegRunner::WriteTrajectory(const LegPlan& plan, const RunJournal& journal,
  const BlockCallback& onBlock, FileProgress& written)
{
  const TrajectorySampler sampler(plan, this->Survey.Legs[plan.Leg].TrajectoryTimeInterval);
  const auto writer = this->MakeTrajectoryWriter(plan);
  this->Open(writer, journal);
  bool goesOn = true;
  for (vtkIdType first = 0; first < sampler.GetNumberOfSamples() && goesOn && !this->Log.HasError();
       first += SamplesPerBlock)
  {
    writer->Write(sampler.GetSamples(first, SamplesPerBlock));
    goesOn = first + SamplesPerBlock >= sampler.GetNumberOfSamples() || onBlock(this->Counts);
  }
  if (this->Log.HasError() || !goesOn)
  {
    writer->Abandon();
    return false;
  }
  const bool ends = this->EndsFiles(plan);
  const bool good = ends ? writer->Close() : writer->Flush();
  written = CollectProgress(writer, ends); // without the footer of an index: the next leg continues
                                           // there
  return (ends || writer->Abandon()) && good;
}

//------------------------------------------------------------------------------
bool LegRunner::Run(const LegPlan& plan, RunJournal& journal, const BlockCallback& onBlock)
{
  const LegProgress before = journal.GetLeg(plan.Leg);
  if (before.IsDone)
  {
    this->Counts = before.Counts;
    if (this->EndsFiles(plan))
    {
      RemoveParts(this->MakeOutputs(plan)); // the run may have ended before it could
    }
    return true;
  }
  if (!CheckRun(journal.Check(), this->Log)) // does not recreate a removed folder
  {
    return false;
  }
  this->Counts = before.Blocks + before.Pieces > 0 ? before.Counts : this->Counts;
  const ScanCounts counts = this->Counts;
  this->Scanner.SetUp(plan);
  const Outputs outputs = this->MakeOutputs(plan);
  FileProgress trajectory;
  // trajectories of a part are written when it is joined
  const bool hasTrajectory = !this->Settings.Part.IsSet();
  bool good = this->OpenAll(outputs, journal) &&
    (!hasTrajectory || this->WriteTrajectory(plan, journal, onBlock, trajectory)) &&
    this->RunBlocks(plan, outputs, journal, onBlock) && !this->Log.HasError();
  this->Scanner.SetOnProgress(this->OnProgress);
  const bool isWhole = good && this->EndsFiles(plan);
  const auto goesOn = [&] { return onBlock(this->Counts); };
  for (const LegOutput& output : outputs)
  {
    good = (isWhole ? Close(output, goesOn) : output.Writer->Abandon()) && good;
  }
  LegProgress done = journal.GetLeg(plan.Leg);
  if (!good)
  {
    this->Counts = done.Blocks + done.Pieces > 0 ? done.Counts : counts; // the safe counts
    return false;
  }
  done.IsDone = true;
  if (isWhole)
  {
    done.Files = CollectProgress(
      outputs, true); // with the footer of an index; the next leg of a strip continues before it
  }
  if (hasTrajectory)
  {
    done.Files.push_back(trajectory);
  }
  if (!CheckRun(journal.Append(plan.Leg, done), this->Log))
  {
    return false;
  }
  if (isWhole)
  {
    RemoveParts(outputs);
  }
  return true;
}

//------------------------------------------------------------------------------
vtkIdType LegRunner::GetPulsesPerPiece() const
{
  const vtkIdType block = this->Settings.PulsesPerBlock;
  const bool isPart = this->Settings.Part.IsSet();
  return HasXml(isPart ? MakeRunPartSettings(this->Settings) : this->Settings)
    ? block
    : std::min(block, PulsesPerPiece);
}

//------------------------------------------------------------------------------
bool LegRunner::RunBlocks(
  const LegPlan& plan, const Outputs& outputs, RunJournal& journal, const BlockCallback& onBlock)
{
  const vtkIdType parts = this->Source->GetPiecesPerBlock();
  const vtkIdType count = plan.NumberOfBlocks * parts;
  if (count > std::numeric_limits<int>::max())
  {
    this->Log.Error(this->Survey.Legs[plan.Leg].Where + ": " + std::to_string(plan.NumberOfPulses) +
      " pulses are more than a leg can have; check its pulse frequency, its speed and its length");
    return false;
  }
  const LegProgress before = journal.GetLeg(plan.Leg);
  LegWriting writing(outputs, journal, plan.Leg, this->Log);
  LegRun run{ plan, outputs, writing, onBlock, Now() - before.Seconds, before };
  const vtkIdType end = plan.EndBlock * parts;
  vtkIdType piece = (plan.FirstBlock + before.Blocks) * parts + before.Pieces;
  while (piece < end)
  {
    const vtkIdType last = (piece / parts + 1) * parts;
    if (!this->RunPieces({ piece, last, count }, run))
    {
      return false;
    }
    piece = last;
    if (!onBlock(this->Counts))
    {
      writing.Finish();
      return false;
    }
  }
  return writing.Finish();
}

//------------------------------------------------------------------------------
/// Returns how many pieces, from one on, are computed as one: for each so many threads, one.
vtkIdType LegRunner::CountJoined(vtkIdType piece, const PieceRange& pieces)
{
  const vtkIdType threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  vtkIdType joined = 1;
  for (vtkIdType next = 2; ThreadsPerPiece * next <= threads && piece % next == 0 &&
       pieces.Count % next == 0 && piece + next <= pieces.Last;
       next *= 2)
  {
    joined = next;
  }
  return joined;
}

//------------------------------------------------------------------------------
/// Computes pieces, up to the end of a block, and has them written.
bool LegRunner::RunPieces(const PieceRange& pieces, LegRun& run)
{
  for (vtkIdType piece = pieces.First, joined = 1; piece < pieces.Last; piece += joined)
  {
    joined = CountJoined(piece, pieces);
    this->WatchPiece(run, piece / joined, pieces.Count / joined);
    if (!this->Source->Compute(run.Plan, piece / joined, pieces.Count / joined))
    {
      if (!this->Log.HasError() && piece > pieces.First)
      {
        // chunks of LAZ end with a block: a part of one would change the bytes
        vtkHeliosRunFiles::IsCompressed(this->Settings.Format) ? run.Writing.Finish()
                                                               : run.Writing.Finish(run.Progress);
      }
      return false;
    }
    LegPiece data = this->Source->Collect(run.Files);
    this->Source->Count(this->Counts);
    this->Counts.Pulses = this->CountPulsesBefore(run.Plan, piece + joined, pieces.Count);
    const bool isLast = piece + joined == pieces.Last;
    run.Progress.Blocks += isLast ? 1 : 0;
    run.Progress.Pieces = isLast ? 0 : run.Progress.Pieces + joined;
    run.Progress.Counts = this->Counts;
    run.Progress.Seconds = Now() - run.Start;
    if (!run.Writing.Write(
          std::move(data), isLast ? std::make_optional(run.Progress) : std::nullopt))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// Returns the pulses of the run before one of the count pieces of a leg.
vtkIdType LegRunner::CountPulsesBefore(const LegPlan& plan, vtkIdType piece, vtkIdType count) const
{
  return plan.FirstPulse + SplitPulses(plan.NumberOfPulses, piece, count) - this->FirstPulse;
}

//------------------------------------------------------------------------------
/// Reports the counts while the scanner computes a piece, with estimates of its pulses, which are
/// fewer than all.
void LegRunner::WatchPiece(const LegRun& run, vtkIdType piece, vtkIdType count)
{
  const vtkIdType before = this->CountPulsesBefore(run.Plan, piece, count);
  const vtkIdType pulses = this->CountPulsesBefore(run.Plan, piece + 1, count) - before;
  const double fired = this->Counts.Pulses > 0
    ? static_cast<double>(this->Counts.PulsesFired) / static_cast<double>(this->Counts.Pulses)
    : 1.0;
  this->Scanner.SetOnProgress(
    [this, &run, before, pulses, fired](double share)
    {
      ScanCounts counts = this->Counts;
      const double done = share * static_cast<double>(pulses);
      counts.Pulses = before + std::min(static_cast<vtkIdType>(done), pulses - 1);
      counts.PulsesFired += static_cast<vtkIdType>(fired * done);
      return run.OnBlock(counts);
    });
}

//------------------------------------------------------------------------------
bool LegRunner::Write(const Outputs& outputs)
{
  return WriteOutputs(outputs, this->Own.Collect(outputs));
}

//------------------------------------------------------------------------------
std::string LegRunner::DescribeSampling()
{
  return this->Scanner.DescribeSampling();
}

//------------------------------------------------------------------------------
vtkPolyData* LegRunner::GetScene() const
{
  return this->Scene;
}

//------------------------------------------------------------------------------
bool LegRunner::HasError() const
{
  return this->Log.HasError();
}

//------------------------------------------------------------------------------
void LegRunner::Listen(vtkHeliosStreamWriter* writer)
{
  this->Log.Listen(writer);
}

//------------------------------------------------------------------------------
std::string LegRunner::GetRayCasterName() const
{
  return this->Scanner.GetRayCasterName();
}

} // namespace helios
