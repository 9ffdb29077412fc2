// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Which points were measured just before a time.

#ifndef heliosBeamFan_h
#define heliosBeamFan_h

#include "heliosPose.h"

#include <vector>

namespace helios
{

class Cloud;

/// At most count points of a cloud in time order, evenly from those measured in the duration [s] before a
/// time [s]; of the whole cloud's last ones where the time is infinite.
std::vector<Vec3> FindNewestPoints(
  const Cloud& cloud, double time, double duration, std::size_t count);

} // namespace helios

#endif
