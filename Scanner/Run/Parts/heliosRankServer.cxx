// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRankServer.h"

#include "heliosRankWorker.h"
#include "vtkHeliosRanks.h"
#include "vtkHeliosRayCaster.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <chrono>
#include <thread>

namespace helios
{

namespace
{

constexpr auto Pause = std::chrono::milliseconds(1);

} // namespace

//------------------------------------------------------------------------------
RankServer::RankServer(vtkHeliosRanks* ranks)
  : Ranks(ranks)
{
}

//------------------------------------------------------------------------------
Status RankServer::Serve(const LoadCallback& load, const std::atomic<bool>& stop)
{
  RankMessage message;
  std::string problem;
  while (problem.empty() && message.Kind != RankMessage::End && this->Receive(stop, message))
  {
    const RankMessage response = this->RespondTo(message, load);
    problem = response.Kind.empty() ? std::string() : this->Ranks->Send(0, response.Encode());
  }
  return problem.empty() ? Status() : Status::Error(problem);
}

//------------------------------------------------------------------------------
/// Waits for a message; false if it is to stop.
bool RankServer::Receive(const std::atomic<bool>& stop, RankMessage& message) const
{
  int rank = 0;
  std::string text;
  while (!this->Ranks->Receive(rank, text) || !message.Decode(text))
  {
    if (stop)
    {
      return false;
    }
    std::this_thread::sleep_for(Pause);
  }
  return true;
}

//------------------------------------------------------------------------------
/// Returns the answer to a message of rank 0; without a kind: none.
RankMessage RankServer::RespondTo(const RankMessage& message, const LoadCallback& load)
{
  RankMessage response;
  if (message.Kind == RankMessage::Begin)
  {
    this->Current = load(message.Epoch);
    this->Run = message.Run;
    response.Kind = this->Current.Worker ? RankMessage::Ready : RankMessage::Fault;
    response.Run = message.Run;
    response.Fingerprint = this->Current.Fingerprint;
    response.Error = this->Current.Error;
  }
  else if (message.Kind == RankMessage::Job && message.Run == this->Run && this->Current.Worker)
  {
    response = this->Current.Worker->Compute(message);
  }
  else if (message.Kind == RankMessage::End)
  {
    response.Kind = RankMessage::End;
  }
  return response;
}

} // namespace helios
