// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// All that determines the bytes a run writes: two runs with one fingerprint write the same.

#ifndef heliosRunFingerprint_h
#define heliosRunFingerprint_h

#include <json/value.h>

#include <string>

class vtkPolyData;

namespace helios
{

struct RunSettings;
struct SurveyData;

/**
 * The fingerprint of a run as JSON: "versions", "survey", "inputs" (the files that the survey names,
 * each with its SHA-256), "options", and "scene", which is empty until the scene is loaded. A file
 * that cannot be read has no digest; who reads it reports that.
 */
Json::Value MakeFingerprint(const SurveyData& survey, const RunSettings& settings);

/// The digest of a scene as it was loaded: of all files that went into it, those that no survey names
/// too (material libraries, spectra, coordinate systems beside rasters).
std::string HashScene(vtkPolyData* scene);

/// What differs between the fingerprint of an earlier run and of this one, in words: "survey.xml has
/// changed, Seed was 1 and is 2"; empty: nothing. A scene that is not known yet does not count.
std::string CompareFingerprints(const Json::Value& then, const Json::Value& now);

} // namespace helios

#endif
