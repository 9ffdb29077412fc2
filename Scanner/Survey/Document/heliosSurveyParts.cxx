// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The scene of a survey: its parts and tables of parts.
#include "heliosElementPath.h"
#include "heliosPartTable.h"
#include "heliosRowTable.h"
#include "heliosSurveyDocument.h"
#include "heliosXmlFilter.h"
#include "heliosXmlPart.h"
#include "heliosXmlScene.h"
#include "heliosXmlText.h"

#include <cmath>
#include <cstring>
#include <utility>

namespace helios
{

namespace
{

/// "leg 2": a place in messages.
std::string Numbered(const std::string& what, std::size_t index)
{
  return what + " " + std::to_string(index);
}

/// Adds a rotation after the others of a part; one about the axis of the last one is added to it.
void AddRotation(pugi::xml_node part, const std::string& axis, double angle)
{
  pugi::xml_node last;
  for (const pugi::xml_node filter : part.children("filter"))
  {
    last = GetFilterType(filter.attribute("type").value()) == "rotate" ? filter : last;
  }
  pugi::xml_node rot = last.find_child_by_attribute("param", "key", "rotation").last_child();
  const bool isSame = rot &&
    FindRotationAxis(rot.attribute("axis").value()) == FindRotationAxis(axis) &&
    std::string(rot.parent().attribute("rotations").value()) != "local";
  if (!isSame)
  {
    last = last ? part.insert_child_after("filter", last) : part.append_child("filter");
    SetAttribute(last, "type", "rotate");
    pugi::xml_node parameter = last.append_child("param");
    SetAttribute(parameter, "key", "rotation");
    rot = parameter.append_child("rot");
    SetAttribute(rot, "axis", axis);
    SetAttribute(rot, "angle_deg", 0.0);
  }
  const double sum = std::remainder(rot.attribute("angle_deg").as_double() + angle, 360.0);
  rot.attribute("angle_deg") = ToXmlText(isSame ? RoundComputed(sum) : angle).c_str();
}

} // namespace

//------------------------------------------------------------------------------
/// The scene of this document, made if there is none.
SurveyDocument::Found SurveyDocument::MakeScene()
{
  this->AdoptScene();
  if (!this->Elements.Scene)
  {
    this->Elements.Scene =
      this->MakeElement(this->AddBefore("scene", this->MakeId("scene", "scene"), "scene"));
    this->GetSurvey().remove_attribute("scene");
    SetAttribute(this->GetSurvey(), "scene", this->Refer(this->Elements.Scene));
    this->Files.Scene =
      this->Files.Scene == AssetNeed::Replaced ? AssetNeed::Optional : this->Files.Scene;
  }
  return { this->Elements.Scene, "scene" };
}

//------------------------------------------------------------------------------
int SurveyDocument::AddPart(const std::string& loader, const std::string& file)
{
  this->Log.Restart(this->Owner);
  const std::string where = Numbered("part", this->Elements.Parts.size());
  XmlValueRule rule;
  std::string loaders;
  for (const std::string& each : GetLoaders())
  {
    loaders += (loaders.empty() ? "" : " ") + each;
  }
  rule.Choices = loaders.c_str();
  int type = 0;
  const std::string path = ParseChoice({ "filter", loader, where }, rule, this->Log, type)
    ? this->Files.FindFile({ "filepath", file, where }, *this->Own)
    : std::string();
  if (this->Log.HasError())
  {
    return -1;
  }
  pugi::xml_node part = this->MakeScene().Element.GetNode().append_child("part");
  pugi::xml_node filter = part.append_child("filter");
  SetAttribute(filter, "type", loader);
  pugi::xml_node parameter = filter.append_child("param");
  SetAttribute(parameter, "key", "filepath");
  SetAttribute(parameter, "value", path);
  this->Own->SetPlace(part, where);
  this->Elements.Parts.push_back(this->MakeElement(part));
  return static_cast<int>(this->Elements.Parts.size()) - 1;
}

//------------------------------------------------------------------------------
bool SurveyDocument::RemovePart(int part)
{
  this->Log.Restart(this->Owner);
  this->AdoptScene();
  const Found found = this->Find({ SurveyItem::Part, part });
  if (found)
  {
    this->Own->ForgetPlaces(found.Element.GetNode());
    this->Elements.Scene.GetNode().remove_child(found.Element.GetNode());
    this->Elements.Parts.erase(this->Elements.Parts.begin() + part);
  }
  return static_cast<bool>(found);
}

//------------------------------------------------------------------------------
void SurveyDocument::RemoveAllParts()
{
  this->AdoptScene();
  for (const char* tag : { "part", "partTable" })
  {
    for (const XmlElement& element : this->ListOwn(tag))
    {
      this->Own->ForgetPlaces(element.GetNode());
      this->Elements.Scene.GetNode().remove_child(element.GetNode());
    }
  }
  this->Elements.Parts.clear();
}

//------------------------------------------------------------------------------
int SurveyDocument::AddPartTable(const std::string& file)
{
  this->Log.Restart(this->Owner);
  const std::string path =
    file.empty() ? file : this->Files.FindFile({ "file", file, "part table" }, *this->Own);
  if (this->Log.HasError())
  {
    return -1;
  }
  const std::size_t index = this->ListOwn("partTable").size();
  pugi::xml_node table = this->MakeScene().Element.GetNode().append_child("partTable");
  SetAttribute(table, "file", path);
  this->Own->SetPlace(table, Numbered("part table", index));
  return static_cast<int>(this->ListOwn("partTable").size()) - 1;
}

//------------------------------------------------------------------------------
bool SurveyDocument::SetPartTableRows(int table, const std::string& text)
{
  this->Log.Restart(this->Owner);
  this->AdoptScene();
  const Found found = this->Find({ SurveyItem::PartTable, table });
  std::vector<TableRow> rows;
  RowTable reader("row", this->Log);
  reader.AddRequired("x", "the place of the part [m]");
  reader.AddRequired("y", "the place of the part [m]");
  reader.SetSkipsUnknown(true);
  const auto addRow = [&rows](const std::string& where) -> void*
  {
    rows.emplace_back().Where = where;
    return &rows.back();
  };
  if (!found || !reader.ReadText(found.Where + ", rows", text, addRow))
  {
    return false;
  }
  pugi::xml_node node = found.Element.GetNode();
  for (const XmlElement& row : found.Element.GetChildren("row"))
  {
    this->Own->ForgetPlaces(row.GetNode());
    node.remove_child(row.GetNode());
  }
  for (const TableRow& row : rows)
  {
    pugi::xml_node element = node.append_child("row");
    SetStored(element, row);
    this->Own->SetPlace(element, row.Where);
  }
  return true;
}

//------------------------------------------------------------------------------
bool SurveyDocument::RotatePart(int part, const std::string& axis, double angle)
{
  this->Log.Restart(this->Owner);
  this->AdoptScene();
  const Found found = this->Find({ SurveyItem::Part, part });
  const XmlElementRule* rule = FindXmlRule("rot");
  const XmlValue turn{ "angle_deg", ToXmlText(angle), found.Where };
  const bool isGood = found && CheckValue(turn, *rule->FindValue("angle_deg"), this->Log) &&
    CheckValue({ "axis", axis, found.Where }, *rule->FindValue("axis"), this->Log);
  if (isGood)
  {
    AddRotation(found.Element.GetNode(), axis, angle);
  }
  return isGood;
}

//------------------------------------------------------------------------------
bool SurveyDocument::UseScene(const std::string& reference)
{
  this->Log.Restart(this->Owner);
  const bool isFirst = reference.find('#') == std::string::npos;
  const XmlDocument* file = isFirst ? this->Files.Load(reference) : nullptr;
  const XmlValue value{ "scene", reference, this->Own->GetPath() };
  const XmlElement scene = file ? file->GetRoot().GetChild("scene")
    : isFirst                   ? XmlElement()
                                : this->Files.FindElement("scene", value, *this->Own);
  this->Elements.Parts.clear();
  scene ? void(ReadScene(scene, this->Files, &this->Elements.Parts)) : void();
  if (!scene || this->Log.HasError())
  {
    return false;
  }
  this->Elements.Scene = scene;
  this->GetSurvey().remove_attribute("scene");
  SetAttribute(this->GetSurvey(), "scene", this->Refer(scene));
  this->AdoptScene();
  return true;
}

//------------------------------------------------------------------------------
SceneData SurveyDocument::ResolveScene(Messages& log)
{
  this->Log.Restart(nullptr);
  const SceneData data = this->Elements.Scene
    ? ReadScene(this->Elements.Scene, this->Files, &this->Elements.Parts)
    : SceneData();
  this->Log.HasError() ? log.Error(this->Log.GetLastError()) : void();
  return data;
}

//------------------------------------------------------------------------------
std::string SurveyDocument::GetSceneText() const
{
  pugi::xml_document document;
  document.append_copy(this->Elements.Scene.GetNode());
  return this->Elements.Scene ? ToXmlText(document) : std::string();
}

//------------------------------------------------------------------------------
void SurveyDocument::SetSceneText(const std::string& text)
{
  pugi::xml_document document;
  document.load_string(text.c_str());
  const pugi::xml_node given =
    document.find_node([](pugi::xml_node node) { return std::strcmp(node.name(), "scene") == 0; });
  if (!given)
  {
    return;
  }
  pugi::xml_node old = this->MakeScene().Element.GetNode();
  pugi::xml_node scene = old.parent().insert_copy_before(given, old);
  this->Own->ForgetPlaces(old);
  old.parent().remove_child(old);
  this->Own->SetPlace(scene, "scene");
  this->Elements.Scene = this->MakeElement(scene);
  this->Elements.Parts = this->ListOwn("part");
  this->GetSurvey().attribute("scene").set_value(this->Refer(this->Elements.Scene).c_str());
}

//------------------------------------------------------------------------------
/// Makes the scene an element of this document, with one element for each part.
void SurveyDocument::AdoptScene()
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

} // namespace helios
