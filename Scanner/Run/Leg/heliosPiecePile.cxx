// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPiecePile.h"

#include "heliosChannelMerge.h"

namespace helios
{

//------------------------------------------------------------------------------
void PiecePile::Add(vtkDataObject* piece)
{
  auto data = vtkSmartPointer<vtkDataObject>::Take(piece->NewInstance());
  data->ShallowCopy(piece);
  this->Parts.push_back({ data, 1 });
  while (this->Parts.size() > 1 &&
    this->Parts[this->Parts.size() - 2].Pieces <= this->Parts.back().Pieces)
  {
    this->JoinLast();
  }
}

//------------------------------------------------------------------------------
void PiecePile::Finish()
{
  while (this->Parts.size() > 1)
  {
    this->JoinLast();
  }
  this->Whole = this->Parts.empty() ? nullptr : this->Parts.front().Data;
}

//------------------------------------------------------------------------------
void PiecePile::JoinLast()
{
  const Part last = this->Parts.back();
  this->Parts.pop_back();
  Part& before = this->Parts.back();
  before = { MergeChannels({ before.Data, last.Data }), before.Pieces + last.Pieces };
}

} // namespace helios
