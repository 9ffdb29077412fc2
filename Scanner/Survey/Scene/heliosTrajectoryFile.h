// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The reader of a trajectory file, of a platform or of a part of the scene.

#ifndef heliosTrajectoryFile_h
#define heliosTrajectoryFile_h

#include "heliosTrajectoryFileData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkSmartPointer.h>

#include <string>

class vtkHeliosTrajectoryReader;

namespace helios
{

/// Makes the reader of a file, whose positions are in a system.
VTKHELIOSSCANNERSURVEY_EXPORT vtkSmartPointer<vtkHeliosTrajectoryReader> MakeTrajectoryReader(
  const TrajectoryFileData& file, AngleConvention convention, const std::string& crs);

} // namespace helios

#endif
