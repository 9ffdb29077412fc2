// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlFilter.h"

#include "heliosMessages.h"
#include "heliosXmlRules.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <sstream>

namespace helios
{

namespace
{

/// Loaders of files that are meshes, by the extension.
constexpr struct
{
  const char* Ending;
  Loader Type;
} Endings[] = { { ".obj", Loader::Obj }, { ".tif", Loader::GeoTiff }, { ".tiff", Loader::GeoTiff },
  { ".vrt", Loader::GeoTiff }, { ".ply", Loader::Ply }, { ".stl", Loader::Stl },
  { ".json", Loader::CityJson }, { ".jsonl", Loader::CityJson }, { ".gltf", Loader::Gltf },
  { ".glb", Loader::Gltf } };

} // namespace

//------------------------------------------------------------------------------
XmlFilter::XmlFilter(const XmlElement& element)
  : Element(element)
  , Type(GetFilterType(element.GetText("type")))
  , Rule(FindFilterRule(this->Type))
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
void XmlFilter::AddParameter(const XmlElement& parameter)
{
  parameter.CheckNames();
  const std::string key = parameter.GetText("key");
  const std::string warned = parameter.GetDocument().GetPath() + " " + this->Type + " " + key;
  const std::string what =
    parameter.Where() + ": parameter \"" + key + "\" of filter " + this->Type + " ";
  if (const XmlValueRule* rule = this->Rule->FindValue(key))
  {
    this->Parameters[key] = parameter;
    if (rule->Use == XmlUse::NotModelled)
    {
      this->GetMessages().WarnOnce(warned, what + "is not modelled and not used");
    }
    return;
  }
  const std::string nearest = this->Rule->FindNearestValue(key);
  this->GetMessages().WarnOnce(warned,
    what + "is unknown" + (nearest.empty() ? " and not used" : "; did you mean " + nearest + "?"));
}

//------------------------------------------------------------------------------
XmlValue XmlFilter::GetValue(const char* key) const
{
  const XmlElement& parameter = this->GetParameter(key);
  return { key, parameter.GetText("value"), parameter.Where() };
}

//------------------------------------------------------------------------------
bool XmlFilter::Read(const char* key, std::string& target) const
{
  if (!this->Has(key))
  {
    return false;
  }
  target = this->GetValue(key).Text;
  return true;
}

//------------------------------------------------------------------------------
bool XmlFilter::Read(const char* key, double& target) const
{
  return this->Has(key) &&
    ParseReal(this->GetValue(key), *this->Rule->FindValue(key), this->GetMessages(), target);
}

//------------------------------------------------------------------------------
bool XmlFilter::Read(const char* key, int& target) const
{
  return this->Has(key) &&
    ParseInteger(this->GetValue(key), *this->Rule->FindValue(key), this->GetMessages(), target);
}

//------------------------------------------------------------------------------
bool XmlFilter::Read(const char* key, bool& target) const
{
  return this->Has(key) && ParseBoolean(this->GetValue(key), this->GetMessages(), target);
}

//------------------------------------------------------------------------------
bool XmlFilter::Read(const char* key, Vec3& target) const
{
  return this->Has(key) && ParseVector(this->GetValue(key), this->GetMessages(), target);
}

//------------------------------------------------------------------------------
const std::vector<std::string>& GetFilterTypes()
{
  static const std::vector<std::string> types = { "objloader", "geotiffloader", "xyzloader",
    "detailedvoxels", "plyloader", "stlloader", "cityjsonloader", "gltfloader", "lasloader", "crs",
    "repair", "simplify", "frames", "rotate", "scale", "translate" };
  return types;
}

//------------------------------------------------------------------------------
std::string MakeMeshDocument(const std::string& fileName, const std::string& id)
{
  const std::optional<Loader> loader = FindLoader(fileName);
  if (!loader)
  {
    return {};
  }
  pugi::xml_document document;
  pugi::xml_node scene = document.append_child("document").append_child("scene");
  scene.append_attribute("id") = id.c_str();
  pugi::xml_node part = scene.append_child("part");
  part.append_attribute("id") = id.c_str();
  pugi::xml_node filter = part.append_child("filter");
  filter.append_attribute("type") = GetLoaderName(*loader).c_str();
  pugi::xml_node param = filter.append_child("param");
  param.append_attribute("type") = "string";
  param.append_attribute("key") = "filepath";
  param.append_attribute("value") = fileName.c_str();
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

//------------------------------------------------------------------------------
std::vector<std::string> GetLoaders()
{
  const std::vector<std::string>& types = GetFilterTypes();
  return { types.begin(), std::find(types.begin(), types.end(), "crs") };
}

//------------------------------------------------------------------------------
const std::string& GetLoaderName(Loader type)
{
  return GetFilterTypes()[static_cast<std::size_t>(type)];
}

//------------------------------------------------------------------------------
std::optional<Loader> FindLoader(const std::string& fileName)
{
  const std::string ending = ToLower(std::filesystem::path(fileName).extension().string());
  const auto* found = std::find_if(std::begin(Endings), std::end(Endings),
    [&ending](const auto& each) { return ending == each.Ending; });
  return found == std::end(Endings) ? std::nullopt : std::optional(found->Type);
}

//------------------------------------------------------------------------------
std::string GetMeshEndings()
{
  std::string all;
  for (const auto& each : Endings)
  {
    all += (all.empty() ? "" : ", ") + std::string(each.Ending);
  }
  return all;
}

} // namespace helios
