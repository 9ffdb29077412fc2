// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Collects the errors and warnings of an object for checks in a test.

#ifndef heliosErrorObserver_h
#define heliosErrorObserver_h

#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkObject.h>

#include <string>

namespace helios
{

class ErrorObserver : public vtkCommand
{
public:
  static ErrorObserver* New() { return new ErrorObserver; }

  void Execute(vtkObject*, unsigned long event, void* text) override
  {
    const char* message = static_cast<const char*>(text);
    std::string& log = event == vtkCommand::ErrorEvent ? this->Errors : this->Warnings;
    log += message ? message : "";
  }

  /// Observes an object from here on.
  void Watch(vtkObject* object)
  {
    object->AddObserver(vtkCommand::ErrorEvent, this);
    object->AddObserver(vtkCommand::WarningEvent, this);
  }

  bool HasError(const std::string& part) const
  {
    return this->Errors.find(part) != std::string::npos;
  }
  bool HasWarning(const std::string& part) const
  {
    return this->Warnings.find(part) != std::string::npos;
  }
  void Clear()
  {
    this->Errors.clear();
    this->Warnings.clear();
  }

  std::string Errors;
  std::string Warnings;
};

} // namespace helios

#endif
