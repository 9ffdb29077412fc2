// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Parallel lines over an area, and the time to fly them.

#ifndef heliosFlightPattern_h
#define heliosFlightPattern_h

#include "heliosFlightArea.h"

#include <vector>

namespace helios
{

struct PatternSettings
{
  double Swath = 100.0;    ///< [m], the width that a line covers
  double Spacing = 80.0;   ///< [m], the largest distance of neighbouring lines
  double RunIn = 0.0;      ///< [m], before and after each line
  double Speed = 60.0;     ///< [m/s]
  double TurnRadius = 0.0; ///< [m]
  double TurnTime = 0.0;   ///< [s] per turn; 0: the time for TurnRadius
};

/// A line in turned coordinates, from First to Last along.
struct PatternLine
{
  double Across = 0.0;
  double First = 0.0;
  double Last = 0.0;
};

struct FlightPattern
{
  double Heading = 0.0;           ///< [deg], of the first line, clockwise from y
  std::vector<PatternLine> Lines; ///< in flight order, each in the opposite direction of the last
  double LineLength = 0.0;        ///< [m], of all lines
  double TurnLength = 0.0;        ///< [m]; with TurnTime that at Speed
  double Time = 0.0;              ///< [s]
};

/**
 * Returns the length of a half turn onto an antiparallel line, at a distance across, whose start is
 * displaced along: straight on to that level, then the shortest path of arcs of a radius and
 * straight parts (Dubins 1957, Am. J. Math. 79, 497-516). Radius 0: a straight line.
 */
double ComputeTurnLength(double across, double along, double radius);

/// Returns the lines at a heading.
FlightPattern MakePattern(const FlightArea& area, double heading, const PatternSettings& settings);

/**
 * Returns the lines at the heading in [0, 180) with the shortest time: of steps of a quarter degree
 * and the edges of the convex hull, refined about the best ones to a hundredth.
 */
FlightPattern FindPattern(const FlightArea& area, const PatternSettings& settings);

} // namespace helios

#endif
