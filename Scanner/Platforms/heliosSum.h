// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef heliosSum_h
#define heliosSum_h

#include <algorithm>

namespace helios
{

/// A sum of terms >= 0, exact to an ulp for any number of them: the rounding error of each addition
/// is kept and added back (Neumaier 1974).
class Sum
{
public:
  void Add(double term)
  {
    const double sum = this->High + term;
    this->Low += std::max(this->High, term) - sum + std::min(this->High, term);
    this->High = sum;
  }
  double Get() const { return this->High + this->Low; }

private:
  double High = 0.0;
  double Low = 0.0;
};

} // namespace helios

#endif
