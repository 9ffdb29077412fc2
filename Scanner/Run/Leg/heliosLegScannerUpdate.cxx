// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs pieces of a leg: their progress, stops, and windows of moving scenes.
#include "heliosLegScanner.h"

#include "heliosMessages.h"
#include "heliosPulseCount.h"
#include "heliosPulseSubset.h"
#include "heliosScanCounts.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosScanner.h"

#include <vtkCommand.h>
#include <vtkImageData.h>
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
  const bool isGood =
    this->Motion.IsMoving() ? this->UpdateMoving(piece, pieces) : this->UpdateAll(piece, pieces);
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
/// Runs a piece in pulse windows of constant scene.
bool LegScanner::UpdateMoving(int piece, int pieces)
{
  this->ReleaseOutput();
  this->Gathered.assign(this->Channels.size(),
    std::vector<PieceBuffer>(vtkHeliosEchoAlgorithm::Outputs::NumberOfPorts));
  const vtkIdType count = std::max<vtkIdType>(0, this->Channels.front()->GetNumberOfPulses());
  const vtkIdType begin = std::max(this->FirstPulse,
    helios::CountPulses(this->WindowStart - this->Clock.StartTime, this->Clock.Rate));
  const vtkIdType first = begin + SplitPulses(count, piece, pieces);
  const vtkIdType end = begin + SplitPulses(count, piece + 1, pieces);
  const auto getShare = [first, end](vtkIdType pulse)
  {
    return static_cast<double>(pulse - first) /
      static_cast<double>(std::max<vtkIdType>(1, end - first));
  };
  vtkIdType pulse = first;
  bool isGood = true;
  do
  {
    pulse = std::min(end, this->FindSample(pulse));
    const vtkIdType next = std::min(end, this->Motion.MoveTo(this->Clock, pulse));
    this->ShareBefore = getShare(pulse);
    this->ShareAfter = getShare(next);
    this->ApplyParts();
    this->ApplyWindow(pulse, next);
    isGood = this->UpdateAll(0, 1);
    isGood ? this->Gather() : void(); // a stopped scanner has no arrays
    pulse = next;
  } while (isGood && pulse < end);
  this->ApplyWindow(this->FirstPulse, this->LastPulse);
  for (std::vector<PieceBuffer>& ports : this->Gathered)
  {
    for (PieceBuffer& pile : ports)
    {
      pile.Finish();
    }
  }
  return isGood;
}

//------------------------------------------------------------------------------
/// Returns the first pulse of the sample from a pulse on, of any channel.
vtkIdType LegScanner::FindSample(vtkIdType pulse) const
{
  vtkIdType first = VTK_ID_MAX;
  for (vtkHeliosScanner* channel : this->Channels)
  {
    const PulseSubset sample(channel->GetPulseStep(), channel->GetFirstPulseId());
    first = std::min(first, sample.Get(sample.CountBelow(pulse)));
  }
  return first;
}

//------------------------------------------------------------------------------
/// Updates the scene of all channels.
void LegScanner::ApplyParts()
{
  const vtkMTimeType time = this->Motion.GetMoveTime();
  if (time == this->MoveTime)
  {
    return;
  }
  this->MoveTime = time;
  const ScannerData& scanner = this->Survey.Scanners[this->Scanner];
  for (std::size_t k = 0; k < this->Channels.size(); ++k)
  {
    const auto scene = this->Motion.Move(this->GetScene(scanner.GetChannel(k).Receiver.Wavelength));
    this->Channels[k]->SetInputDataObject(0, scene);
  }
}

//------------------------------------------------------------------------------
/// Appends the output of the channels to that gathered.
void LegScanner::Gather()
{
  AddCounts(this->Channels, this->GatheredCounts);
  for (std::size_t k = 0; k < this->Channels.size(); ++k)
  {
    for (int port = 0; port < vtkHeliosEchoAlgorithm::Outputs::NumberOfPorts; ++port)
    {
      if (this->Settings.Wants.HasPort(port))
      {
        this->Gathered[k][static_cast<std::size_t>(port)].Add(
          this->Channels[k]->GetOutputDataObject(port));
      }
    }
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
  this->Motion.IsMoving() ? counts.Add(this->GatheredCounts) : AddCounts(this->Channels, counts);
}

} // namespace helios
