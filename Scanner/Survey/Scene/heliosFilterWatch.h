// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Watches filters while they run: their progress, whether they are stopped, and the files they open.

#ifndef heliosFilterWatch_h
#define heliosFilterWatch_h

#include "heliosInputFile.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkSmartPointer.h>

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

class vtkAlgorithm;
class vtkObject;

namespace helios
{

class Messages;

/// Called before each step of a long task with its name; false stops it.
using StepCallback = std::function<bool(const std::string& step)>;

class VTKHELIOSSCANNERSURVEY_EXPORT FilterWatch
{
public:
  explicit FilterWatch(Messages& log)
    : Log(log)
  {
  }

  /// Watches a filter; its messages begin with a place.
  void Add(vtkAlgorithm* filter, const std::string& where);

  /// Sets a function to call with the current step at every progress event; if it returns false,
  /// the filter is stopped, and its messages about that are dropped. Null: none.
  void SetOnProgress(const StepCallback* onProgress) { this->OnProgress = onProgress; }

  void Restart() { this->IsStopped = false; }
  void BeginStep(const std::string& step);
  const std::string& GetStep() const { return this->Step; }
  bool WasStopped() const { return this->IsStopped; }

  /// Drops the files of all other filters.
  void RemoveOthers(const std::set<vtkAlgorithm*>& used);

  /// Returns the files that all filters have opened.
  InputFiles GetInputs() const;

private:
  void HandleProgress(vtkObject* caller, unsigned long, void*);
  void HandleStart(vtkObject* caller, unsigned long, void*);
  void HandleEnd(vtkObject* caller, unsigned long, void*);

  Messages& Log;
  std::string Step; // the current one
  const StepCallback* OnProgress = nullptr;
  bool IsStopped = false;
  std::chrono::steady_clock::time_point LastProgress{};
  std::map<vtkSmartPointer<vtkAlgorithm>, InputFiles> Inputs; // by the filter that opened them
  std::optional<InputWatch> Watch;                            // while a filter runs
};

} // namespace helios

#endif
