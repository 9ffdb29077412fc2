// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The elements and attributes of the dialect by their paths.

#ifndef heliosElementPath_h
#define heliosElementPath_h

#include "heliosXmlElement.h"
#include "heliosXmlKin.h"
#include "heliosXmlValue.h"

#include <pugixml.hpp>

#include <string>
#include <vector>

namespace helios
{

class Messages;

/**
 * A path is the names of elements and an attribute, as in dmotion[1]/motion/angle. An index counts
 * from 0, and is 0 if not given; that after the last adds an element. Filters of parts are named by
 * their type and parameters by their key, as in swap/translate/offset; of several translate or
 * scale without an index, the last one, which is used. A path to an element has the value true: the
 * element exists.
 */
class ElementPath
{
public:
  /// A path from an element; value: its path as given for messages, and their place.
  ElementPath(pugi::xml_node root, std::string path, const XmlValue& value)
    : Node(root)
    , Path(std::move(path))
    , Value(value)
  {
  }

  /// Finds what the path leads to, without a change. False after an error: that is, if adds is set,
  /// also an element that is missing and cannot be added.
  bool Follow(bool adds, Messages& log);

  /// Whether all elements of the path exist.
  bool IsThere() const { return this->Missing.empty(); }

  /// The rule of the attribute; null: the path is of an element.
  const XmlValueRule* GetRule() const { return this->Last; }

  /// The element that exists, the last one of the path or one above those that are missing.
  pugi::xml_node GetNode() const { return this->Node; }

  /// The text of the attribute, or "true" for an element; empty: not given.
  std::string Get() const;

  /// Checks a text for Set(); false after an error.
  bool Check(const std::string& text, Messages& log) const;

  /// Sets the text, with the elements that are missing. An empty one, of an element also false,
  /// removes it.
  void Set(const std::string& text, XmlDocument& document);

  /// The first name of a path.
  static std::string GetFirstName(const std::string& path);

  /// Whether an element has an attribute or a child of a name.
  static bool Knows(const XmlElementRule& rule, const std::string& name);

private:
  /// The children of a node that a name stands for, and how to add one.
  struct Kin : XmlKin
  {
    bool Has(pugi::xml_node child) const;
    pugi::xml_node Find(pugi::xml_node parent, int index, std::size_t& count) const;
    pugi::xml_node Add(pugi::xml_node parent) const;
  };

  struct Step
  {
    std::string Name;
    int Index = -1; ///< negative: not given
  };

  static std::vector<Step> Split(const std::string& path);
  bool Enter(const Step& step, bool adds, Messages& log);
  bool Refuse(const std::string& name, Messages& log) const;

  pugi::xml_node Node;
  std::string Path;
  const XmlValue& Value;
  const XmlElementRule* Rule = nullptr; ///< rule of the last element
  const XmlValueRule* Last = nullptr;
  std::vector<Kin> Missing;
};

/// Checks one value by its rule; false after an error.
bool CheckValue(const XmlValue& value, const XmlValueRule& rule, Messages& log);

/// The text as the dialect writes a value; empty: not given, or not valid.
std::string NormalizeValue(const XmlValue& value, const XmlValueRule& rule);

/// The default of a value that is stored; empty: none.
std::string GetDefault(const XmlValueRule& rule);

/// Says that a name is unknown, and which one is near. Always false.
bool RefuseName(const XmlValue& value, const std::string& name,
  const std::vector<std::string>& names, Messages& log);

} // namespace helios

#endif
