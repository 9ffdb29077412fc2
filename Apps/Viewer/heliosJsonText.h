// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// JSON from a stream, with what is wrong in words: never an exception.

#ifndef heliosJsonText_h
#define heliosJsonText_h

#include <json/json.h>

#include <istream>
#include <string>

namespace helios
{

/// False, with a problem in words, where a stream is no JSON, or nested too deeply.
inline bool ReadJson(std::istream& stream, Json::Value& value, std::string& problem)
{
  try
  {
    return Json::parseFromStream(Json::CharReaderBuilder(), stream, &value, &problem);
  }
  catch (const Json::Exception& error) // more than 1000 brackets within one another
  {
    problem = error.what();
    return false;
  }
}

} // namespace helios

#endif
