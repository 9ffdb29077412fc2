// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Errors and warnings on behalf of one VTK object: its own, and those of the objects it runs.

#ifndef heliosMessages_h
#define heliosMessages_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkCallbackCommand.h>
#include <vtkNew.h>

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkObject;

namespace helios
{

/// A text in the making: numbers come out as they would be typed.
class Sentence : public std::ostringstream
{
public:
  Sentence() { this->precision(15); }
};

/// "a, b and c".
std::string Enumerate(const std::vector<std::string>& words);

/// What messages show of a value that may be long.
std::string Shorten(const std::string& text);

/// Reports through the owner's error and warning events; the same text only once.
class VTKHELIOSSCANNERSURVEY_EXPORT Messages
{
public:
  explicit Messages(vtkObject* owner);
  ~Messages() { this->Observer->SetCallback(nullptr); }
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  void Error(const std::string& text);
  void Warning(const std::string& text);

  /// Warns unless something with this key was warned of before.
  void WarnOnce(const std::string& key, const std::string& text);

  /// While muted no error is reported, nor counted: of what is stopped on request.
  void Mute(bool isMuted) { this->IsMuted = isMuted; }

  bool HasError() const { return this->NumberOfErrors > 0; }

  /// So far, those that were told before counted again: what has failed since shows by it.
  int GetNumberOfErrors() const { return this->NumberOfErrors; }

  /// The last error; empty: none.
  const std::string& GetLastError() const { return this->LastError; }

  /// From here on, what this object reports is reported by the owner, with the place (file:line)
  /// that it works for in front, if any. Of an algorithm's executive only what is no echo of the
  /// algorithm's own error.
  void Listen(vtkObject* object, const std::string& where = {});
  void Listen(vtkAlgorithm* algorithm, const std::string& where = {});

private:
  static void Forward(vtkObject*, unsigned long event, void* self, void* text);

  vtkObject* Owner;
  vtkNew<vtkCallbackCommand> Observer;
  std::set<std::string> Seen;
  std::map<vtkObject*, std::string> Places;
  std::string LastError;
  int NumberOfErrors = 0;
  bool IsMuted = false;
};

} // namespace helios

#endif
