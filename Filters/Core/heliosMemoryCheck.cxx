// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMemoryCheck.h"

#include "heliosStatus.h"
#include "vtkHeliosMemoryLimit.h"

#include <iomanip>
#include <iterator>
#include <sstream>

namespace helios
{

namespace
{

constexpr double Mebibyte = 1048576.0;
constexpr double Plenty = 64.0 * Mebibyte; // smaller requests are not checked without a limit

std::string ToSize(double bytes)
{
  static const char* const units[] = { "MB", "GB", "TB", "PB", "EB" };
  double value = bytes / 1e6;
  std::size_t unit = 0;
  for (; value >= 1000.0 && unit + 1 < std::size(units); ++unit)
  {
    value /= 1000.0;
  }
  std::ostringstream text;
  text << std::setprecision(3) << value << ' ' << units[unit];
  return text.str();
}

} // namespace

Status CheckMemory(const std::string& things, double count, double bytesEach)
{
  const double needed = count * bytesEach;
  const double limit = Mebibyte * vtkHeliosMemoryLimit::GetLimit();
  if (limit <= 0.0 && needed < Plenty)
  {
    return {};
  }
  const double available = Mebibyte * vtkHeliosMemoryLimit::GetAvailable();
  if (needed <= available)
  {
    return {};
  }
  std::ostringstream text;
  text << std::setprecision(15) << count << ' ' << things << " need about " << ToSize(needed)
       << " of memory, and " << ToSize(available) << " are available"
       << (limit > 0.0 ? " of the " + ToSize(limit) + " that may be used" : std::string())
       << "; use fewer, or allow more with vtkhelios run --memory (vtkHeliosMemoryLimit)";
  return Status::Error(text.str());
}

} // namespace helios
