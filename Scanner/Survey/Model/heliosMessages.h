// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Errors and warnings on behalf of one VTK object: its own, and messages of the objects that it
// runs.

#ifndef heliosMessages_h
#define heliosMessages_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkCallbackCommand.h>
#include <vtkNew.h>

#include <map>
#include <mutex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkObject;

namespace helios
{

/// A message stream: numbers are formatted as a user would type them.
class MessageBuilder : public std::ostringstream
{
public:
  MessageBuilder() { this->precision(15); }
};

/// Joins words: "a, b and c".
VTKHELIOSSCANNERSURVEY_EXPORT std::string JoinChoices(
  const std::vector<std::string>& words, const char* last = "and");

/// Shortens a value that may be long for messages.
std::string Shorten(const std::string& text);

/// Reports through the owner's error and warning events; the same text only once. Without an owner,
/// errors are counted only.
class VTKHELIOSSCANNERSURVEY_EXPORT Messages
{
public:
  explicit Messages(vtkObject* owner);
  ~Messages() { this->Observer->SetCallback(nullptr); }
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  void Error(const std::string& text);
  void Warning(const std::string& text);

  /// Warns unless there was a warning with this key before.
  void WarnOnce(const std::string& key, const std::string& text);

  /// Mutes errors: none is reported or counted, for a run that is stopped on request.
  void Mute(bool isMuted) { this->IsMuted = isMuted; }

  /// Forgets all messages, and reports the next ones for another owner.
  void Restart(vtkObject* owner);

  bool HasError() const { return this->NumberOfErrors > 0; }

  /// Counts repeated errors too, so that a change shows that something failed.
  int GetNumberOfErrors() const { return this->NumberOfErrors; }

  /// Returns the last error; empty: none.
  const std::string& GetLastError() const { return this->LastError; }

  /// While one exists, messages of the objects listened to that the calling thread causes are
  /// deferred: observers may need a lock that the thread of the run holds, such as Python's.
  class DeferredMessages
  {
  public:
    DeferredMessages();
    ~DeferredMessages();
    DeferredMessages(const DeferredMessages&) = delete;
    void operator=(const DeferredMessages&) = delete;
  };

  /// Reports the deferred messages, in their order.
  void ReportDeferred();

  /// Makes the owner report what this object reports from now on, with the current place
  /// (file:line), if any, in front. Messages of an algorithm's executive that only repeat the
  /// algorithm's error are dropped.
  void Listen(vtkObject* object, const std::string& where = {});
  void Listen(vtkAlgorithm* algorithm, const std::string& where = {});

private:
  struct Message
  {
    vtkObject* Caller;
    unsigned long Event;
    std::string Text;
  };

  static void Forward(vtkObject*, unsigned long event, void* self, void* text);
  void Report(const Message& message);

  vtkObject* Owner;
  vtkNew<vtkCallbackCommand> Observer;
  std::set<std::string> Seen;
  std::map<vtkObject*, std::string> Places;
  std::string LastError;
  int NumberOfErrors = 0;
  bool IsMuted = false;
  std::mutex DeferredMutex;
  std::vector<Message> Deferred;
};

} // namespace helios

#endif
