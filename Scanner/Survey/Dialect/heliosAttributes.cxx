// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosAttributes.h"

#include "heliosMessages.h"
#include "heliosSurveyData.h"
#include "heliosXmlRules.h"

#include <algorithm>
#include <iterator>

namespace helios
{

namespace
{

/// Collects the attributes of elements.
class Collector
{
public:
  /// Adds the attributes that a struct itself stores.
  template <typename WholeT>
  Collector& Add(const std::vector<const char*>& elements)
  {
    for (const char* element : elements)
    {
      this->AddPrefixed<WholeT>(element, "");
    }
    return *this;
  }

  template <typename WholeT>
  void AddPrefixed(const char* element, const std::string& prefix)
  {
    this->Add(element, prefix, typeid(WholeT), [](void* whole) { return whole; });
  }

  /// Adds those of a struct inside.
  template <auto First, auto... Rest>
  Collector& AddInside(const char* element)
  {
    using WholeT = store::Owner<First>;
    using InsideT =
      std::remove_reference_t<decltype(store::Follow<First, Rest...>(std::declval<WholeT&>()))>;
    this->Add(element, std::string(element) + "/", typeid(InsideT),
      [](void* whole)
      { return static_cast<void*>(&store::Follow<First, Rest...>(*static_cast<WholeT*>(whole))); });
    return *this;
  }

  /// Adds one attribute that a struct itself stores, as element/attribute.
  template <typename WholeT>
  Collector& AddOne(const char* element, const char* attribute)
  {
    Collector others;
    others.AddPrefixed<WholeT>(element, std::string(element) + "/");
    const std::string name = std::string(element) + "/" + attribute;
    std::copy_if(others.All.begin(), others.All.end(), std::back_inserter(this->All),
      [&name](const Attribute& other) { return other.Name == name; });
    return *this;
  }

  std::vector<Attribute> All;

private:
  void Add(const char* element, const std::string& prefix, const std::type_info& type,
    void* (*findOwner)(void*))
  {
    for (const XmlValueRule* rule : FindXmlRule(element)->FindStored(type))
    {
      const std::string name = prefix + rule->Name;
      const bool isKnown = std::any_of(this->All.begin(), this->All.end(),
        [&name](const Attribute& attribute) { return attribute.Name == name; });
      if (!isKnown && !rule->IsAlias)
      {
        this->All.push_back({ name, rule, findOwner });
      }
    }
  }
};

/// Copies a value between places of the same type.
void CopyPlace(const XmlPlace& from, const XmlPlace& to)
{
  const auto copy = [&from](auto place)
  {
    using PlaceT = decltype(place);
    if constexpr (std::is_pointer_v<PlaceT>)
    {
      *place = *std::get<PlaceT>(from);
    }
    else if constexpr (std::is_same_v<PlaceT, XmlEnumeration>)
    {
      place.Set(place.Place, place.Get(std::get<PlaceT>(from).Place));
    }
    else if constexpr (std::is_same_v<PlaceT, XmlAccess>)
    {
      Messages silent(nullptr);
      place.Set(place.Place, { "", place.Get(std::get<PlaceT>(from).Place), "" }, silent);
    }
  };
  std::visit(copy, to);
}

std::string Trim(std::string text)
{
  text.erase(0, std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  return text;
}

XmlPlace FindPlace(const Attribute& attribute, void* whole)
{
  return attribute.Rule->Store.Find(attribute.FindOwner(whole));
}

} // namespace

//------------------------------------------------------------------------------
template <>
const std::vector<Attribute>& GetAttributes<LegSettings>()
{
  static const std::vector<Attribute> attributes =
    Collector().Add<LegSettings>({ "leg", "platformSettings", "scannerSettings" }).All;
  return attributes;
}

//------------------------------------------------------------------------------
template <>
const std::vector<Attribute>& GetAttributes<ScannerData>()
{
  constexpr auto receiver = &ScannerData::Receiver;
  static const std::vector<Attribute> attributes =
    Collector()
      .Add<ScannerData>({ "scanner", "FWFSettings", "detectorSettings" })
      .AddOne<ScannerData>("channel", "id")
      .AddInside<&ScannerData::Beam>("beamOrigin")
      .AddInside<receiver, &ReceiverData::Errors>("rangeError")
      .AddInside<receiver, &ReceiverData::Errors>("deflectionError")
      .AddInside<receiver, &ReceiverData::Errors>("headError")
      .AddInside<receiver, &ReceiverData::Panoramic>("panoramicError")
      .All;
  return attributes;
}

//------------------------------------------------------------------------------
template <>
const std::vector<Attribute>& GetAttributes<PlatformData>()
{
  static const std::vector<Attribute> attributes =
    Collector()
      .Add<PlatformData>({ "platform" })
      .AddInside<&PlatformData::Mount>("scannerMount")
      .AddInside<&PlatformData::Noise, 0>("positionXNoise")
      .AddInside<&PlatformData::Noise, 1>("positionYNoise")
      .AddInside<&PlatformData::Noise, 2>("positionZNoise")
      .AddInside<&PlatformData::Noise, 3>("attitudeXNoise")
      .AddInside<&PlatformData::Noise, 4>("attitudeYNoise")
      .AddInside<&PlatformData::Noise, 5>("attitudeZNoise")
      .AddInside<&PlatformData::Errors>("navigationError")
      .All;
  return attributes;
}

//------------------------------------------------------------------------------
template <>
const std::vector<Attribute>& GetAttributes<SurveyData>()
{
  static const std::vector<Attribute> attributes = Collector().Add<SurveyData>({ "survey" }).All;
  return attributes;
}

//------------------------------------------------------------------------------
template <>
const std::vector<Attribute>& GetAttributes<SceneData>()
{
  static const std::vector<Attribute> attributes = Collector().Add<SceneData>({ "scene" }).All;
  return attributes;
}

//------------------------------------------------------------------------------
template <>
const std::vector<Attribute>& GetAttributes<PartData>()
{
  static const std::vector<Attribute> attributes = []
  {
    Collector collector;
    collector.Add<PartData>({ "part" });
    for (const XmlElementRule& rule : GetXmlRules())
    {
      const std::string name = rule.Name;
      if (name.rfind("filter:", 0) == 0)
      {
        collector.AddPrefixed<PartData>(rule.Name, name.substr(7) + "/");
      }
    }
    return collector.All;
  }();
  return attributes;
}

//------------------------------------------------------------------------------
const Attribute* FindAttribute(
  const std::vector<Attribute>& attributes, const XmlValue& value, Messages& log)
{
  std::vector<std::string> names;
  for (const Attribute& attribute : attributes)
  {
    if (attribute.Name == value.Name)
    {
      return &attribute;
    }
    names.push_back(attribute.Name);
  }
  const std::string nearest = FindNearestName(value.Name, names);
  log.Error(value.Where + ": attribute " + value.Name + " is unknown" +
    (nearest.empty() ? "; give one of " + Enumerate(names) : "; did you mean " + nearest + "?"));
  return nullptr;
}

//------------------------------------------------------------------------------
bool SetAttribute(const Attribute& attribute, const XmlValue& value, Messages& log, void* whole)
{
  const XmlPlace place = FindPlace(attribute, whole);
  const std::string text = attribute.Rule->HasBlanks ? value.Text : Trim(value.Text);
  if (text.empty())
  {
    CopyPlace(attribute.Rule->Store.FindDefault(), place);
    return true;
  }
  return ParseStored({ value.Name, text, value.Where }, *attribute.Rule, log, place);
}

//------------------------------------------------------------------------------
std::string GetAttribute(const Attribute& attribute, void* whole)
{
  return FormatStored(*attribute.Rule, FindPlace(attribute, whole));
}

} // namespace helios
