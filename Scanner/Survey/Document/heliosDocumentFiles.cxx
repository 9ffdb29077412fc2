// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What a survey refers to in other files: copied into its document, or named as in a new folder.
#include "heliosElementPath.h"
#include "heliosPartFile.h"
#include "heliosSurveyDocument.h"
#include "heliosXmlFilter.h"
#include "heliosXmlPart.h"
#include "heliosXmlText.h"

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
  const std::string type = GetFilterType(node.parent().attribute("type").value());
  const XmlElementRule* rule = FindXmlRule(isParameter ? "filter:" + type : node.name());
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

/// The file part of a value, and what follows it: #id, or a pattern.
std::pair<std::string, std::string> SplitFile(const XmlValueRule& rule, const std::string& text)
{
  const char mark = rule.File == XmlFile::Pattern ? '/' : '#';
  const bool isWhole = rule.File != XmlFile::Pattern && rule.Kind != XmlKind::Reference;
  const std::size_t end = isWhole ? std::string::npos : text.rfind(mark);
  const bool hasFile = isWhole || (end != std::string::npos && end > 0);
  return hasFile ? std::pair(text.substr(0, end), isWhole ? "" : text.substr(end))
                 : std::pair(std::string(), text);
}

/// The whole path of a file or folder; empty: not found.
std::string FindWhole(
  const XmlValueRule& rule, const std::string& name, const XmlDocument& from, const Assets& files)
{
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
      if (fs::exists(path, ignored) &&
        fs::is_directory(path, ignored) == (rule.File == XmlFile::Pattern))
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
  std::vector<std::string> bases = assetDirectories;
  bases.push_back(folder.empty() ? "." : folder);
  for (const std::string& base : bases)
  {
    // A trailing slash of the folder would make its last part empty.
    const fs::path way = whole.lexically_relative(fs::absolute(base + "/.").lexically_normal());
    if (!way.empty() && way != "." && *way.begin() != "..")
    {
      return way.string();
    }
  }
  return whole.string();
}

//------------------------------------------------------------------------------
void FindFilesIn(pugi::xml_node node, const XmlDocument& from, const Assets& files)
{
  VisitFiles(node,
    [&](const XmlValueRule& rule, pugi::xml_attribute attribute)
    {
      const auto [file, rest] = SplitFile(rule, attribute.value());
      const std::string path = file.empty() ? file : FindWhole(rule, file, from, files);
      path.empty() ? void() : void(attribute.set_value((path + rest).c_str()));
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
        const std::string name = ReferTo(file, folder, isBeside ? none : files.GetDirectories());
        attribute.set_value((name + rest).c_str());
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
/// The attributes of the survey and its legs that refer to an element; to <survey>: interpolated.
std::vector<pugi::xml_attribute> SurveyDocument::FindReferences(const XmlElement& element)
{
  const bool isSurvey = element.GetTag() == "survey";
  const std::string tag = isSurvey ? "platform" : element.GetTag();
  std::map<std::string, bool> known = { { "interpolated", isSurvey } };
  std::vector<pugi::xml_attribute> found;
  const auto add = [&](pugi::xml_attribute attribute)
  {
    const std::string text = attribute.value();
    if (attribute && known.count(text) == 0)
    {
      Messages silent(nullptr);
      const XmlValue value{ tag, text, "" };
      known[text] = this->Files.FindElement(tag.c_str(), value, *this->Own).GetIdentity() ==
        element.GetIdentity();
    }
    attribute&& known[text] ? found.push_back(attribute) : void();
  };
  add(this->GetSurvey().attribute(tag.c_str()));
  isSurvey ? void() : add(this->GetSurvey().attribute(tag == "platform" ? "basePlatform" : ""));
  for (const pugi::xml_node scan : this->GetSurvey().children("scan"))
  {
    add(scan.attribute(tag.c_str()));
  }
  for (const XmlElement& leg : this->GetLegs())
  {
    add(leg.GetNode().attribute(tag.c_str()));
  }
  return found;
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
/// A scanner or platform as an element of this document, which can be changed; of an interpolated
/// platform the one below it.
XmlElement SurveyDocument::TakeOver(SurveyItem item, int index)
{
  const bool isScanner = item == SurveyItem::Scanner;
  std::vector<XmlElement>& all = isScanner ? this->Elements.Scanners : this->Elements.Platforms;
  XmlElement& entry = all[static_cast<std::size_t>(index)];
  const bool isInterpolated = entry.GetTag() == "survey";
  XmlElement element = this->GetBasePlatform(entry);
  pugi::xml_node survey = this->GetSurvey();
  if (!element)
  {
    pugi::xml_node node =
      this->Own->GetTree().child("document").insert_child_before("platform", survey);
    SetAttribute(node, "id", this->MakeId("platform", "interpolated"));
    element = this->MakeElement(node);
    SetAttribute(survey, "basePlatform", this->Refer(element));
  }
  if (&element.GetDocument() == this->Own.get())
  {
    return element;
  }
  const std::vector<pugi::xml_attribute> references = this->FindReferences(element);
  const XmlElement copy = this->MakeElement(this->CopyHere(element));
  entry = isInterpolated ? entry : copy;
  for (pugi::xml_attribute reference : references)
  {
    reference.set_value(this->Refer(copy).c_str());
  }
  return copy;
}

//------------------------------------------------------------------------------
/// Makes the scene an element of this document, with one element for each part.
void SurveyDocument::TakeOverScene()
{
  XmlElement& scene = this->Elements.Scene;
  if (!scene)
  {
    return;
  }
  const std::vector<XmlElement> given = this->Elements.Parts;
  if (&scene.GetDocument() != this->Own.get())
  {
    scene = this->MakeElement(this->CopyHere(scene));
    this->GetSurvey().attribute("scene").set_value(this->Refer(scene).c_str());
    this->Elements.Parts = scene.GetChildren("part");
  }
  else
  {
    this->Elements.Parts = this->ListOwn("part");
  }
  std::size_t index = 0;
  for (const XmlElement& part : std::exchange(this->Elements.Parts, {}))
  {
    std::size_t last = index;
    while (last < given.size() && given[last].GetIdentity() == given[index].GetIdentity())
    {
      ++last;
    }
    last - index > 1 ? this->SpreadPart(part, index) : this->Elements.Parts.push_back(part);
    index = last;
  }
}

//------------------------------------------------------------------------------
/// Splits a part with several files and no id into one part per file, each with its default name.
void SurveyDocument::SpreadPart(const XmlElement& part, std::size_t index)
{
  const PartData data = ReadPart(part, this->Elements.Scene, this->Files);
  pugi::xml_node scene = this->Elements.Scene.GetNode();
  for (const std::string& file : data.Files)
  {
    pugi::xml_node one = scene.insert_copy_before(part.GetNode(), part.GetNode());
    this->CopyPlaces(part, one);
    one.remove_attribute("id");
    one.prepend_attribute("id") = std::to_string(index++).c_str();
    for (pugi::xml_node filter : one.children("filter"))
    {
      pugi::xml_node pattern = filter.find_child_by_attribute("param", "key", "efilepath");
      filter.remove_child(
        pattern ? filter.find_child_by_attribute("param", "key", "filepath") : pugi::xml_node());
      if (pattern)
      {
        pattern.attribute("key") = "filepath";
        pattern.attribute("value") = file.c_str();
      }
    }
    this->Elements.Parts.push_back(this->MakeElement(one));
  }
  scene.remove_child(part.GetNode());
}

//------------------------------------------------------------------------------
/// Adds the origins of the Java program to the positions of their legs.
void SurveyDocument::FoldOrigins()
{
  pugi::xml_node survey = this->GetSurvey();
  if (!survey.child("origin"))
  {
    return;
  }
  Vec3 offset(0.0, 0.0, 0.0);
  int leg = 0;
  std::vector<std::pair<int, Vec3>> moved;
  for (const pugi::xml_node child : survey.children())
  {
    const std::string tag = child.name();
    if (tag == "origin")
    {
      offset = Vec3(0.0, 0.0, 0.0);
      this->MakeElement(child).ReadVector(offset);
    }
    const auto legs = child.children("leg");
    const int count =
      tag == "scan" ? static_cast<int>(std::distance(legs.begin(), legs.end())) : tag == "leg";
    for (int i = 0; i < count; ++i)
    {
      moved.emplace_back(leg++, offset);
    }
  }
  while (survey.remove_child("origin"))
  {
  }
  for (const auto& [index, by] : moved)
  {
    const char* const names[] = { "x", "y", "z" };
    for (int k = 0; k < 3; ++k)
    {
      const SurveyPlace place{ SurveyItem::Leg, index };
      double number = 0.0;
      const XmlValueRule* rule = FindXmlRule("platformSettings")->FindValue(names[k]);
      ParseReal({ names[k], this->Get(place, names[k]), "" }, *rule, this->Log, number);
      by[k] != 0.0
        ? void(this->SetIn(this->Find(place), SurveyItem::Leg, names[k], ToXmlText(number + by[k])))
        : void();
    }
  }
}

//------------------------------------------------------------------------------
Status SurveyDocument::Write(const std::string& fileName)
{
  pugi::xml_document copy;
  copy.reset(this->Own->GetTree());
  for (pugi::xml_node node = copy.first_child(); node;)
  {
    const pugi::xml_node next = node.next_sibling();
    const bool isHead = node.type() == pugi::node_doctype || node.type() == pugi::node_declaration;
    isHead ? copy.remove_child(node) : false;
    node = next;
  }
  pugi::xml_node declaration = copy.prepend_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node survey = copy.child("document").child("survey");
  if (!survey.attribute("name"))
  {
    const std::string stem = fs::path(this->Own->GetPath()).stem().string();
    survey.prepend_attribute("name") = MakeFolderName(stem).c_str();
  }
  const std::string folder = fs::path(fileName).parent_path().string();
  FindFilesIn(copy, *this->Own, this->Files);
  ReferToFiles(copy, folder, this->Files);
  return WriteWhole(fileName, ToXmlText(copy));
}

} // namespace helios
