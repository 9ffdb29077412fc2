// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A JSON file, and the lines of its values.

#ifndef heliosJsonFile_h
#define heliosJsonFile_h

#include "heliosStatus.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace Json
{
class Value;
}

namespace helios
{

/// Parses with jsoncpp, strictly: no comments, no duplicate keys, nothing after the value.
class JsonFile
{
public:
  JsonFile();
  ~JsonFile();
  JsonFile(const JsonFile&) = delete;
  void operator=(const JsonFile&) = delete;

  /// Reads a file; a root that is no object is an error.
  Status Read(const std::string& path);

  /// Parses a text that comes from a file, from a line on.
  Status Parse(const std::string& path, std::string text, std::int64_t line = 1);

  const Json::Value& GetRoot() const { return *this->Root; }
  const std::string& GetPath() const { return this->Path; }

  /// Returns "path:line: " of a value.
  std::string GetPlace(const Json::Value& value) const;

private:
  std::string Path;
  std::string Text;
  std::int64_t Line = 1;
  std::unique_ptr<Json::Value> Root;
};

/// @{
/// Returns a member of an object; null if it is missing, or the value is no object.
const Json::Value& GetMember(const Json::Value& value, const char* name);
std::string GetText(const Json::Value& value, const char* name); // empty if it is no text
///@}

/// Returns whether a value is a list of finite numbers.
bool ReadNumbers(const Json::Value& value, double* numbers, std::size_t count);

/// Returns a whole number from 0 to below a limit; -1: something else.
std::int64_t ReadIndex(const Json::Value& value, std::int64_t limit);

/// Returns a value in a message: short, without line ends.
std::string Describe(const Json::Value& value);

} // namespace helios

#endif
