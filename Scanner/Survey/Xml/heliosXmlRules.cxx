// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlRules.h"

#include "heliosXmlTables.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <numeric>
#include <sstream>

namespace helios
{

namespace
{

template <typename RuleT>
const RuleT* FindByName(const std::vector<RuleT>& rules, const std::string& name)
{
  const auto found = std::find_if(
    rules.begin(), rules.end(), [&name](const RuleT& rule) { return name == rule.Name; });
  return found != rules.end() ? &*found : nullptr;
}

template <typename RuleT>
std::string FindNearest(const std::vector<RuleT>& rules, const std::string& name)
{
  std::vector<std::string> names;
  for (const RuleT& rule : rules)
  {
    names.emplace_back(rule.Name);
  }
  return FindNearestName(name, names);
}

/// Returns Levenshtein's distance: the number of letters to insert, delete or replace.
std::size_t EditDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({ row[j] + 1, row[j + 1] + 1, replaced });
    }
  }
  return row.back();
}

/// Returns a rule with one property changed.
template <typename RuleT, typename PropertyT>
RuleT Change(RuleT rule, PropertyT RuleT::*property, PropertyT value)
{
  rule.*property = value;
  return rule;
}

std::vector<XmlElementRule> MakeRules()
{
  std::vector<XmlElementRule> rules;
  for (const auto make : { MakeSurveyRules, MakePlannerRules, MakeLegRules, MakeReceiverRules,
         MakeScannerRules, MakePlatformRules, MakeSceneRules, MakeFilterRules })
  {
    const std::vector<XmlElementRule> group = make();
    rules.insert(rules.end(), group.begin(), group.end());
  }
  return rules;
}

} // namespace

//------------------------------------------------------------------------------
XmlValueRule XmlValueRule::In(const char* unit) const
{
  return Change(*this, &XmlValueRule::Unit, unit);
}

//------------------------------------------------------------------------------
XmlValueRule XmlValueRule::In(const char* unit, const XmlRange& range) const
{
  return Change(this->In(unit), &XmlValueRule::Range, range);
}

//------------------------------------------------------------------------------
XmlValueRule XmlValueRule::Default(const char* text) const
{
  return Change(*this, &XmlValueRule::DefaultText, text);
}

//------------------------------------------------------------------------------
XmlValueRule XmlValueRule::Required() const
{
  return Change(*this, &XmlValueRule::IsRequired, true);
}

//------------------------------------------------------------------------------
XmlValueRule XmlValueRule::Listed() const
{
  return Change(*this, &XmlValueRule::Use, XmlUse::Listed);
}

//------------------------------------------------------------------------------
XmlValueRule XmlValueRule::Ignored() const
{
  return Change(*this, &XmlValueRule::Use, XmlUse::Ignored);
}

//------------------------------------------------------------------------------
XmlValueRule XmlValueRule::Later() const
{
  return Change(*this, &XmlValueRule::Use, XmlUse::NotModelled);
}

//------------------------------------------------------------------------------
XmlValueRule XmlValueRule::From(std::vector<std::string> (*findChoices)()) const
{
  return Change(*this, &XmlValueRule::FindChoices, findChoices);
}

//------------------------------------------------------------------------------
XmlValueRule XmlValueRule::Meaning(const int* values) const
{
  return Change(*this, &XmlValueRule::Values, values);
}

//------------------------------------------------------------------------------
XmlValueRule XmlValueRule::Scaled(double scale) const
{
  return Change(*this, &XmlValueRule::Scale, scale);
}

//------------------------------------------------------------------------------
XmlValueRule XmlValueRule::Inverted() const
{
  return Change(*this, &XmlValueRule::IsInverted, true);
}

//------------------------------------------------------------------------------
XmlValueRule XmlValueRule::Checked(Status (*findFault)(const std::string& text)) const
{
  return Change(*this, &XmlValueRule::FindFault, findFault);
}

//------------------------------------------------------------------------------
XmlValueRule XmlValueRule::KeepsBlanks() const
{
  return Change(*this, &XmlValueRule::HasBlanks, true);
}

//------------------------------------------------------------------------------
XmlValueRule XmlValueRule::Alias() const
{
  return Change(*this, &XmlValueRule::IsAlias, true);
}

//------------------------------------------------------------------------------
XmlValueRule XmlValueRule::Names(XmlFile file) const
{
  return Change(*this, &XmlValueRule::File, file);
}

//------------------------------------------------------------------------------
XmlChildRule XmlChildRule::Ignored() const
{
  return Change(*this, &XmlChildRule::Use, XmlUse::Ignored);
}

//------------------------------------------------------------------------------
std::vector<std::string> XmlValueRule::GetChoices() const
{
  if (this->FindChoices)
  {
    return this->FindChoices();
  }
  const std::string text = this->IsAnyCase() ? this->Choices + 1 : this->Choices;
  const char separator =
    text.find('|') != std::string::npos ? '|' : ' '; // words may contain blanks
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; std::getline(stream, word, separator);)
  {
    words.push_back(word);
  }
  return words;
}

//------------------------------------------------------------------------------
const XmlValueRule* XmlElementRule::FindValue(const std::string& name) const
{
  return FindByName(this->Values, name);
}

//------------------------------------------------------------------------------
const XmlChildRule* XmlElementRule::FindChild(const std::string& name) const
{
  return FindByName(this->Children, name);
}

//------------------------------------------------------------------------------
std::string XmlElementRule::FindNearestValue(const std::string& name) const
{
  return FindNearest(this->Values, name);
}

//------------------------------------------------------------------------------
std::string XmlElementRule::FindNearestChild(const std::string& name) const
{
  return FindNearest(this->Children, name);
}

//------------------------------------------------------------------------------
std::string ToLower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

//------------------------------------------------------------------------------
const XmlElementRule* FindXmlRule(const std::string& element)
{
  return FindByName(GetXmlRules(), element);
}

//------------------------------------------------------------------------------
std::vector<const XmlValueRule*> XmlElementRule::FindStored(const std::type_info& type) const
{
  std::vector<const XmlValueRule*> stored;
  for (const bool isAlias : { true, false })
  {
    for (const XmlValueRule& value : this->Values)
    {
      if (value.IsAlias == isAlias && value.Store.Owner && *value.Store.Owner == type)
      {
        stored.push_back(&value);
      }
    }
  }
  return stored;
}

//------------------------------------------------------------------------------
const std::vector<XmlElementRule>& GetXmlRules()
{
  static const std::vector<XmlElementRule> rules = MakeRules();
  return rules;
}

//------------------------------------------------------------------------------
std::string FindNearestName(const std::string& name, const std::vector<std::string>& names)
{
  const std::string wanted = ToLower(name);
  std::size_t best = std::max<std::size_t>(2, name.size() / 3) + 1;
  std::string nearest;
  for (const std::string& candidate : names)
  {
    const std::size_t distance = EditDistance(wanted, ToLower(candidate));
    if (distance < best && distance < candidate.size())
    {
      best = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

} // namespace helios
