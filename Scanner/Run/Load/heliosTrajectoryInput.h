// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A trajectory from a pipeline, in place of a file.

#ifndef heliosTrajectoryInput_h
#define heliosTrajectoryInput_h

#include <string>

class vtkPolyData;

namespace helios
{

class Messages;

/**
 * Checks a trajectory in the layout of vtkHeliosTrajectoryReader: points, GpsTime in order and
 * Orientation as unit quaternions. False after an error that names the array, the row (from 0) and
 * its value.
 */
bool CheckTrajectoryInput(vtkPolyData* data, const std::string& name, Messages& log);

} // namespace helios

#endif
