// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Structures of a LAS file: header, records, point formats. Sources: ASPRS LAS specifications
// 1.4, revision 15, and 1.5.

#ifndef heliosLasFormat_h
#define heliosLasFormat_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace helios
{

///@{
/// Stores a number as bytes; LAS is little-endian, and so are all supported machines.
template <typename T>
void StoreLas(char* bytes, T value)
{
  std::memcpy(bytes, &value, sizeof(T));
}
template <typename T>
T LoadLas(const char* bytes)
{
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}
template <typename T>
std::string EncodeLas(T value)
{
  std::string bytes(sizeof(T), '\0');
  StoreLas(bytes.data(), value);
  return bytes;
}
///@}

/// Offsets of the fields in a point record [bytes]; -1: the field does not exist.
struct LasPointForm
{
  int Length = 0;
  bool IsLong = false; // formats 6 to 10
  int Time = -1;
  int Color = -1;
  int Infrared = -1;
  int Wave = -1;

  bool IsKnown() const { return this->Length > 0; }
};

/// Returns the layout of a point data record format; empty above 10.
VTKHELIOSFILTERSIO_EXPORT LasPointForm GetLasPointForm(int format);

/// Totals over all points of a file.
struct VTKHELIOSFILTERSIO_EXPORT LasSummary
{
  std::uint64_t Count = 0;
  std::array<std::uint64_t, 15> ByReturn{};
  std::array<std::int32_t, 3> Minimum{};
  std::array<std::int32_t, 3> Maximum{};

  /// Adds points of formats 6 to 10.
  void Add(const char* records, std::int64_t count, std::int64_t length);
  void Add(const LasSummary& other);
};

struct VTKHELIOSFILTERSIO_EXPORT LasHeader
{
  static constexpr int Size10 = 227; ///< LAS 1.0
  static constexpr int Size14 = 375;
  static constexpr int LargestSize = 393;           ///< LAS 1.5
  static constexpr double StandardTimeOffset = 1e9; ///< [s]

  ///@{
  /// Bits of Encoding.
  static constexpr int StandardTime = 1; ///< GPS time minus StandardTimeOffset
  static constexpr int ExternalWaves = 4;
  static constexpr int HasWkt = 16;
  static constexpr int OffsetTime = 64; ///< LAS 1.5: standard time minus an offset of its own
  ///@}

  int Minor = 4;
  int Encoding = 0;
  std::string System;
  std::string Software;
  int CreationDay = 0;
  int CreationYear = 0;
  std::uint32_t HeaderSize = Size14;
  std::uint32_t PointsBegin = 0;
  std::uint32_t NumberOfRecords = 0;
  int Format = 6;
  int PointLength = 30;
  bool IsCompressed = false; ///< LAZ
  std::array<double, 3> Scale{ 1.0, 1.0, 1.0 };
  std::array<double, 3> Offset{};
  std::uint64_t WavesBegin = 0; ///< start of the packet record in the file itself
  std::uint64_t ExtendedBegin = 0;
  std::uint32_t NumberOfExtended = 0;
  double Epoch = 0.0; ///< GPS time at which the times begin [s], when reading; 0: unknown
  LasSummary Points;  ///< when reading: only the count

  /// Encodes a header of LAS 1.4, with the counts of older versions 0.
  std::string Encode() const;

  /// Decodes the first bytes of a file (LargestSize, or all).
  Status Decode(std::string_view bytes);

  /// Checks scale and offset.
  Status CheckScaling() const;

  double GetCoordinate(std::int32_t number, int axis) const
  {
    return static_cast<double>(number) * this->Scale[axis] + this->Offset[axis];
  }

private:
  Status DecodeCounts(std::string_view bytes);
  double DecodeEpoch(std::string_view bytes) const;
  Status CheckNumbers() const;
};

/// A variable length record.
struct VTKHELIOSFILTERSIO_EXPORT LasRecord
{
  static constexpr int HeadSize = 54;
  static constexpr int ExtendedHeadSize = 60;

  std::string User;
  int Id = 0;
  std::string Description;
  std::string Data;

  ///@{
  /// Encodes it after the header, or after the points.
  std::string Encode() const;
  std::string EncodeExtended() const;
  ///@}
};

/// A scalar field of the Extra Bytes of a point.
struct LasExtra
{
  std::string Name;
  std::string Description;
  int Type = 0; ///< 1 to 10: u8 i8 u16 i16 u32 i32 u64 i64 f32 f64; 0: undocumented bytes
  int Size = 0; ///< [bytes]
  int Components = 1;
  bool IsScaled = false;
  std::array<double, 3> Scale{ 1.0, 1.0, 1.0 };
  std::array<double, 3> Offset{};
  bool HasNoData = false;
  std::array<double, 3> NoData{}; ///< values before scaling that stand for no value
};

///@{
/// Encodes and decodes the Extra Bytes record.
VTKHELIOSFILTERSIO_EXPORT std::string EncodeLasExtras(const std::vector<LasExtra>& extras);
VTKHELIOSFILTERSIO_EXPORT Status DecodeLasExtras(
  std::string_view data, std::vector<LasExtra>& extras);
///@}

///@{
/// User id and record id of a variable length record.
inline constexpr const char* LasSpecUser = "LASF_Spec";
inline constexpr int LasExtraBytesId = 4;
inline constexpr const char* LasProjectionUser = "LASF_Projection";
inline constexpr int LasWktId = 2112;
inline constexpr int LasGeoKeysId = 34735;
///@}

/// Returns the text in bytes, up to the first zero.
VTKHELIOSFILTERSIO_EXPORT std::string GetLasText(std::string_view bytes);

} // namespace helios

#endif
