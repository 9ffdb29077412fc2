// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Parses the text of a .vox file: a grid of cells and their values.

#ifndef heliosVoxelFile_h
#define heliosVoxelFile_h

#include "heliosTextFile.h"

#include <vtkType.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace helios
{

/// Geometry of the grid.
struct VoxelLayout
{
  double Corner[3] = { 0.0, 0.0, 0.0 }; // minimum corner [m]
  double Size[3] = { 0.0, 0.0, 0.0 };   // size of a cell [m]
  std::int64_t Count[3] = { 0, 0, 0 };  // number of cells
  double MaximumPad = 0.0;              // 0: not set
  bool HasTransmittance = false;

  std::int64_t GetNumberOfCells() const { return this->Count[0] * this->Count[1] * this->Count[2]; }
};

/// Reads the header of a file, then its rows; every number used is checked.
class VoxelFile
{
public:
  VoxelFile(const std::string& padColumn, TextReport& report)
    : PadColumn(padColumn)
    , Report(report)
  {
  }

  /// Reads up to the first row; false after an error.
  bool ReadHead(const std::string& path);

  const VoxelLayout& GetLayout() const { return this->Layout; }
  TextFile& GetText() { return this->Text; }

  /**
   * Writes the values of the cells present in the file; the caller initializes all cells.
   * transmittance may be null. False after an error.
   */
  bool ReadRows(double* pad, double* transmittance);

private:
  enum class Role : char
  {
    None,
    I,
    J,
    K,
    Pad,
    Transmittance
  };

  struct Row
  {
    std::int64_t Index[3];
    double Pad;
    double Transmittance;
  };

  bool ReadKeys(std::string_view line);
  bool ReadKey(const std::string& key, std::string_view values);
  bool ReadNumbers(const std::string& key, std::string_view values, int minimum, double numbers[3]);
  bool ReadNames(std::string_view line);
  bool FinishHead();
  bool CheckCount();
  void SetRole(std::size_t column, Role role);
  bool ReadRow(std::string_view line, double* pad, double* transmittance);
  bool ReadColumns(TextWords& words, Row& row);
  bool ReadIndex(TextWords& words, int axis, std::int64_t& index);
  bool ReadValue(TextWords& words, Role role, double& value);
  std::string GetName(Role role) const;
  bool Fail(const std::string& message)
  {
    return this->Report.Fail(this->Text.GetPlace() + message);
  }

  std::string PadColumn;
  TextReport& Report;
  TextFile Text;
  VoxelLayout Layout;
  double HighCorner[3] = { 0.0, 0.0, 0.0 };
  bool HasCorner = false;
  bool HasHighCorner = false;
  std::vector<Role> Roles;   // per column, up to the last one read
  std::string_view FirstRow; // ends the header
  std::vector<bool> Seen;    // per cell
};

/// Reads the rows x y z G of a leaf-angle table, separated by , ; or blanks; false after an error.
bool ReadLeafTable(const std::string& path, TextReport& report, std::vector<double>& rows);

} // namespace helios

#endif
