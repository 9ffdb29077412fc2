// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs pieces of a leg: their progress and stops.
#include "heliosLegScanner.h"

#include "heliosMessages.h"
#include "heliosScanCounts.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScanner.h"

#include <vtkCommand.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr std::chrono::milliseconds ProgressInterval(100);

vtkIdType CountFirstReturns(vtkPolyData* echoes)
{
  auto* numbers =
    vtkUnsignedCharArray::SafeDownCast(echoes->GetPointData()->GetArray(names::ReturnNumber));
  const unsigned char* first = numbers ? numbers->GetPointer(0) : nullptr;
  return first ? std::count(first, first + numbers->GetNumberOfTuples(), 1) : 0;
}

void AddCounts(const std::vector<vtkSmartPointer<vtkHeliosScanner>>& channels, ScanCounts& counts)
{
  for (vtkHeliosScanner* channel : channels)
  {
    counts.Add(channel->GetCounts());
    counts.FirstReturns += CountFirstReturns(channel->GetOutput());
  }
}

} // namespace

//------------------------------------------------------------------------------
bool LegScanner::Update(int piece, int pieces)
{
  this->IsStopped = false;
  this->ShareBefore = 0.0;
  this->ShareAfter = 1.0;
  const bool isGood = this->UpdateAll(piece, pieces);
  if (this->IsStopped)
  {
    this->Log.Mute(false);
  }
  return isGood;
}

//------------------------------------------------------------------------------
/// Passes on the progress of a channel, and stops it; its own message about that is not reported.
void LegScanner::HandleProgress(vtkObject* caller, unsigned long, void*)
{
  auto* channel = vtkAlgorithm::SafeDownCast(caller);
  const auto now = std::chrono::steady_clock::now();
  if (!this->IsStopped && this->OnProgress && now - this->LastProgress > ProgressInterval)
  {
    this->LastProgress = now;
    const double share = this->ShareAfter - this->ShareBefore;
    this->IsStopped = !this->OnProgress(this->ShareBefore + share * channel->GetProgress());
  }
  if (this->IsStopped)
  {
    this->Log.Mute(true);
    channel->SetAbortExecute(1);
  }
}

//------------------------------------------------------------------------------
bool LegScanner::UpdateAll(int piece, int pieces)
{
  const double before = this->ShareBefore;
  const double step = (this->ShareAfter - before) /
    static_cast<double>(std::max<std::size_t>(1, this->Channels.size()));
  for (std::size_t k = 0; k < this->Channels.size(); ++k)
  {
    this->ShareBefore = before + static_cast<double>(k) * step;
    this->ShareAfter = this->ShareBefore + step;
    this->Channels[k]->UpdatePiece(piece, pieces, 0);
    if (this->IsStopped)
    {
      this->Channels[k]->SetAbortExecute(0); // since VTK 9.3 it stays
      return false;
    }
    if (this->Log.HasError())
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void LegScanner::Count(ScanCounts& counts) const
{
  AddCounts(this->Channels, counts);
}

} // namespace helios
