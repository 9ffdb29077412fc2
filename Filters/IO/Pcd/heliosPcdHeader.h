// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The header of PCD files, version 0.7, and the vtkHelios comments in it.

#ifndef heliosPcdHeader_h
#define heliosPcdHeader_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace helios
{

/// A field of a point: Count numbers of a type.
struct PcdField
{
  std::string Name;
  int Size = 4;    ///< size of a number [bytes]
  char Type = 'F'; ///< F: float, I: signed, U: unsigned
  int Count = 1;

  std::size_t GetBytes() const
  {
    return static_cast<std::size_t>(this->Size) * static_cast<std::size_t>(this->Count);
  }
  bool operator==(const PcdField& other) const
  {
    return this->Name == other.Name && this->Size == other.Size && this->Type == other.Type &&
      this->Count == other.Count;
  }
};

enum class PcdStorage
{
  Ascii,
  Binary,    ///< point by point
  Compressed ///< field by field, in LZF
};

/// Letters of ASCII in lower case.
std::string ToLowerCase(std::string text);

struct VTKHELIOSFILTERSIO_EXPORT PcdHeader
{
  std::vector<PcdField> Fields;
  std::uint64_t Width = 0;
  std::uint64_t Height = 1;
  PcdStorage Storage = PcdStorage::Binary;

  ///@{
  /// Stored in comments, so other programs can read the file.
  double Origin[3] = { 0.0, 0.0, 0.0 }; ///< to be added to x y z
  bool HasEpoch = false;
  double Epoch = 0.0;             ///< epoch of GpsTime
  std::string Crs;                ///< one line
  bool HasAmplitude = false;      ///< the field intensity is the amplitude [W]
  bool HasWholeIntensity = false; ///< the field intensity has whole numbers of 16 bits
  ///@}

  double Viewpoint[7] = { 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 };

  std::uint64_t DataBegin = 0; ///< first byte after the header
  std::int64_t DataLine = 0;   ///< its line, from 1

  /// Returns whether VIEWPOINT is the default: no viewpoint.
  bool IsPlainViewpoint() const;
  std::uint64_t GetNumberOfPoints() const { return this->Width * this->Height; }
  std::size_t GetRowSize() const;
  std::int64_t GetNumberOfColumns() const;
  /// Returns the index of the field with exactly this name, or -1.
  int Find(const std::string& name) const;
  /// Returns the index of a field of PCL, in lower case, else in upper case; -1: the file has
  /// neither.
  int FindPcl(const std::string& name) const;

  /// Reads the header of a file. An error has path:line.
  Status Read(const std::string& path, std::istream& file);

  /// Formats the header in ASCII; its length is constant for any number of points below 1e15.
  std::string Format() const;
};

} // namespace helios

#endif
