// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosYamlFile.h"

#include "heliosXmlElement.h"

#include <algorithm>
#include <new>

namespace helios
{

namespace
{

constexpr int MaximumLevels = 4 * DocumentDepth;
constexpr int MaximumAnchors = 1000;

Status MakeError(std::size_t line, const std::string& text)
{
  return Status::Error(std::to_string(line + 1) + ": " + text);
}

} // namespace

//------------------------------------------------------------------------------
YamlFile::YamlFile(const std::string& text)
  : Text(text)
{
  if (!yaml_parser_initialize(&this->Parser))
  {
    throw std::bad_alloc();
  }
  yaml_parser_set_encoding(&this->Parser, YAML_UTF8_ENCODING);
  yaml_parser_set_input_string(
    &this->Parser, reinterpret_cast<const unsigned char*>(text.data()), text.size());
}

//------------------------------------------------------------------------------
YamlFile::~YamlFile()
{
  yaml_document_delete(&this->Document);
  yaml_parser_delete(&this->Parser);
}

//------------------------------------------------------------------------------
Status YamlFile::Load()
{
  yaml_document_delete(&this->Document);
  return yaml_parser_load(&this->Parser, &this->Document) ? Status() : this->FindFault();
}

//------------------------------------------------------------------------------
Status YamlFile::Check(const std::string& text)
{
  YamlFile file(text);
  int levels = 0;
  int anchors = 0;
  for (bool isEnd = false; !isEnd;)
  {
    yaml_event_t event;
    if (!file.Parse(event, levels, anchors))
    {
      return file.FindFault();
    }
    const std::size_t line = event.start_mark.line;
    isEnd = event.type == YAML_STREAM_END_EVENT;
    yaml_event_delete(&event);
    if (levels > MaximumLevels)
    {
      return MakeError(line,
        "elements are nested more than " + std::to_string(DocumentDepth) + " times; nest fewer");
    }
    if (anchors > MaximumAnchors)
    {
      return MakeError(line,
        "there are more than " + std::to_string(MaximumAnchors) +
          " anchors; give elements a template instead");
    }
  }
  return {};
}

//------------------------------------------------------------------------------
/// Parses an event, and counts levels and anchors; false after an error.
bool YamlFile::Parse(yaml_event_t& event, int& levels, int& anchors)
{
  if (!yaml_parser_parse(&this->Parser, &event))
  {
    return false;
  }
  switch (event.type)
  {
    case YAML_MAPPING_START_EVENT:
      ++levels;
      anchors += event.data.mapping_start.anchor ? 1 : 0;
      break;
    case YAML_SEQUENCE_START_EVENT:
      ++levels;
      anchors += event.data.sequence_start.anchor ? 1 : 0;
      break;
    case YAML_SCALAR_EVENT:
      anchors += event.data.scalar.anchor ? 1 : 0;
      break;
    case YAML_MAPPING_END_EVENT:
    case YAML_SEQUENCE_END_EVENT:
      --levels;
      break;
    default:
      break;
  }
  return true;
}

//------------------------------------------------------------------------------
/// Returns what the parser did not understand.
Status YamlFile::FindFault() const
{
  const yaml_parser_t& parser = this->Parser;
  if (parser.error == YAML_MEMORY_ERROR)
  {
    throw std::bad_alloc();
  }
  const std::string problem = parser.problem ? parser.problem : "it is not valid";
  if (parser.error == YAML_READER_ERROR)
  {
    const std::size_t end = std::min(parser.problem_offset, this->Text.size());
    const auto lines =
      std::count(this->Text.begin(), this->Text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    return MakeError(static_cast<std::size_t>(lines),
      "the text is not valid: " + problem + "; save the file as UTF-8");
  }
  const std::string context = parser.context ? std::string(" ") + parser.context : std::string();
  return MakeError(parser.problem_mark.line,
    "this is not YAML: " + problem + context +
      "; indent by blanks, write key: value, and quote texts with other characters");
}

} // namespace helios
