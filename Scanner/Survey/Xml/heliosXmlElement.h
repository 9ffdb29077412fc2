// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// XML files and their elements, read strictly, with file:line in every message.

#ifndef heliosXmlElement_h
#define heliosXmlElement_h

#include "heliosPose.h"
#include "heliosXmlRules.h"
#include "heliosXmlValue.h"

#include <pugixml.hpp>

#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace helios
{

/// The deepest nesting of elements in a document.
constexpr int DocumentDepth = 64;

class Messages;
class XmlElement;

/// One file: XML, or YAML by its ending. Entities of XML other than its own five are not expanded.
class XmlDocument
{
public:
  /// Reads a file; null if it is not XML or YAML, or its root is not <document>. A second root and a
  /// duplicate attribute are errors; the first is used.
  static std::unique_ptr<XmlDocument> Load(const std::string& path, Messages& messages);

  /// Makes a document of the text of a file, XML.
  static std::unique_ptr<XmlDocument> Make(
    const std::string& path, std::string text, Messages& messages);

  /// Makes a document of an element that is not from a file: places are paths instead of lines.
  static std::unique_ptr<XmlDocument> MakeOf(
    const std::string& place, std::string text, Messages& messages);

  const std::string& GetPath() const { return this->Path; }
  Messages& GetMessages() const { return *this->Log; }
  XmlElement GetRoot() const;

  /// The place of an element in messages: "file:line", or "file:line:column" after another element
  /// with its name in the line. Columns count bytes, from 1. An element that was not read from a file,
  /// or was changed since, has the place that was set for it, or its path from the nearest element
  /// with one, as in "part 0, dmotion[1]/motion".
  std::string Where(pugi::xml_node node) const;

  /// The place of an attribute: its own line in YAML, or that of its element.
  std::string Where(pugi::xml_node node, pugi::xml_attribute attribute) const;

  /// Sets the line of an element or attribute of a file, and the column of one that the line does not
  /// tell from others; 0: none.
  void SetLine(const void* object, std::size_t line, std::size_t column = 0);

  /// Sets the place of an element, and forgets that of an element that is removed.
  void SetPlace(pugi::xml_node node, const std::string& place);
  const std::string* GetPlace(pugi::xml_node node) const; ///< that was set; null: none
  void ForgetPlaces(pugi::xml_node node);

  /// The tree of a document that is changed.
  pugi::xml_document& GetTree() { return this->Tree; }

private:
  XmlDocument() = default;
  static std::unique_ptr<XmlDocument> Make(
    const std::string& path, std::string text, bool isYaml, Messages& messages);
  bool CheckText(std::string& text);
  bool Parse(std::string text);
  bool CheckDepth();
  bool CheckRoot();
  std::string WhereOffset(std::ptrdiff_t offset) const;
  std::string MakePlace(const std::pair<std::size_t, std::size_t>& line) const;
  std::size_t FindLine(std::ptrdiff_t offset) const;
  void CheckElements();

  std::string Path;
  Messages* Log = nullptr;
  pugi::xml_document Tree;
  std::vector<std::ptrdiff_t> LineEnds;
  std::vector<std::ptrdiff_t> Repeated; // elements after others with their name in a line, in order
  std::unordered_map<const void*, std::string> Places; // by their elements
  std::unordered_map<const void*, std::pair<std::size_t, std::size_t>>
    Lines;             // and columns, of YAML
  bool IsMade = false; // not from a file
};

/// Returns whether a name is that of a file in YAML, by its ending.
bool IsYaml(const std::string& path);

/// Returns the axis of a rotation: x, y, z, or the names of the Java program; null for others.
const Vec3* FindRotationAxis(const std::string& name);

/// The path of an element from one that holds it, as in dmotion[1]/motion; empty: that one.
std::string MakePath(pugi::xml_node node, pugi::xml_node from);

/// An element of a document, or none. It is valid as long as its document.
class XmlElement
{
public:
  XmlElement() = default;
  XmlElement(const XmlDocument* document, pugi::xml_node node)
    : Document(document)
    , Node(node)
  {
  }

  explicit operator bool() const { return !this->Node.empty(); }
  std::string GetTag() const { return this->Node.name(); }

  /// Returns a pointer that differs for all elements, whatever their places and ids; null: no
  /// element.
  const void* GetIdentity() const { return this->Node.internal_object(); }

  /// Returns its place, or that of an attribute, for messages only: "file:line", or "file:line:column".
  std::string Where() const;
  std::string Where(const char* attribute) const;

  /// The element in the tree of its document.
  pugi::xml_node GetNode() const { return this->Node; }

  const XmlDocument& GetDocument() const { return *this->Document; }
  Messages& GetMessages() const { return this->Document->GetMessages(); }

  /// Returns the children, all or with a tag, in order; the first of them, or none.
  std::vector<XmlElement> GetChildren() const;
  std::vector<XmlElement> GetChildren(const char* tag) const;
  XmlElement GetChild(const char* tag) const { return { this->Document, this->Node.child(tag) }; }

  bool Has(const char* name) const { return !this->Node.attribute(name).empty(); }

  /// Returns the trimmed text of an attribute; empty if missing.
  std::string GetText(const char* name) const;

  /**
   * Read an attribute (or, if the dialect has such a child, its text) by its rule. False if it is
   * missing or invalid; the target is then unchanged.
   */
  bool Read(const char* name, std::string& target) const;
  bool Read(const char* name, double& target) const;
  bool Read(const char* name, int& target) const;
  bool Read(const char* name, bool& target) const;
  bool Read(const char* name, std::vector<double>& target) const;
  bool Read(const char* name, Vec3& target) const;

  /// Reads all attributes that are stored in a struct.
  template <typename OwnerT>
  void ReadStored(OwnerT& owner) const
  {
    for (const XmlValueRule* rule : FindXmlRule(this->GetTag())->FindStored(typeid(OwnerT)))
    {
      this->ReadStored(*rule, rule->Store.Find(&owner));
    }
  }

  /// Reads the attributes x, y, z; a missing one is left unchanged.
  void ReadVector(Vec3& target) const;

  /// Returns the rotation of the <rot> children, composed by the attribute rotations.
  Quaternion ReadRotation() const;

  /// Warns of attributes and children that are unknown or not modelled, and of a second child where
  /// only one is allowed.
  void CheckNames() const;

private:
  bool FindValue(const char* name, XmlValue& value) const;
  void ReadStored(const XmlValueRule& rule, const XmlPlace& place) const;
  const XmlValueRule& GetRule(const char* name) const;
  void WarnOfValue(const XmlElementRule& rule, const std::string& name) const;
  void WarnOfChild(const XmlElementRule& rule, const XmlElement& child) const;

  const XmlDocument* Document = nullptr;
  pugi::xml_node Node;
};

} // namespace helios

#endif
