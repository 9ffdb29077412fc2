// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What moves on a journey, as its data say.

#ifndef heliosMakePlatform_h
#define heliosMakePlatform_h

#include "heliosSurveyData.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkHeliosPlatform;
class vtkHeliosPlatformNoise;

namespace helios
{

class Messages;

/// The platform of the legs [first, last), with its waypoints or its recorded trajectory.
vtkSmartPointer<vtkHeliosPlatform> MakePlatform(const SurveyData& survey,
  const std::vector<Vec3>& positions, std::size_t first, std::size_t last, Messages& log);

/// How a platform shakes, each value lasting for so many pulses of all channels; null: it does not.
vtkSmartPointer<vtkHeliosPlatformNoise> MakePlatformNoise(
  const PlatformData& platform, std::size_t channels);

} // namespace helios

#endif
