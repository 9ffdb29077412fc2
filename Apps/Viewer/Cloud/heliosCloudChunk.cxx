// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCloud.h"

#include <limits>

namespace helios::viewer
{

namespace
{

template <typename T>
std::size_t GetBytes(const std::vector<T>& values)
{
  return values.capacity() * sizeof(T);
}

} // namespace

//------------------------------------------------------------------------------
CloudChunk::CloudChunk()
  : FirstTime(std::numeric_limits<double>::quiet_NaN())
  , LastTime(std::numeric_limits<double>::quiet_NaN())
  , Bounds{ 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 }
{
  const auto capacity = static_cast<std::size_t>(Capacity);
  this->Xyz->SetNumberOfComponents(3);
  this->Xyz->Allocate(3 * Capacity);
  this->Pulses.reserve(capacity);
  this->Times.reserve(capacity);
  this->Ranges.reserve(capacity);
  this->Tags.reserve(capacity);
  this->Amplitudes.reserve(capacity);
  this->ReturnNumbers.reserve(capacity);
  this->NumbersOfReturns.reserve(capacity);
  this->Classes.reserve(capacity);
  this->Incidences.reserve(capacity);
}

//------------------------------------------------------------------------------
std::size_t CloudChunk::GetMemorySize() const
{
  return sizeof(*this) + static_cast<std::size_t>(this->Xyz->GetSize()) * sizeof(float) +
    GetBytes(this->Pulses) + GetBytes(this->Times) + GetBytes(this->Ranges) + GetBytes(this->Tags) +
    GetBytes(this->Amplitudes) + GetBytes(this->ReturnNumbers) + GetBytes(this->NumbersOfReturns) +
    GetBytes(this->Classes) + GetBytes(this->Incidences) + GetBytes(this->Colors);
}

//------------------------------------------------------------------------------
void CloudChunk::Squeeze()
{
  this->Xyz->Squeeze();
  this->Pulses.shrink_to_fit();
  this->Times.shrink_to_fit();
  this->Ranges.shrink_to_fit();
  this->Tags.shrink_to_fit();
  this->Amplitudes.shrink_to_fit();
  this->ReturnNumbers.shrink_to_fit();
  this->NumbersOfReturns.shrink_to_fit();
  this->Classes.shrink_to_fit();
  this->Incidences.shrink_to_fit();
  this->Colors.shrink_to_fit();
}

} // namespace helios::viewer
