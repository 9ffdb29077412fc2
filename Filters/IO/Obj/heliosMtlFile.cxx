// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMtlFile.h"

#include "heliosImage.h"
#include "heliosMtlCutout.h"
#include "heliosStatus.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>

namespace helios
{

namespace
{

// Keys of other programs that a scanner does not need.
bool IsIgnored(std::string_view key)
{
  static constexpr std::array<std::string_view, 21> keys = { "Tr", "Tf", "Ke", "sharpness", "bump",
    "disp", "decal", "refl", "norm", "Pr", "Pm", "Ps", "Pc", "Pcr", "Pfr", "aniso", "anisor", "Km",
    "helios_useVertexColors", "helios_castShadows", "helios_receiveShadows" };
  return key.substr(0, 4) == "map_" || std::find(keys.begin(), keys.end(), key) != keys.end();
}

double Sum(const std::array<double, 3>& color)
{
  return color[0] + color[1] + color[2];
}

std::string ToText(double value)
{
  std::array<char, 32> digits;
  return { digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr };
}

std::string ToText(const std::string& key, double red, double green, double blue)
{
  return key + ' ' + ToText(red) + ' ' + ToText(green) + ' ' + ToText(blue) + '\n';
}

// Formats two colours that restore the specularity exactly: grey, or components with an exact sum.
std::string FormatColors(double specularity)
{
  const double s = specularity;
  const double d = 1.0 - s;
  if (GetSpecularity(d + d + d, s + s + s) == s)
  {
    return ToText("Kd", d, d, d) + ToText("Ks", s, s, s);
  }
  return ToText("Kd", d / 2, d / 4, d / 4) + ToText("Ks", s / 2, s / 4, s / 4);
}

// Formats Kd and Ks, and the texture. Materials without a specular lobe have a colour; their Kd has
// no other meaning.
std::string FormatColors(const Material& material)
{
  const MaterialColor& color = material.Color;
  const bool isWritten = color.IsSet() && material.Specularity == 0.0;
  const std::string colors = isWritten
    ? ToText("Kd", color.Base[0], color.Base[1], color.Base[2]) + ToText("Ks", 0.0, 0.0, 0.0)
    : FormatColors(material.Specularity);
  return colors + (color.Texture.empty() ? "" : "map_Kd " + color.Texture + '\n');
}

// Returns an error if a material cannot be written: the value.
Status FindFault(const Material& m)
{
  if (m.Reflectance < 0.0 || m.Reflectance > 1.0)
  {
    return Status::Error("reflectance " + ToText(m.Reflectance) + ", outside [0, 1]");
  }
  if (!(m.Specularity >= 0.0 && m.Specularity <= 1.0))
  {
    return Status::Error("specularity " + ToText(m.Specularity) + ", outside [0, 1]");
  }
  if (!(m.SpecularExponent >= 0.0 && std::isfinite(m.SpecularExponent)))
  {
    return Status::Error(
      "specular exponent " + ToText(m.SpecularExponent) + ", not a finite number >= 0");
  }
  if (std::any_of(m.Spectrum.begin(), m.Spectrum.end(), TextWords::IsBlank))
  {
    return Status::Error(
      "spectrum " + Quote(m.Spectrum) + ", which has a blank that MTL cannot store");
  }
  return {};
}

} // namespace

double GetSpecularity(double diffuse, double specular)
{
  return specular > 0.0 ? specular / (diffuse + specular) : 0.0;
}

bool MtlFile::Read(const std::string& path)
{
  this->Started = false;
  this->Unknown = this->Percent = Note();
  TextFile file;
  const Status status = file.Open(path);
  if (!status.IsOk())
  {
    return this->Report.Fail(status.Message());
  }
  std::string_view line;
  while (file.NextLine(line))
  {
    if (!this->ReadLine(file, line))
    {
      return false;
    }
  }
  if (!file.GetError().empty())
  {
    return this->Report.Fail(file.GetError());
  }
  if (!this->Finish(path))
  {
    return false;
  }
  this->Warn(this->Percent);
  this->Warn(this->Unknown);
  return true;
}

bool MtlFile::ReadLine(TextFile& file, std::string_view line)
{
  TextWords words(line);
  const std::string_view key = words.Next();
  if (this->Started)
  {
    FindMtlCutout(file, key, words, this->CurrentColors.Shape);
  }
  if (this->ReadsColors && this->Started && key == "map_Kd")
  {
    return this->ReadTexture(file, words);
  }
  if (key.empty() || IsIgnored(key))
  {
    return true;
  }
  if (key == "newmtl")
  {
    return this->Start(file, words.NextTitle());
  }
  if (MtlOptics::Has(key) && (this->Started || !MtlOptics::IsOwn(key)))
  {
    this->Optics.Read(file, key, words);
    return true;
  }
  if (!this->Started)
  {
    return this->Report.Fail(file.GetPlace() + Quote(key) +
      " comes before any material; begin one with newmtl NAME above it");
  }
  std::array<double, 3> unused;
  if (key == "Ka")
    return this->ReadColor(file, key, words, unused);
  if (key == "Kd")
  {
    this->CurrentColors.HasDiffuse = true;
    return this->ReadColor(file, key, words, this->CurrentColors.Diffuse);
  }
  if (key == "Ks")
    return this->ReadColor(file, key, words, this->CurrentColors.Specular);
  if (key == "Ns")
    return this->ReadExponent(file, words);
  if (key == "helios_reflectance")
    return this->ReadReflectance(file, words);
  if (key == "helios_classification")
    return this->ReadClassification(file, words);
  if (key == "helios_isGround")
    return this->ReadIsGround(file, words);
  if (key == "helios_spectra")
    return this->ReadSpectrum(file, words);
  this->CountUnknown(file, key);
  return true;
}

// Reads a colour. A single number applies to all three components.
bool MtlFile::ReadColor(
  TextFile& file, std::string_view key, TextWords& words, std::array<double, 3>& color)
{
  std::size_t count = 0;
  while (count < 3 && words.HasMore())
  {
    TextWords ahead = words;
    constexpr double largest = 1e100; // keeps sums finite
    if (ahead.Next(color[count]) != TextWords::Number::Good ||
      !(color[count] >= 0.0 && color[count] <= largest))
    {
      break;
    }
    words = ahead;
    ++count;
  }
  if (words.HasMore() || (count != 3 && count != 1))
  {
    return this->Report.Fail(file.GetPlace() + std::string(key) + " of material " +
      Quote(this->Current.Name) + " is malformed" +
      (words.HasMore() ? " at " + Quote(words.Next()) : std::string()) +
      "; expected three finite numbers >= 0: red green blue");
  }
  if (count == 1)
  {
    color.fill(color[0]);
  }
  return true;
}

// Reads the path of an image: beside the MTL file, unless it is absolute. Users of the texture read
// its pixels.
bool MtlFile::ReadTexture(TextFile& file, TextWords& words)
{
  const std::string name(words.NextTitle());
  if (name.empty() || name[0] == '-')
  {
    this->Report.Warn(file.GetPlace() + "map_Kd of material " + Quote(this->Current.Name) +
      (name.empty() ? " has no file" : " has options, which are not read: " + Quote(name)) +
      ", so its colour is Kd; give the name of an image alone");
    return true;
  }
  const std::filesystem::path folder = std::filesystem::path(file.GetPath()).parent_path();
  this->CurrentColors.Texture = (folder / name).string();
  ImageHeader header;
  const Status status = ReadImageHeader({ this->CurrentColors.Texture }, header);
  return status.IsOk() ||
    this->Report.Fail(file.GetPlace() + "map_Kd of material " + Quote(this->Current.Name) + ": " +
      MakeTextureError(status).Message());
}

// Makes the colour of Kd; a texture alone is white.
MaterialColor MtlFile::MakeColor() const
{
  MaterialColor color;
  const Colors& colors = this->CurrentColors;
  if (this->ReadsColors && (colors.HasDiffuse || !colors.Texture.empty()))
  {
    for (std::size_t i = 0; i < color.Base.size(); ++i)
    {
      color.Base[i] = colors.HasDiffuse ? std::min(1.0, colors.Diffuse[i]) : 1.0;
    }
    color.Texture = colors.Texture;
  }
  return color;
}

bool MtlFile::ReadExponent(TextFile& file, TextWords& words)
{
  TextWords start = words;
  double exponent = 0.0;
  if (words.Next(exponent) != TextWords::Number::Good || !(exponent >= 0.0) ||
    !std::isfinite(exponent))
  {
    return this->Report.Fail(file.GetPlace() + "Ns " + Quote(start.Next()) +
      " is not a finite number >= 0; it is the specular exponent");
  }
  this->Current.SpecularExponent = exponent;
  return true;
}

// Reads a fraction; a value above 1 is interpreted as percent.
bool MtlFile::ReadReflectance(TextFile& file, TextWords& words)
{
  TextWords start = words;
  double reflectance = 0.0;
  if (words.Next(reflectance) != TextWords::Number::Good || !std::isfinite(reflectance))
  {
    return this->Report.Fail(file.GetPlace() + "helios_reflectance " + Quote(start.Next()) +
      " is not a number; it is a fraction from 0 to 1");
  }
  if (reflectance < 0.0 || reflectance > 100.0)
  {
    return this->Report.Fail(file.GetPlace() + "helios_reflectance " + ToText(reflectance) +
      " is outside [0, 1]; it is a fraction, so 50 percent is 0.5");
  }
  const bool isPercent = reflectance > 1.0;
  this->Current.Reflectance = isPercent ? reflectance / 100.0 : reflectance;
  if (isPercent && this->Percent.Count++ == 0)
  {
    this->Percent.First = file.GetPlace() + "helios_reflectance " + ToText(reflectance) +
      " is above 1 and read as percent; write it as the fraction " +
      ToText(this->Current.Reflectance);
  }
  return true;
}

bool MtlFile::ReadClassification(TextFile& file, TextWords& words)
{
  TextWords start = words;
  if (words.Next(this->Current.Classification) != TextWords::Number::Good)
  {
    return this->Report.Fail(file.GetPlace() + "helios_classification " + Quote(start.Next()) +
      " is not a whole number; give a class such as 2");
  }
  return true;
}

bool MtlFile::ReadIsGround(TextFile& file, TextWords& words)
{
  const std::string_view word = words.Next();
  this->Current.IsGround = word == "true" || word == "1";
  if (!this->Current.IsGround && word != "false" && word != "0")
  {
    return this->Report.Fail(
      file.GetPlace() + "helios_isGround " + Quote(word) + " is neither true nor false; give one");
  }
  return true;
}

bool MtlFile::ReadSpectrum(TextFile& file, TextWords& words)
{
  this->Current.Spectrum = words.NextName();
  if (this->Current.Spectrum.empty())
  {
    return this->Report.Fail(
      file.GetPlace() + "helios_spectra has no name; give that of a spectrum, such as grass");
  }
  return true;
}

bool MtlFile::Start(TextFile& file, std::string_view name)
{
  if (name.empty())
  {
    return this->Report.Fail(file.GetPlace() + "newmtl has no name; give the material one");
  }
  if (!this->Finish(file.GetPath()))
  {
    return false;
  }
  this->Started = true;
  this->StartLine = file.GetLine();
  this->Current = Material();
  this->Current.Name = name;
  this->CurrentColors = Colors();
  this->Optics.Start();
  return true;
}

// Adds the current material to the table; false after an error.
bool MtlFile::Finish(const std::string& path)
{
  if (!this->Started)
  {
    return true;
  }
  if (!this->Optics.Finish(
        Sum(this->CurrentColors.Specular) / 3.0, this->Current.Optics, this->Report))
  {
    return false;
  }
  this->Current.Specularity =
    GetSpecularity(Sum(this->CurrentColors.Diffuse), Sum(this->CurrentColors.Specular));
  this->Current.Color = this->MakeColor();
  const int next = static_cast<int>(this->Materials.size());
  const auto [place, isNew] = this->Rows.emplace(this->Current.Name, next);
  if (isNew)
  {
    this->Materials.push_back(this->Current);
    const std::string word(TextWords(this->Current.Name).NextName());
    const auto [first, isFirst] = this->FirstWordRows.emplace(word, next);
    first->second = isFirst ? next : -1;
  }
  else if (!(this->Materials[place->second] == this->Current))
  {
    this->Report.Warn(Place(path, this->StartLine) + "material " + Quote(this->Current.Name) +
      " was defined differently before; this definition is used");
    this->Materials[place->second] = this->Current;
  }
  if (!this->CurrentColors.Shape.What.empty())
  {
    this->CurrentColors.Shape.What += " of material " + Quote(this->Current.Name);
    this->CurrentColors.Shape.Row = place->second;
    this->Cutouts.push_back(this->CurrentColors.Shape);
  }
  return true;
}

int MtlFile::Find(std::string_view name) const
{
  const auto place = this->Rows.find(std::string(name));
  if (place != this->Rows.end())
  {
    return place->second;
  }
  const auto first = this->FirstWordRows.find(std::string(TextWords(name).NextName()));
  return first == this->FirstWordRows.end() ? -1 : first->second;
}

void MtlFile::CountUnknown(TextFile& file, std::string_view key)
{
  if (this->Unknown.Count++ == 0)
  {
    this->Unknown.First = file.GetPlace() + "unknown keyword " + Quote(key) + ", ignored";
  }
}

void MtlFile::Warn(const Note& note)
{
  if (note.Count > 0)
  {
    this->Report.Warn(note.First + " (" + std::to_string(note.Count) + " such lines in this file)");
  }
}

bool FormatMtl(const MaterialTable& materials, std::string& text, TextReport& report)
{
  for (const Material& m : materials)
  {
    const Status status = FindFault(m);
    if (!status.IsOk())
    {
      return report.Fail(
        "material " + Quote(m.Name) + " has the " + status.Message() + "; correct it");
    }
    text += "\nnewmtl " + m.Name + '\n' + FormatColors(m);
    text += "Ns " + ToText(m.SpecularExponent) + '\n';
    if (!std::isnan(m.Reflectance))
    {
      text += "helios_reflectance " + ToText(m.Reflectance) + '\n';
    }
    if (!m.Spectrum.empty())
    {
      text += "helios_spectra " + m.Spectrum + '\n';
    }
    text += "helios_classification " + std::to_string(m.Classification) + '\n';
    text += std::string("helios_isGround ") + (m.IsGround ? "true" : "false") + '\n';
    text += FormatMtlOptics(m.Optics);
  }
  return true;
}

bool ReplaceMaterials(const std::string& path, MaterialTable& materials, TextReport& report)
{
  MaterialTable given;
  MtlFile file(given, report);
  if (!file.Read(path))
  {
    return false;
  }
  bool isUsed = false;
  for (Material& material : materials)
  {
    const int row = file.Find(material.Name);
    if (row >= 0)
    {
      Material other = given[static_cast<std::size_t>(row)];
      const bool hasClass = other.Classification != 0;
      other.Classification = hasClass ? other.Classification : material.Classification;
      other.IsGround = hasClass ? other.IsGround : other.IsGround || material.IsGround;
      material = other;
      isUsed = true;
    }
  }
  if (!isUsed && !materials.empty())
  {
    report.Warn(path + ": no material has the name of one of the scene, such as " +
      Quote(materials.front().Name) + ", so none is used");
  }
  return true;
}

} // namespace helios
