// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosInputFile.h"
#include "heliosMessages.h"
#include "heliosStatus.h"
#include "heliosXmlElement.h"
#include "heliosYamlReader.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

namespace helios
{

namespace
{

constexpr const char* Utf8Mark = "\xEF\xBB\xBF";

/// Returns whether the XML declaration has the encoding Latin-1.
bool IsLatin1(const std::string& text)
{
  const std::string declaration = text.substr(0, text.find("?>"));
  return text.compare(0, 5, "<?xml") == 0 &&
    (declaration.find("8859-1") != std::string::npos ||
      declaration.find("latin1") != std::string::npos);
}

std::string Latin1ToUtf8(const std::string& text)
{
  std::string utf8;
  utf8.reserve(text.size() + text.size() / 8);
  for (const char c : text)
  {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80)
    {
      utf8 += c;
    }
    else
    {
      utf8 += static_cast<char>(0xC0 | (byte >> 6));
      utf8 += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return utf8;
}

/// Returns a duplicate attribute of an element; empty: none.
std::string FindDuplicate(const pugi::xml_node& node)
{
  std::set<std::string> names;
  for (const pugi::xml_attribute attribute : node.attributes())
  {
    if (!names.insert(attribute.name()).second)
    {
      return attribute.name();
    }
  }
  return {};
}

/// Returns the ends of lines, by LF, CR LF or CR.
std::vector<std::ptrdiff_t> FindLineEnds(const std::string& text)
{
  std::vector<std::ptrdiff_t> ends;
  for (std::size_t end = text.find_first_of("\r\n"); end != std::string::npos;
       end = text.find_first_of("\r\n", end + 1))
  {
    const bool isPair = text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n';
    end += isPair ? 1 : 0;
    ends.push_back(static_cast<std::ptrdiff_t>(end));
  }
  return ends;
}

/// Returns the next node in document order, children first; none after the last.
pugi::xml_node NextNode(pugi::xml_node node)
{
  if (node.first_child())
  {
    return node.first_child();
  }
  while (node && !node.next_sibling())
  {
    node = node.parent();
  }
  return node.next_sibling();
}

/// Finds the first node that is nested too deeply.
struct DepthCheck : pugi::xml_tree_walker
{
  bool for_each(pugi::xml_node& node) override
  {
    this->Node = node;
    return this->depth() <= DocumentDepth;
  }
  pugi::xml_node Node;
};

} // namespace

//------------------------------------------------------------------------------
std::unique_ptr<XmlDocument> XmlDocument::Load(const std::string& path, Messages& messages)
{
  if (const Status status = CheckInputFile(path); !status.IsOk())
  {
    messages.Error(path + ": " + status.Message());
    return nullptr;
  }
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    const bool isThere = !StampFile(path).empty();
    messages.Error(path + (isThere ? ": cannot be read" : ": no such file") +
      "; give the name of an XML or YAML file");
    return nullptr;
  }
  return XmlDocument::Make(path,
    { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() }, IsYaml(path),
    messages);
}

//------------------------------------------------------------------------------
std::unique_ptr<XmlDocument> XmlDocument::Make(
  const std::string& path, std::string text, Messages& messages)
{
  return XmlDocument::Make(path, std::move(text), false, messages);
}

//------------------------------------------------------------------------------
std::unique_ptr<XmlDocument> XmlDocument::Make(
  const std::string& path, std::string text, bool isYaml, Messages& messages)
{
  std::unique_ptr<XmlDocument> document(new XmlDocument);
  document->Path = path;
  document->Log = &messages;
  if (!document->CheckText(text))
  {
    return nullptr;
  }
  if (isYaml)
  {
    return ReadYaml(text, *document) ? std::move(document) : nullptr;
  }
  if (!document->Parse(std::move(text)) || !document->CheckDepth() || !document->CheckRoot())
  {
    return nullptr;
  }
  document->CheckElements();
  return document;
}

//------------------------------------------------------------------------------
std::unique_ptr<XmlDocument> XmlDocument::MakeOf(
  const std::string& place, std::string text, Messages& messages)
{
  auto document = XmlDocument::Make(place, std::move(text), messages);
  document->IsMade = true;
  document->SetPlace(document->GetRoot().GetNode().first_child(), place);
  return document;
}

//------------------------------------------------------------------------------
/// Removes the mark of UTF-8; false after an error if nothing can be read.
bool XmlDocument::CheckText(std::string& text)
{
  if (text.compare(0, 3, Utf8Mark) == 0)
  {
    text.erase(0, 3);
  }
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
  {
    this->Log->Error(this->Path + ":1: the file is empty; a HELIOS file holds one <document>");
    return false;
  }
  if (text.compare(0, 2, "\xFE\xFF") == 0 || text.compare(0, 2, "\xFF\xFE") == 0)
  {
    this->Log->Error(this->Path + ":1: the file is UTF-16; save it as UTF-8");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool XmlDocument::Parse(std::string text)
{
  if (IsLatin1(text))
  {
    text = Latin1ToUtf8(text);
  }
  this->LineEnds = FindLineEnds(text);
  const pugi::xml_parse_result result = this->Tree.load_buffer(text.data(), text.size(),
    pugi::parse_default | pugi::parse_doctype | pugi::parse_comments, pugi::encoding_utf8);
  const bool isEmpty = result.status == pugi::status_no_document_element;
  if (!result && !isEmpty)
  {
    std::string reason = result.description();
    this->Log->Error(this->WhereOffset(result.offset) + ": this is not XML: " + reason +
      "; close every element, and quote every value");
  }
  return result || isEmpty;
}

//------------------------------------------------------------------------------
bool XmlDocument::CheckDepth()
{
  DepthCheck check;
  if (!this->Tree.traverse(check))
  {
    this->Log->Error(this->WhereOffset(check.Node.offset_debug()) +
      ": elements are nested more than " + std::to_string(DocumentDepth) + " times; nest fewer");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool XmlDocument::CheckRoot()
{
  pugi::xml_node root;
  for (const pugi::xml_node node : this->Tree.children())
  {
    if (node.type() == pugi::node_doctype)
    {
      this->Log->Warning(
        this->Path + ": its document type is not read, and its entities are not expanded");
    }
    else if (node.type() == pugi::node_element && root)
    {
      this->Log->Error(this->WhereOffset(node.offset_debug()) + ": a second root element <" +
        node.name() + ">; put everything into one <document>");
    }
    else if (node.type() == pugi::node_element)
    {
      root = node;
    }
  }
  if (std::string(root.name()) != "document")
  {
    this->Log->Error(this->WhereOffset(root ? root.offset_debug() : 0) + ": the root element is " +
      (root ? std::string("<") + root.name() + ">" : std::string("missing")) +
      "; that of a HELIOS file is <document>");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
/// Finds elements whose lines do not tell them apart, and duplicate attributes.
void XmlDocument::CheckElements()
{
  std::set<std::string> names; // names of the elements of a line
  std::size_t line = 0;
  for (pugi::xml_node node = this->Tree.first_child(); node; node = NextNode(node))
  {
    if (node.type() != pugi::node_element)
    {
      continue;
    }
    const std::ptrdiff_t offset = node.offset_debug();
    if (const std::size_t its = this->FindLine(offset); its != line)
    {
      line = its;
      names.clear();
    }
    if (!names.insert(node.name()).second)
    {
      this->Repeated.push_back(offset);
    }
  }
  for (pugi::xml_node node = this->Tree.first_child(); node; node = NextNode(node))
  {
    const std::string duplicate = FindDuplicate(node);
    if (!duplicate.empty())
    {
      this->Log->Error(this->WhereOffset(node.offset_debug()) + ": <" + node.name() +
        "> has the attribute " + duplicate + " twice; leave one of them");
    }
  }
}

//------------------------------------------------------------------------------
XmlElement XmlDocument::GetRoot() const
{
  return { this, this->Tree.child("document") };
}

//------------------------------------------------------------------------------
/// Returns the line of an offset, from 0.
std::size_t XmlDocument::FindLine(std::ptrdiff_t offset) const
{
  const auto line = std::lower_bound(this->LineEnds.begin(), this->LineEnds.end(), offset);
  return static_cast<std::size_t>(line - this->LineEnds.begin());
}

//------------------------------------------------------------------------------
std::string XmlDocument::WhereOffset(std::ptrdiff_t offset) const
{
  const std::size_t line = this->FindLine(offset);
  const std::ptrdiff_t start = line == 0 ? 0 : this->LineEnds[line - 1] + 1;
  const bool isRepeated = std::binary_search(this->Repeated.begin(), this->Repeated.end(), offset);
  return this->Path + ":" + std::to_string(line + 1) +
    (isRepeated ? ":" + std::to_string(offset - start) : std::string());
}

//------------------------------------------------------------------------------
std::string XmlDocument::Where(pugi::xml_node node) const
{
  const auto own = this->Places.find(node.internal_object());
  if (own != this->Places.end())
  {
    return own->second;
  }
  if (const auto line = this->Lines.find(node.internal_object()); line != this->Lines.end())
  {
    return this->MakePlace(line->second);
  }
  if (const std::ptrdiff_t offset = node.offset_debug(); offset >= 0 && !this->IsMade)
  {
    return this->WhereOffset(offset);
  }
  for (pugi::xml_node from = node.parent(); from; from = from.parent())
  {
    const auto above = this->Places.find(from.internal_object());
    if (above != this->Places.end())
    {
      const bool isBelow = above->second.find(", ") != std::string::npos;
      return above->second + (isBelow ? "/" : ", ") + MakePath(node, from);
    }
  }
  return this->Path;
}

//------------------------------------------------------------------------------
std::string XmlDocument::Where(pugi::xml_node node, pugi::xml_attribute attribute) const
{
  const auto line = this->Lines.find(attribute.internal_object());
  const bool isOwn = line != this->Lines.end() && !this->GetPlace(node);
  return isOwn ? this->MakePlace(line->second) : this->Where(node);
}

//------------------------------------------------------------------------------
std::string XmlDocument::MakePlace(const std::pair<std::size_t, std::size_t>& line) const
{
  return this->Path + ":" + std::to_string(line.first) +
    (line.second ? ":" + std::to_string(line.second) : std::string());
}

//------------------------------------------------------------------------------
void XmlDocument::SetLine(const void* object, std::size_t line, std::size_t column)
{
  this->Lines[object] = { line, column };
}

//------------------------------------------------------------------------------
const std::string* XmlDocument::GetPlace(pugi::xml_node node) const
{
  const auto found = this->Places.find(node.internal_object());
  return found == this->Places.end() ? nullptr : &found->second;
}

//------------------------------------------------------------------------------
void XmlDocument::SetPlace(pugi::xml_node node, const std::string& place)
{
  this->Places[node.internal_object()] = place;
}

//------------------------------------------------------------------------------
void XmlDocument::ForgetPlaces(pugi::xml_node node)
{
  this->Places.erase(node.internal_object());
  this->Lines.erase(node.internal_object());
  for (const pugi::xml_attribute attribute : node.attributes())
  {
    this->Lines.erase(attribute.internal_object());
  }
  for (const pugi::xml_node child : node.children())
  {
    this->ForgetPlaces(child);
  }
}

} // namespace helios
