// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Platforms from their elements. Errors go to the messages of the document.

#ifndef heliosXmlPlatform_h
#define heliosXmlPlatform_h

#include "heliosSurveyData.h"
#include "heliosXmlElement.h"

namespace helios
{

class Assets;

/// The pose of <scannerMount> or <beamOrigin>; as before where there is no element.
void ReadPose(const XmlElement& element, Pose& pose);

/// What an attribute says of a model; as before where there is none. Its file is not looked for.
void ReadModel(const XmlElement& element, const char* attribute, ModelData& model);

/// Finds the file of a model that an element has given. None is no error: it is but shown.
void FindModel(const XmlElement& element, const Assets& files, ModelData& model);

PlatformData ReadPlatform(const XmlElement& element);

/// What a survey's own noise elements and, of a platform that plays a trajectory, its <scannerMount>
/// change in a platform.
void OverridePlatform(const XmlElement& survey, PlatformData& platform);

} // namespace helios

#endif
