// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// XML files and their elements, read strictly, with file:line in every message.

#ifndef heliosXmlElement_h
#define heliosXmlElement_h

#include "heliosPose.h"
#include "heliosXmlRules.h"

#include <pugixml.hpp>

#include <memory>
#include <string>
#include <vector>

namespace helios
{

class Messages;
class XmlElement;

/// One file. Entities other than XML's own five are not expanded.
class XmlDocument
{
public:
  /// Reads a file; null where it is no XML or its root is no <document>. A second root, or an
  /// attribute that an element has twice, is an error, and the first counts.
  static std::unique_ptr<XmlDocument> Load(const std::string& path, Messages& messages);

  /// The same of a text that stands for a file.
  static std::unique_ptr<XmlDocument> Make(
    const std::string& path, std::string text, Messages& messages);

  const std::string& GetPath() const { return this->Path; }
  Messages& GetMessages() const { return *this->Log; }
  XmlElement GetRoot() const;

  /// "file:line" of a place in the file.
  std::string Where(std::ptrdiff_t offset) const;

private:
  XmlDocument() = default;
  bool Parse(std::string text);
  bool CheckRoot();
  void CheckAttributes();

  std::string Path;
  Messages* Log = nullptr;
  pugi::xml_document Tree;
  std::vector<std::ptrdiff_t> LineEnds;
};

/// A value as it stands in the file: how it is named in messages, its text, its line.
struct XmlValue
{
  std::string Name;
  std::string Text;
  std::string Where;
};

/**
 * Each of these reads a whole text; false, after an error that names file:line, the value and the
 * cure, where the text is none of the kind or not in the rule's range. The target is then as before.
 */
bool ParseReal(const XmlValue& value, const XmlValueRule& rule, Messages& log, double& target);
bool ParseInteger(const XmlValue& value, const XmlValueRule& rule, Messages& log, int& target);
bool ParseBoolean(const XmlValue& value, Messages& log, bool& target);
bool ParseRealList(
  const XmlValue& value, const XmlValueRule& rule, Messages& log, std::vector<double>& target);
bool ParseVector(const XmlValue& value, Messages& log, Vec3& target);

/// An element of a document, or none. It holds as long as its document.
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
  std::string Where() const;
  const XmlDocument& GetDocument() const { return *this->Document; }
  Messages& GetMessages() const { return this->Document->GetMessages(); }

  /// Children, all or with a tag, in order; the first of them, or none.
  std::vector<XmlElement> GetChildren() const;
  std::vector<XmlElement> GetChildren(const char* tag) const;
  XmlElement GetChild(const char* tag) const { return { this->Document, this->Node.child(tag) }; }

  bool Has(const char* name) const { return !this->Node.attribute(name).empty(); }

  /// The trimmed text of an attribute; empty where it is missing.
  std::string GetText(const char* name) const;

  /**
   * Each reads an attribute (or, where the dialect has such a child, the child's text) by its rule.
   * False where it is missing or wrong; the target is then as before.
   */
  bool Read(const char* name, std::string& target) const;
  bool Read(const char* name, double& target) const;
  bool Read(const char* name, int& target) const;
  bool Read(const char* name, bool& target) const;
  bool Read(const char* name, std::vector<double>& target) const;
  bool Read(const char* name, Vec3& target) const;

  /// Reads an attribute with its blanks and tabs.
  bool ReadAsWritten(const char* name, std::string& target) const;

  /// The attributes x, y, z; a missing one stays as before.
  void ReadVector(Vec3& target) const;

  /// The rotation of the <rot> children, composed as the attribute rotations says.
  Quaternion ReadRotation() const;

  /// Warns of attributes and children that the dialect does not know, or that are not modelled, and
  /// of a second child where one is meant.
  void CheckNames() const;

private:
  bool FindValue(const char* name, XmlValue& value) const;
  const XmlValueRule& GetRule(const char* name) const;
  void WarnOfValue(const XmlElementRule& rule, const std::string& name) const;
  void WarnOfChild(const XmlElementRule& rule, const XmlElement& child) const;

  const XmlDocument* Document = nullptr;
  pugi::xml_node Node;
};

} // namespace helios

#endif
