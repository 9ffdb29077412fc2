// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFilePattern.h"

#include <re2/re2.h>

#include <algorithm>
#include <filesystem>

namespace helios
{
namespace fs = std::filesystem;

namespace
{

RE2::Options MakeOptions()
{
  RE2::Options options(RE2::Latin1); // bytes, not characters
  options.set_log_errors(false);
  return options;
}

std::string MakeFault(const RE2& expression)
{
  const RE2::ErrorCode code = expression.error_code();
  const bool isUnsupported = code == RE2::ErrorBadPerlOp || code == RE2::ErrorBadEscape;
  return expression.error() +
    (isUnsupported ? " (lookahead and back references are not supported)" : "");
}

} // namespace

/// RE2, hidden from the header.
struct FilePattern::Engine
{
  explicit Engine(const std::string& text)
    : Expression(text, MakeOptions())
  {
  }

  RE2 Expression;
};

//------------------------------------------------------------------------------
FilePattern::FilePattern(const std::string& text)
{
  const std::size_t slash = text.rfind('/');
  const std::size_t start = slash == std::string::npos ? 0 : slash + 1;
  this->Folder = text.substr(0, start);
  if (text.size() - start > LongestExpression)
  {
    this->Fault = "it has " + std::to_string(text.size() - start) + " characters, and at most " +
      std::to_string(LongestExpression) + " are allowed";
    return;
  }
  this->Expression = std::make_unique<Engine>(text.substr(start));
  if (!this->Expression->Expression.ok())
  {
    this->Fault = MakeFault(this->Expression->Expression);
  }
}

//------------------------------------------------------------------------------
FilePattern::~FilePattern() = default;

//------------------------------------------------------------------------------
bool FilePattern::FindFiles(
  const std::string& folder, std::vector<std::string>& files, std::size_t maximum) const
{
  std::vector<std::string> found;
  std::size_t count = 0;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored))
  {
    if (++count > maximum)
    {
      return false;
    }
    const std::string name = entry->path().filename().string();
    if (RE2::FullMatch(name, this->Expression->Expression) && !entry->is_directory(ignored))
    {
      found.push_back(entry->path().string());
    }
  }
  std::sort(found.begin(), found.end());
  files.insert(files.end(), found.begin(), found.end());
  return true;
}

} // namespace helios
