// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMessages.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkObject.h>

namespace helios
{

namespace
{

/// Returns the text of a message without "ERROR: In file, line n", its object and trailing line
/// ends.
std::string StripOrigin(const std::string& message)
{
  const std::size_t line = message.find('\n');
  const std::size_t object = line == std::string::npos ? line : message.find("): ", line);
  std::string text = object == std::string::npos ? message : message.substr(object + 3);
  text.erase(text.find_last_not_of(" \n") + 1);
  return text;
}

constexpr std::size_t LongestShown = 200;

thread_local int NumberOfDeferrals = 0;

} // namespace

//------------------------------------------------------------------------------
std::string Shorten(const std::string& text)
{
  return text.size() <= LongestShown
    ? text
    : text.substr(0, LongestShown) + "... (" + std::to_string(text.size()) + " characters)";
}

//------------------------------------------------------------------------------
std::string JoinChoices(const std::vector<std::string>& words, const char* last)
{
  const std::string before = std::string(" ") + last + " ";
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : before) + words[i];
  }
  return text;
}

//------------------------------------------------------------------------------
Messages::DeferredMessages::DeferredMessages()
{
  ++NumberOfDeferrals;
}

//------------------------------------------------------------------------------
Messages::DeferredMessages::~DeferredMessages()
{
  --NumberOfDeferrals;
}

//------------------------------------------------------------------------------
Messages::Messages(vtkObject* owner)
  : Owner(owner)
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(Messages::Forward);
}

//------------------------------------------------------------------------------
void Messages::Restart(vtkObject* owner)
{
  this->Owner = owner;
  this->Seen.clear();
  this->LastError.clear();
  this->NumberOfErrors = 0;
}

//------------------------------------------------------------------------------
void Messages::Error(const std::string& text)
{
  if (this->IsMuted)
  {
    return;
  }
  ++this->NumberOfErrors;
  if (this->Seen.insert(text).second)
  {
    this->LastError = text;
    if (this->Owner)
    {
      vtkErrorWithObjectMacro(this->Owner, << text);
    }
  }
}

//------------------------------------------------------------------------------
void Messages::Warning(const std::string& text)
{
  this->WarnOnce(text, text);
}

//------------------------------------------------------------------------------
void Messages::WarnOnce(const std::string& key, const std::string& text)
{
  if (this->Seen.insert(key).second && this->Owner)
  {
    vtkWarningWithObjectMacro(this->Owner, << text);
  }
}

//------------------------------------------------------------------------------
void Messages::Listen(vtkObject* object, const std::string& where)
{
  this->Places[object] = where;
  object->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  object->AddObserver(vtkCommand::WarningEvent, this->Observer);
}

//------------------------------------------------------------------------------
void Messages::Listen(vtkAlgorithm* algorithm, const std::string& where)
{
  this->Listen(static_cast<vtkObject*>(algorithm), where);
  this->Listen(static_cast<vtkObject*>(algorithm->GetExecutive()), where);
}

//------------------------------------------------------------------------------
void Messages::Forward(vtkObject* caller, unsigned long event, void* self, void* data)
{
  auto* messages = static_cast<Messages*>(self);
  const Message message{ caller, event, data ? static_cast<const char*>(data) : "" };
  if (NumberOfDeferrals == 0)
  {
    messages->Report(message);
    return;
  }
  const std::lock_guard<std::mutex> lock(messages->DeferredMutex);
  messages->Deferred.push_back(message);
}

//------------------------------------------------------------------------------
void Messages::ReportDeferred()
{
  std::vector<Message> deferred;
  {
    const std::lock_guard<std::mutex> lock(this->DeferredMutex);
    deferred.swap(this->Deferred);
  }
  for (const Message& message : deferred)
  {
    this->Report(message);
  }
}

//------------------------------------------------------------------------------
void Messages::Report(const Message& message)
{
  if (this->IsMuted)
  {
    return;
  }
  const std::string& where = this->Places[message.Caller];
  const std::string text = where + (where.empty() ? "" : ": ") + StripOrigin(message.Text);
  const bool isEcho = vtkExecutive::SafeDownCast(message.Caller) &&
    text.find("returned failure") != std::string::npos;
  if (isEcho)
  {
    ++this->NumberOfErrors;
  }
  else if (message.Event == vtkCommand::ErrorEvent)
  {
    this->Error(text);
  }
  else
  {
    this->Warning(text);
  }
}

} // namespace helios
