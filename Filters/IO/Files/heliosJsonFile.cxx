// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosJsonFile.h"

#include "heliosFileBytes.h"
#include "heliosLineFile.h"
#include "heliosTextFile.h"

#include <json/json.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace helios
{

namespace
{

constexpr double BytesPerByte = 65.0; // memory per byte of a file; measured: 25 to 64

/// Makes an error with line and words from "* Line 3, Column 5 Missing ',' ...".
Status DescribeFault(const std::string& path, const std::string& errors, std::int64_t first)
{
  int line = 0;
  int column = 0;
  if (std::sscanf(errors.c_str(), "* Line %d, Column %d", &line, &column) != 2)
  {
    return Status::Error(path + ": is not valid JSON; write it again");
  }
  const std::size_t begin = std::min(errors.find('\n'), errors.size());
  const std::string rest = errors.substr(std::min(begin + 1, errors.size()));
  std::string words = rest.substr(0, rest.find('\n'));
  words.erase(0, std::min(words.find_first_not_of(' '), words.size()));
  return Status::Error(Place(path, first - 1 + line) + "is not valid JSON at column " +
    std::to_string(column) + ": " + words + "; correct it, or write the file again");
}

} // namespace

//------------------------------------------------------------------------------
JsonFile::JsonFile()
  : Root(std::make_unique<Json::Value>())
{
}

//------------------------------------------------------------------------------
JsonFile::~JsonFile() = default;

//------------------------------------------------------------------------------
Status JsonFile::Read(const std::string& path)
{
  std::string text;
  const Status status = ReadBytes(path, BytesPerByte, text);
  return status.IsOk() ? this->Parse(path, std::move(text)) : status;
}

//------------------------------------------------------------------------------
Status JsonFile::Parse(const std::string& path, std::string text, std::int64_t line)
{
  this->Line = line;
  this->Path = path;
  this->Text = std::move(text);
  Json::CharReaderBuilder builder;
  Json::CharReaderBuilder::strictMode(&builder.settings_);
  builder["skipBom"] = true;
  const std::unique_ptr<Json::CharReader> reader(builder.newCharReader());
  std::string errors;
  try
  {
    const char* begin = this->Text.data();
    if (!reader->parse(begin, begin + this->Text.size(), this->Root.get(), &errors))
    {
      return DescribeFault(path, errors, line);
    }
  }
  catch (const Json::Exception& fault) // nested too deep
  {
    return Status::Error(path + ": is not valid JSON: " + fault.what() + "; write it again");
  }
  return this->Root->isObject()
    ? Status()
    : Status::Error(path + ": is JSON, but no object; check the name of the file");
}

//------------------------------------------------------------------------------
std::string JsonFile::GetPlace(const Json::Value& value) const
{
  const auto at = std::clamp<std::ptrdiff_t>(
    value.getOffsetStart(), 0, static_cast<std::ptrdiff_t>(this->Text.size()));
  return Place(
    this->Path, this->Line + std::count(this->Text.begin(), this->Text.begin() + at, '\n'));
}

//------------------------------------------------------------------------------
const Json::Value& GetMember(const Json::Value& value, const char* name)
{
  return value.isObject() ? value[name] : Json::Value::nullSingleton();
}

//------------------------------------------------------------------------------
std::string GetText(const Json::Value& value, const char* name)
{
  const Json::Value& member = GetMember(value, name);
  return member.isString() ? member.asString() : "";
}

//------------------------------------------------------------------------------
bool ReadNumbers(const Json::Value& value, double* numbers, std::size_t count)
{
  if (!value.isArray() || value.size() != count)
  {
    return false;
  }
  for (const Json::Value& each : value)
  {
    if (!each.isNumeric() || !std::isfinite(each.asDouble()))
    {
      return false;
    }
    *numbers++ = each.asDouble();
  }
  return true;
}

//------------------------------------------------------------------------------
std::int64_t ReadIndex(const Json::Value& value, std::int64_t limit)
{
  return value.isInt64() && value.asInt64() >= 0 && value.asInt64() < limit ? value.asInt64() : -1;
}

//------------------------------------------------------------------------------
std::string Describe(const Json::Value& value)
{
  if (value.isArray() || value.isObject())
  {
    return value.isArray() ? "a list of " + std::to_string(value.size()) : "an object";
  }
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "";
  builder["emitUTF8"] = true;
  const std::string text = value.isString() ? value.asString() : Json::writeString(builder, value);
  return value.isString() ? Quote(text) : text.substr(0, 40);
}

} // namespace helios
