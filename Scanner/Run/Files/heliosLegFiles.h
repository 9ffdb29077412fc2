// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The files of legs.

#ifndef heliosLegFiles_h
#define heliosLegFiles_h

#include "heliosLegOutput.h"
#include "heliosLegPlan.h"
#include "heliosRunSettings.h"

#include <vtkSmartPointer.h>

#include <string>

namespace helios
{

struct SurveyData;

class LegFiles
{
public:
  /// Names the files of a run, or of one part of it, whose settings come from
  /// MakeRunPartSettings().
  LegFiles(const SurveyData& survey, const RunSettings& settings);

  /// Returns the outputs of a leg, with unopened writers.
  LegOutputs MakeOutputs(const LegPlan& plan) const;

  /// Returns the writer of the trajectory of a leg, not open yet.
  vtkSmartPointer<vtkHeliosStreamWriter> MakeTrajectoryWriter(const LegPlan& plan) const;

private:
  std::string MakeFileName(
    const LegPlan& plan, int kind, const std::string& channel = std::string()) const;
  void AddOutputs(const LegPlan& plan, int port, LegOutputs& outputs) const;

  const SurveyData& Survey;
  RunSettings Settings;
};

/// Returns the file of a part with the port and channel of an output of the run.
const LegOutput& FindOutput(const LegOutputs& files, const LegOutput& output);

/// Returns whether a file is an index of VTK XML.
bool IsXml(const LegOutput& file);

/// Returns whether the files of any output are VTK XML, with a file per piece.
bool HasXml(const RunSettings& settings);

/// Returns the settings of the files of parts. Text is the text of the run. LAS is VTK XML, which
/// has the exact numbers: the header of a LAS file, by which its points are rounded, depends on all
/// parts.
RunSettings MakeRunPartSettings(RunSettings settings);

} // namespace helios

#endif
