// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// All that determines the output of a run: runs with equal fingerprints are byte-identical.

#ifndef heliosRunFingerprint_h
#define heliosRunFingerprint_h

#include "heliosInputFile.h"
#include "heliosStatus.h"

#include <vtkSmartPointer.h>

#include <json/value.h>

#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace helios
{

class LegRunner;
class SurveyLoader;
struct RunSettings;
struct SurveyData;

/**
 * Returns the fingerprint of a run as JSON: "versions", "survey", "inputs" (the files that the
 * survey names, each with its SHA-256), "options", and "scene", which is empty until the scene is
 * loaded; of a part of a run also "part". An unreadable file has no digest; its reader reports the
 * error.
 */
Json::Value MakeFingerprint(const SurveyData& survey, const RunSettings& settings);

/// Adds what a loaded survey tells: its "scene", and all "inputs", which are also returned: those
/// that other files name (material libraries, tiles, spectra, images). An error if one has changed.
Status AddLoadedSurvey(const SurveyLoader& loader, const LegRunner& legs,
  const RunSettings& settings, Json::Value& fingerprint, InputFiles& inputs);

/// Returns whether a fingerprint has what a loaded survey tells.
bool IsOfLoadedSurvey(const Json::Value& fingerprint);

/// Returns the digest of a loaded scene, with the bytes of files that its materials name. Grids
/// count if they are from no file.
std::string HashScene(vtkPolyData* scene,
  const std::vector<vtkSmartPointer<vtkImageData>>& grids = {},
  const std::vector<std::string>& files = {});

/// Returns the differences between the fingerprints of an earlier run and of this one as text:
/// "survey.xml has changed, Seed was 1 and is 2"; empty: none. What only a loaded survey tells is
/// ignored if one of them has not.
std::string CompareFingerprints(const Json::Value& then, const Json::Value& now);

} // namespace helios

#endif
