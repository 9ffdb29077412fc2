// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosColumnProfile.h"

namespace helios
{

/// Returns the slab of a number; those up to it are made.
ColumnProfile::Slab& ColumnProfile::GetSlab(vtkIdType index)
{
  if (this->Slabs.empty())
  {
    this->First = index;
  }
  if (index < this->First)
  {
    this->Slabs.insert(this->Slabs.begin(), static_cast<std::size_t>(this->First - index), Slab());
    this->First = index;
  }
  const auto place = static_cast<std::size_t>(index - this->First);
  this->Slabs.resize(std::max(this->Slabs.size(), place + 1));
  return this->Slabs[place];
}

} // namespace helios
