// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlElement.h"

#include "heliosMessages.h"
#include "heliosXmlRules.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace helios
{

namespace
{

const Vec3 AxisX(1.0, 0.0, 0.0);
const Vec3 AxisY(0.0, 1.0, 0.0);
const Vec3 AxisZ(0.0, 0.0, 1.0);

/// Returns the text of a node, whose pieces comments and CDATA sections separate.
std::string JoinText(pugi::xml_node node)
{
  std::string text;
  for (const pugi::xml_node piece : node.children())
  {
    const bool isText = piece.type() == pugi::node_pcdata || piece.type() == pugi::node_cdata;
    text += isText ? piece.value() : "";
  }
  return text;
}

} // namespace

//------------------------------------------------------------------------------
const Vec3* FindRotationAxis(const std::string& name)
{
  struct Axis
  {
    const char* Name;
    const Vec3* Direction;
  };
  static const Axis axes[] = { { "x", &AxisX }, { "X", &AxisX }, { "pitch", &AxisX },
    { "y", &AxisY }, { "Y", &AxisY }, { "roll", &AxisY }, { "z", &AxisZ }, { "Z", &AxisZ },
    { "yaw", &AxisZ } };
  for (const Axis& axis : axes)
  {
    if (name == axis.Name)
    {
      return axis.Direction;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
std::string MakePath(pugi::xml_node node, pugi::xml_node from)
{
  std::string path;
  const auto getName = [](pugi::xml_node of)
  {
    const std::string tag = of.name();
    const char* key = tag == "filter" ? "type" : tag == "param" ? "key" : nullptr;
    return key ? of.attribute(key).value() : of.name();
  };
  for (; node && node != from; node = node.parent())
  {
    const std::string name = getName(node);
    std::size_t index = 0;
    std::size_t count = 0;
    for (const pugi::xml_node other : node.parent().children())
    {
      index = other == node ? count : index;
      count += getName(other) == name ? 1 : 0;
    }
    const std::string place = count > 1 ? "[" + std::to_string(index) + "]" : std::string();
    path = name + place + (path.empty() ? "" : "/") + path;
  }
  return path;
}

//------------------------------------------------------------------------------
std::string XmlElement::Where() const
{
  return this->Document->Where(this->Node);
}

//------------------------------------------------------------------------------
std::string XmlElement::Where(const char* attribute) const
{
  return this->Document->Where(this->Node, this->Node.attribute(attribute));
}

//------------------------------------------------------------------------------
std::vector<XmlElement> XmlElement::GetChildren() const
{
  std::vector<XmlElement> children;
  for (const pugi::xml_node child : this->Node.children())
  {
    if (child.type() == pugi::node_element)
    {
      children.emplace_back(this->Document, child);
    }
  }
  return children;
}

//------------------------------------------------------------------------------
std::vector<XmlElement> XmlElement::GetChildren(const char* tag) const
{
  std::vector<XmlElement> children;
  for (const pugi::xml_node child : this->Node.children(tag))
  {
    children.emplace_back(this->Document, child);
  }
  return children;
}

//------------------------------------------------------------------------------
std::string XmlElement::GetText(const char* name) const
{
  std::string text;
  this->Read(name, text);
  return text;
}

//------------------------------------------------------------------------------
bool XmlElement::Read(const char* name, std::string& target) const
{
  XmlValue value;
  if (!this->FindValue(name, value))
  {
    return false;
  }
  target = value.Text;
  return true;
}

//------------------------------------------------------------------------------
bool XmlElement::Read(const char* name, double& target) const
{
  XmlValue value;
  return this->FindValue(name, value) &&
    ParseReal(value, this->GetRule(name), this->GetMessages(), target);
}

//------------------------------------------------------------------------------
bool XmlElement::Read(const char* name, int& target) const
{
  XmlValue value;
  return this->FindValue(name, value) &&
    ParseInteger(value, this->GetRule(name), this->GetMessages(), target);
}

//------------------------------------------------------------------------------
bool XmlElement::Read(const char* name, bool& target) const
{
  XmlValue value;
  return this->FindValue(name, value) && ParseBoolean(value, this->GetMessages(), target);
}

//------------------------------------------------------------------------------
bool XmlElement::Read(const char* name, std::vector<double>& target) const
{
  XmlValue value;
  return this->FindValue(name, value) &&
    ParseRealList(value, this->GetRule(name), this->GetMessages(), target);
}

//------------------------------------------------------------------------------
bool XmlElement::Read(const char* name, Vec3& target) const
{
  XmlValue value;
  return this->FindValue(name, value) && ParseVector(value, this->GetMessages(), target);
}

//------------------------------------------------------------------------------
void XmlElement::ReadStored(const XmlValueRule& rule, const XmlPlace& place) const
{
  XmlValue value;
  if (this->FindValue(rule.Name, value))
  {
    value.Folder = std::filesystem::path(this->Document->GetPath()).parent_path().string();
    value.Text = rule.HasBlanks ? this->Node.attribute(rule.Name).value() : value.Text;
    ParseStored(value, rule, this->GetMessages(), place);
  }
}

//------------------------------------------------------------------------------
void XmlElement::ReadVector(Vec3& target) const
{
  this->Read("x", target[0]);
  this->Read("y", target[1]);
  this->Read("z", target[2]);
}

//------------------------------------------------------------------------------
Quaternion XmlElement::ReadRotation() const
{
  Quaternion rotation(1.0, 0.0, 0.0, 0.0);
  std::string order = "global";
  if (this->Read("rotations", order) && order != "global" && order != "local")
  {
    this->GetMessages().Error(this->Where("rotations") + ": rotations=\"" + order +
      "\" is neither global nor local; give one of them");
  }
  for (const XmlElement& rot : this->GetChildren("rot"))
  {
    rot.CheckNames();
    const std::string name = rot.GetText("axis");
    const Vec3* axis = FindRotationAxis(name);
    double angle = 0.0;
    if (!axis)
    {
      this->GetMessages().Error(rot.Where("axis") + ": axis=\"" + name +
        "\" is not valid: expected x, y or z (or pitch, roll or yaw)");
    }
    else if (rot.Read("angle_deg", angle))
    {
      const Quaternion turn = AxisAngle(*axis, angle);
      rotation = order == "local" ? rotation * turn : turn * rotation;
    }
    else if (!rot.Has("angle_deg"))
    {
      this->GetMessages().Error(rot.Where() + ": <rot> has no angle_deg; give the angle [deg]");
    }
  }
  rotation.Normalize();
  return rotation;
}

//------------------------------------------------------------------------------
void XmlElement::CheckNames() const
{
  const XmlElementRule* rule = FindXmlRule(this->GetTag());
  for (const pugi::xml_attribute attribute : this->Node.attributes())
  {
    this->WarnOfValue(*rule, attribute.name());
  }
  std::set<std::string> seen;
  for (const pugi::xml_node node : this->Node.children())
  {
    if (node.type() != pugi::node_element)
    {
      continue;
    }
    const XmlElement child(this->Document, node);
    const XmlChildRule* known = rule->FindChild(node.name());
    this->WarnOfChild(*rule, child);
    if (known && !known->Repeats && !seen.insert(node.name()).second)
    {
      this->GetMessages().Warning(child.Where() + ": a second <" + child.GetTag() + "> in one <" +
        this->GetTag() + "> is not used; leave one of them");
    }
  }
}

//------------------------------------------------------------------------------
void XmlElement::WarnOfValue(const XmlElementRule& rule, const std::string& name) const
{
  const XmlValueRule* value = rule.FindValue(name);
  const bool isForeign = name.find(':') != std::string::npos || name == "xmlns"; // XML schema
                                                                                 // attributes
  if (isForeign || (value && value->Use != XmlUse::NotModelled))
  {
    return;
  }
  const std::string key = this->Document->GetPath() + " <" + rule.Name + " " + name + ">";
  std::string text =
    this->Where(name.c_str()) + ": attribute " + name + " of <" + rule.Name + "> is ";
  if (value)
  {
    text += "not used: this version does not model it";
  }
  else
  {
    const std::string nearest = rule.FindNearestValue(name);
    text += nearest.empty() ? "unknown and not used" : "unknown; did you mean " + nearest + "?";
  }
  this->GetMessages().WarnOnce(key, text);
}

//------------------------------------------------------------------------------
void XmlElement::WarnOfChild(const XmlElementRule& rule, const XmlElement& child) const
{
  const XmlChildRule* known = rule.FindChild(child.GetTag());
  if (known && known->Use != XmlUse::NotModelled)
  {
    return;
  }
  const std::string key =
    this->Document->GetPath() + " <" + rule.Name + "><" + child.GetTag() + ">";
  std::string text =
    child.Where() + ": element <" + child.GetTag() + "> in <" + rule.Name + "> is ";
  if (known)
  {
    text += "not used: this version does not model it";
  }
  else
  {
    const std::string nearest = rule.FindNearestChild(child.GetTag());
    text += nearest.empty() ? "unknown and not used" : "unknown; did you mean <" + nearest + ">?";
  }
  this->GetMessages().WarnOnce(key, text);
}

//------------------------------------------------------------------------------
bool XmlElement::FindValue(const char* name, XmlValue& value) const
{
  const pugi::xml_attribute attribute = this->Node.attribute(name);
  const XmlElementRule* rule = FindXmlRule(this->GetTag());
  const XmlElement child = rule && rule->FindChild(name) ? this->GetChild(name) : XmlElement();
  if (attribute.empty() && !child)
  {
    return false;
  }
  std::string text = attribute.empty() ? JoinText(child.Node) : attribute.value();
  value = { name, TrimBlanks(text), attribute.empty() ? child.Where() : this->Where(name) };
  return true;
}

//------------------------------------------------------------------------------
const XmlValueRule& XmlElement::GetRule(const char* name) const
{
  static const XmlValueRule none;
  const XmlElementRule* rule = FindXmlRule(this->GetTag());
  const XmlValueRule* value = rule ? rule->FindValue(name) : nullptr;
  return value ? *value : none;
}

} // namespace helios
