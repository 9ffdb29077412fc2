// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlScene.h"

#include "heliosMessages.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

namespace helios
{

namespace
{

std::string ToLower(std::string text)
{
  std::transform(text.begin(),
    text.end(),
    text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// One <filter>: its parameters by name.
class Filter
{
public:
  explicit Filter(const XmlElement& element);

  const std::string& GetType() const { return this->Type; }
  const XmlElement& GetElement() const { return this->Element; }
  Messages& GetMessages() const { return this->Element.GetMessages(); }

  bool Has(const char* key) const { return this->Parameters.count(key) > 0; }
  const XmlElement& GetParameter(const char* key) const { return this->Parameters.at(key); }
  XmlValue GetValue(const char* key) const;

  /// The value of a parameter, by its rule; false where it is missing or wrong.
  bool Read(const char* key, double& target) const;
  bool Read(const char* key, int& target) const;
  bool Read(const char* key, Vec3& target) const;

private:
  void AddParameter(const XmlElement& parameter);

  XmlElement Element;
  std::string Type;
  const XmlElementRule* Rule;
  std::map<std::string, XmlElement> Parameters;
};

//------------------------------------------------------------------------------
Filter::Filter(const XmlElement& element)
  : Element(element)
  , Type(ToLower(element.GetText("type")))
  , Rule(FindXmlRule("filter:" + this->Type))
{
  element.CheckNames();
  if (this->Rule)
  {
    for (const XmlElement& parameter : element.GetChildren("param"))
    {
      this->AddParameter(parameter);
    }
  }
}

//------------------------------------------------------------------------------
void Filter::AddParameter(const XmlElement& parameter)
{
  parameter.CheckNames();
  const std::string key = parameter.GetText("key");
  if (this->Rule->FindValue(key))
  {
    this->Parameters[key] = parameter;
    return;
  }
  const std::string nearest = this->Rule->FindNearestValue(key);
  const std::string warned = parameter.GetDocument().GetPath() + " " + this->Type + " " + key;
  this->GetMessages().WarnOnce(warned,
    parameter.Where() + ": parameter \"" + key + "\" of filter " + this->Type + " is unknown" +
      (nearest.empty() ? " and not used" : "; did you mean " + nearest + "?"));
}

//------------------------------------------------------------------------------
XmlValue Filter::GetValue(const char* key) const
{
  const XmlElement& parameter = this->GetParameter(key);
  return { key, parameter.GetText("value"), parameter.Where() };
}

//------------------------------------------------------------------------------
bool Filter::Read(const char* key, double& target) const
{
  return this->Has(key) &&
    ParseReal(this->GetValue(key), *this->Rule->FindValue(key), this->GetMessages(), target);
}

//------------------------------------------------------------------------------
bool Filter::Read(const char* key, int& target) const
{
  return this->Has(key) &&
    ParseInteger(this->GetValue(key), *this->Rule->FindValue(key), this->GetMessages(), target);
}

//------------------------------------------------------------------------------
bool Filter::Read(const char* key, Vec3& target) const
{
  return this->Has(key) && ParseVector(this->GetValue(key), this->GetMessages(), target);
}

//------------------------------------------------------------------------------
/// Reads the filters of one <part>.
class PartReader
{
public:
  PartReader(const XmlElement& element, Assets& assets)
    : Element(element)
    , Files(assets)
  {
  }

  /// The part with its files; several of them that each are a part of its own where it has no id.
  PartData Read();

private:
  void ReadFilter(const Filter& filter);
  void ReadObjLoader(const Filter& filter);
  void ReadScale(const Filter& filter);
  void ReadTranslate(const Filter& filter);
  void WarnIfRepeated(const Filter& filter, bool& seen);
  void ReportFilter(const Filter& filter);

  const XmlElement& Element;
  Assets& Files;
  PartData Part;
  bool HasLoader = false;
  bool HasScale = false;
  bool HasTranslate = false;
};

//------------------------------------------------------------------------------
PartData PartReader::Read()
{
  this->Element.CheckNames();
  this->Part.Where = this->Element.Where();
  this->Part.Name = this->Element.GetText("id");
  for (const XmlElement& filter : this->Element.GetChildren("filter"))
  {
    this->ReadFilter(Filter(filter));
  }
  if (!this->HasLoader)
  {
    this->Element.GetMessages().Error(
      this->Part.Where + ": <part> has no loader; add a <filter type=\"objloader\">");
  }
  return this->Part;
}

//------------------------------------------------------------------------------
void PartReader::ReadFilter(const Filter& filter)
{
  if (filter.GetType() == "objloader")
  {
    this->ReadObjLoader(filter);
  }
  else if (filter.GetType() == "scale")
  {
    this->ReadScale(filter);
  }
  else if (filter.GetType() == "translate")
  {
    this->ReadTranslate(filter);
  }
  else if (filter.GetType() == "rotate" && filter.Has("rotation"))
  {
    this->Part.Rotation = filter.GetParameter("rotation").ReadRotation() * this->Part.Rotation;
  }
  else if (filter.GetType() != "rotate")
  {
    this->ReportFilter(filter);
  }
}

//------------------------------------------------------------------------------
void PartReader::ReadObjLoader(const Filter& filter)
{
  Messages& log = filter.GetMessages();
  const std::string where = filter.GetElement().Where();
  if (this->HasLoader)
  {
    log.Error(where + ": a second loader in one <part>; make a <part> of each");
    return;
  }
  this->HasLoader = true;
  const XmlDocument& document = filter.GetElement().GetDocument();
  if (filter.Has("efilepath"))
  {
    this->Part.Files = this->Files.FindFiles(filter.GetValue("efilepath"), document);
  }
  else if (filter.Has("filepath"))
  {
    this->Part.Files = { this->Files.FindFile(filter.GetValue("filepath"), document) };
  }
  else
  {
    log.Error(
      where + ": filter objloader has no filepath; add <param key=\"filepath\" value=\"...\">");
  }
  const std::string up = filter.Has("up") ? ToLower(filter.GetValue("up").Text) : "z";
  this->Part.UpIsY = up == "y";
  if (up != "y" && up != "z")
  {
    log.Error(
      filter.GetValue("up").Where + ": up=\"" + up + "\" is no axis that points up; give y or z");
  }
}

//------------------------------------------------------------------------------
void PartReader::ReadScale(const Filter& filter)
{
  double scale = 0.0;
  if (!filter.Read("scale", scale))
  {
    return;
  }
  this->WarnIfRepeated(filter, this->HasScale);
  if (scale > 0.0)
  {
    this->Part.Scale = scale;
    return;
  }
  filter.GetMessages().Warning(
    filter.GetElement().Where() + ": scale=\"0\" is not used; the part keeps its size");
}

//------------------------------------------------------------------------------
void PartReader::ReadTranslate(const Filter& filter)
{
  this->WarnIfRepeated(filter, this->HasTranslate);
  int onGround = 0;
  this->Part.Translation = Vec3(0.0, 0.0, 0.0);
  filter.Read("offset", this->Part.Translation);
  filter.Read("onGround", onGround);
  this->Part.OnGround = onGround != 0;
}

//------------------------------------------------------------------------------
void PartReader::WarnIfRepeated(const Filter& filter, bool& seen)
{
  if (seen)
  {
    filter.GetMessages().Warning(filter.GetElement().Where() + ": a repeated filter " +
      filter.GetType() + " replaces the one before it in this <part>");
  }
  seen = true;
}

//------------------------------------------------------------------------------
void PartReader::ReportFilter(const Filter& filter)
{
  static const std::vector<std::string> later = { "geotiffloader",
    "xyzloader",
    "detailedvoxels",
    "crs",
    "crstransform",
    "transform",
    "assumematerials",
    "wms" };
  static const std::vector<std::string> now = { "objloader", "rotate", "scale", "translate" };
  const std::string& type = filter.GetType();
  std::string text = filter.GetElement().Where() + ": filter type=\"" + type + "\" ";
  if (std::find(later.begin(), later.end(), type) != later.end())
  {
    text += "comes with a later version; those that exist now are ";
  }
  else
  {
    const std::string nearest = FindNearestName(type, now);
    text +=
      "is unknown; " + (nearest.empty() ? "" : "did you mean " + nearest + "? ") + "Filters are ";
  }
  filter.GetMessages().Error(text + "objloader, rotate, scale and translate");
  this->HasLoader =
    this->HasLoader || type.find("load") != std::string::npos || type == "detailedvoxels";
}

//------------------------------------------------------------------------------
/// Adds a part; as one part a file where it has several files and no id.
void AddPart(PartData part, std::vector<PartData>& parts)
{
  if (!part.Name.empty())
  {
    parts.push_back(part);
    return;
  }
  const std::vector<std::string> files = std::move(part.Files);
  for (const std::string& file : files)
  {
    part.Name = std::to_string(parts.size());
    part.Files = { file };
    parts.push_back(part);
  }
}

std::vector<std::string> FindSpectraFolders(const std::vector<std::string>& folders)
{
  std::vector<std::string> spectra;
  for (const std::string& folder : folders)
  {
    spectra.push_back((std::filesystem::path(folder) / "spectra").lexically_normal().string());
  }
  return spectra;
}

} // namespace

//------------------------------------------------------------------------------
SceneData ReadScene(const XmlElement& element, Assets& assets)
{
  SceneData scene;
  scene.Where = element.Where();
  scene.Id = element.GetText("id");
  scene.Name = element.Has("name") ? element.GetText("name") : scene.Id;
  scene.SpectraFolders = FindSpectraFolders(assets.GetFolders(element.GetDocument()));
  element.CheckNames();
  const std::vector<XmlElement> parts = element.GetChildren("part");
  for (const XmlElement& part : parts)
  {
    AddPart(PartReader(part, assets).Read(), scene.Parts);
  }
  if (parts.empty())
  {
    element.GetMessages().Error(
      scene.Where + ": scene " + scene.Id + " has no <part>; add one with an objloader");
  }
  return scene;
}

} // namespace helios
