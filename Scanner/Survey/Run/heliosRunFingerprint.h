// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// All that determines the output of a run: runs with equal fingerprints are byte-identical.

#ifndef heliosRunFingerprint_h
#define heliosRunFingerprint_h

#include <vtkSmartPointer.h>

#include <json/value.h>

#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace helios
{

struct RunSettings;
struct SurveyData;

/**
 * The fingerprint of a run as JSON: "versions", "survey", "inputs" (the files that the survey
 * names, each with its SHA-256), "options", and "scene", which is empty until the scene is loaded; of a part of a run also "part".
 * An unreadable file has no digest; its reader reports the error.
 */
Json::Value MakeFingerprint(const SurveyData& survey, const RunSettings& settings);

/// The digest of a loaded scene: of all its input files, also those that no survey names (material
/// libraries, spectra, coordinate systems beside rasters). Grids count if they are from no file.
std::string HashScene(
  vtkPolyData* scene, const std::vector<vtkSmartPointer<vtkImageData>>& grids = {});

/// The differences between the fingerprints of an earlier run and of this one as text: "survey.xml
/// has changed, Seed was 1 and is 2"; empty: none. A scene not known yet is ignored.
std::string CompareFingerprints(const Json::Value& then, const Json::Value& now);

} // namespace helios

#endif
