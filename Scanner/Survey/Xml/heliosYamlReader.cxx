// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosYamlReader.h"

#include "heliosMessages.h"
#include "heliosXmlElement.h"
#include "heliosXmlKin.h"

#include <yaml.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <new>
#include <set>
#include <sstream>
#include <vector>

namespace helios
{

namespace
{

/// What aliases may repeat: so many values for each of the file, besides the first ones.
constexpr std::size_t AliasFactor = 10;
constexpr std::size_t AliasFree = 100000;

// What the library takes time for: it looks at all open brackets and all anchors again and again.
constexpr int MaximumLevels = 4 * YamlDepth;
constexpr int MaximumAnchors = 1000;

/// The parser of the library, and the document that it has loaded.
class YamlFile
{
public:
  explicit YamlFile(const std::string& text)
  {
    if (!yaml_parser_initialize(&this->Parser))
    {
      throw std::bad_alloc();
    }
    yaml_parser_set_encoding(&this->Parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(
      &this->Parser, reinterpret_cast<const unsigned char*>(text.data()), text.size());
  }
  ~YamlFile()
  {
    yaml_document_delete(&this->Document);
    yaml_parser_delete(&this->Parser);
  }
  YamlFile(const YamlFile&) = delete;
  void operator=(const YamlFile&) = delete;

  /// Loads the next document, whose root is null after the last one.
  bool Load()
  {
    yaml_document_delete(&this->Document);
    return yaml_parser_load(&this->Parser, &this->Document) != 0;
  }

  /// Parses what Load() does not; false after an error, or if it has too many levels or anchors.
  bool ParseAll()
  {
    for (bool isEnd = false; !isEnd;)
    {
      yaml_event_t event;
      if (!yaml_parser_parse(&this->Parser, &event))
      {
        return false;
      }
      const bool isMapping = event.type == YAML_MAPPING_START_EVENT;
      const bool isList = event.type == YAML_SEQUENCE_START_EVENT;
      const bool isText = event.type == YAML_SCALAR_EVENT;
      const auto* anchor = isMapping ? event.data.mapping_start.anchor
        : isList                     ? event.data.sequence_start.anchor
        : isText                     ? event.data.scalar.anchor
                                     : nullptr;
      const bool isClosed =
        event.type == YAML_MAPPING_END_EVENT || event.type == YAML_SEQUENCE_END_EVENT;
      this->Levels += isMapping || isList ? 1 : isClosed ? -1 : 0;
      this->Anchors += anchor ? 1 : 0;
      this->Line = event.start_mark.line;
      isEnd = event.type == YAML_STREAM_END_EVENT;
      yaml_event_delete(&event);
      if (this->Levels > MaximumLevels || this->Anchors > MaximumAnchors)
      {
        return false;
      }
    }
    return true;
  }

  yaml_parser_t Parser{};
  yaml_document_t Document{};
  int Levels = 0;
  int Anchors = 0;
  std::size_t Line = 0; ///< of the last event
};

std::string GetText(const yaml_node_t& node)
{
  return { reinterpret_cast<const char*>(node.data.scalar.value), node.data.scalar.length };
}

/// Returns whether a value is not given: empty, ~ or null without quotes.
bool IsNull(const yaml_node_t& node)
{
  static const std::set<std::string> nulls = { "", "~", "null", "Null", "NULL" };
  return node.type == YAML_SCALAR_NODE && node.data.scalar.style == YAML_PLAIN_SCALAR_STYLE &&
    nulls.count(GetText(node)) > 0;
}

bool IsName(const std::string& text)
{
  const auto isGood = [](unsigned char c)
  { return std::isalnum(c) || c >= 0x80 || c == '_' || c == ':' || c == '-' || c == '.'; };
  return !text.empty() && std::all_of(text.begin(), text.end(), isGood) &&
    text.find_first_of("0123456789-.") != 0;
}

/// Returns whether a text has characters that XML cannot have.
bool HasControls(const std::string& text)
{
  return std::any_of(text.begin(), text.end(),
    [](unsigned char c) { return c < ' ' && c != '\t' && c != '\n' && c != '\r'; });
}

bool HasOwnTag(const yaml_node_t& node)
{
  const std::string tag = reinterpret_cast<const char*>(node.tag);
  return tag != YAML_STR_TAG && tag != YAML_MAP_TAG && tag != YAML_SEQ_TAG;
}

/// Returns the type of a parameter as HELIOS files have it.
const char* NameType(XmlKind kind)
{
  switch (kind)
  {
    case XmlKind::Real:
      return "double";
    case XmlKind::Integer:
      return "integer";
    case XmlKind::Boolean:
      return "boolean";
    case XmlKind::Vector:
      return "vec3";
    case XmlKind::Rotation:
      return "rotation";
    default:
      return "string";
  }
}

/// Makes the tree of a document.
class YamlReader
{
public:
  YamlReader(const std::string& text, XmlDocument& document);
  bool Read();

private:
  struct Element
  {
    pugi::xml_node Node;
    const XmlElementRule* Rule; // null: unknown
  };

  bool CheckAll();
  bool ReadFault(const yaml_parser_t& parser);
  void ReadMapping(const Element& element, const yaml_node_t& mapping);
  void ReadEntry(const Element& element, const yaml_node_t& key, const yaml_node_t& value);
  void ReadChildren(const Element& element, const yaml_node_t& list);
  void ReadList(const Element& element, const yaml_node_t& key, const yaml_node_t& list);
  void AddElement(const Element& element, const yaml_node_t& key, const yaml_node_t& content,
    const yaml_mark_t& mark);
  void AddText(const Element& element, const yaml_node_t& key, const std::string& text);
  bool CheckKey(const Element& element, const yaml_node_t& key);
  bool Enter(const yaml_node_t& node);
  void AddComments(pugi::xml_node parent, std::size_t end, std::size_t column = 0);
  void Pass(const yaml_node_t& scalar);
  void SetLine(const void* object, const std::string& name, const yaml_mark_t& mark);
  void Error(std::size_t line, const std::string& text);
  const yaml_node_t& Get(int index) { return *yaml_document_get_node(&this->File.Document, index); }

  const std::string& Text;
  XmlDocument& Result;
  YamlFile File;
  std::vector<std::string> Lines;
  std::size_t NextLine = 0;    // the first one that was not read, for comments
  std::vector<bool> Seen;      // values, by their numbers
  std::set<std::string> Names; // of elements in the last line
  std::size_t LastLine = 0;
  std::size_t Repeated = 0; // values that aliases repeat
  std::size_t Largest = 0;
  int Depth = 0;
  bool IsRefused = false;
};

//------------------------------------------------------------------------------
YamlReader::YamlReader(const std::string& text, XmlDocument& document)
  : Text(text)
  , Result(document)
  , File(text)
{
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    line.erase(line.find_last_not_of(" \t\r") + 1);
    this->Lines.push_back(line);
  }
}

//------------------------------------------------------------------------------
/// Checks the whole text, before a document is made of it.
bool YamlReader::CheckAll()
{
  YamlFile all(this->Text);
  if (all.ParseAll())
  {
    return true;
  }
  if (all.Levels > MaximumLevels)
  {
    this->Error(all.Line,
      "elements are nested more than " + std::to_string(YamlDepth) + " times; nest fewer");
    return false;
  }
  if (all.Anchors > MaximumAnchors)
  {
    this->Error(all.Line,
      "there are more than " + std::to_string(MaximumAnchors) +
        " anchors; give elements a template instead");
    return false;
  }
  return this->ReadFault(all.Parser);
}

//------------------------------------------------------------------------------
bool YamlReader::Read()
{
  if (!this->CheckAll())
  {
    return false;
  }
  if (!this->File.Load())
  {
    return this->ReadFault(this->File.Parser);
  }
  const yaml_node_t* root = yaml_document_get_root_node(&this->File.Document);
  if (!root || root->type != YAML_MAPPING_NODE || HasOwnTag(*root))
  {
    this->Error(root ? root->start_mark.line : 0,
      "the file is not a mapping; begin with the name of an element, as in survey: {name: yard}");
    return false;
  }
  const auto& nodes = this->File.Document.nodes;
  this->Seen.resize(static_cast<std::size_t>(nodes.top - nodes.start));
  this->Largest = AliasFree + AliasFactor * this->Seen.size();
  pugi::xml_document& tree = this->Result.GetTree();
  std::size_t head = root->start_mark.line; // comments above a blank line are those of the file
  while (head > 0 && !this->Lines[head - 1].empty())
  {
    --head;
  }
  this->AddComments(tree, head);
  const Element document{ tree.append_child("document"), FindXmlRule("document") };
  this->SetLine(document.Node.internal_object(), "document", root->start_mark);
  this->ReadMapping(document, *root);
  this->AddComments(document.Node, this->Lines.size());
  if (this->IsRefused)
  {
    return false;
  }
  if (!this->File.Load())
  {
    return this->ReadFault(this->File.Parser);
  }
  if (const yaml_node_t* second = yaml_document_get_root_node(&this->File.Document))
  {
    this->Error(second->start_mark.line, "a second document; put everything into one");
  }
  return true;
}

//------------------------------------------------------------------------------
/// Reports what the parser did not understand. Always false.
bool YamlReader::ReadFault(const yaml_parser_t& parser)
{
  if (parser.error == YAML_MEMORY_ERROR)
  {
    throw std::bad_alloc();
  }
  const std::string problem = parser.problem ? parser.problem : "it is not valid";
  if (parser.error == YAML_READER_ERROR)
  {
    const auto end = this->Text.begin() +
      static_cast<std::ptrdiff_t>(std::min(parser.problem_offset, this->Text.size()));
    this->Error(static_cast<std::size_t>(std::count(this->Text.begin(), end, '\n')),
      "the text is not valid: " + problem + "; save the file as UTF-8");
    return false;
  }
  const std::string context = parser.context ? std::string(" ") + parser.context : std::string();
  this->Error(parser.problem_mark.line,
    "this is not YAML: " + problem + context +
      "; indent by blanks, write key: value, and quote texts with other characters");
  return false;
}

//------------------------------------------------------------------------------
void YamlReader::ReadMapping(const Element& element, const yaml_node_t& mapping)
{
  std::map<std::string, std::size_t> lines; // of keys
  const auto& pairs = mapping.data.mapping.pairs;
  for (const yaml_node_pair_t* pair = pairs.start; pair != pairs.top && !this->IsRefused; ++pair)
  {
    const yaml_node_t& key = this->Get(pair->key);
    if (!this->CheckKey(element, key))
    {
      continue;
    }
    this->AddComments(element.Node, key.start_mark.line);
    this->Pass(key);
    const auto [before, isNew] = lines.emplace(GetText(key), key.start_mark.line);
    if (!isNew)
    {
      this->Error(key.start_mark.line,
        "<" + std::string(element.Node.name()) + "> has " + before->first +
          " twice, first in line " + std::to_string(before->second + 1) +
          "; leave one of them, or make a list of both");
      continue;
    }
    const yaml_node_t& value = this->Get(pair->value);
    if (this->Enter(value))
    {
      this->ReadEntry(element, key, value);
      --this->Depth;
    }
  }
  this->AddComments(element.Node, mapping.end_mark.line, mapping.start_mark.column);
}

//------------------------------------------------------------------------------
bool YamlReader::CheckKey(const Element& element, const yaml_node_t& key)
{
  const std::string name = key.type == YAML_SCALAR_NODE ? GetText(key) : std::string();
  const bool isParameter = element.Rule && IsFilterRule(*element.Rule);
  if (name == "<<")
  {
    this->Error(key.start_mark.line,
      "<<: keys are not merged; repeat a whole element by an alias, or give it a template");
    return false;
  }
  if (!(isParameter ? !name.empty() && !HasControls(name) : IsName(name)))
  {
    this->Error(key.start_mark.line,
      "\"" + Shorten(name) + "\" in <" + element.Node.name() +
        "> is not a name; names have letters, digits and _");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
/// Checks a value before it is read, and goes a level down; false after an error.
bool YamlReader::Enter(const yaml_node_t& node)
{
  const std::size_t line = node.start_mark.line;
  const auto number = static_cast<std::size_t>(&node - this->File.Document.nodes.start);
  this->Repeated += this->Seen[number] ? 1 : 0;
  this->Seen[number] = true;
  if (this->Depth >= YamlDepth)
  {
    this->Error(line,
      "elements are nested more than " + std::to_string(YamlDepth) +
        " times, or an alias is inside of what it repeats; nest fewer");
    this->IsRefused = true;
  }
  else if (this->Repeated > this->Largest)
  {
    this->Error(line,
      "aliases repeat more than " + std::to_string(this->Largest) + " values; write fewer of them");
    this->IsRefused = true;
  }
  else if (HasOwnTag(node))
  {
    this->Error(line,
      "the tag " + Shorten(reinterpret_cast<const char*>(node.tag)) +
        " is not read; remove it, kinds of values follow from their names");
    return false;
  }
  else if (node.type == YAML_SCALAR_NODE && HasControls(GetText(node)))
  {
    this->Error(line, "the text has a control character; remove it");
    return false;
  }
  this->Depth += this->IsRefused ? 0 : 1;
  return !this->IsRefused;
}

//------------------------------------------------------------------------------
void YamlReader::ReadEntry(const Element& element, const yaml_node_t& key, const yaml_node_t& value)
{
  const std::string name = GetText(key);
  const std::string owner = element.Node.name();
  const XmlElementRule* rule = element.Rule;
  const XmlKin kin = rule ? FindXmlKin(*rule, name) : XmlKin();
  const XmlValueRule* own = rule && !kin.Rule ? rule->FindValue(name) : nullptr;
  if (name == YamlChildren)
  {
    this->ReadChildren(element, value);
  }
  else if (value.type == YAML_SEQUENCE_NODE)
  {
    this->ReadList(element, key, value);
  }
  else if (value.type == YAML_SCALAR_NODE && !IsNull(value))
  {
    this->Pass(value);
    kin.Rule ? this->Error(key.start_mark.line,
                 name + " of <" + owner + "> is an element, not a value; give its keys below it, " +
                   "or {} for none")
             : this->AddText(element, key, GetText(value));
  }
  else if (own)
  {
    this->Pass(value);
    this->Error(key.start_mark.line,
      name + " of <" + owner + "> " +
        (IsNull(value) ? "has no value; give one, in quotes if it begins with #, or remove the line"
                       : "is one value; give it instead of keys below it"));
  }
  else
  {
    this->AddElement(element, key, value, key.start_mark);
  }
}

//------------------------------------------------------------------------------
/// Reads a vector or list of numbers, or elements of one name.
void YamlReader::ReadList(const Element& element, const yaml_node_t& key, const yaml_node_t& list)
{
  const XmlValueRule* rule = element.Rule ? element.Rule->FindValue(GetText(key)) : nullptr;
  const bool isVector = rule && rule->Kind == XmlKind::Vector;
  const bool isNumbers = rule && rule->Kind == XmlKind::RealList;
  const std::string what = GetText(key) + " of <" + element.Node.name() + "> ";
  std::string text;
  const auto& items = list.data.sequence.items;
  for (const yaml_node_item_t* item = items.start; item != items.top && !this->IsRefused; ++item)
  {
    const yaml_node_t& node = this->Get(*item);
    if (!this->Enter(node))
    {
      continue;
    }
    --this->Depth;
    const bool isText = node.type == YAML_SCALAR_NODE && !IsNull(node);
    if (rule && !isVector && !isNumbers)
    {
      this->Error(
        node.start_mark.line, what + "is one value, not a list; give it without -, [ and ]");
      return;
    }
    if (rule ? !isText : isText || node.type == YAML_SEQUENCE_NODE)
    {
      this->Error(node.start_mark.line,
        what +
          (rule ? "is a list of numbers; give them as in [1, 2, 3]"
                : "is a list of elements; give the keys of each, as in - {x: 1}"));
      return;
    }
    if (rule)
    {
      this->Pass(node);
      text += (item == items.start ? "" : isVector ? ";" : ",") + GetText(node);
    }
    else
    {
      this->AddComments(element.Node, node.start_mark.line);
      this->AddElement(element, key, node, node.start_mark);
    }
  }
  rule ? this->AddText(element, key, text) : void();
}

//------------------------------------------------------------------------------
/// Reads elements of several names, in their order.
void YamlReader::ReadChildren(const Element& element, const yaml_node_t& list)
{
  if (list.type != YAML_SEQUENCE_NODE)
  {
    this->Error(list.start_mark.line,
      std::string(YamlChildren) + " of <" + element.Node.name() +
        "> is not a list; give elements in their order, as in - leg: {...}");
    return;
  }
  const auto& items = list.data.sequence.items;
  for (const yaml_node_item_t* item = items.start; item != items.top && !this->IsRefused; ++item)
  {
    const yaml_node_t& node = this->Get(*item);
    const auto& pairs = node.data.mapping.pairs;
    if (node.type != YAML_MAPPING_NODE || pairs.top - pairs.start != 1)
    {
      this->Error(node.start_mark.line,
        std::string(YamlChildren) + " of <" + element.Node.name() +
          "> are elements; give the name of each and its keys, as in - leg: {...}");
      continue;
    }
    const yaml_node_t& key = this->Get(pairs.start->key);
    const yaml_node_t& value = this->Get(pairs.start->value);
    if (this->CheckKey(element, key) && this->Enter(value))
    {
      this->AddComments(element.Node, key.start_mark.line);
      this->Pass(key);
      this->ReadEntry(element, key, value);
      --this->Depth;
    }
  }
}

//------------------------------------------------------------------------------
/// Adds an element, whose content is a mapping or nothing. What an element with filters does not know
/// is a filter, unless the name of another child is nearer.
void YamlReader::AddElement(const Element& element, const yaml_node_t& key,
  const yaml_node_t& content, const yaml_mark_t& mark)
{
  const std::string name = GetText(key);
  XmlKin kin = element.Rule ? FindXmlKin(*element.Rule, name) : XmlKin();
  if (!kin.Rule && element.Rule && element.Rule->FindChild(name))
  {
    kin = { FindXmlRule(name), name, "", name };
  }
  else if (!kin.Rule && element.Rule && element.Rule->FindChild("filter"))
  {
    const std::string nearest = FindNearestName(name, ListXmlNames(*element.Rule));
    const bool isChild = element.Rule->FindChild(nearest) || element.Rule->FindValue(nearest);
    kin = isChild ? kin : XmlKin{ FindFilterRule(name), "filter", "type", name };
  }
  pugi::xml_node parent = element.Node;
  pugi::xml_node child = parent.append_child((kin.Tag.empty() ? name : kin.Tag).c_str());
  this->SetLine(child.internal_object(), child.name(), mark);
  if (!kin.Key.empty())
  {
    const bool isParameter = kin.Tag == "param";
    isParameter ? void(child.append_attribute("type") = NameType(XmlKind::Rotation)) : void();
    child.append_attribute(kin.Key.c_str()) = kin.Name.c_str();
  }
  content.type == YAML_MAPPING_NODE ? this->ReadMapping({ child, kin.Rule }, content)
                                    : this->Pass(content);
}

//------------------------------------------------------------------------------
/// Adds an attribute, or a parameter of a filter.
void YamlReader::AddText(const Element& element, const yaml_node_t& key, const std::string& text)
{
  pugi::xml_node node = element.Node;
  const std::string name = GetText(key);
  if (element.Rule && IsFilterRule(*element.Rule))
  {
    const XmlValueRule* rule = element.Rule->FindValue(name);
    node = node.append_child("param");
    node.append_attribute("type") = NameType(rule ? rule->Kind : XmlKind::Text);
    node.append_attribute("key") = name.c_str();
    node.append_attribute("value") = text.c_str();
    this->SetLine(node.internal_object(), "param", key.start_mark);
    return;
  }
  pugi::xml_attribute attribute = node.append_attribute(name.c_str());
  attribute = text.c_str();
  this->Result.SetLine(attribute.internal_object(), key.start_mark.line + 1);
}

//------------------------------------------------------------------------------
/// Adds the comments before a line that begin in a column or right of it; those between blank lines
/// are one.
void YamlReader::AddComments(pugi::xml_node parent, std::size_t end, std::size_t column)
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
/// Passes the lines of a text, which has no comments.
void YamlReader::Pass(const yaml_node_t& scalar)
{
  const yaml_mark_t& end = scalar.end_mark;
  this->NextLine = std::max(this->NextLine, end.line + (end.column > 0 ? 1 : 0));
}

//------------------------------------------------------------------------------
/// Sets the line of an element, with the column after another one of its name in the line.
void YamlReader::SetLine(const void* object, const std::string& name, const yaml_mark_t& mark)
{
  if (mark.line != this->LastLine)
  {
    this->LastLine = mark.line;
    this->Names.clear();
  }
  const bool isFirst = this->Names.insert(name).second;
  this->Result.SetLine(object, mark.line + 1, isFirst ? 0 : mark.column + 1);
}

//------------------------------------------------------------------------------
void YamlReader::Error(std::size_t line, const std::string& text)
{
  this->Result.GetMessages().Error(
    this->Result.GetPath() + ":" + std::to_string(line + 1) + ": " + text);
}

} // namespace

//------------------------------------------------------------------------------
bool IsYaml(const std::string& path)
{
  const std::string ending = ToLower(std::filesystem::path(path).extension().string());
  return ending == ".yaml" || ending == ".yml";
}

//------------------------------------------------------------------------------
bool ReadYaml(const std::string& text, XmlDocument& document)
{
  return YamlReader(text, document).Read();
}

} // namespace helios
