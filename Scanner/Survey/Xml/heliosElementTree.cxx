// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosElementTree.h"

#include "heliosMessages.h"

#include <cstdlib>
#include <sstream>
#include <vector>

namespace helios
{

namespace
{

const std::string FilterPrefix = "filter:";

/// A name of a path with its index.
struct Step
{
  std::string Name;
  std::size_t Index = 0;
};

/// The steps of a path; empty if it is not a path.
std::vector<Step> Split(const std::string& path)
{
  std::vector<Step> steps;
  std::istringstream stream(path);
  for (std::string text; std::getline(stream, text, '/');)
  {
    Step step;
    const std::size_t bracket = text.find('[');
    step.Name = text.substr(0, bracket);
    if (bracket != std::string::npos)
    {
      const std::string index = text.substr(bracket + 1, text.size() - bracket - 2);
      const bool isGood = text.back() == ']' && !index.empty() && index.size() < 7 &&
        index.find_first_not_of("0123456789") == std::string::npos;
      if (!isGood)
      {
        return {};
      }
      step.Index = std::strtoul(index.c_str(), nullptr, 10);
    }
    steps.push_back(step);
  }
  return steps;
}

/// The children of a node that a name stands for, and how to add one.
struct Kin
{
  const XmlElementRule* Rule = nullptr; ///< of the children; null: no child has the name
  std::string Tag;
  std::string Key; ///< the attribute that tells them from others of the tag; empty: none
  std::string Name;
  bool Repeats = false;

  bool Has(pugi::xml_node child) const
  {
    return child.name() == this->Tag &&
      (this->Key.empty() || child.attribute(this->Key.c_str()).value() == this->Name);
  }

  pugi::xml_node Find(pugi::xml_node parent, std::size_t index, std::size_t& count) const
  {
    pugi::xml_node found;
    count = 0;
    for (const pugi::xml_node child : parent.children())
    {
      if (this->Has(child) && count++ == index)
      {
        found = child;
      }
    }
    return found;
  }

  pugi::xml_node Add(pugi::xml_node parent) const
  {
    pugi::xml_node child = parent.append_child(this->Tag.c_str());
    if (!this->Key.empty())
    {
      child.append_attribute(this->Key.c_str()) = this->Name.c_str();
    }
    return child;
  }
};

bool IsFilter(const XmlElementRule& rule)
{
  return std::string(rule.Name).compare(0, FilterPrefix.size(), FilterPrefix) == 0;
}

Kin FindKin(const XmlElementRule& rule, const std::string& name)
{
  const XmlChildRule* child = rule.FindChild(name);
  if (child && child->Use == XmlUse::Used && name != "filter")
  {
    return { FindXmlRule(name), name, "", name, child->Repeats };
  }
  if (const XmlElementRule* filter = FindXmlRule(FilterPrefix + name);
      filter && rule.FindChild("filter"))
  {
    return { filter, "filter", "type", name, true };
  }
  const XmlValueRule* value = IsFilter(rule) ? rule.FindValue(name) : nullptr;
  return value && value->Kind == XmlKind::Rotation
    ? Kin{ FindXmlRule("param"), "param", "key", name, false }
    : Kin();
}

/// An attribute that this version reads; null: none.
const XmlValueRule* FindUsed(const XmlElementRule& rule, const std::string& name)
{
  const XmlValueRule* value = rule.FindValue(name);
  const bool isOwn = value && !FindKin(rule, name).Rule;
  return isOwn && value->Use == XmlUse::Used ? value : nullptr;
}

/// All names that may follow.
std::vector<std::string> ListNames(const XmlElementRule& rule)
{
  std::vector<std::string> names;
  for (const XmlValueRule& value : rule.Values)
  {
    names.emplace_back(value.Name);
  }
  for (const XmlChildRule& child : rule.Children)
  {
    names.emplace_back(child.Name);
  }
  for (const XmlElementRule& other : GetXmlRules())
  {
    if (rule.FindChild("filter") && IsFilter(other))
    {
      names.push_back(std::string(other.Name).substr(FilterPrefix.size()));
    }
  }
  return names;
}

/// Checks one value by its rule.
bool CheckValue(const XmlValue& value, const XmlValueRule& rule, Messages& log)
{
  double number = 0.0;
  int integer = 0;
  bool flag = false;
  std::vector<double> list;
  Vec3 vector;
  switch (rule.Kind)
  {
    case XmlKind::Real:
      return ParseReal(value, rule, log, number);
    case XmlKind::Integer:
      return ParseInteger(value, rule, log, integer);
    case XmlKind::Boolean:
      return ParseBoolean(value, log, flag);
    case XmlKind::RealList:
      return ParseRealList(value, rule, log, list);
    case XmlKind::Vector:
      return ParseVector(value, log, vector);
    default:
      return *rule.Choices == '\0' || ParseChoice(value, rule, log, integer);
  }
}

/// What a path leads to: an element, or an attribute of it.
class Walk
{
public:
  Walk(const XmlValue& value, Messages& log)
    : Value(value)
    , Log(log)
  {
  }

  /// Follows the path, and adds the elements that are missing on request. False after an error, and
  /// at an element that is missing.
  bool Follow(pugi::xml_node root, bool adds);

  pugi::xml_node Node;
  const XmlElementRule* Rule = nullptr;
  const XmlValueRule* Last = nullptr; // null: the path is of the element

private:
  bool Enter(const Step& step, bool adds);
  bool Refuse(const std::string& name);

  const XmlValue& Value;
  Messages& Log;
};

bool Walk::Follow(pugi::xml_node root, bool adds)
{
  this->Node = root;
  this->Rule = FindXmlRule(root.name());
  const std::vector<Step> steps = Split(this->Value.Name);
  if (steps.empty())
  {
    this->Log.Error(this->Value.Where + ": " + this->Value.Name +
      " is not a path; give names and indices, as in dmotion[0]/motion[1]/angle");
    return false;
  }
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    this->Last = i + 1 == steps.size() ? FindUsed(*this->Rule, steps[i].Name) : nullptr;
    if (!this->Last && !this->Enter(steps[i], adds))
    {
      return false;
    }
  }
  return true;
}

bool Walk::Enter(const Step& step, bool adds)
{
  const Kin kin = FindKin(*this->Rule, step.Name);
  if (!kin.Rule)
  {
    return this->Refuse(step.Name);
  }
  std::size_t count = 0;
  pugi::xml_node child = kin.Find(this->Node, step.Index, count);
  if (!child && adds && step.Index == count && (count == 0 || kin.Repeats))
  {
    child = kin.Add(this->Node);
  }
  else if (!child && adds)
  {
    this->Log.Error(this->Value.Where + ": " + this->Value.Name + ": " + step.Name + "[" +
      std::to_string(step.Index) + "] does not exist; there are " + std::to_string(count) +
      ", counted from 0" + (kin.Repeats ? ", and the next can be added" : ""));
  }
  this->Node = child;
  this->Rule = kin.Rule;
  return static_cast<bool>(child);
}

bool Walk::Refuse(const std::string& name)
{
  const std::vector<std::string> names = ListNames(*this->Rule);
  const std::string nearest = FindNearestName(name, names);
  this->Log.Error(this->Value.Where + ": attribute " + this->Value.Name + " is unknown" +
    (nearest.empty()      ? "; give one of " + Enumerate(names)
        : nearest == name ? ": " + name + " cannot be set"
                          : "; did you mean " + nearest + "?"));
  return false;
}

/// The parameter of a filter.
pugi::xml_node FindParameter(pugi::xml_node filter, const std::string& key)
{
  return filter.find_child_by_attribute("param", "key", key.c_str());
}

void SetText(pugi::xml_node node, const char* name, const std::string& text)
{
  node.remove_attribute(name);
  if (!text.empty())
  {
    node.append_attribute(name) = text.c_str();
  }
}

} // namespace

//------------------------------------------------------------------------------
ElementTree::ElementTree(const std::string& tag)
{
  this->Tree.append_child(tag.c_str());
}

//------------------------------------------------------------------------------
ElementTree::ElementTree(const ElementTree& other)
  : Names(other.Names)
{
  this->Tree.reset(other.Tree);
}

//------------------------------------------------------------------------------
ElementTree& ElementTree::operator=(const ElementTree& other)
{
  if (this != &other)
  {
    this->Names = other.Names;
    this->Tree.reset(other.Tree);
  }
  return *this;
}

//------------------------------------------------------------------------------
bool ElementTree::Set(const XmlValue& value, Messages& log)
{
  ElementTree changed(*this);
  bool removes = value.Text.empty();
  Walk walk(value, log);
  if (!walk.Follow(changed.GetRoot(), !removes))
  {
    const bool isGone = removes && !log.HasError();
    if (isGone) // but may be given by a file
    {
      this->Names.insert(GetFirstName(value.Name));
    }
    return isGone;
  }
  bool isThere = true;
  const bool isGood =
    removes || (walk.Last ? CheckValue(value, *walk.Last, log) : ParseBoolean(value, log, isThere));
  removes = removes || !isThere;
  if (!isGood)
  {
    return false;
  }
  if (!walk.Last && removes)
  {
    walk.Node.parent().remove_child(walk.Node);
  }
  else if (walk.Last && IsFilter(*walk.Rule))
  {
    walk.Node.remove_child(FindParameter(walk.Node, walk.Last->Name));
    if (!removes)
    {
      pugi::xml_node parameter = walk.Node.append_child("param");
      SetText(parameter, "key", walk.Last->Name);
      SetText(parameter, "value", value.Text);
    }
  }
  else if (walk.Last)
  {
    SetText(walk.Node, walk.Last->Name, value.Text);
  }
  changed.Names.insert(GetFirstName(value.Name));
  *this = changed;
  return true;
}

//------------------------------------------------------------------------------
std::string ElementTree::Get(const XmlValue& value, Messages& log) const
{
  Walk walk(value, log);
  if (!walk.Follow(this->GetRoot(), false))
  {
    return {};
  }
  return !walk.Last        ? "true"
    : IsFilter(*walk.Rule) ? FindParameter(walk.Node, walk.Last->Name).attribute("value").value()
                           : walk.Node.attribute(walk.Last->Name).value();
}

//------------------------------------------------------------------------------
std::unique_ptr<XmlDocument> ElementTree::MakeDocument(
  const std::string& where, Messages& log) const
{
  std::ostringstream text;
  text << "<document>";
  this->GetRoot().print(text, "", pugi::format_raw);
  text << "</document>";
  return XmlDocument::MakeOf(where, text.str(), log);
}

//------------------------------------------------------------------------------
std::string ElementTree::Simplify(std::string path)
{
  const std::string zero = "[0]";
  for (std::size_t at = path.find(zero); at != std::string::npos; at = path.find(zero, at))
  {
    path.erase(at, zero.size());
  }
  return path;
}

//------------------------------------------------------------------------------
std::string ElementTree::GetFirstName(const std::string& path)
{
  return path.substr(0, path.find_first_of("/["));
}

} // namespace helios
