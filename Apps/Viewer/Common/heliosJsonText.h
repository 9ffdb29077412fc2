// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads JSON from a stream, with error messages: never an exception.

#ifndef heliosJsonText_h
#define heliosJsonText_h

#include <json/json.h>

#include <istream>
#include <string>

namespace helios::viewer
{

/// Returns false and sets a problem if a stream is not JSON, or nested too deeply.
inline bool ReadJson(std::istream& stream, Json::Value& value, std::string& problem)
{
  try
  {
    return Json::parseFromStream(Json::CharReaderBuilder(), stream, &value, &problem);
  }
  catch (const Json::Exception& error) // more than 1000 nested brackets
  {
    problem = error.what();
    return false;
  }
}

} // namespace helios::viewer

#endif
