// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Elements that a survey refers to in other files: copied into its document, or named as in a new
// folder.
#include "heliosElementPath.h"
#include "heliosPartFile.h"
#include "heliosSurveyDocument.h"
#include "heliosXmlFilter.h"
#include "heliosXmlPart.h"
#include "heliosXmlScene.h"
#include "heliosXmlText.h"
#include "heliosYamlWriter.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <functional>

namespace fs = std::filesystem;

namespace helios
{

namespace
{

/// Calls a function for all attributes of an element and those inside that name files or refer to
/// elements of files.
void VisitFiles(pugi::xml_node node,
  const std::function<void(const XmlValueRule& rule, pugi::xml_attribute attribute)>& visit)
{
  const bool isParameter = std::strcmp(node.name(), "param") == 0;
  const XmlElementRule* rule = isParameter ? FindFilterRule(node.parent().attribute("type").value())
                                           : FindXmlRule(node.name());
  for (const pugi::xml_attribute attribute : node.attributes())
  {
    const bool isValue = isParameter && std::strcmp(attribute.name(), "value") == 0;
    const std::string name = isValue ? node.attribute("key").value() : attribute.name();
    const XmlValueRule* value = rule && isParameter == isValue ? rule->FindValue(name) : nullptr;
    if (value && (value->File != XmlFile::None || value->Kind == XmlKind::Reference))
    {
      visit(*value, attribute);
    }
  }
  for (const pugi::xml_node child : node.children())
  {
    VisitFiles(child, visit);
  }
}

fs::path GetFolder(const std::string& file)
{
  return fs::absolute(fs::path(file).parent_path() / ".").lexically_normal();
}

/// Returns a document as an XML file has it.
std::string MakeXmlText(pugi::xml_document& document)
{
  for (pugi::xml_node node = document.first_child(); node;)
  {
    const pugi::xml_node next = node.next_sibling();
    const bool isHead = node.type() == pugi::node_doctype || node.type() == pugi::node_declaration;
    isHead ? document.remove_child(node) : false;
    node = next;
  }
  pugi::xml_node declaration = document.prepend_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  return ToXmlText(document);
}

/// Makes the text of a document as a file of this name has it.
Status MakeText(pugi::xml_document& document, const std::string& fileName, std::string& text)
{
  const bool isYaml = IsYaml(fileName);
  const Status status = isYaml ? MakeYaml(document, text) : Status();
  text = isYaml ? text : MakeXmlText(document);
  return status.IsOk() ? status : Status::Error(fileName + ": not written: " + status.Message());
}

/// The file part of a value, and what follows it: #id, or a pattern.
std::pair<std::string, std::string> SplitFile(const XmlValueRule& rule, const std::string& text)
{
  const bool isReference = rule.Kind == XmlKind::Reference;
  const std::size_t end = isReference ? text.rfind('#')
    : rule.File == XmlFile::Pattern   ? text.rfind('/')
                                      : text.size();
  return end == std::string::npos ? std::pair(std::string(), text)
                                  : std::pair(text.substr(0, end), text.substr(end));
}

/// The whole path of a file or folder; empty: not found.
std::string FindWhole(
  const XmlValueRule& rule, const std::string& name, const XmlDocument& from, Assets& files)
{
  if (rule.File == XmlFile::Pattern)
  {
    const std::vector<std::string> found =
      files.FindFiles({ rule.Name, name, from.GetPath() }, from);
    return found.empty() ? std::string()
                         : fs::absolute(found.front()).lexically_normal().parent_path().string();
  }
  std::vector<std::string> folders = files.GetFolders(from);
  if (rule.File == XmlFile::Beside)
  {
    folders = { fs::path(from.GetPath()).parent_path().string(), "" };
  }
  std::error_code ignored;
  for (const char* below : { "", "Models" }) // the Java program has a folder for models
  {
    for (const std::string& folder : folders)
    {
      const fs::path path = fs::path(folder) / below / name;
      if (!name.empty() && fs::exists(path, ignored) && !fs::is_directory(path, ignored))
      {
        return fs::absolute(path).lexically_normal().string();
      }
    }
  }
  return {};
}

} // namespace

//------------------------------------------------------------------------------
std::string ReferTo(const std::string& path, const std::string& folder,
  const std::vector<std::string>& assetDirectories)
{
  const fs::path whole = fs::absolute(path).lexically_normal();
  // Without a name after the slash, so that a folder has the same text with a slash at its end.
  const auto absolute = [](const std::string& base)
  { return fs::absolute(base.empty() ? "." : base + "/.").lexically_normal(); };
  std::vector<std::string> bases = assetDirectories;
  bases.push_back(folder);
  std::string shortest = whole.string();
  for (const std::string& base : bases)
  {
    const fs::path way = whole.lexically_relative(absolute(base));
    const bool isBelow = !way.empty() && way != "." && *way.begin() != "..";
    // The working directory of the program that reads the file may be another one.
    const bool isFixed = absolute(base) == absolute(folder) || absolute(base) != absolute("");
    if (isBelow && isFixed && way.string().size() < shortest.size())
    {
      shortest = way.string();
    }
  }
  return shortest;
}

//------------------------------------------------------------------------------
void FindFilesIn(pugi::xml_node node, const XmlDocument& from, Assets& files)
{
  VisitFiles(node,
    [&](const XmlValueRule& rule, pugi::xml_attribute attribute)
    {
      const std::string text = attribute.value();
      const bool isPattern = rule.File == XmlFile::Pattern;
      const auto [file, rest] = SplitFile(rule, text);
      const std::string path = FindWhole(rule, isPattern ? text : file, from, files);
      const std::string after = isPattern && rest[0] != '/' ? "/" + rest : rest;
      path.empty() ? void() : void(attribute.set_value((path + after).c_str()));
    });
}

//------------------------------------------------------------------------------
void ReferToFiles(pugi::xml_node node, const std::string& folder, const Assets& files)
{
  VisitFiles(node,
    [&](const XmlValueRule& rule, pugi::xml_attribute attribute)
    {
      const auto [file, rest] = SplitFile(rule, attribute.value());
      if (fs::path(file).is_absolute())
      {
        const std::vector<std::string> none;
        const bool isBeside = rule.File == XmlFile::Beside;
        const bool isPattern = rule.File == XmlFile::Pattern;
        const std::string name =
          ReferTo(isPattern ? file + rest : file, folder, isBeside ? none : files.GetDirectories());
        attribute.set_value((isPattern ? name : name + rest).c_str());
      }
    });
}

//------------------------------------------------------------------------------
/// The text of a reference to an element.
std::string SurveyDocument::Refer(const XmlElement& element) const
{
  const bool isOwn = &element.GetDocument() == this->Own.get();
  return element.GetTag() == "survey"
    ? "interpolated"
    : (isOwn ? "" : element.GetDocument().GetPath()) + "#" + element.GetText("id");
}

//------------------------------------------------------------------------------
/// Sets the places of a copy and all elements in it to those of the original.
void SurveyDocument::CopyPlaces(const XmlElement& from, pugi::xml_node to)
{
  this->Own->SetPlace(to, from.Where());
  pugi::xml_node copy = to.first_child();
  for (const pugi::xml_node child : from.GetNode().children())
  {
    child.type() == pugi::node_element
      ? this->CopyPlaces(XmlElement(&from.GetDocument(), child), copy)
      : void();
    copy = copy.next_sibling();
  }
}

//------------------------------------------------------------------------------
/// Copies an element of any document before the survey, with the files that it names.
pugi::xml_node SurveyDocument::CopyHere(const XmlElement& element)
{
  const std::string id = this->MakeId(element.GetTag().c_str(), element.GetText("id"));
  pugi::xml_node copy =
    this->Own->GetTree().child("document").insert_copy_before(element.GetNode(), this->GetSurvey());
  this->CopyPlaces(element, copy);
  copy.attribute("id") ? copy.attribute("id") : copy.prepend_attribute("id");
  copy.attribute("id") = id.c_str();
  FindFilesIn(copy, element.GetDocument(), this->Files);
  return copy;
}

//------------------------------------------------------------------------------
Status WriteTree(pugi::xml_document& document, const std::string& fileName)
{
  std::string text;
  const Status status = MakeText(document, fileName, text);
  return status.IsOk() ? WriteWhole(fileName, text) : status;
}

//------------------------------------------------------------------------------
Status WriteDocument(XmlDocument& document, Assets& files, const std::string& fileName)
{
  pugi::xml_document copy;
  copy.reset(document.GetTree());
  pugi::xml_node survey = copy.child("document").child("survey");
  if (survey && !survey.attribute("name"))
  {
    const std::string stem = fs::path(document.GetPath()).stem().string();
    survey.prepend_attribute("name") = MakeFolderName(stem).c_str();
  }
  const fs::path folder = GetFolder(fileName);
  if (folder != GetFolder(document.GetPath()))
  {
    FindFilesIn(copy, document, files);
  }
  ReferToFiles(copy, folder.string(), files);
  return WriteTree(copy, fileName);
}

//------------------------------------------------------------------------------
Status SurveyDocument::Write(const std::string& fileName)
{
  this->Log.Restart(nullptr); // a file that does not exist keeps its name
  return WriteDocument(*this->Own, this->Files, fileName);
}

//------------------------------------------------------------------------------
std::string SurveyDocument::MakeFileText(
  const SurveyPlace& place, const std::string& comment, const std::string& fileName)
{
  this->Log.Restart(this->Owner);
  const Found found = this->Find(place);
  pugi::xml_document document;
  document.append_child(pugi::node_comment).set_value(comment.c_str());
  document.append_child("document").append_copy(found.Element.GetNode());
  ReferToFiles(document, GetFolder(fileName).string(), this->Files);
  std::string text;
  const Status status = found ? MakeText(document, fileName, text) : Status();
  if (!status.IsOk())
  {
    this->Log.Error(status.Message());
  }
  return text;
}

//------------------------------------------------------------------------------
void SurveyDocument::SetComment(const std::string& text)
{
  pugi::xml_node root = this->Own->GetTree().child("document");
  root.parent().insert_child_before(pugi::node_comment, root).set_value(text.c_str());
}

} // namespace helios
