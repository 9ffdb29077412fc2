// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPieceBuffer.h"

#include "heliosChannelMerge.h"

namespace helios
{

//------------------------------------------------------------------------------
void PieceBuffer::Add(vtkDataObject* piece)
{
  auto data = vtkSmartPointer<vtkDataObject>::Take(piece->NewInstance());
  data->ShallowCopy(piece);
  this->Groups.push_back({ data, 1 });
  while (this->Groups.size() > 1 &&
    this->Groups[this->Groups.size() - 2].Pieces <= this->Groups.back().Pieces)
  {
    this->JoinLast();
  }
}

//------------------------------------------------------------------------------
void PieceBuffer::Finish()
{
  while (this->Groups.size() > 1)
  {
    this->JoinLast();
  }
  this->Whole = this->Groups.empty() ? nullptr : this->Groups.front().Data;
}

//------------------------------------------------------------------------------
void PieceBuffer::JoinLast()
{
  const Merged last = this->Groups.back();
  this->Groups.pop_back();
  Merged& before = this->Groups.back();
  before = { MergeChannels({ before.Data, last.Data }), before.Pieces + last.Pieces };
}

} // namespace helios
