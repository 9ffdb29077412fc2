// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Platforms from their elements. Errors go to the messages of the document.

#ifndef heliosXmlPlatform_h
#define heliosXmlPlatform_h

#include "heliosSurveyData.h"
#include "heliosXmlElement.h"

namespace helios
{

/// The pose of <scannerMount> or <beamOrigin>; as before where there is no element.
void ReadPose(const XmlElement& element, Pose& pose);

PlatformData ReadPlatform(const XmlElement& element);

/// What a survey's own noise elements and, of a platform that plays a trajectory, its <scannerMount>
/// change in a platform.
void OverridePlatform(const XmlElement& survey, PlatformData& platform);

} // namespace helios

#endif
