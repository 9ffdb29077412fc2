// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Material files (MTL) with the HELIOS keys.

#ifndef heliosMtlFile_h
#define heliosMtlFile_h

#include "heliosCutouts.h"
#include "heliosMaterialTable.h"
#include "heliosMtlOptics.h"
#include "heliosTextFile.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace helios
{

/**
 * Reads MTL files one by one into one table. Keys: newmtl, Kd, Ks, Ns, helios_reflectance,
 * helios_isGround, helios_classification, helios_spectra and the keys of MtlOptics; Ka is checked;
 * map_Kd is read with colours. The specularity of every material is sum Ks / (sum Kd + sum Ks). A
 * material defined again replaces the first one. A reflectance above 1 is read as percent, up to
 * 100, with a warning.
 */
class MtlFile
{
public:
  MtlFile(MaterialTable& materials, TextReport& report)
    : Materials(materials)
    , Report(report)
  {
  }

  /// Sets whether Kd and map_Kd become colours of the materials. Default: false.
  void SetReadsColors(bool reads) { this->ReadsColors = reads; }

  /// Returns false after an error, which is in the report.
  bool Read(const std::string& path);

  /**
   * Returns the row of a material, -1 if the name does not exist. Names may contain blanks; if the
   * full name is not found, the first word is used (HELIOS reads only that), provided it is unique.
   */
  int Find(std::string_view name) const;

  /// Returns the materials with map_d, or a map_Kd that has transparency.
  const std::vector<Cutout>& GetCutouts() const { return this->Cutouts; }

private:
  struct Colors
  {
    std::array<double, 3> Diffuse{}; // red, green, blue
    std::array<double, 3> Specular{};
    bool HasDiffuse = false;
    std::string Texture; // path; empty: none
    Cutout Shape;        // shape by map_d, or by a texture with transparency; What is empty: none
  };

  bool ReadLine(TextFile& file, std::string_view line);
  bool ReadColor(
    TextFile& file, std::string_view key, TextWords& words, std::array<double, 3>& color);
  bool ReadTexture(TextFile& file, TextWords& words);
  bool ReadExponent(TextFile& file, TextWords& words);
  bool ReadReflectance(TextFile& file, TextWords& words);
  bool ReadClassification(TextFile& file, TextWords& words);
  bool ReadIsGround(TextFile& file, TextWords& words);
  bool ReadSpectrum(TextFile& file, TextWords& words);
  MaterialColor MakeColor() const;
  bool Start(TextFile& file, std::string_view name);
  bool Finish(const std::string& path);
  void CountUnknown(TextFile& file, std::string_view key);

  MaterialTable& Materials;
  TextReport& Report;
  std::unordered_map<std::string, int> Rows;
  std::unordered_map<std::string, int> FirstWordRows; // -1: ambiguous

  bool ReadsColors = false;
  std::vector<Cutout> Cutouts;

  // The current material.
  bool Started = false;
  std::int64_t StartLine = 0;
  Material Current;
  Colors CurrentColors;
  MtlOptics Optics;

  /// Lines of one kind; the first is reported with their count.
  struct Note
  {
    std::int64_t Count = 0;
    std::string First;
  };

  void Warn(const Note& note);

  Note Unknown;
  Note Percent;
};

/// Returns sum Ks / (sum Kd + sum Ks), 0 if both are zero.
double GetSpecularity(double diffuse, double specular);

/**
 * Formats an MTL file from which MtlFile reads the same materials. Reports what cannot be written;
 * names must already be single words.
 */
bool FormatMtl(const MaterialTable& materials, std::string& text, TextReport& report);

/**
 * Replaces the materials of a table by materials with the same names in an MTL file; a class of 0
 * keeps the class and ground of the table. False after an error, which is in the report.
 */
bool ReplaceMaterials(const std::string& path, MaterialTable& materials, TextReport& report);

} // namespace helios

#endif
