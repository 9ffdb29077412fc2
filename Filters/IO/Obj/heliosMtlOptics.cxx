// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMtlOptics.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace helios
{

namespace
{

constexpr const char* KindKey = "helios_optics";
constexpr const char* ModelKey = "illum";
constexpr const char* DissolveKey = "d";

struct NumberKey
{
  const char* Key;
  double Least, Most;
  double MaterialOptics::*Value;
};
constexpr std::array<NumberKey, 4> NumberKeys = { {
  { "helios_mirrorReflectance", 0.0, 1.0, &MaterialOptics::MirrorReflectance },
  { "Ni", 1.0, 4.0, &MaterialOptics::RefractiveIndex },
  { "helios_thickness", 0.0, 10.0, &MaterialOptics::Thickness },
  { "helios_attenuation", 0.0, 1e6, &MaterialOptics::Attenuation },
} };

struct KindName
{
  const char* Name;
  OpticsKind Kind;
};
constexpr std::array<KindName, 3> KindNames = { { { "mirror", OpticsKind::Mirror },
  { "pane", OpticsKind::Pane }, { "volume", OpticsKind::Volume } } };

std::string ToText(double value)
{
  std::array<char, 32> digits;
  return { digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr };
}

} // namespace

bool MtlOptics::Has(std::string_view key)
{
  return key == KindKey || key == ModelKey || key == DissolveKey ||
    std::any_of(NumberKeys.begin(), NumberKeys.end(),
      [key](const NumberKey& number) { return key == number.Key; });
}

void MtlOptics::Read(TextFile& file, std::string_view key, TextWords& words)
{
  this->Lines.insert_or_assign(
    std::string(key), Line{ file.GetPlace(), std::string(words.Next()) });
}

bool MtlOptics::Finish(double specular, MaterialOptics& optics, TextReport& report) const
{
  optics = MaterialOptics();
  const auto kind = this->Lines.find(KindKey);
  if (kind == this->Lines.end())
  {
    return true;
  }
  return this->SetKind(kind->second, specular, optics, report) &&
    std::all_of(NumberKeys.begin(), NumberKeys.end(),
      [&](const NumberKey& number) {
        return this->SetNumber(number.Key, number.Least, number.Most, optics.*number.Value, report);
      });
}

bool MtlOptics::SetKind(
  const Line& line, double specular, MaterialOptics& optics, TextReport& report) const
{
  if (line.Value == ModelKey)
  {
    return this->SetStandardKind(line, specular, optics, report);
  }
  for (const KindName& name : KindNames)
  {
    if (line.Value == name.Name)
    {
      optics.Kind = name.Kind;
      return true;
    }
  }
  return report.Fail(line.Place + KindKey + ' ' + Quote(line.Value) +
    " is unknown; give mirror, pane, volume, or illum for what illum and d mean");
}

/// The illumination models 3 and 5 have reflections, 4 a transparent surface, 6 and 7 refraction.
bool MtlOptics::SetStandardKind(
  const Line& line, double specular, MaterialOptics& optics, TextReport& report) const
{
  const auto model = this->Lines.find(ModelKey);
  const std::string number = model == this->Lines.end() ? "" : model->second.Value;
  double dissolve = 1.0;
  if (!this->SetNumber(DissolveKey, 0.0, 1.0, dissolve, report))
  {
    return false;
  }
  if (number == "3" || number == "5" || number == "8")
  {
    optics.Kind = OpticsKind::Mirror;
    optics.MirrorReflectance = std::min(1.0, specular);
  }
  else if (number == "6" || number == "7")
  {
    optics.Kind = OpticsKind::Volume;
  }
  else if (number == "4" || number == "9" || dissolve < 1.0)
  {
    optics.Kind = OpticsKind::Pane;
  }
  else if (number.empty())
  {
    return report.Fail(line.Place + KindKey +
      " is illum, but the material has no illum and no d below 1; add one, or name its kind");
  }
  return true;
}

bool MtlOptics::SetNumber(
  const char* key, double least, double most, double& value, TextReport& report) const
{
  const auto found = this->Lines.find(key);
  if (found == this->Lines.end())
  {
    return true;
  }
  TextWords words(found->second.Value);
  double number = 0.0;
  if (words.Next(number) != TextWords::Number::Good || !(number >= least && number <= most))
  {
    return report.Fail(found->second.Place + key + ' ' + Quote(found->second.Value) +
      " is not a number from " + ToText(least) + " to " + ToText(most));
  }
  value = number;
  return true;
}

std::string FormatMtlOptics(const MaterialOptics& optics)
{
  std::string text;
  for (const KindName& name : KindNames)
  {
    text += optics.Kind == name.Kind ? std::string(KindKey) + ' ' + name.Name + '\n' : "";
  }
  for (const NumberKey& number : NumberKeys)
  {
    text += text.empty() ? "" : std::string(number.Key) + ' ' + ToText(optics.*number.Value) + '\n';
  }
  return text;
}

} // namespace helios
