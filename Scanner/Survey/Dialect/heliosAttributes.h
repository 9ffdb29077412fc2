// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The attributes of the dialect that are stored in a struct, by their names.

#ifndef heliosAttributes_h
#define heliosAttributes_h

#include "heliosXmlValue.h"

#include <string>
#include <vector>

namespace helios
{

/// An attribute of a struct, or of a struct inside it.
struct Attribute
{
  std::string Name;
  const XmlValueRule* Rule;
  void* (*FindOwner)(void* whole); ///< the struct that stores the value
};

/// The attributes of the elements that describe a struct, each name once. Those of an element for a
/// struct inside, and the parameters of filters, are named element/attribute. Of SurveyData,
/// SceneData, PartData, ScannerData, PlatformData and LegSettings.
template <typename WholeT>
const std::vector<Attribute>& GetAttributes();

/// Whether a struct stores the attribute of a name; null: no.
template <typename WholeT>
const Attribute* FindStored(const std::string& name)
{
  for (const Attribute& attribute : GetAttributes<WholeT>())
  {
    if (attribute.Name == name)
    {
      return &attribute;
    }
  }
  return nullptr;
}

/// The attribute of a name; null after an error with its place and the nearest name.
const Attribute* FindAttribute(
  const std::vector<Attribute>& attributes, const XmlValue& value, Messages& log);

/// Sets a value; an empty text restores the default. False after an error.
bool SetAttribute(const Attribute& attribute, const XmlValue& value, Messages& log, void* whole);

std::string GetAttribute(const Attribute& attribute, void* whole);

/// Sets a value; an empty text restores the default. False after an error.
template <typename WholeT>
bool SetAttribute(WholeT& whole, const XmlValue& value, Messages& log)
{
  const Attribute* attribute = FindAttribute(GetAttributes<WholeT>(), value, log);
  return attribute && SetAttribute(*attribute, value, log, &whole);
}

/// A value as text; empty: not given, or after an error.
template <typename WholeT>
std::string GetAttribute(WholeT& whole, const XmlValue& value, Messages& log)
{
  const Attribute* attribute = FindAttribute(GetAttributes<WholeT>(), value, log);
  return attribute ? GetAttribute(*attribute, &whole) : std::string();
}

} // namespace helios

#endif
