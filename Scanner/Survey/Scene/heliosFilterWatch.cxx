// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFilterWatch.h"

#include "heliosMessages.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>

#include <iterator>

namespace helios
{

namespace
{

constexpr std::chrono::milliseconds ProgressInterval(100);

} // namespace

//------------------------------------------------------------------------------
void FilterWatch::Add(vtkAlgorithm* filter, const std::string& where)
{
  this->Log.Listen(filter, where);
  filter->AddObserver(vtkCommand::ProgressEvent, this, &FilterWatch::HandleProgress);
  filter->AddObserver(vtkCommand::StartEvent, this, &FilterWatch::HandleStart);
  filter->AddObserver(vtkCommand::EndEvent, this, &FilterWatch::HandleEnd);
}

//------------------------------------------------------------------------------
void FilterWatch::BeginStep(const std::string& step)
{
  this->Step = step;
  this->LastProgress = std::chrono::steady_clock::now();
}

//------------------------------------------------------------------------------
void FilterWatch::HandleProgress(vtkObject* caller, unsigned long, void*)
{
  const auto now = std::chrono::steady_clock::now();
  if (this->OnProgress && now - this->LastProgress > ProgressInterval)
  {
    this->LastProgress = now;
    this->IsStopped = this->IsStopped || !(*this->OnProgress)(this->Step);
  }
  if (this->IsStopped)
  {
    this->Log.Mute(true);
    vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
  }
}

//------------------------------------------------------------------------------
/// Records the files that a filter opens before it runs, to describe its output; it opens them
/// again then.
void FilterWatch::HandleStart(vtkObject* caller, unsigned long, void*)
{
  InputFiles& inputs = this->Inputs[vtkAlgorithm::SafeDownCast(caller)];
  inputs.clear();
  this->Watch.reset();
  this->Watch.emplace(inputs);
}

//------------------------------------------------------------------------------
void FilterWatch::HandleEnd(vtkObject*, unsigned long, void*)
{
  this->Watch.reset();
}

//------------------------------------------------------------------------------
void FilterWatch::RemoveOthers(const std::set<vtkAlgorithm*>& used)
{
  for (auto input = this->Inputs.begin(); input != this->Inputs.end();)
  {
    input = used.count(input->first) == 0 ? this->Inputs.erase(input) : std::next(input);
  }
}

//------------------------------------------------------------------------------
InputFiles FilterWatch::GetInputs() const
{
  InputFiles all;
  for (const auto& [filter, files] : this->Inputs)
  {
    all.insert(files.begin(), files.end());
  }
  return all;
}

} // namespace helios
