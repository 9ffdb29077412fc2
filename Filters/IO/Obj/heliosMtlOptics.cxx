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
constexpr const char* WaterKey = "helios_water";
constexpr const char* DispersionKey = "helios_dispersion";
constexpr const char* ModelKey = "illum";
constexpr const char* DissolveKey = "d";

struct NumberKey
{
  const char* Key;
  double Minimum, Maximum;
  double MaterialOptics::*Value;
};
constexpr std::array<NumberKey, 8> NumberKeys = { {
  { "helios_mirrorReflectance", 0.0, 1.0, &MaterialOptics::MirrorReflectance },
  { "Ni", 1.0, 4.0, &MaterialOptics::RefractiveIndex },
  { "helios_thickness", 0.0, 10.0, &MaterialOptics::Thickness },
  { "helios_attenuation", 0.0, 1e6, &MaterialOptics::Attenuation },
  { "helios_backscatter", 0.0, 1e6, &MaterialOptics::Backscatter },
  { "helios_transmittance", 0.0, 1.0, &MaterialOptics::Transmittance },
  { "helios_retroreflection", 0.0, 1e9, &MaterialOptics::Retroreflection },
  { "helios_meanSquareSlope", 0.0, 1.0, &MaterialOptics::MeanSquareSlope },
} };

struct KindName
{
  const char* Name;
  OpticsKind Kind;
};
constexpr std::array<KindName, 6> KindNames = { { { "mirror", OpticsKind::Mirror },
  { "pane", OpticsKind::Pane }, { "volume", OpticsKind::Volume }, { "water", OpticsKind::Water },
  { "leaf", OpticsKind::Leaf }, { "retroreflector", OpticsKind::Retroreflector } } };

struct DispersionName
{
  const char* Name;
  DispersionKind Kind;
};
constexpr std::array<DispersionName, 4> DispersionNames = { { { "water", DispersionKind::Water },
  { "sodaLime", DispersionKind::SodaLime }, { "bk7", DispersionKind::Bk7 },
  { "silica", DispersionKind::Silica } } };

/**
 * Waters as Petzold measured them in green light (1972, SIO reference 72-78): off the Bahamas, off
 * California, and in San Diego harbour. The attenuation is absorption + backscatter coefficient, as
 * a receiver that sees all light scattered forward has it (Gordon 1982, Applied Optics 21,
 * 2996-3001); the backscatter is the latter over 2 pi.
 */
struct WaterType
{
  const char* Name;
  double Attenuation; // [1/m]
  double Backscatter; // [1/(m sr)]
};
constexpr std::array<WaterType, 3> WaterTypes = { { { "clear", 0.116, 2.6e-4 },
  { "coastal", 0.182, 4.5e-4 }, { "harbour", 0.403, 5.8e-3 } } };

std::string ToText(double value)
{
  std::array<char, 32> digits;
  return { digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr };
}

} // namespace

bool MtlOptics::Has(std::string_view key)
{
  return key == KindKey || key == WaterKey || key == DispersionKey || key == ModelKey ||
    key == DissolveKey ||
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
  const auto water = this->Lines.find(WaterKey);
  if (kind == this->Lines.end() && water == this->Lines.end())
  {
    const auto own = std::find_if(
      this->Lines.begin(), this->Lines.end(), [](const auto& line) { return IsOwn(line.first); });
    if (own != this->Lines.end())
    {
      report.Warn(own->second.Place + own->first + " has no effect without " + KindKey + "; add " +
        KindKey + " with the kind, such as pane");
    }
    return true;
  }
  return (kind == this->Lines.end() || this->SetKind(kind->second, specular, optics, report)) &&
    (water == this->Lines.end() || this->SetWater(water->second, optics, report)) &&
    this->SetDispersion(optics, report) &&
    std::all_of(NumberKeys.begin(), NumberKeys.end(),
      [&](const NumberKey& number)
      {
        return this->SetNumber(
          number.Key, number.Minimum, number.Maximum, optics.*number.Value, report);
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
      optics.RefractiveIndex = name.Kind == OpticsKind::Water ? WaterIndex : optics.RefractiveIndex;
      return true;
    }
  }
  return report.Fail(line.Place + KindKey + ' ' + Quote(line.Value) +
    " is unknown; give mirror, pane, volume, water, leaf, retroreflector, or illum for what illum "
    "and d mean");
}

bool MtlOptics::SetWater(const Line& line, MaterialOptics& optics, TextReport& report) const
{
  if (optics.Kind != OpticsKind::Opaque && optics.Kind != OpticsKind::Water)
  {
    return report.Fail(
      line.Place + WaterKey + " is of " + KindKey + " water only; remove one of them");
  }
  for (const WaterType& type : WaterTypes)
  {
    if (line.Value == type.Name)
    {
      optics.Kind = OpticsKind::Water;
      optics.RefractiveIndex = WaterIndex;
      optics.Attenuation = type.Attenuation;
      optics.Backscatter = type.Backscatter;
      return true;
    }
  }
  return report.Fail(line.Place + WaterKey + ' ' + Quote(line.Value) +
    " is unknown; give clear, coastal or harbour");
}

bool MtlOptics::SetDispersion(MaterialOptics& optics, TextReport& report) const
{
  const auto line = this->Lines.find(DispersionKey);
  if (line == this->Lines.end())
  {
    return true;
  }
  for (const DispersionName& name : DispersionNames)
  {
    if (line->second.Value == name.Name)
    {
      optics.Dispersion = name.Kind;
      return true;
    }
  }
  return report.Fail(line->second.Place + DispersionKey + ' ' + Quote(line->second.Value) +
    " is unknown; give water, sodaLime, bk7 or silica, or the index as Ni");
}

/// Sets the kind by the illumination model: 3 and 5 have reflections, 4 a transparent surface, 6
/// and 7 refraction.
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
  const char* key, double minimum, double maximum, double& value, TextReport& report) const
{
  const auto found = this->Lines.find(key);
  if (found == this->Lines.end())
  {
    return true;
  }
  TextWords words(found->second.Value);
  double number = 0.0;
  if (words.Next(number) != TextWords::Number::Good || !(number >= minimum && number <= maximum))
  {
    return report.Fail(found->second.Place + key + ' ' + Quote(found->second.Value) +
      " is not a number from " + ToText(minimum) + " to " + ToText(maximum));
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
  for (const DispersionName& name : DispersionNames)
  {
    const bool has = !text.empty() && optics.Dispersion == name.Kind;
    text += has ? std::string(DispersionKey) + ' ' + name.Name + '\n' : "";
  }
  for (const NumberKey& number : NumberKeys)
  {
    text += text.empty() ? "" : std::string(number.Key) + ' ' + ToText(optics.*number.Value) + '\n';
  }
  return text;
}

} // namespace helios
