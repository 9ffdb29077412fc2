// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The platforms and scanners of a folder of assets.

#ifndef heliosCatalogue_h
#define heliosCatalogue_h

#include "heliosSurveyData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <string>
#include <utility>
#include <vector>

namespace helios
{

/// The available items, each with its reference (/folder/file.xml#id).
struct Catalogue
{
  std::vector<std::pair<std::string, PlatformData>> Platforms;
  std::vector<std::pair<std::string, ScannerData>> Scanners;
};

/// Returns the platforms and scanners of the documents in asset directories (and their folders
/// Assets), and of more files. Items with errors are omitted.
VTKHELIOSSCANNERSURVEY_EXPORT Catalogue ReadCatalogue(
  const std::vector<std::string>& assetDirectories, const std::vector<std::string>& files);

} // namespace helios

#endif
