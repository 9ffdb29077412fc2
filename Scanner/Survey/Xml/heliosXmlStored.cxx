// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Parses and formats values in their places.

#include "heliosMessages.h"
#include "heliosStatus.h"
#include "heliosXmlRules.h"
#include "heliosXmlValue.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

namespace helios
{

namespace
{

/// Parses a value to a place of one type, by its rule.
class Parser
{
public:
  Parser(const XmlValue& value, const XmlValueRule& rule, Messages& log)
    : Value(value)
    , Rule(rule)
    , Log(log)
  {
  }

  bool operator()(std::monostate) const { return false; }
  bool operator()(double* place) const
  {
    double number = 0.0;
    const bool isGood = ParseReal(this->Value, this->Rule, this->Log, number);
    *place = isGood ? number * this->Rule.Scale : *place;
    return isGood;
  }
  bool operator()(int* place) const
  {
    return *this->Rule.Choices != '\0' ? this->FindChoice(*place)
                                       : ParseInteger(this->Value, this->Rule, this->Log, *place);
  }
  bool operator()(bool* place) const
  {
    int index = 0;
    bool isOn = false;
    const bool isWord = *this->Rule.Choices != '\0';
    const bool isNumber = this->Rule.Kind == XmlKind::Integer; // not 0: true
    const bool isGood = isWord ? this->FindChoice(index)
      : isNumber               ? ParseInteger(this->Value, this->Rule, this->Log, index)
                               : ParseBoolean(this->Value, this->Log, isOn);
    if (isGood)
    {
      *place = isWord || isNumber ? index != 0 : isOn != this->Rule.IsInverted;
    }
    return isGood;
  }
  bool operator()(std::string* place) const
  {
    int index = 0;
    const bool isWord = *this->Rule.Choices != '\0';
    const bool isGood = isWord ? this->FindChoice(index) : this->CheckText();
    if (isGood)
    {
      *place = isWord ? this->Rule.GetChoices()[static_cast<std::size_t>(index)] : this->Value.Text;
    }
    return isGood;
  }
  bool operator()(vtkIdType* place) const { return ParseSeed(this->Value, this->Log, *place); }
  bool operator()(std::vector<double>* place) const
  {
    return ParseRealList(this->Value, this->Rule, this->Log, *place);
  }
  bool operator()(Vec3* place) const { return ParseVector(this->Value, this->Log, *place); }
  bool operator()(const XmlEnumeration& place) const
  {
    int index = 0;
    const bool isGood = this->FindChoice(index);
    if (isGood)
    {
      place.Set(place.Place, index);
    }
    return isGood;
  }

  bool operator()(const XmlAccess& place) const
  {
    return place.Set(place.Place, this->Value, this->Log);
  }

private:
  /// Finds the value of an enumeration.
  bool FindChoice(int& value) const
  {
    const bool isGood = ParseChoice(this->Value, this->Rule, this->Log, value);
    value = isGood && this->Rule.Values ? this->Rule.Values[value] : value;
    return isGood;
  }

  bool CheckText() const
  {
    const Status status = this->Rule.FindFault ? this->Rule.FindFault(this->Value.Text) : Status();
    if (!status.IsOk())
    {
      this->Log.Error(this->Value.Where + ": " + this->Value.Name + "=\"" +
        Shorten(this->Value.Text) + "\"" + status.Message());
    }
    return status.IsOk();
  }

  const XmlValue& Value;
  const XmlValueRule& Rule;
  Messages& Log;
};

/// Returns the number that is exactly the stored one after scaling, if there is one.
double Unscale(double stored, double scale)
{
  const double number = stored / scale;
  for (const double to :
    { number, std::nextafter(number, -HUGE_VAL), std::nextafter(number, HUGE_VAL) })
  {
    if (to * scale == stored)
    {
      return to;
    }
  }
  return number;
}

/// Formats the value of a place of one type: exactly, or for people.
class Formatter
{
public:
  Formatter(const XmlValueRule& rule, bool isExact)
    : Rule(rule)
    , IsExact(isExact)
  {
  }

  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(const double* place) const
  {
    const double number = Unscale(*place, this->Rule.Scale);
    return this->IsGiven(*place, number) ? this->ToText(number) : std::string();
  }
  std::string operator()(const int* place) const
  {
    return *this->Rule.Choices        ? this->GetWord(*place)
      : this->IsGiven(*place, *place) ? std::to_string(*place)
                                      : std::string();
  }
  std::string operator()(const bool* place) const
  {
    const int value = *place != this->Rule.IsInverted ? 1 : 0;
    return *this->Rule.Choices              ? this->GetWord(value)
      : this->Rule.Kind == XmlKind::Integer ? std::to_string(value)
      : value != 0                          ? "true"
                                            : "false";
  }
  std::string operator()(const std::string* place) const { return *place; }
  std::string operator()(const vtkIdType* place) const
  {
    return *place < 0 ? std::string() : std::to_string(*place);
  }
  std::string operator()(const std::vector<double>* place) const
  {
    std::string text;
    for (const double number : *place)
    {
      text += (text.empty() ? "" : ", ") + this->ToText(number);
    }
    return text;
  }
  std::string operator()(const Vec3* place) const
  {
    const Vec3& v = *place;
    return this->ToText(v[0]) + ";" + this->ToText(v[1]) + ";" + this->ToText(v[2]);
  }
  std::string operator()(const XmlEnumeration& place) const
  {
    return this->GetWord(place.Get(place.Place));
  }

  std::string operator()(const XmlAccess& place) const { return place.Get(place.Place); }

private:
  /// Returns whether the value is given: a default out of range means that it is not.
  template <typename NumberT>
  bool IsGiven(NumberT stored, double number) const
  {
    return !std::isnan(number) &&
      (this->Rule.Range.Contains(number) ||
        stored != *std::get<NumberT*>(this->Rule.Store.FindDefault()));
  }

  std::string ToText(double number) const
  {
    MessageBuilder text;
    text << number;
    return this->IsExact ? ToXmlText(number) : text.str();
  }

  /// Returns the first word for a value of an enumeration; empty: no word is for it.
  std::string GetWord(int value) const
  {
    const std::vector<std::string> words = this->Rule.GetChoices();
    for (std::size_t i = 0; i < words.size(); ++i)
    {
      if ((this->Rule.Values ? this->Rule.Values[i] : static_cast<int>(i)) == value)
      {
        return words[i];
      }
    }
    return {};
  }

  const XmlValueRule& Rule;
  bool IsExact;
};

} // namespace

//------------------------------------------------------------------------------
bool ParseChoice(const XmlValue& value, const XmlValueRule& rule, Messages& log, int& target)
{
  const std::vector<std::string> words = rule.GetChoices();
  const auto isSame = [&](const std::string& word)
  { return word == value.Text || (rule.IsAnyCase() && ToLower(word) == ToLower(value.Text)); };
  const auto found = std::find_if(words.begin(), words.end(), isSame);
  if (found != words.end())
  {
    target = static_cast<int>(found - words.begin());
    return true;
  }
  const std::string nearest = FindNearestName(value.Text, words);
  log.Error(value.Where + ": " + value.Name + "=\"" + Shorten(value.Text) + "\" is not valid" +
    (nearest.empty() ? ": expected " : "; did you mean " + nearest + "? Expected ") +
    JoinChoices(words, "or"));
  return false;
}

//------------------------------------------------------------------------------
bool ParseStored(
  const XmlValue& value, const XmlValueRule& rule, Messages& log, const XmlPlace& place)
{
  return std::visit(Parser(value, rule, log), place);
}

//------------------------------------------------------------------------------
std::string FormatStored(const XmlValueRule& rule, const XmlPlace& place)
{
  return std::visit(Formatter(rule, true), place);
}

//------------------------------------------------------------------------------
std::string DescribeDefault(const XmlValueRule& rule)
{
  const bool isStored = rule.Store.Owner && !rule.IsAlias && !*rule.DefaultText;
  return rule.IsRequired ? "required"
    : isStored           ? std::visit(Formatter(rule, false), rule.Store.FindDefault())
                         : rule.DefaultText;
}

//------------------------------------------------------------------------------
std::string ToXmlText(double value)
{
  char digits[400]; // digits of the smallest number
  return { digits, std::to_chars(digits, std::end(digits), value, std::chars_format::fixed).ptr };
}

} // namespace helios
