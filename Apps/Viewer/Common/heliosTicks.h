// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Round numbers with units: of colour scales, axes and scale bars.

#ifndef heliosTicks_h
#define heliosTicks_h

#include <string>
#include <vector>

namespace helios::viewer
{

struct Tick
{
  double Value;
  std::string Text;
};

struct Ticks
{
  std::vector<Tick> List; ///< ascending, inside the range
  std::string Unit;       ///< unit of the texts, with its SI prefix; empty: none, or in the texts
};

/**
 * Ticks of a range at multiples of 1, 2 or 5 times a power of ten. The unit gets an SI prefix (of
 * W, J and Hz) that fits the larger end; all texts have the same decimals.
 * most: the largest number of ticks, at least 2. An empty or infinite range has no ticks.
 */
Ticks MakeTicks(double low, double high, int maximum, const std::string& unit);

/**
 * Ticks of a logarithmic range, 0 < low < high: powers of ten, with 2 and 5 times them where they
 * fit; linear ones below a ratio of 10. Texts have their unit: "200 nW", "1 uW" with the Greek mu.
 */
Ticks MakeLogTicks(double low, double high, int maximum, const std::string& unit);

/// Returns a value in a suitable unit with three significant digits: "12.3 nW"; 0 is "0 W".
std::string DescribeValue(double value, const std::string& unit);

/// Returns the largest of 1, 2, 5 times a power of ten that is not above a positive value.
double RoundDown(double value);

/// Returns a length [m] of one significant digit in mm, cm, m or km: "20 m".
std::string DescribeLength(double metres);

} // namespace helios::viewer

#endif
