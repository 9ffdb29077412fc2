// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Terms of an error model without a usable value, counted by pulses.

#ifndef heliosErrorTerms_h
#define heliosErrorTerms_h

#include "vtkHeliosErrorModel.h"

#include <vtkType.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>

namespace helios
{

/// The largest valid value of a term; a larger or non-finite one is invalid.
constexpr double LargestErrorTerm = 1e9;

inline bool IsUsableTerm(double value)
{
  return std::abs(value) <= LargestErrorTerm; // false for NaN
}

/// The pulses for which a term has no usable value.
struct TermFault
{
  vtkIdType Pulses = 0;
  vtkIdType First = VTK_ID_MAX; ///< its id
  double Variable = 0.0;        ///< variable of the first
  vtkIdType Last = -1;          ///< id added

  /// Adds a fault; the echoes of a pulse are consecutive and count once.
  void Add(vtkIdType pulse, double variable)
  {
    this->Pulses += pulse == this->Last ? 0 : 1;
    this->Last = pulse;
    if (pulse < this->First)
    {
      this->First = pulse;
      this->Variable = variable;
    }
  }

  void Add(const TermFault& other)
  {
    this->Pulses += other.Pulses;
    if (other.First < this->First)
    {
      this->First = other.First;
      this->Variable = other.Variable;
    }
  }

  /// Returns the text after the name of the term in a message.
  std::string Describe(int term, vtkIdType fired) const
  {
    const bool isOfRange = term == vtkHeliosErrorModel::RANGE_NOISE_FACTOR;
    std::ostringstream text;
    text << " is not finite, or beyond 1e9, for " << this->Pulses << " of " << fired
         << " pulses, the first of them pulse " << this->First << " at "
         << (isOfRange ? "a range of " : "a scan angle of ") << this->Variable
         << (isOfRange ? " m" : " rad") << "; give one that is finite there";
    return text.str();
  }
};

using TermFaults = std::array<TermFault, vtkHeliosErrorModel::NUMBER_OF_TERMS>;

} // namespace helios

#endif
