// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The input files of a run, as the list "inputs" of its fingerprint: names, sizes and digests.

#ifndef heliosRunInputs_h
#define heliosRunInputs_h

#include "heliosInputFile.h"
#include "heliosStatus.h"

#include <vtkSmartPointer.h>

#include <json/value.h>

#include <string>
#include <vector>

class vtkDataObject;
class vtkImageData;

namespace helios
{

struct RunSettings;
struct SurveyData;

/// Returns the files that a survey names. An unreadable file has no digest; its reader reports the
/// error.
Json::Value DescribeInputs(const SurveyData& survey, const RunSettings& settings);

/// Returns the files that materials of a scene and its voxels name, in their order: spectra, and
/// images if the run has colours.
std::vector<std::string> FindMaterialFiles(vtkDataObject* scene,
  const std::vector<vtkSmartPointer<vtkImageData>>& grids, const SurveyData& survey,
  const RunSettings& settings);

/// Adds files that were opened; an error if one has changed since.
Status AddInputs(const InputFiles& files, Json::Value& inputs);

/// Adds the inputs of an earlier run that only its loaded scene has named, as they are now; false if
/// one may be elsewhere.
bool AddEarlierInputs(const Json::Value& then, Json::Value& inputs);

/**
 * Returns the files that differ between the inputs of an earlier run and of this one as texts:
 * "a.obj has changed". Files in other folders, or with other names, are equal if their bytes are.
 * Files that are no longer read count if all that are read are known.
 */
std::vector<std::string> CompareInputs(
  const Json::Value& then, const Json::Value& now, bool areAllKnown);

} // namespace helios

#endif
