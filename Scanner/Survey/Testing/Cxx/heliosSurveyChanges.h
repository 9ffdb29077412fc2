// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Single changes to a valid survey, and the resulting messages.

#ifndef heliosSurveyChanges_h
#define heliosSurveyChanges_h

#include "heliosSurveyFiles.h"

#include <string>
#include <vector>

namespace helios
{
namespace test
{

/// A change to a file of a valid survey, and the texts expected in messages.
struct Change
{
  std::string File;
  std::string From;
  std::string To;
  std::vector<std::string> Messages;
};

inline void CheckRefused(const Files& files, const std::vector<std::string>& messages)
{
  const Reading reading(files);
  INFO(reading.Log->Errors);
  CHECK_FALSE(reading.Good);
  CHECK(reading.Reader->GetSurvey() == nullptr);
  for (const std::string& message : messages)
  {
    INFO("missing: " << message);
    CHECK(reading.Log->HasError(message));
  }
}

/// Each change alone makes the survey invalid.
inline void CheckAllRefused(
  const char* attributes, const char* legs, const std::vector<Change>& changes)
{
  for (const Change& change : changes)
  {
    const Files files;
    REQUIRE(Reading(files, attributes, legs).Good);
    INFO(change.From << " -> " << change.To);
    files.Replace(change.File, change.From, change.To);
    CheckRefused(files, change.Messages);
  }
}

/// Each change alone causes a warning, and the survey is read.
inline void CheckAllWarned(
  const char* attributes, const char* legs, const std::vector<Change>& changes)
{
  for (const Change& change : changes)
  {
    const Files files;
    REQUIRE(Reading(files, attributes, legs).Good);
    INFO(change.From << " -> " << change.To);
    files.Replace(change.File, change.From, change.To);
    const Reading reading(files);
    INFO(reading.Log->Errors << reading.Log->Warnings);
    CHECK(reading.Good);
    for (const std::string& message : change.Messages)
    {
      INFO("missing: " << message);
      CHECK(reading.Log->HasWarning(message));
    }
  }
}

} // namespace test
} // namespace helios

#endif
