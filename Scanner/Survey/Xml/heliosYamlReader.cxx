// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosYamlReader.h"

#include "heliosMessages.h"
#include "heliosXmlElement.h"
#include "heliosXmlKin.h"
#include "heliosYamlComments.h"
#include "heliosYamlFile.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

namespace helios
{

namespace
{

/// Values that aliases may repeat: so many for each of the file, besides the first ones.
constexpr std::size_t AliasFactor = 10;
constexpr std::size_t AliasFree = 100000;

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

  bool Check(const Status& status);
  void ReadMapping(const Element& element, const yaml_node_t& mapping);
  void ReadEntry(const Element& element, const yaml_node_t& key, const yaml_node_t& value);
  void ReadChildren(const Element& element, const yaml_node_t& list);
  void ReadList(const Element& element, const yaml_node_t& key, const yaml_node_t& list);
  void AddElement(const Element& element, const yaml_node_t& key, const yaml_node_t& content,
    const yaml_mark_t& mark);
  void AddText(const Element& element, const yaml_node_t& key, const std::string& text);
  bool CheckKey(const Element& element, const yaml_node_t& key);
  bool Enter(const yaml_node_t& node);
  void SetLine(const void* object, const std::string& name, const yaml_mark_t& mark);
  void Error(std::size_t line, const std::string& text);
  const std::string& Text;
  XmlDocument& Result;
  YamlFile File;
  YamlComments Comments;
  std::vector<bool> Seen;      // values, by their numbers
  std::set<std::string> Names; // elements in the last line
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
  , Comments(text)
{
}

//------------------------------------------------------------------------------
/// Reports an error that begins with the line.
bool YamlReader::Check(const Status& status)
{
  status.IsOk() ? void()
                : this->Result.GetMessages().Error(this->Result.GetPath() + ":" + status.Message());
  return status.IsOk();
}

//------------------------------------------------------------------------------
bool YamlReader::Read()
{
  if (!this->Check(YamlFile::Check(this->Text)) || !this->Check(this->File.Load()))
  {
    return false;
  }
  const yaml_node_t* root = this->File.GetRoot();
  if (!root || root->type != YAML_MAPPING_NODE || HasOwnTag(*root))
  {
    this->Error(root ? root->start_mark.line : 0,
      "the file is not a mapping; begin with the name of an element, as in survey: {name: yard}");
    return false;
  }
  this->Seen.resize(this->File.GetSize());
  this->Largest = AliasFree + AliasFactor * this->Seen.size();
  pugi::xml_document& tree = this->Result.GetTree();
  this->Comments.AddHead(tree, root->start_mark.line);
  const Element document{ tree.append_child("document"), FindXmlRule("document") };
  this->SetLine(document.Node.internal_object(), "document", root->start_mark);
  this->ReadMapping(document, *root);
  this->Comments.AddRest(document.Node);
  if (this->IsRefused)
  {
    return false;
  }
  if (!this->Check(this->File.Load()))
  {
    return false;
  }
  if (const yaml_node_t* second = this->File.GetRoot())
  {
    this->Error(second->start_mark.line, "a second document; put everything into one");
  }
  return true;
}

//------------------------------------------------------------------------------
void YamlReader::ReadMapping(const Element& element, const yaml_node_t& mapping)
{
  std::map<std::string, std::size_t> lines; // first lines of keys
  const auto& pairs = mapping.data.mapping.pairs;
  for (const yaml_node_pair_t* pair = pairs.start; pair != pairs.top && !this->IsRefused; ++pair)
  {
    const yaml_node_t& key = this->File.Get(pair->key);
    if (!this->CheckKey(element, key))
    {
      continue;
    }
    this->Comments.Add(element.Node, key.start_mark.line);
    this->Comments.Pass(key);
    const auto [before, isNew] = lines.emplace(GetText(key), key.start_mark.line);
    if (!isNew)
    {
      this->Error(key.start_mark.line,
        "<" + std::string(element.Node.name()) + "> has " + before->first +
          " twice, first in line " + std::to_string(before->second + 1) +
          "; leave one of them, or make a list of both");
      continue;
    }
    const yaml_node_t& value = this->File.Get(pair->value);
    if (this->Enter(value))
    {
      this->ReadEntry(element, key, value);
      --this->Depth;
    }
  }
  this->Comments.Add(element.Node, mapping.end_mark.line, mapping.start_mark.column);
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
  const std::size_t number = this->File.GetIndex(node);
  this->Repeated += this->Seen[number] ? 1 : 0;
  this->Seen[number] = true;
  if (this->Depth >= DocumentDepth)
  {
    this->Error(line,
      "elements are nested more than " + std::to_string(DocumentDepth) +
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
    this->Comments.Pass(value);
    kin.Rule ? this->Error(key.start_mark.line,
                 name + " of <" + owner + "> is an element, not a value; give its keys below it, " +
                   "or {} for none")
             : this->AddText(element, key, GetText(value));
  }
  else if (own)
  {
    this->Comments.Pass(value);
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
    const yaml_node_t& node = this->File.Get(*item);
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
      this->Comments.Pass(node);
      text += (item == items.start ? "" : isVector ? ";" : ",") + GetText(node);
    }
    else
    {
      this->Comments.Add(element.Node, node.start_mark.line);
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
    const yaml_node_t& node = this->File.Get(*item);
    const auto& pairs = node.data.mapping.pairs;
    if (node.type != YAML_MAPPING_NODE || pairs.top - pairs.start != 1)
    {
      this->Error(node.start_mark.line,
        std::string(YamlChildren) + " of <" + element.Node.name() +
          "> are elements; give the name of each and its keys, as in - leg: {...}");
      continue;
    }
    const yaml_node_t& key = this->File.Get(pairs.start->key);
    const yaml_node_t& value = this->File.Get(pairs.start->value);
    if (this->CheckKey(element, key) && this->Enter(value))
    {
      this->Comments.Add(element.Node, key.start_mark.line);
      this->Comments.Pass(key);
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
                                    : this->Comments.Pass(content);
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
