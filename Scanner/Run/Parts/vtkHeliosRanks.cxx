// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRanks.h"

#include "heliosRankMessage.h"

#include <chrono>
#include <thread>

//------------------------------------------------------------------------------
void vtkHeliosRanks::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfRanks: " << this->GetNumberOfRanks() << "\n"
     << indent << "Rank: " << this->GetRank() << "\n"
     << indent << "NumberOfMessages: " << this->NumberOfMessages << "\n"
     << indent << "NumberOfBytes: " << this->NumberOfBytes << "\n";
}

//------------------------------------------------------------------------------
bool vtkHeliosRanks::Receive(int& rank, std::string& message)
{
  const bool isThere = this->ReceiveNext(rank, message);
  this->NumberOfMessages += isThere ? 1 : 0;
  this->NumberOfBytes += isThere ? static_cast<vtkIdType>(message.size()) : 0;
  return isThere;
}

//------------------------------------------------------------------------------
void vtkHeliosRanks::Dismiss()
{
  using helios::RankMessage;
  const std::string end = RankMessage(RankMessage::End).Encode();
  int waiting = 0;
  for (int rank = 1; rank < this->GetNumberOfRanks(); ++rank)
  {
    waiting += this->Send(rank, end).empty() ? 1 : 0;
  }
  while (waiting > 0) // messages on the way are received, too
  {
    int rank = 0;
    std::string text;
    RankMessage message;
    if (!this->Receive(rank, text))
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    else if (message.Decode(text) && message.Kind == RankMessage::End)
    {
      --waiting;
    }
  }
}
