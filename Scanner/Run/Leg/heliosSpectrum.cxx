// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSpectrum.h"

#include "heliosInputFile.h"
#include "heliosMaterialTable.h"
#include "heliosMessages.h"
#include "heliosStatus.h"
#include "heliosTextFile.h"

#include <vtkDataObject.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <utility>

namespace helios
{

namespace
{

constexpr double NanometresPerMicrometre = 1000.0;
constexpr double Percent = 0.01;

const char* SkipBlanks(const char* text, const char* end)
{
  return std::find_if(
    text, end, [](char c) { return c != ' ' && c != '\t' && c != '\r' && c != ','; });
}

/// Parses two numbers and nothing else.
bool ParseRow(const std::string& line, double row[2])
{
  const char* text = line.data();
  const char* end = text + line.size();
  for (int k = 0; k < 2; ++k)
  {
    const char* begin = SkipBlanks(text, end);
    if (k > 0 && begin == text)
    {
      return false; // 1.5.2 is not 1.5 and 0.2
    }
    text = begin;
    const auto result = std::from_chars(text, end, row[k]);
    if (result.ec != std::errc() || !std::isfinite(row[k]))
    {
      return false;
    }
    text = result.ptr;
  }
  return SkipBlanks(text, end) == end;
}

bool IsBlank(const std::string& line)
{
  const char* end = line.data() + line.size();
  return SkipBlanks(line.data(), end) == end;
}

/// Returns whether several words, and all of them, start as numbers do: a row with an error, not a
/// header.
bool HasNumbers(const std::string& line)
{
  std::istringstream words(line);
  int count = 0;
  for (std::string word; words >> word; ++count)
  {
    if (std::string("+-.0123456789").find(word[0]) == std::string::npos)
    {
      return false;
    }
  }
  return count > 1;
}

/// Returns the reflectance of one spectrum at a wavelength; NaN, after a warning, if it is missing.
double ReadReflectance(const std::string& name, const std::vector<std::string>& folders,
  double wavelength, Messages& log)
{
  const std::string path = FindSpectrum(name, folders);
  Spectrum spectrum;
  const Status status =
    path.empty() ? Status::Error("was not found in the spectra folders:") : spectrum.Read(path);
  if (status.IsOk())
  {
    return spectrum.GetReflectance(wavelength);
  }
  std::string problem = status.Message();
  if (path.empty())
  {
    for (const std::string& folder : folders)
    {
      problem += " " + folder;
    }
  }
  MessageBuilder text;
  text << "Spectrum " << name << " " << problem << "; its materials reflect " << DefaultReflectance;
  log.Warning(text.str());
  return std::numeric_limits<double>::quiet_NaN();
}

/// Returns the reflectances of all spectra that materials need, by name.
std::map<std::string, double> ReadReflectances(const MaterialTable& materials,
  const std::vector<std::string>& folders, double wavelength, Messages& log)
{
  std::map<std::string, double> reflectances;
  for (const Material& material : materials)
  {
    const std::string& name = material.Spectrum;
    if (NeedsSpectrum(material) && reflectances.count(name) == 0)
    {
      reflectances[name] = ReadReflectance(name, folders, wavelength, log);
    }
  }
  return reflectances;
}

} // namespace

//------------------------------------------------------------------------------
std::string FindSpectrum(const std::string& name, const std::vector<std::string>& folders)
{
  for (const std::string& folder : folders)
  {
    const std::filesystem::path path = std::filesystem::path(folder) / (name + ".txt");
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored))
    {
      return path.string();
    }
  }
  return {};
}

//------------------------------------------------------------------------------
bool NeedsSpectrum(const Material& material)
{
  return std::isnan(material.Reflectance) && !material.Spectrum.empty();
}

//------------------------------------------------------------------------------
Status Spectrum::Read(const std::string& path)
{
  this->Wavelengths.clear();
  this->Values.clear();
  if (const Status status = CheckInputFile(path); !status.IsOk())
  {
    return Status::Error("(" + path + ") " + status.Message());
  }
  std::ifstream file(path);
  std::string line;
  int number = 0;
  while (std::getline(file, line))
  {
    ++number;
    double row[2];
    const std::string where = "(" + path + ":" + std::to_string(number) + ") ";
    const bool isRow = ParseRow(line, row);
    if (!isRow && (this->Wavelengths.empty() ? HasNumbers(line) : !IsBlank(line)))
    {
      return Status::Error(where + "has " + Quote(line) +
        " among its rows, which is not a wavelength [um] and a reflectance [%]");
    }
    if (!isRow)
    {
      continue; // header
    }
    if (!this->Wavelengths.empty() && row[0] < this->Wavelengths.back())
    {
      return Status::Error(where + "has wavelengths that do not ascend");
    }
    if (row[0] <= 0.0 || row[1] < 0.0 || row[1] > 100.0)
    {
      return Status::Error(
        where + "has a wavelength [um] that is not positive or a reflectance outside 0 to 100 %");
    }
    this->Wavelengths.push_back(row[0]);
    this->Values.push_back(row[1]);
  }
  return this->Values.empty()
    ? Status::Error("(" + path + ") has no rows of wavelength [um] and reflectance [%]")
    : Status();
}

//------------------------------------------------------------------------------
double Spectrum::GetReflectance(double wavelength) const
{
  const double wanted = wavelength / NanometresPerMicrometre;
  const auto after = std::upper_bound(this->Wavelengths.begin(), this->Wavelengths.end(), wanted);
  const auto i = static_cast<std::size_t>(after - this->Wavelengths.begin());
  if (i == 0 || i == this->Wavelengths.size())
  {
    return Percent * (i == 0 ? this->Values.front() : this->Values.back());
  }
  const double s =
    (wanted - this->Wavelengths[i - 1]) / (this->Wavelengths[i] - this->Wavelengths[i - 1]);
  return Percent * (this->Values[i - 1] + s * (this->Values[i] - this->Values[i - 1]));
}

//------------------------------------------------------------------------------
SpectralScenes::SpectralScenes(
  vtkDataObject* scene, std::vector<std::string> folders, Messages& log)
  : Scene(scene)
  , Folders(std::move(folders))
  , Log(log)
{
}

//------------------------------------------------------------------------------
vtkDataObject* SpectralScenes::Get(double wavelength)
{
  vtkSmartPointer<vtkDataObject>& scene = this->Scenes[wavelength];
  if (scene)
  {
    return scene;
  }
  MaterialTable materials = GetMaterials(this->Scene);
  const std::map<std::string, double> reflectances =
    ReadReflectances(materials, this->Folders, wavelength, this->Log);
  if (reflectances.empty())
  {
    return scene = this->Scene;
  }
  for (Material& material : materials)
  {
    if (NeedsSpectrum(material))
    {
      material.Reflectance = reflectances.at(material.Spectrum);
    }
  }
  scene = vtk::TakeSmartPointer(this->Scene->NewInstance());
  scene->ShallowCopy(this->Scene);
  SetMaterials(scene, materials);
  return scene;
}

} // namespace helios
