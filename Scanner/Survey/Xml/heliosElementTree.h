// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// An element of the dialect with its children, made by the paths of its attributes.

#ifndef heliosElementTree_h
#define heliosElementTree_h

#include "heliosXmlElement.h"
#include "heliosXmlValue.h"

#include <pugixml.hpp>

#include <memory>
#include <set>
#include <string>

namespace helios
{

class Messages;

/**
 * A path is the names of elements and an attribute, as in dmotion[1]/motion/angle. An index counts
 * from 0, and is 0 if not given; that after the last adds an element. Filters of parts are named by
 * their type and parameters by their key, as in swap/translate/offset. A path to an element has the
 * value true: the element exists.
 */
class ElementTree
{
public:
  explicit ElementTree(const std::string& tag);
  ElementTree(const ElementTree& other);
  ElementTree& operator=(const ElementTree& other);

  /// Sets the value of a path; an empty one, of an element also false, removes it. False, without a
  /// change, after an error.
  bool Set(const XmlValue& value, Messages& log);

  /// The value of a path; empty: not given, or after an error.
  std::string Get(const XmlValue& value, Messages& log) const;

  /// Whether any path with this first name was set.
  bool HasSet(const std::string& name) const { return this->Names.count(name) > 0; }

  /// The element for the readers of files, with places such as "part 0, dmotion[1]".
  std::unique_ptr<XmlDocument> MakeDocument(const std::string& where, Messages& log) const;

  /// The path without indices that are 0.
  static std::string Simplify(std::string path);

  /// The first name of a path.
  static std::string GetFirstName(const std::string& path);

private:
  pugi::xml_node GetRoot() const { return this->Tree.first_child(); }

  pugi::xml_document Tree;
  std::set<std::string> Names; // first ones that were set
};

} // namespace helios

#endif
