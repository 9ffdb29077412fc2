// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosYamlWriter.h"

#include "heliosXmlKin.h"
#include "heliosXmlRules.h"
#include "heliosXmlValue.h"
#include "heliosYamlFile.h"
#include "heliosYamlReader.h"
#include "heliosYamlText.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <sstream>
#include <vector>

namespace helios
{

namespace
{

constexpr std::size_t Width = 100; // columns of a line with a whole element

/// A key with its value.
struct Entry
{
  std::string Key;
  std::vector<std::string> Comments; // before it
  std::string Text;                  // value of an attribute
  pugi::xml_node Element;            // element instead, with its rule, null: unknown
  const XmlElementRule* Rule = nullptr;
};

struct Content
{
  std::vector<Entry> Entries;
  std::vector<std::string> Comments; // after them
};

/// Returns whether a filter has only parameters, each once, with what follows from their keys.
bool IsUsualFilter(pugi::xml_node filter)
{
  std::set<std::string> keys;
  for (const pugi::xml_node child : filter.children())
  {
    if (child.type() != pugi::node_element)
    {
      continue;
    }
    const pugi::xml_attribute value = child.attribute("value");
    const pugi::xml_node below =
      child.find_child([](pugi::xml_node node) { return node.type() != pugi::node_comment; });
    for (const pugi::xml_attribute attribute : child.attributes())
    {
      const std::string name = attribute.name();
      if (name != "type" && name != "key" && (value ? name != "value" : name != "rotations"))
      {
        return false;
      }
    }
    const std::string key = child.attribute("key").value();
    const XmlKin kin = FindXmlKin(*FindFilterRule(filter.attribute("type").value()), key);
    if (std::strcmp(child.name(), "param") != 0 || key.empty() || key == YamlChildren ||
      key == "<<" || (value ? below || kin.Rule : !kin.Rule) || !keys.insert(key).second)
    {
      return false;
    }
  }
  return std::next(filter.attributes_begin()) == filter.attributes_end();
}

/// Returns the key of an element and the rule of its content.
Entry MakeEntry(pugi::xml_node node, const XmlElementRule* parent)
{
  Entry entry;
  entry.Element = node;
  entry.Key = node.name();
  const bool isKnown = parent && parent->FindChild(entry.Key);
  entry.Rule = isKnown ? FindXmlRule(entry.Key) : nullptr;
  const std::string type = node.attribute("type").value();
  const XmlElementRule* filter = isKnown && entry.Key == "filter" ? FindFilterRule(type) : nullptr;
  if (filter && IsUsualFilter(node))
  {
    entry.Rule = filter;
    entry.Key = type;
  }
  else if (parent && IsFilterRule(*parent))
  {
    entry.Rule = FindXmlRule("param");
    entry.Key = node.attribute("key").value();
  }
  return entry;
}

class YamlWriter
{
public:
  std::string Write(const pugi::xml_document& tree);

private:
  static Content List(pugi::xml_node node, const XmlElementRule* rule, bool isParameter = false);
  static void ListChild(pugi::xml_node child, const XmlElementRule* rule, Content& content);
  static bool NeedsOrder(const Content& content);
  static std::string MakeText(const Entry& entry, const XmlElementRule* rule);
  static std::string MakeKey(const std::string& key);
  void AddContent(const Content& content, const XmlElementRule* rule, std::size_t indent);
  void AddElement(const Entry& entry, const Content& content, std::size_t indent);
  void AddItem(Entry entry, const std::string& key, std::size_t indent);
  void AddComments(const std::vector<std::string>& comments, std::size_t indent);
  static std::string MakeLine(const Content& content, const XmlElementRule* rule, std::size_t room);
  static Content ListOf(Entry& entry);

  std::string Text;
};

//------------------------------------------------------------------------------
std::string YamlWriter::Write(const pugi::xml_document& tree)
{
  std::vector<std::string> head;
  Content content;
  for (const pugi::xml_node node : tree.children())
  {
    if (node.type() == pugi::node_comment)
    {
      (content.Entries.empty() ? head : content.Comments).emplace_back(node.value());
    }
    else if (node.type() == pugi::node_element)
    {
      content = List(node, FindXmlRule("document"));
    }
  }
  this->AddComments(head, 0);
  this->Text += head.empty() ? "" : "\n";
  this->AddContent(content, FindXmlRule("document"), 0);
  this->Text += content.Entries.empty() ? "{}\n" : "";
  return this->Text;
}

//------------------------------------------------------------------------------
/// Lists what an element has; of a parameter without what its key says.
Content YamlWriter::List(pugi::xml_node node, const XmlElementRule* rule, bool isParameter)
{
  Content content;
  const bool isFilter = rule && IsFilterRule(*rule);
  for (const pugi::xml_attribute attribute : node.attributes())
  {
    const std::string name = attribute.name();
    const bool isSaid = isFilter || (isParameter && (name == "type" || name == "key"));
    isSaid ? void() : content.Entries.push_back({ name, {}, attribute.value(), {}, nullptr });
  }
  for (const pugi::xml_node child : node.children())
  {
    ListChild(child, rule, content);
  }
  return content;
}

//------------------------------------------------------------------------------
void YamlWriter::ListChild(pugi::xml_node child, const XmlElementRule* rule, Content& content)
{
  const bool isElement = child.type() == pugi::node_element;
  if (!isElement)
  {
    child.type() == pugi::node_pi ? void() : content.Comments.push_back(child.value());
    return;
  }
  Entry entry = MakeEntry(child, rule);
  const bool isFilter = rule && IsFilterRule(*rule);
  const bool isValue = isFilter ? !child.attribute("value").empty()
                                : rule && !entry.Rule && rule->FindValue(entry.Key);
  if (isValue)
  {
    const auto isSame = [&entry](const Entry& other) { return other.Key == entry.Key; };
    const auto& all = content.Entries;
    if (std::any_of(all.begin(), all.end(), isSame))
    {
      return; // an attribute, or an earlier child, is read instead
    }
    entry.Text = isFilter ? child.attribute("value").value() : TrimBlanks(child.text().get());
    entry.Element = {};
  }
  entry.Comments = std::move(content.Comments);
  content.Comments.clear();
  content.Entries.push_back(std::move(entry));
}

//------------------------------------------------------------------------------
/// Lists what the element of an entry has. Comments inside of an empty one are before it.
Content YamlWriter::ListOf(Entry& entry)
{
  const bool isParameter = entry.Rule == FindXmlRule("param") && entry.Key != "param";
  Content content = List(entry.Element, entry.Rule, isParameter);
  if (content.Entries.empty())
  {
    entry.Comments.insert(entry.Comments.end(), content.Comments.begin(), content.Comments.end());
    content.Comments.clear();
  }
  return content;
}

//------------------------------------------------------------------------------
/// Returns whether elements of one name do not follow each other, or have the name of an attribute.
bool YamlWriter::NeedsOrder(const Content& content)
{
  std::set<std::string> keys;
  std::string last;
  for (const Entry& entry : content.Entries)
  {
    const bool follows = entry.Element && entry.Key == last;
    if (!follows && !keys.insert(entry.Key).second)
    {
      return true;
    }
    last = entry.Element ? entry.Key : std::string();
  }
  return false;
}

//------------------------------------------------------------------------------
std::string YamlWriter::MakeKey(const std::string& key)
{
  return IsPlainYaml(key, true) ? key : QuoteYaml(key);
}

//------------------------------------------------------------------------------
std::string YamlWriter::MakeText(const Entry& entry, const XmlElementRule* rule)
{
  const XmlValueRule* value = rule ? rule->FindValue(entry.Key) : nullptr;
  const XmlKind kind = value ? value->Kind : XmlKind::Text;
  const char separator = kind == XmlKind::Vector ? ';' : kind == XmlKind::RealList ? ',' : '\0';
  if (separator && entry.Text.find(separator) != std::string::npos &&
    entry.Text.back() != separator)
  {
    std::string list;
    std::istringstream stream(entry.Text);
    for (std::string item; std::getline(stream, item, separator);)
    {
      item = TrimBlanks(item);
      list += (list.empty() ? "[" : ", ") + (IsPlainYaml(item, true) ? item : QuoteYaml(item));
    }
    return list + "]";
  }
  const bool isNumber =
    separator || kind == XmlKind::Real || kind == XmlKind::Integer || kind == XmlKind::Boolean;
  return IsPlainYaml(entry.Text, isNumber) ? entry.Text : QuoteYaml(entry.Text);
}

//------------------------------------------------------------------------------
/// Returns attributes in one line; empty: it has others, or no room.
std::string YamlWriter::MakeLine(
  const Content& content, const XmlElementRule* rule, std::size_t room)
{
  std::string line;
  bool isLong = !content.Comments.empty();
  for (const Entry& entry : content.Entries)
  {
    isLong = isLong || entry.Element || !entry.Comments.empty() || line.size() > room;
    line +=
      isLong ? "" : (line.empty() ? "" : ", ") + MakeKey(entry.Key) + ": " + MakeText(entry, rule);
  }
  return isLong || line.size() + 2 > room ? std::string() : "{" + line + "}";
}

//------------------------------------------------------------------------------
void YamlWriter::AddComments(const std::vector<std::string>& comments, std::size_t indent)
{
  for (std::size_t i = 0; i < comments.size(); ++i)
  {
    const std::vector<std::string> lines = SplitYamlComment(comments[i]);
    this->Text += i > 0 ? "\n" : "";
    this->Text += lines.empty() ? std::string(indent, ' ') + "#\n" : std::string();
    for (const std::string& line : lines)
    {
      this->Text +=
        std::string(indent, ' ') + (line.empty() ? "#" : "# ") + EscapeYaml(line, "") + "\n";
    }
  }
}

//------------------------------------------------------------------------------
void YamlWriter::AddContent(const Content& content, const XmlElementRule* rule, std::size_t indent)
{
  const std::string blanks(indent, ' ');
  const bool isOrdered = NeedsOrder(content);
  bool isOpen = false; // the list of all elements
  for (std::size_t i = 0; i < content.Entries.size(); ++i)
  {
    Entry entry = content.Entries[i];
    if (isOrdered && entry.Element)
    {
      this->Text += isOpen ? "" : blanks + YamlChildren + ":\n";
      isOpen = true;
      this->AddItem(entry, MakeKey(entry.Key), indent + 2);
      continue;
    }
    const auto isSame = [&](std::size_t other)
    {
      return other < content.Entries.size() && content.Entries[other].Element &&
        content.Entries[other].Key == entry.Key;
    };
    const bool isList = entry.Element && isSame(i + 1);
    const Content inner = entry.Element && !isList ? ListOf(entry) : Content();
    this->AddComments(entry.Comments, indent);
    this->Text += blanks + MakeKey(entry.Key) + ":";
    if (!entry.Element)
    {
      this->Text += " " + MakeText(entry, rule) + "\n";
    }
    else if (!isList)
    {
      this->AddElement(entry, inner, indent + 2);
    }
    else
    {
      this->Text += "\n";
      entry.Comments.clear();
      this->AddItem(entry, "", indent + 2);
      for (; isSame(i + 1); ++i)
      {
        this->AddItem(content.Entries[i + 1], "", indent + 2);
      }
    }
  }
  this->AddComments(content.Comments, indent);
}

//------------------------------------------------------------------------------
/// Adds the content of an element after its name: in the line, or in lines of its own.
void YamlWriter::AddElement(const Entry& entry, const Content& content, std::size_t indent)
{
  const std::size_t start = this->Text.rfind('\n') + 1;
  const std::size_t used = this->Text.size() - start;
  const std::string line = MakeLine(content, entry.Rule, used < Width ? Width - used : 0);
  if (!line.empty() || content.Entries.empty())
  {
    this->Text += " " + (line.empty() ? "{}" : line) + "\n";
    return;
  }
  this->Text += "\n";
  this->AddContent(content, entry.Rule, indent);
}

//------------------------------------------------------------------------------
/// Adds an element as an item of a list, with or without its name. Comments that it begins with are
/// above it.
void YamlWriter::AddItem(Entry entry, const std::string& key, std::size_t indent)
{
  Content content = ListOf(entry);
  this->AddComments(entry.Comments, indent);
  if (!content.Entries.empty() && key.empty())
  {
    this->AddComments(content.Entries.front().Comments, indent);
    content.Entries.front().Comments.clear();
  }
  const std::string blanks(indent, ' ');
  if (!key.empty())
  {
    this->Text += blanks + "- " + key + ":";
    this->AddElement(entry, content, indent + 4);
    return;
  }
  const std::string line = MakeLine(content, entry.Rule, Width - std::min(Width, indent + 2));
  if (!line.empty() || content.Entries.empty())
  {
    this->Text += blanks + "- " + (line.empty() ? "{}" : line) + "\n";
    return;
  }
  const std::size_t start = this->Text.size();
  this->AddContent(content, entry.Rule, indent + 2);
  this->Text[start + indent] = '-';
}

} // namespace

//------------------------------------------------------------------------------
Status MakeYaml(const pugi::xml_document& tree, std::string& text)
{
  YamlWriter writer;
  text = writer.Write(tree);
  yaml_event_t event;
  const auto* bytes = reinterpret_cast<const unsigned char*>(text.data());
  const bool isText = yaml_scalar_event_initialize(&event, nullptr, nullptr, bytes,
                        static_cast<int>(text.size()), 1, 1, YAML_ANY_SCALAR_STYLE) != 0;
  isText ? yaml_event_delete(&event) : void();
  return isText ? Status()
                : Status::Error("texts are not all UTF-8, as those of YAML; correct them");
}

} // namespace helios
