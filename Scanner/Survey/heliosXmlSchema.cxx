// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlSchema.h"

#include "heliosMessages.h"
#include "heliosXmlFilter.h"
#include "heliosXmlNotes.h"
#include "heliosXmlRules.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace helios
{

namespace
{

constexpr double NoLimit = 1e300;

const char* const Head = R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors -->
<!-- SPDX-License-Identifier: BSD-3-Clause -->
<!-- Made by vtkhelios schema from the table that vtkHelios reads files by; do not edit. -->
<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema" elementFormDefault="qualified">
  <xs:element name="document" type="document"/>
  <xs:simpleType name="boolean">
    <xs:restriction base="xs:token"><xs:pattern value="[Tt][Rr][Uu][Ee]|[Ff][Aa][Ll][Ss][Ee]|0|1"/></xs:restriction>
  </xs:simpleType>
  <xs:complexType name="anything" mixed="true">
    <xs:sequence><xs:any minOccurs="0" maxOccurs="unbounded" processContents="skip"/></xs:sequence>
    <xs:anyAttribute processContents="skip"/>
  </xs:complexType>
)";

constexpr const char* Number = R"([+\-]?([0-9]+([.][0-9]*)?|[.][0-9]+)([eE][+\-]?[0-9]+)?)";

/// Escapes a text for XML, or for a Markdown table.
std::string Escape(const std::string& text, bool isXml)
{
  std::string escaped;
  for (const char c : text)
  {
    const char* name = c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : nullptr;
    escaped += name ? name : !isXml && c == '|' ? "\\|" : std::string(1, c);
  }
  return escaped;
}

std::string ToText(double number)
{
  std::ostringstream text; // six digits: 1e+12
  text << number;
  return text.str();
}

/// Capitalises the first letter.
std::string Capitalise(std::string text)
{
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

bool IsFilter(const XmlElementRule& rule)
{
  return std::string(rule.Name).rfind("filter:", 0) == 0;
}

/// Whether the readers read a value; others may be anything.
bool IsRead(const XmlValueRule& value)
{
  return value.Use == XmlUse::Used;
}

/// "description [unit]; default: this; not read"
std::string Describe(const XmlValueRule& value, const XmlNote& note)
{
  std::string text = note.Text;
  text += *value.Unit ? std::string(" [") + value.Unit + "]" : "";
  text += *note.Default && !IsRequired(note) ? std::string("; default: ") + note.Default : "";
  return text + (value.Use == XmlUse::Used ? "" : "; not read");
}

/// The words of an attribute; for a filter's type the supported filters.
std::vector<std::string> FindChoices(const XmlElementRule& rule, const XmlValueRule& value)
{
  std::vector<std::string> choices = GetChoices(FindXmlNote(rule.Name, value.Name));
  if (std::string(rule.Name) == "filter")
  {
    choices = GetFilterTypes();
    choices.insert(choices.end(), { "crstransform", "transform" });
  }
  return choices;
}

bool IsAnyCase(const XmlElementRule& rule, const XmlValueRule& value)
{
  return std::string(rule.Name) == "filter" || *FindXmlNote(rule.Name, value.Name).Choices == '~';
}

/// Writes the schema.
class SchemaMaker
{
public:
  std::string Make();

private:
  void AddElement(const XmlElementRule& rule);
  void AddChildren(const XmlElementRule& rule);
  void AddAttribute(const XmlElementRule& rule, const XmlValueRule& value);
  static std::string MakeType(const XmlElementRule& rule, const XmlValueRule& value);
  static std::string MakeNumber(const XmlValueRule& value);
  static std::string MakeList(char separator, const char* count);
  static std::string MakeWords(const std::vector<std::string>& words, bool isAnyCase);

  std::string Text;
};

//------------------------------------------------------------------------------
std::string SchemaMaker::Make()
{
  this->Text = Head;
  for (const XmlElementRule& rule : GetXmlRules())
  {
    if (!IsFilter(rule)) // their parameters are attributes of <param>
    {
      this->AddElement(rule);
    }
  }
  return this->Text + "</xs:schema>\n";
}

//------------------------------------------------------------------------------
void SchemaMaker::AddElement(const XmlElementRule& rule)
{
  this->Text += std::string("  <xs:complexType name=\"") + rule.Name + "\">\n";
  this->Text += "    <xs:annotation><xs:documentation>" +
    Escape(FindXmlNote(rule.Name, "").Text, true) + "</xs:documentation></xs:annotation>\n";
  this->AddChildren(rule);
  for (const XmlValueRule& value : rule.Values)
  {
    this->AddAttribute(rule, value);
  }
  this->Text += "  </xs:complexType>\n";
}

//------------------------------------------------------------------------------
void SchemaMaker::AddChildren(const XmlElementRule& rule)
{
  if (rule.Children.empty())
  {
    return;
  }
  const bool repeats = std::any_of(rule.Children.begin(), rule.Children.end(),
    [](const XmlChildRule& child) { return child.Repeats; });
  this->Text +=
    repeats ? "    <xs:choice minOccurs=\"0\" maxOccurs=\"unbounded\">\n" : "    <xs:all>\n";
  for (const XmlChildRule& child : rule.Children)
  {
    const XmlValueRule* value = rule.FindValue(child.Name); // an attribute given as a child
    const bool isKnown = FindXmlRule(child.Name) && child.Use == XmlUse::Used;
    this->Text += std::string("      <xs:element name=\"") + child.Name + "\"" +
      (repeats ? "" : " minOccurs=\"0\"");
    this->Text += value ? ">" + MakeType(rule, *value) + "</xs:element>\n"
                        : std::string(" type=\"") + (isKnown ? child.Name : "anything") + "\"/>\n";
  }
  this->Text += repeats ? "    </xs:choice>\n" : "    </xs:all>\n";
}

//------------------------------------------------------------------------------
void SchemaMaker::AddAttribute(const XmlElementRule& rule, const XmlValueRule& value)
{
  const XmlNote& note = FindXmlNote(rule.Name, value.Name);
  this->Text += std::string("    <xs:attribute name=\"") + value.Name + "\"" +
    (IsRequired(note) && IsRead(value) ? " use=\"required\"" : "") + ">\n";
  this->Text += "      <xs:annotation><xs:documentation>" + Escape(Describe(value, note), true) +
    "</xs:documentation></xs:annotation>\n";
  this->Text += "      " + MakeType(rule, value) + "\n    </xs:attribute>\n";
}

//------------------------------------------------------------------------------
std::string SchemaMaker::MakeType(const XmlElementRule& rule, const XmlValueRule& value)
{
  const std::vector<std::string> words = FindChoices(rule, value);
  std::string facets;
  std::string base = "xs:string";
  if (!IsRead(value))
  {
    // any text
  }
  else if (!words.empty())
  {
    base = "xs:token";
    facets = MakeWords(words, IsAnyCase(rule, value));
  }
  else if (value.Kind == XmlKind::Real || value.Kind == XmlKind::Integer)
  {
    base = value.Kind == XmlKind::Real ? "xs:double" : "xs:integer";
    facets = MakeNumber(value);
  }
  else if (value.Kind == XmlKind::Boolean)
  {
    base = "boolean";
  }
  else if (value.Kind == XmlKind::RealList)
  {
    facets = MakeList(',', "*");
  }
  else if (value.Kind == XmlKind::Vector)
  {
    facets = MakeList(';', "{2}");
  }
  return "<xs:simpleType><xs:restriction base=\"" + base + "\">" + facets +
    "</xs:restriction></xs:simpleType>";
}

//------------------------------------------------------------------------------
std::string SchemaMaker::MakeNumber(const XmlValueRule& value)
{
  const bool isReal = value.Kind == XmlKind::Real;
  const XmlRange& range = value.Range;
  const double most = isReal ? NoLimit : 2147483647.0;
  // Unlimited reals get limits too: NaN and infinity are not valid.
  Sentence text;
  text << "<xs:min" << (range.AboveLow ? "Exclusive" : "Inclusive") << " value=\""
       << std::max(range.Low, -most) << "\"/><xs:maxInclusive value=\""
       << std::min(range.High, most) << "\"/>";
  return text.str();
}

//------------------------------------------------------------------------------
std::string SchemaMaker::MakeList(char separator, const char* count)
{
  const std::string number = std::string("\\s*") + Number + "\\s*";
  return "<xs:pattern value=\"" + number + "(" + separator + number + ")" + count + "\"/>";
}

//------------------------------------------------------------------------------
std::string SchemaMaker::MakeWords(const std::vector<std::string>& words, bool isAnyCase)
{
  std::string facets;
  for (const std::string& word : words)
  {
    std::string pattern;
    for (const char c : word)
    {
      const auto letter = static_cast<unsigned char>(c);
      const char both[] = { '[', static_cast<char>(std::toupper(letter)), c, ']', '\0' };
      pattern += isAnyCase && std::isalpha(letter) ? both : std::string(1, c);
    }
    facets += isAnyCase ? "<xs:pattern value=\"" + pattern + "\"/>"
                        : "<xs:enumeration value=\"" + word + "\"/>";
  }
  return facets;
}

const char* NameKind(XmlKind kind)
{
  switch (kind)
  {
    case XmlKind::Real:
      return "number";
    case XmlKind::Integer:
      return "integer";
    case XmlKind::Boolean:
      return "boolean";
    case XmlKind::RealList:
      return "numbers, comma separated";
    case XmlKind::Vector:
      return "vector, a;b;c";
    case XmlKind::Rotation:
      return "rot children";
    case XmlKind::Reference:
      return "reference";
    case XmlKind::Text:
      break;
  }
  return "text";
}

/// "0 < . <= 10", for a table.
std::string DescribeRange(const XmlElementRule& rule, const XmlValueRule& value)
{
  const std::vector<std::string> words = FindChoices(rule, value);
  if (!words.empty())
  {
    return Enumerate(words);
  }
  const XmlRange& range = value.Range;
  std::string text;
  if (value.Kind != XmlKind::Real && value.Kind != XmlKind::Integer &&
    value.Kind != XmlKind::RealList && value.Kind != XmlKind::Vector)
  {
    return text;
  }
  if (range.Low > -NoLimit)
  {
    text += (range.AboveLow ? "above " : "from ") + ToText(range.Low);
  }
  if (range.High < NoLimit)
  {
    text += (text.empty() ? "to " : " to ") + ToText(range.High);
  }
  return text;
}

const char* NameUse(XmlUse use)
{
  return use == XmlUse::Used ? "yes" : use == XmlUse::Ignored ? "no" : "no, warns";
}

/// "`a`, `b`"
std::string Quote(const std::vector<std::string>& tags)
{
  std::string text;
  for (const std::string& tag : tags)
  {
    text += (text.empty() ? "`<" : ", `<") + tag + ">`";
  }
  return text;
}

/// The elements that have a child of this name.
std::vector<std::string> FindParents(const std::string& name)
{
  std::vector<std::string> parents;
  for (const XmlElementRule& rule : GetXmlRules())
  {
    if (rule.FindChild(name))
    {
      parents.emplace_back(rule.Name);
    }
  }
  return parents;
}

std::string MakeRow(const XmlElementRule& rule, const XmlValueRule& value)
{
  const XmlNote& note = FindXmlNote(rule.Name, value.Name);
  const bool isRead = IsRead(value);
  const std::string cells[] = { std::string("`") + value.Name + "`", NameKind(value.Kind),
    value.Unit, isRead ? DescribeRange(rule, value) : "", note.Default, NameUse(value.Use),
    note.Text };
  std::string row = "|";
  for (const std::string& cell : cells)
  {
    row += " " + Escape(cell, false) + " |";
  }
  return row + "\n";
}

/// The children without a table of their own.
std::string MakeChildRows(const XmlElementRule& rule)
{
  std::string rows;
  for (const XmlChildRule& child : rule.Children)
  {
    if (!FindXmlRule(child.Name) || child.Use != XmlUse::Used)
    {
      rows += std::string("| `<") + child.Name + ">` | element | | | | " + NameUse(child.Use) +
        " | " + Escape(FindXmlNote(child.Name, "").Text, false) + " |\n";
    }
  }
  return rows;
}

std::string MakeTable(const XmlElementRule& rule)
{
  const bool isFilter = IsFilter(rule);
  const std::string name = rule.Name;
  const std::vector<std::string> parents = FindParents(name);
  std::string text =
    "### " + (isFilter ? "filter `" + name.substr(7) + "`" : "`<" + name + ">`") + "\n\n";
  text += Capitalise(Escape(FindXmlNote(name, "").Text, false)) + ".";
  text += parents.empty() ? "\n" : " In " + Quote(parents) + ".\n";
  std::string rows;
  for (const XmlValueRule& value : rule.Values)
  {
    rows += MakeRow(rule, value);
  }
  rows += MakeChildRows(rule);
  const char* head = "\n| name | kind | unit | range | default | read | what it is |\n"
                     "|---|---|---|---|---|---|---|\n";
  return text + (rows.empty() ? "" : head + rows) + "\n";
}

} // namespace

//------------------------------------------------------------------------------
std::string MakeXmlSchema()
{
  return SchemaMaker().Make();
}

//------------------------------------------------------------------------------
std::string MakeXmlTables()
{
  std::string text;
  for (const XmlElementRule& rule : GetXmlRules())
  {
    text += MakeTable(rule);
  }
  return text;
}

} // namespace helios
