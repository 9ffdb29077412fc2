// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosViewerKeys.h"

#include "heliosViewerTool.h"

#include <algorithm>

namespace helios::viewer
{

namespace
{

constexpr std::size_t KeyWidth = 16;

/// The lines as a column of equal lengths: they are centred as one block.
std::string JoinColumns(const std::vector<std::string>& lines)
{
  std::size_t width = 0;
  for (const std::string& line : lines)
  {
    width = std::max(width, line.size() + 1);
  }
  std::string text;
  for (const std::string& line : lines)
  {
    text += line + std::string(width - line.size(), ' ') + "\n";
  }
  return text;
}

} // namespace

//------------------------------------------------------------------------------
bool ViewerKeys::Press(const std::string& key, bool control)
{
  for (const auto& tool : this->Tools)
  {
    if (tool->OnKey(key, control))
    {
      return true;
    }
  }
  for (const Action& action : this->Actions)
  {
    if (!control && std::find(action.Keys.begin(), action.Keys.end(), key) != action.Keys.end())
    {
      action.Do();
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::string ViewerKeys::GetHelp() const
{
  std::vector<std::string> lines;
  const auto add = [&lines](const std::string& key, const std::string& what)
  {
    const std::size_t gap = key.size() < KeyWidth ? KeyWidth - key.size() : 1;
    lines.push_back("   " + key + std::string(gap, ' ') + what);
  };
  for (const Action& action : this->Actions)
  {
    if (!action.Heading.empty())
    {
      lines.push_back(" " + action.Heading);
    }
    add(action.Shown, action.What);
  }
  for (const auto& tool : this->Tools)
  {
    lines.push_back(" " + tool->GetName());
    for (const KeyHelp& key : tool->GetKeys())
    {
      add(key.first, key.second);
    }
  }
  return JoinColumns(lines);
}

} // namespace helios::viewer
