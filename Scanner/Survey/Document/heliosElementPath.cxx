// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosElementPath.h"

#include "heliosMessages.h"
#include "heliosXmlFilter.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace helios
{

namespace
{

/// Whether the last one of several filters is used.
bool ReplacesOthers(const std::string& filter)
{
  return filter == "translate" || filter == "scale";
}

/// The parameter of a filter; of several the last one, which is used.
pugi::xml_node FindParameter(pugi::xml_node filter, const std::string& key)
{
  pugi::xml_node found;
  for (const pugi::xml_node parameter : filter.children("param"))
  {
    found = parameter.attribute("key").value() == key ? parameter : found;
  }
  return found;
}

void SetText(pugi::xml_node node, const char* name, const std::string& text)
{
  node.remove_child(name); // an attribute that is a child
  if (text.empty())
  {
    node.remove_attribute(name);
    return;
  }
  pugi::xml_attribute attribute = node.attribute(name);
  attribute = attribute ? attribute : node.append_attribute(name);
  attribute.set_value(text.c_str());
}

bool IsSettable(const XmlValueRule* value)
{
  return value && (value->Use == XmlUse::Used || value->Use == XmlUse::Listed);
}

} // namespace

//------------------------------------------------------------------------------
bool CheckValue(const XmlValue& value, const XmlValueRule& rule, Messages& log)
{
  if (rule.Store.Owner)
  {
    const std::shared_ptr<void> scratch = rule.Store.MakeOwner();
    return ParseStored(value, rule, log, rule.Store.Find(scratch.get()));
  }
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

//------------------------------------------------------------------------------
std::string NormalizeValue(const XmlValue& value, const XmlValueRule& rule)
{
  if (!rule.Store.Owner || value.Text.empty())
  {
    return value.Text;
  }
  Messages silent(nullptr);
  const std::shared_ptr<void> scratch = rule.Store.MakeOwner();
  const XmlPlace place = rule.Store.Find(scratch.get());
  return ParseStored(value, rule, silent, place) ? FormatStored(rule, place) : std::string();
}

//------------------------------------------------------------------------------
std::string GetDefault(const XmlValueRule& rule)
{
  return rule.Store.Owner ? FormatStored(rule, rule.Store.FindDefault()) : std::string();
}

//------------------------------------------------------------------------------
bool RefuseName(const XmlValue& value, const std::string& name,
  const std::vector<std::string>& names, Messages& log)
{
  const std::string nearest = FindNearestName(name, names);
  log.Error(value.Where + ": attribute " + value.Name + " is unknown" +
    (nearest.empty()      ? "; give one of " + JoinChoices(names)
        : nearest == name ? ": " + name + " cannot be set"
                          : "; did you mean " + nearest + "?"));
  return false;
}

//------------------------------------------------------------------------------
bool ElementPath::Kin::Has(pugi::xml_node child) const
{
  const std::string key = child.attribute(this->Key.c_str()).value();
  return child.name() == this->Tag &&
    (this->Key.empty() || (this->Key == "type" ? GetFilterType(key) : key) == this->Name);
}

//------------------------------------------------------------------------------
pugi::xml_node ElementPath::Kin::Find(pugi::xml_node parent, int index, std::size_t& count) const
{
  const bool isLast = index < 0 && ReplacesOthers(this->Name);
  const auto wanted = static_cast<std::size_t>(std::max(0, index));
  pugi::xml_node found;
  count = 0;
  for (const pugi::xml_node child : parent.children(this->Tag.c_str()))
  {
    if (this->Has(child) && (count++ == wanted || isLast))
    {
      found = child;
    }
  }
  return found;
}

//------------------------------------------------------------------------------
pugi::xml_node ElementPath::Kin::Add(pugi::xml_node parent) const
{
  pugi::xml_node child = parent.append_child(this->Tag.c_str());
  if (!this->Key.empty())
  {
    child.append_attribute(this->Key.c_str()) = this->Name.c_str();
  }
  return child;
}

//------------------------------------------------------------------------------
/// The steps of a path; empty if it is not a path.
std::vector<ElementPath::Step> ElementPath::Split(const std::string& path)
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
      step.Index = std::atoi(index.c_str());
    }
    steps.push_back(step);
  }
  return steps;
}

//------------------------------------------------------------------------------
bool ElementPath::Knows(const XmlElementRule& rule, const std::string& name)
{
  const XmlValueRule* value = rule.FindValue(name);
  return IsSettable(value) || FindXmlKin(rule, name).Rule;
}

//------------------------------------------------------------------------------
std::string ElementPath::GetFirstName(const std::string& path)
{
  return path.substr(0, path.find_first_of("/["));
}

//------------------------------------------------------------------------------
bool ElementPath::Follow(bool adds, Messages& log)
{
  const std::vector<Step> steps = Split(this->Path);
  if (steps.empty())
  {
    log.Error(this->Value.Where + ": " + this->Value.Name +
      " is not a path; give names and indices, as in dmotion[0]/motion[1]/angle");
    return false;
  }
  this->Rule = FindXmlRule(this->Node.name());
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    const XmlValueRule* value = this->Rule->FindValue(steps[i].Name);
    const bool isLast =
      i + 1 == steps.size() && IsSettable(value) && !FindXmlKin(*this->Rule, steps[i].Name).Rule;
    this->Last = isLast ? value : nullptr;
    if (!this->Last && !this->Enter(steps[i], adds, log))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool ElementPath::Enter(const Step& step, bool adds, Messages& log)
{
  const Kin kin{ FindXmlKin(*this->Rule, step.Name) };
  if (!kin.Rule)
  {
    return this->Refuse(step.Name, log);
  }
  std::size_t count = 0;
  const pugi::xml_node child =
    this->Missing.empty() ? kin.Find(this->Node, step.Index, count) : pugi::xml_node();
  const auto index = static_cast<std::size_t>(std::max(0, step.Index));
  if (!child && adds && !(index == count && (count == 0 || kin.Repeats)))
  {
    log.Error(this->Value.Where + ": " + this->Value.Name + ": " + step.Name + "[" +
      std::to_string(index) + "] does not exist; there are " + std::to_string(count) +
      ", counted from 0" + (kin.Repeats ? ", and the next can be added" : ""));
    return false;
  }
  child ? void(this->Node = child) : this->Missing.push_back(kin);
  this->Rule = kin.Rule;
  return true;
}

//------------------------------------------------------------------------------
bool ElementPath::Refuse(const std::string& name, Messages& log) const
{
  return RefuseName(this->Value, name, ListXmlNames(*this->Rule), log);
}

//------------------------------------------------------------------------------
std::string ElementPath::Get() const
{
  if (!this->IsThere())
  {
    return {};
  }
  return !this->Last ? "true"
    : IsFilterRule(*this->Rule)
    ? FindParameter(this->Node, this->Last->Name).attribute("value").value()
    : this->Node.attribute(this->Last->Name) ? this->Node.attribute(this->Last->Name).value()
                                             : this->Node.child_value(this->Last->Name);
}

//------------------------------------------------------------------------------
bool ElementPath::Check(const std::string& text, Messages& log) const
{
  bool isThere = true;
  const XmlValue value{ this->Value.Name, text, this->Value.Where, this->Value.Folder };
  return text.empty() ||
    (this->Last ? CheckValue(value, *this->Last, log) : ParseBoolean(value, log, isThere));
}

//------------------------------------------------------------------------------
void ElementPath::Set(const std::string& text, XmlDocument& document)
{
  bool isThere = true;
  Messages silent(nullptr);
  const bool removes =
    text.empty() || (!this->Last && ParseBoolean({ "", text, "" }, silent, isThere) && !isThere);
  if (removes && !this->IsThere())
  {
    return;
  }
  for (const Kin& kin : this->Missing)
  {
    this->Node = kin.Add(this->Node);
  }
  this->Missing.clear();
  if (!this->Last && removes)
  {
    document.ForgetPlaces(this->Node);
    const pugi::xml_node parent = this->Node.parent();
    this->Node.parent().remove_child(this->Node);
    this->Node = parent;
  }
  else if (this->Last && IsFilterRule(*this->Rule))
  {
    pugi::xml_node parameter = FindParameter(this->Node, this->Last->Name);
    for (; removes && parameter; parameter = FindParameter(this->Node, this->Last->Name))
    {
      document.ForgetPlaces(parameter);
      this->Node.remove_child(parameter);
    }
    if (!removes)
    {
      parameter = parameter ? parameter : this->Node.append_child("param");
      SetText(parameter, "key", this->Last->Name);
      SetText(parameter, "value", text);
    }
  }
  else if (this->Last)
  {
    SetText(this->Node, this->Last->Name, text);
  }
}

} // namespace helios
