// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Selects the points measured just before a time.

#ifndef heliosBeamFan_h
#define heliosBeamFan_h

#include "heliosPose.h"

#include <vector>

namespace helios::viewer
{

class Cloud;

/// Returns at most count points of a cloud in time order, spread evenly over the points measured in
/// the duration [s] before a time [s]; an infinite time selects from the cloud's last points.
std::vector<Vec3> FindNewestPoints(
  const Cloud& cloud, double time, double duration, std::size_t count);

} // namespace helios::viewer

#endif
