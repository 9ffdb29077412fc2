// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRankBlocks.h"

#include "heliosMessages.h"
#include "heliosRunFingerprint.h"
#include "heliosRunProgress.h"
#include "heliosVtkXmlText.h"
#include "vtkHeliosPlatform.h"
#include "vtkHeliosRanks.h"
#include "vtkHeliosRayCaster.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

namespace helios
{

namespace
{

constexpr int JobsPerRank = 2;   // jobs that a rank has: it computes one, and the next one waits
constexpr std::size_t Ahead = 3; // blocks a rank given before the one that is written next
constexpr auto Pause = std::chrono::microseconds(200);
constexpr auto CallInterval = std::chrono::milliseconds(50);

int CountRun()
{
  static std::atomic<int> runs{ 0 };
  return ++runs;
}

} // namespace

//------------------------------------------------------------------------------
RankBlocks::RankBlocks(
  vtkHeliosRanks* ranks, const LegFiles& files, Messages& log, WaitCallback onWait)
  : Ranks(ranks)
  , Files(files)
  , Log(log)
  , OnWait(std::move(onWait))
  , Run(CountRun())
{
}

//------------------------------------------------------------------------------
RankBlocks::~RankBlocks() = default;

//------------------------------------------------------------------------------
bool RankBlocks::Fail(int rank, const std::string& problem)
{
  this->Log.Error("rank " + std::to_string(rank) + ": " + problem);
  return false;
}

//------------------------------------------------------------------------------
bool RankBlocks::Send(int rank, const RankMessage& message)
{
  const std::string problem = this->Ranks->Send(rank, message.Encode());
  return problem.empty() || this->Fail(rank, problem);
}

//------------------------------------------------------------------------------
bool RankBlocks::Begin(int epoch)
{
  RankMessage begin(RankMessage::Begin);
  begin.Run = this->Run;
  begin.Epoch = epoch;
  bool good = true;
  for (int rank = 1; good && rank < this->Ranks->GetNumberOfRanks(); ++rank)
  {
    good = this->Send(rank, begin);
  }
  return good;
}

//------------------------------------------------------------------------------
void RankBlocks::SetRun(const std::vector<LegPlan>& plans, const Json::Value& fingerprint)
{
  this->Plans = plans;
  this->Fingerprint = fingerprint;
}

//------------------------------------------------------------------------------
/// Adds the blocks from the first one on, in order.
void RankBlocks::AddJobs(const Job& first)
{
  for (const LegPlan& plan : this->Plans)
  {
    for (vtkIdType block = plan.FirstBlock; block < plan.EndBlock; ++block)
    {
      if (Job(plan.Leg, block) >= first)
      {
        this->Jobs.emplace_back(plan.Leg, block);
      }
    }
  }
}

//------------------------------------------------------------------------------
/// Gives jobs to ranks that are ready.
bool RankBlocks::AssignJobs()
{
  const std::size_t end = std::min(this->Jobs.size(),
    this->Current + Ahead * static_cast<std::size_t>(this->Ranks->GetNumberOfRanks() - 1));
  bool good = true;
  for (int jobs = 0; jobs < JobsPerRank; ++jobs) // first one for each
  {
    for (auto& [rank, given] : this->Given)
    {
      if (good && given <= jobs && this->Next < end)
      {
        RankMessage job(RankMessage::Job);
        job.Run = this->Run;
        job.Leg = static_cast<int>(this->Jobs[this->Next].first);
        job.Index = this->Jobs[this->Next].second;
        ++this->Next;
        ++given;
        good = this->Send(rank, job);
      }
    }
  }
  return good;
}

//------------------------------------------------------------------------------
bool RankBlocks::Compute(const LegPlan& plan, vtkIdType block, vtkIdType)
{
  if (this->Jobs.empty())
  {
    this->AddJobs({ plan.Leg, block });
  }
  else
  {
    ++this->Current;
  }
  const auto& job = this->Jobs[this->Current];
  while (this->Received.count(job) == 0)
  {
    if (!this->AssignJobs() || !this->Wait())
    {
      return false;
    }
  }
  this->Block = std::move(this->Received.extract(job).mapped());
  this->CurrentFiles = this->Files.MakeOutputs(plan);
  this->Pieces.clear();
  return this->AssignJobs();
}

//------------------------------------------------------------------------------
/// Waits for a message; false to stop.
bool RankBlocks::Wait()
{
  auto called = std::chrono::steady_clock::now();
  int rank = 0;
  std::string text;
  while (!this->Ranks->Receive(rank, text))
  {
    std::this_thread::sleep_for(Pause);
    const auto now = std::chrono::steady_clock::now();
    if (now - called > CallInterval)
    {
      called = now;
      if (!this->OnWait())
      {
        return false;
      }
    }
  }
  RankMessage message;
  return message.Decode(text) ? this->Accept(rank, message)
                              : this->Fail(rank,
                                  "has sent a message that cannot be read; start "
                                  "all ranks with the same version");
}

//------------------------------------------------------------------------------
bool RankBlocks::Accept(int rank, RankMessage& message)
{
  if (message.Run != this->Run)
  {
    return true; // an earlier run that was stopped
  }
  if (message.Kind == RankMessage::Ready)
  {
    this->Given[rank] = 0;
    return this->CheckFingerprint(rank, message.Fingerprint);
  }
  if (message.Kind == RankMessage::Fault)
  {
    return this->Fail(rank, message.Error);
  }
  --this->Given[rank];
  const Job job(static_cast<std::size_t>(message.Leg), message.Index);
  this->Received[job] = std::move(message);
  return true;
}

//------------------------------------------------------------------------------
bool RankBlocks::CheckFingerprint(int rank, const std::string& text)
{
  Json::Value fingerprint;
  FromText(text, fingerprint);
  const std::string difference = CompareFingerprints(this->Fingerprint, fingerprint);
  return difference.empty() ||
    this->Fail(rank,
      "cannot share the run of rank 0, since " + difference +
        "; give all ranks the same files, options and version");
}

//------------------------------------------------------------------------------
std::size_t RankBlocks::FindFile(int port, std::size_t channel) const
{
  const LegOutput output{ nullptr, port, channel };
  return static_cast<std::size_t>(
    &FindOutput(this->CurrentFiles, output) - this->CurrentFiles.data());
}

//------------------------------------------------------------------------------
/// Returns the data of a port; null: it has no records.
vtkSmartPointer<vtkDataObject> RankBlocks::GetData(int port, std::size_t channel)
{
  const std::size_t file = this->FindFile(port, channel);
  vtkSmartPointer<vtkDataObject>& piece = this->Pieces[file];
  const std::string& bytes = this->Block.Records[file].Bytes;
  if (!piece && !bytes.empty())
  {
    piece = ReadVtkXmlText(bytes, port == WaveformPort);
  }
  return piece;
}

//------------------------------------------------------------------------------
LegPiece RankBlocks::Collect(const LegOutputs& outputs)
{
  const auto get = [this](int port, std::size_t channel) { return this->GetData(port, channel); };
  LegPiece piece;
  for (const LegOutput& output : outputs)
  {
    const std::size_t file = this->FindFile(output.Port, output.Channel);
    if (IsXml(this->CurrentFiles[file]))
    {
      piece.push_back(CollectPiece(output, get));
      continue;
    }
    RankRecords& records = this->Block.Records[file];
    piece.emplace_back();
    piece.back().Rows.Count = records.Count;
    piece.back().Rows.Text = std::move(records.Bytes);
  }
  return piece;
}

//------------------------------------------------------------------------------
void RankBlocks::Count(ScanCounts& counts)
{
  counts.Add(this->Block.Counts);
  this->Block = {};
  this->Pieces.clear();
}

} // namespace helios
