// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneEdit.h"

#include "heliosAssets.h"
#include "heliosMessages.h"
#include "heliosPartFile.h"
#include "heliosSceneBuilder.h"
#include "heliosSceneReaders.h"
#include "heliosStatus.h"
#include "heliosSurveyDocument.h"
#include "heliosSurveyXml.h"
#include "heliosXmlFilter.h"
#include "heliosXmlPart.h"
#include "heliosXmlScene.h"
#include "heliosXmlText.h"

#include <vtkPolyData.h>
#include <vtkPolyDataAlgorithm.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>

namespace fs = std::filesystem;

namespace helios
{

namespace
{

constexpr const char* UsualId = "scene";

/// A parameter of a filter, added if missing.
pugi::xml_node GetParameter(pugi::xml_node filter, const char* key, const char* type)
{
  pugi::xml_node parameter = filter.find_child_by_attribute("param", "key", key);
  if (!parameter)
  {
    parameter = filter.append_child("param");
    parameter.append_attribute("type") = type;
    parameter.append_attribute("key") = key;
  }
  return parameter;
}

void SetValue(pugi::xml_node parameter, const std::string& value)
{
  parameter.remove_attribute("value");
  parameter.append_attribute("value") = value.c_str();
}

/// The last filter of a type, which is the one used; none if missing.
pugi::xml_node FindFilter(pugi::xml_node part, const char* type)
{
  pugi::xml_node found;
  for (const pugi::xml_node filter : part.children("filter"))
  {
    std::string name = filter.attribute("type").value();
    std::transform(name.begin(), name.end(), name.begin(),
      [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    found = name == type ? filter : found;
  }
  return found;
}

/// The same, added after the other filters if missing.
pugi::xml_node GetFilter(pugi::xml_node part, const char* type)
{
  pugi::xml_node filter = FindFilter(part, type);
  if (!filter)
  {
    pugi::xml_node before; // filters precede swaps and motions
    for (const pugi::xml_node child : part.children("filter"))
    {
      before = child;
    }
    filter = before ? part.insert_child_after("filter", before) : part.append_child("filter");
    filter.append_attribute("type") = type;
  }
  return filter;
}

std::string ToXmlText(const Vec3& v)
{
  return helios::ToXmlText(v[0]) + ";" + helios::ToXmlText(v[1]) + ";" + helios::ToXmlText(v[2]);
}

Vec3 ParseOffset(const std::string& text)
{
  Vec3 offset(0.0, 0.0, 0.0);
  const char* at = text.c_str();
  for (int i = 0; i < 3; ++i)
  {
    while (*at == ' ' || *at == ';')
    {
      ++at;
    }
    const auto parsed = std::from_chars(at, text.c_str() + text.size(), offset[i]);
    at = parsed.ptr;
  }
  return offset;
}

Vec3 GetOffset(pugi::xml_node part)
{
  const pugi::xml_node filter = FindFilter(part, "translate");
  return ParseOffset(
    filter.find_child_by_attribute("param", "key", "offset").attribute("value").value());
}

void SetOffset(pugi::xml_node part, const Vec3& offset)
{
  SetValue(
    GetParameter(GetFilter(part, "translate"), "offset", "vec3"), ToXmlText(RoundComputed(offset)));
}

double GetScale(pugi::xml_node part)
{
  double scale = 1.0;
  for (const pugi::xml_node filter : part.children("filter"))
  {
    const pugi::xml_node value = filter.find_child_by_attribute("param", "key", "scale");
    const double given = value.attribute("value").as_double();
    scale = given > 0.0 ? given : scale;
  }
  return scale;
}

bool IsOneTurn(pugi::xml_node filter)
{
  const pugi::xml_node parameter = filter.find_child_by_attribute("param", "key", "rotation");
  const pugi::xml_node rot = parameter.child("rot");
  return rot && !rot.next_sibling() && std::strcmp(rot.attribute("axis").value(), "z") == 0;
}

/// Adds to the last rotation if it is about the vertical, else appends one.
void AddTurn(pugi::xml_node part, double angle)
{
  pugi::xml_node filter = FindFilter(part, "rotate");
  if (!IsOneTurn(filter))
  {
    const pugi::xml_node before = filter ? filter : part.child("filter");
    filter = part.insert_child_after("filter", before);
    filter.append_attribute("type") = "rotate";
    pugi::xml_node rot = GetParameter(filter, "rotation", "rotation").append_child("rot");
    rot.append_attribute("axis") = "z";
    rot.append_attribute("angle_deg") = "0";
  }
  pugi::xml_attribute turn =
    GetParameter(filter, "rotation", "rotation").child("rot").attribute("angle_deg");
  const double sum = std::remainder(turn.as_double() + angle, 360.0);
  turn = helios::ToXmlText(RoundComputed(sum)).c_str();
}

} // namespace

/// The <scene>, and the search for its files.
class SceneEdit::Internals
{
public:
  pugi::xml_node GetScene() const { return this->Document.document_element(); }
  pugi::xml_node GetPart(int part) const;
  void Read(const XmlElement& scene, Assets& assets);
  void Spread(const XmlElement& element, pugi::xml_node part, const XmlElement& scene,
    Assets& assets, int& count);
  void FindFiles(pugi::xml_node node, const XmlDocument& from, Assets& assets);
  std::string Refer(const std::string& path) const
  {
    return ReferTo(path, this->Folder, this->AssetDirectories);
  }

  pugi::xml_document Document;
  std::string Folder;
  std::vector<std::string> AssetDirectories;
};

//------------------------------------------------------------------------------
pugi::xml_node SceneEdit::Internals::GetPart(int part) const
{
  for (const pugi::xml_node node : this->GetScene().children("part"))
  {
    if (part-- == 0)
    {
      return node;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void SceneEdit::Internals::Read(const XmlElement& scene, Assets& assets)
{
  this->Document.reset();
  pugi::xml_node copy = this->Document.append_copy(scene.GetNode());
  if (!copy.attribute("id"))
  {
    copy.prepend_attribute("id") = UsualId;
  }
  const std::vector<XmlElement> elements = scene.GetChildren("part");
  std::vector<pugi::xml_node> parts;
  for (const pugi::xml_node part : copy.children("part"))
  {
    parts.push_back(part);
  }
  int count = 0;
  for (std::size_t i = 0; i < std::min(parts.size(), elements.size()); ++i)
  {
    this->Spread(elements[i], parts[i], scene, assets, count);
  }
  for (const pugi::xml_node table : copy.children("partTable"))
  {
    this->FindFiles(table, scene.GetDocument(), assets);
  }
}

//------------------------------------------------------------------------------
/// Splits a part with several files and no id into one part per file, each with its default name.
void SceneEdit::Internals::Spread(const XmlElement& element, pugi::xml_node part,
  const XmlElement& scene, Assets& assets, int& count)
{
  const PartData data = ReadPart(element, scene, assets);
  this->FindFiles(part, element.GetDocument(), assets);
  if (!data.Name.empty())
  {
    ++count;
    return;
  }
  part.remove_attribute("id");
  for (const std::string& file : data.Files)
  {
    pugi::xml_node one = part.parent().insert_copy_before(part, part);
    one.prepend_attribute("id") = std::to_string(count++).c_str();
    for (pugi::xml_node filter : one.children("filter"))
    {
      pugi::xml_node pattern = filter.find_child_by_attribute("param", "key", "efilepath");
      if (pattern)
      {
        pattern.attribute("key") = "filepath";
        SetValue(pattern, this->Refer(file));
      }
    }
  }
  part.parent().remove_child(part);
}

//------------------------------------------------------------------------------
/// Names files relative to the new folder.
void SceneEdit::Internals::FindFiles(pugi::xml_node node, const XmlDocument& from, Assets& assets)
{
  const std::string key = node.attribute("key").value();
  const XmlValue value{ key, node.attribute("value").value(), from.GetPath() };
  if (key == "filepath" || key == "matfile" || key == "ladlut")
  {
    const std::string path = assets.FindFile(value, from);
    path.empty() ? void() : SetValue(node, this->Refer(path));
  }
  else if (key == "efilepath")
  {
    const std::vector<std::string> files = assets.FindFiles(value, from);
    const std::string pattern = value.Text.substr(value.Text.rfind('/') + 1);
    const fs::path folder = files.empty() ? fs::path() : fs::path(files.front()).parent_path();
    files.empty() ? void() : SetValue(node, fs::absolute(folder).string() + "/" + pattern);
  }
  const char* const name = std::strcmp(node.name(), "row") == 0 ? "model" : "file";
  if (pugi::xml_attribute file = node.attribute(name); file)
  {
    const std::string path = assets.FindPath(file.value(), from);
    path.empty() ? void() : void(file.set_value(this->Refer(path).c_str()));
  }
  for (const pugi::xml_node child : node.children())
  {
    this->FindFiles(child, from, assets);
  }
}

//------------------------------------------------------------------------------
SceneEdit::SceneEdit()
  : Inside(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
SceneEdit::~SceneEdit() = default;
SceneEdit::SceneEdit(SceneEdit&&) noexcept = default;
SceneEdit& SceneEdit::operator=(SceneEdit&&) noexcept = default;

//------------------------------------------------------------------------------
bool SceneEdit::Load(const std::string& scene, const std::string& folder,
  const std::vector<std::string>& assetDirectories, Messages& log)
{
  this->Inside->Folder = folder;
  this->Inside->AssetDirectories = assetDirectories;
  this->Inside->Document.reset();
  const std::string mesh = MakeMeshDocument(this->Inside->Refer(scene), UsualId);
  if (!mesh.empty())
  {
    const bool isGood = this->Inside->Document.load_string(mesh.c_str());
    pugi::xml_document whole;
    whole.append_copy(this->Inside->GetScene().first_child());
    this->Inside->Document.reset(whole);
    return isGood;
  }
  Assets assets(log, assetDirectories);
  const int before = log.GetNumberOfErrors();
  const auto here =
    XmlDocument::Make((fs::path(folder) / "survey.xml").string(), "<document></document>", log);
  const bool isFirst = scene.find('#') == std::string::npos;
  const XmlDocument* file = isFirst ? assets.Load(scene) : nullptr;
  const XmlElement element = file ? file->GetRoot().GetChild("scene")
    : isFirst                     ? XmlElement()
              : assets.FindElement("scene", { "scene", scene, here->GetPath() }, *here);
  if (element)
  {
    this->Inside->Read(element, assets);
  }
  return element && log.GetNumberOfErrors() == before;
}

//------------------------------------------------------------------------------
bool SceneEdit::IsLoaded() const
{
  return static_cast<bool>(this->Inside->GetScene());
}

//------------------------------------------------------------------------------
int SceneEdit::GetNumberOfParts() const
{
  const auto parts = this->Inside->GetScene().children("part");
  return static_cast<int>(std::distance(parts.begin(), parts.end()));
}

//------------------------------------------------------------------------------
std::string SceneEdit::GetPartName(int part) const
{
  return this->Inside->GetPart(part).attribute("id").value();
}

//------------------------------------------------------------------------------
int SceneEdit::FindPart(const std::string& name) const
{
  for (int part = 0; part < this->GetNumberOfParts(); ++part)
  {
    if (this->GetPartName(part) == name)
    {
      return part;
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
bool SceneEdit::MovePart(int part, const Vec3& way)
{
  const pugi::xml_node node = this->Inside->GetPart(part);
  if (!node)
  {
    return false;
  }
  SetOffset(node, GetOffset(node) + way);
  return true;
}

//------------------------------------------------------------------------------
bool SceneEdit::TurnPart(int part, double angle, const Vec3& about)
{
  const pugi::xml_node node = this->Inside->GetPart(part);
  if (!node)
  {
    return false;
  }
  AddTurn(node, angle);
  SetOffset(node, about + Rotate(AxisAngle({ 0.0, 0.0, 1.0 }, angle), GetOffset(node) - about));
  return true;
}

//------------------------------------------------------------------------------
bool SceneEdit::ScalePart(int part, double factor, const Vec3& about)
{
  const pugi::xml_node node = this->Inside->GetPart(part);
  if (!node || !(factor > 0.0))
  {
    return false;
  }
  const double scale = factor * GetScale(node);
  SetValue(GetParameter(GetFilter(node, "scale"), "scale", "double"), helios::ToXmlText(scale));
  SetOffset(node, about + factor * (GetOffset(node) - about));
  return true;
}

//------------------------------------------------------------------------------
bool SceneEdit::RemovePart(int part)
{
  const pugi::xml_node node = this->Inside->GetPart(part);
  return this->GetNumberOfParts() > 1 && node && this->Inside->GetScene().remove_child(node);
}

//------------------------------------------------------------------------------
int SceneEdit::AddPart(const std::string& fileName, const Vec3& place, Messages& log)
{
  PartData data;
  data.Type = FindLoader(fileName).value_or(Loader::Obj);
  const auto reader = MakeSceneReader(data, fileName);
  log.Listen(reader);
  reader->Update();
  if (reader->GetOutput()->GetNumberOfPoints() == 0)
  {
    log.Error(
      fileName + ": has nothing to add to the scene; give a file with faces: " + GetMeshEndings());
    return -1;
  }
  double b[6];
  reader->GetOutput()->GetBounds(b);
  const std::string stem = fs::path(fileName).stem().string();
  std::string name = stem;
  for (int i = 2; this->FindPart(name) >= 0; ++i)
  {
    name = stem + "_" + std::to_string(i);
  }
  pugi::xml_node part = this->Inside->GetScene().append_child("part");
  part.append_attribute("id") = name.c_str();
  pugi::xml_node filter = part.append_child("filter");
  filter.append_attribute("type") = GetLoaderName(data.Type).c_str();
  SetValue(GetParameter(filter, "filepath", "string"), this->Inside->Refer(fileName));
  SetOffset(part, place - Vec3(0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), b[4]));
  return this->GetNumberOfParts() - 1;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SceneEdit::Build(Messages& log) const
{
  const int before = log.GetNumberOfErrors();
  Assets assets(log, this->Inside->AssetDirectories);
  const auto document = XmlDocument::Make(
    (fs::path(this->Inside->Folder) / "scene.xml").string(), this->MakeFile(), log);
  const XmlElement element = document ? document->GetRoot().GetChild("scene") : XmlElement();
  const SceneData data = element ? ReadScene(element, assets) : SceneData();
  if (!element || log.GetNumberOfErrors() != before)
  {
    return nullptr;
  }
  SceneBuilder builder(data, log);
  builder.SetInstances(true);
  return builder.Build([](const std::string&) { return true; });
}

//------------------------------------------------------------------------------
std::string SceneEdit::GetId() const
{
  return this->Inside->GetScene().attribute("id").value();
}

//------------------------------------------------------------------------------
std::string SceneEdit::GetText() const
{
  return this->IsLoaded() ? helios::ToXmlText(this->Inside->Document) : "";
}

//------------------------------------------------------------------------------
void SceneEdit::SetText(const std::string& text)
{
  this->Inside->Document.load_string(text.c_str());
}

//------------------------------------------------------------------------------
std::string SceneEdit::MakeFile() const
{
  pugi::xml_document document;
  StartDocument(document, " A scene changed by hand, written by vtkHelios. ")
    .append_copy(this->Inside->GetScene());
  return helios::ToXmlText(document);
}

//------------------------------------------------------------------------------
Status SceneEdit::Save(const std::string& fileName) const
{
  return WriteWhole(fileName, this->MakeFile());
}

} // namespace helios
