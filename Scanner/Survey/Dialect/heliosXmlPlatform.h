// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads platforms from their elements. Errors go to the messages of the document.

#ifndef heliosXmlPlatform_h
#define heliosXmlPlatform_h

#include "heliosSurveyData.h"
#include "heliosXmlElement.h"

namespace helios
{

class Assets;
class Messages;

/// Reads the pose of <scannerMount> or <beamOrigin>; unchanged without an element.
void ReadPose(const XmlElement& element, Pose& pose);

/// Reads the model named by an attribute; unchanged without one. Its file is not searched.
void ReadModel(const XmlElement& element, const char* attribute, ModelData& model);

/// Finds the file of a model of an element. A missing file is no error: it is only displayed.
void FindModel(const XmlElement& element, const Assets& files, ModelData& model);

/// The elements of the noise of a platform's pose, in the order of PlatformData::Noise.
constexpr const char* NoiseNames[6] = { "positionXNoise", "positionYNoise", "positionZNoise",
  "attitudeXNoise", "attitudeYNoise", "attitudeZNoise" };

PlatformData ReadPlatform(const XmlElement& element);

/// Checks the complete data: empty intervals of noise.
void CheckPlatform(const PlatformData& platform, Messages& log);

/// Overrides the platform's noise by the survey's and, for a platform that plays a trajectory, its
/// <scannerMount>.
void OverridePlatform(const XmlElement& survey, PlatformData& platform);

} // namespace helios

#endif
