// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Collects the errors of a VTK object.

#ifndef heliosErrorText_h
#define heliosErrorText_h

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkWeakPointer.h>

#include <string>

namespace helios::viewer
{

/// Returns a message of VTK without its file, line and object.
inline std::string StripOrigin(const std::string& message)
{
  const std::size_t object = message.find("): ");
  std::string text = object == std::string::npos ? message : message.substr(object + 3);
  text.erase(text.find_last_not_of(" \n") + 1);
  return text;
}

/// Keeps the errors of an object, one per line, without VTK's prefix. Errors of the pipeline of an
/// algorithm are dropped.
class ErrorText
{
public:
  explicit ErrorText(vtkObject* object)
    : Object(object)
  {
    this->Observer->SetClientData(this);
    this->Observer->SetCallback(Append);
    this->Tag = object->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    if (auto* algorithm = vtkAlgorithm::SafeDownCast(object))
    {
      this->Nobody->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
      this->Executive = algorithm->GetExecutive();
      this->ExecutiveTag = this->Executive->AddObserver(vtkCommand::ErrorEvent, this->Nobody);
    }
  }
  ~ErrorText()
  {
    if (this->Executive)
    {
      this->Executive->RemoveObserver(this->ExecutiveTag);
    }
    if (this->Object)
    {
      this->Object->RemoveObserver(this->Tag);
    }
  }
  ErrorText(const ErrorText&) = delete;
  void operator=(const ErrorText&) = delete;

  bool IsEmpty() const { return this->Text.empty(); }

  /// Returns the errors; without any, a replacement text.
  std::string Get(const std::string& instead) const
  {
    return this->Text.empty() ? instead : this->Text;
  }

private:
  static void Append(vtkObject*, unsigned long, void* self, void* text)
  {
    std::string& kept = static_cast<ErrorText*>(self)->Text;
    kept += (kept.empty() ? "" : "\n") + StripOrigin(static_cast<const char*>(text));
  }

  vtkWeakPointer<vtkObject> Object;
  vtkWeakPointer<vtkObject> Executive;
  vtkNew<vtkCallbackCommand> Observer;
  vtkNew<vtkCallbackCommand> Nobody;
  unsigned long Tag = 0;
  unsigned long ExecutiveTag = 0;
  std::string Text;
};

} // namespace helios::viewer

#endif
