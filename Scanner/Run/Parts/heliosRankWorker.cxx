// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRankWorker.h"

#include "heliosLegRunner.h"
#include "heliosMessages.h"
#include "vtkHeliosRayCaster.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <utility>

namespace helios
{

//------------------------------------------------------------------------------
RankWorker::RankWorker(const LegFiles& files, LegRunner& runner, Messages& log)
  : Files(files)
  , Runner(runner)
  , Log(log)
{
}

//------------------------------------------------------------------------------
RankWorker::~RankWorker()
{
  this->Close();
}

//------------------------------------------------------------------------------
void RankWorker::Close()
{
  for (const LegOutput& output : this->Outputs)
  {
    output.Writer->Abandon();
  }
  this->Outputs.clear();
  this->Plan = nullptr;
}

//------------------------------------------------------------------------------
/// Sets up the scanner and the outputs for a leg.
bool RankWorker::Open(const LegPlan& plan)
{
  this->Close();
  this->Plan = &plan;
  this->Runner.Prepare(plan);
  this->Outputs = this->Files.MakeOutputs(plan);
  this->Texts.assign(this->Outputs.size(), {});
  bool good = true;
  for (std::size_t i = 0; i < this->Outputs.size(); ++i)
  {
    vtkHeliosStreamWriter* writer = this->Outputs[i].Writer;
    this->Runner.Listen(writer);
    writer->SetCountOnly(true);
    writer->SetBlockText(&this->Texts[i]);
    good = writer->Open() && good;
  }
  return good;
}

//------------------------------------------------------------------------------
RankMessage RankWorker::Compute(const RankMessage& job)
{
  const auto& plans = this->Runner.GetPlans();
  const auto plan = std::find_if(plans.begin(), plans.end(),
    [&job](const LegPlan& each) { return each.Leg == static_cast<std::size_t>(job.Leg); });
  RankMessage block = job;
  block.Kind = RankMessage::Block;
  if (plan == plans.end() || !(this->Plan == &*plan || this->Open(*plan)) ||
    !this->Fill(*plan, block))
  {
    block.Kind = RankMessage::Fault;
    block.Error = this->Log.GetLastError();
  }
  return block;
}

//------------------------------------------------------------------------------
bool RankWorker::Fill(const LegPlan& plan, RankMessage& block)
{
  std::vector<vtkIdType> before;
  for (const LegOutput& output : this->Outputs)
  {
    before.push_back(output.Writer->GetNumberOfRecords());
  }
  if (!this->Runner.GetBlocks().Compute(plan, block.Index, plan.NumberOfBlocks) ||
    !this->Runner.Write(this->Outputs))
  {
    return false;
  }
  this->Runner.GetBlocks().Count(block.Counts);
  for (std::size_t i = 0; i < this->Outputs.size(); ++i)
  {
    block.Records.push_back({ this->Outputs[i].Writer->GetNumberOfRecords() - before[i],
      std::exchange(this->Texts[i], {}) });
  }
  return true;
}

} // namespace helios
