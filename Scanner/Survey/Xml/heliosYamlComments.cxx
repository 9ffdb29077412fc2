// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosYamlComments.h"

#include <algorithm>
#include <sstream>

namespace helios
{

//------------------------------------------------------------------------------
YamlComments::YamlComments(const std::string& text)
{
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    line.erase(line.find_last_not_of(" \t\r") + 1);
    this->Lines.push_back(line);
  }
}

//------------------------------------------------------------------------------
void YamlComments::Add(pugi::xml_node parent, std::size_t end, std::size_t column)
{
  std::string text;
  const auto add = [&]()
  {
    if (!text.empty())
    {
      const bool isLine = text.find('\n', 1) == std::string::npos;
      text = isLine ? text.substr(1) + " " : text + "\n";
      parent.append_child(pugi::node_comment).set_value(text.c_str());
      text.clear();
    }
  };
  for (; this->NextLine < std::min(end, this->Lines.size()); ++this->NextLine)
  {
    const std::string& line = this->Lines[this->NextLine];
    const std::size_t start = line.find_first_not_of(" \t");
    const bool isComment = !line.empty() && line[start] == '#';
    if (isComment && start < column)
    {
      break;
    }
    if (!isComment)
    {
      add();
      continue;
    }
    const std::size_t from = start + (line.compare(start, 2, "# ") == 0 ? 2 : 1);
    text += "\n " + line.substr(from);
  }
  add();
}

//------------------------------------------------------------------------------
void YamlComments::AddHead(pugi::xml_node parent, std::size_t end)
{
  while (end > 0 && !this->Lines[end - 1].empty())
  {
    --end;
  }
  this->Add(parent, end);
}

//------------------------------------------------------------------------------
void YamlComments::Pass(const yaml_node_t& scalar)
{
  const yaml_mark_t& end = scalar.end_mark;
  this->NextLine = std::max(this->NextLine, end.line + (end.column > 0 ? 1 : 0));
}

} // namespace helios
