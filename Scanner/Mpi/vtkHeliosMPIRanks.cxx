// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosMPIRanks.h"

#include <vtkMPICommunicator.h>
#include <vtkMPIController.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <list>
#include <memory>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkHeliosMPIRanks);

namespace
{

constexpr int SizeTag = 24001; // tag of the size of a message
constexpr int BytesTag = 24002;
constexpr vtkIdType ChunkSize = 1 << 29; // MPI counts bytes by int
constexpr std::size_t OnTheWay = 2;      // messages to a rank

/// A message on its way, to a rank or from it.
struct Parcel
{
  int Rank = 0;
  vtkIdType Size = 0;
  std::string Bytes;
  std::list<vtkMPICommunicator::Request> Requests;

  bool IsReceived()
  {
    return std::all_of(this->Requests.begin(), this->Requests.end(),
      [](vtkMPICommunicator::Request& request) { return request.Test() != 0; });
  }

  void Wait()
  {
    for (vtkMPICommunicator::Request& request : this->Requests)
    {
      request.Wait();
    }
  }
};

} // namespace

struct vtkHeliosMPIRanks::Internals
{
  vtkNew<vtkMPIController> Controller;
  vtkMPICommunicator* Communicator = nullptr; // communicator of the controller
  std::list<Parcel> Parcels;                  // sent
  std::unique_ptr<Parcel> Coming;             // null: none

  /// Waits for the oldest messages to a rank, if there are too many.
  void MakeRoom(int rank)
  {
    this->Parcels.remove_if([](Parcel& parcel) { return parcel.IsReceived(); });
    const auto isOfRank = [rank](const Parcel& parcel) { return parcel.Rank == rank; };
    auto count =
      static_cast<std::size_t>(std::count_if(this->Parcels.begin(), this->Parcels.end(), isOfRank));
    for (; count >= OnTheWay; --count)
    {
      const auto first = std::find_if(this->Parcels.begin(), this->Parcels.end(), isOfRank);
      first->Wait();
      this->Parcels.erase(first);
    }
  }
};

//------------------------------------------------------------------------------
vtkHeliosMPIRanks::vtkHeliosMPIRanks()
  : Data(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkHeliosMPIRanks::~vtkHeliosMPIRanks() = default;

//------------------------------------------------------------------------------
void vtkHeliosMPIRanks::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Messages on the way: " << this->Data->Parcels.size() << "\n";
}

//------------------------------------------------------------------------------
void vtkHeliosMPIRanks::Initialize()
{
  int count = 0;
  char** words = nullptr;
  this->Data->Controller->Initialize(&count, &words, 0);
  this->Data->Communicator =
    vtkMPICommunicator::SafeDownCast(this->Data->Controller->GetCommunicator());
}

//------------------------------------------------------------------------------
void vtkHeliosMPIRanks::Finalize()
{
  for (Parcel& parcel : this->Data->Parcels)
  {
    parcel.Wait();
  }
  this->Data->Parcels.clear();
  this->Data->Communicator = nullptr;
  this->Data->Controller->Finalize();
}

//------------------------------------------------------------------------------
int vtkHeliosMPIRanks::GetNumberOfRanks() const
{
  return this->Data->Communicator ? this->Data->Controller->GetNumberOfProcesses() : 1;
}

//------------------------------------------------------------------------------
int vtkHeliosMPIRanks::GetRank() const
{
  return this->Data->Communicator ? this->Data->Controller->GetLocalProcessId() : 0;
}

//------------------------------------------------------------------------------
std::string vtkHeliosMPIRanks::Send(int rank, const std::string& message)
{
  this->Data->MakeRoom(rank);
  Parcel& parcel = this->Data->Parcels.emplace_back();
  parcel.Rank = rank;
  parcel.Size = static_cast<vtkIdType>(message.size());
  parcel.Bytes = message;
  vtkMPICommunicator* link = this->Data->Communicator;
  bool good =
    link->NoBlockSend(&parcel.Size, 1, rank, SizeTag, parcel.Requests.emplace_back()) != 0;
  for (vtkIdType at = 0; good && at < parcel.Size; at += ChunkSize)
  {
    const auto size = static_cast<int>(std::min(ChunkSize, parcel.Size - at));
    good = link->NoBlockSend(
             parcel.Bytes.data() + at, size, rank, BytesTag, parcel.Requests.emplace_back()) != 0;
  }
  return good ? std::string()
              : "MPI cannot send " + std::to_string(parcel.Size) +
      " bytes; start the run again "
      "with --resume";
}

//------------------------------------------------------------------------------
/// Begins to receive the next message, if there is one.
bool vtkHeliosMPIRanks::BeginReceiving()
{
  vtkMPICommunicator* link = this->Data->Communicator;
  int isThere = 0;
  auto parcel = std::make_unique<Parcel>();
  if (!link->Iprobe(vtkMultiProcessController::ANY_SOURCE, SizeTag, &isThere, &parcel->Rank) ||
    !isThere || !link->Receive(&parcel->Size, 1, parcel->Rank, SizeTag))
  {
    return false;
  }
  parcel->Bytes.resize(static_cast<std::size_t>(parcel->Size));
  for (vtkIdType at = 0; at < parcel->Size; at += ChunkSize)
  {
    const auto size = static_cast<int>(std::min(ChunkSize, parcel->Size - at));
    link->NoBlockReceive(
      parcel->Bytes.data() + at, size, parcel->Rank, BytesTag, parcel->Requests.emplace_back());
  }
  this->Data->Coming = std::move(parcel);
  return true;
}

//------------------------------------------------------------------------------
/// Does not wait for the rest of a message: its rank may have died.
bool vtkHeliosMPIRanks::ReceiveNext(int& rank, std::string& message)
{
  std::unique_ptr<Parcel>& coming = this->Data->Coming;
  if ((!coming && !this->BeginReceiving()) || !coming->IsReceived())
  {
    return false;
  }
  rank = coming->Rank;
  message = std::move(coming->Bytes);
  coming.reset();
  return true;
}
