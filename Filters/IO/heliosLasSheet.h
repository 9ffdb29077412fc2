// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What is the same for all blocks of a LAS file that is written.

#ifndef heliosLasSheet_h
#define heliosLasSheet_h

#include "heliosLasBlock.h"

#include <string>

namespace helios
{

struct LasSheet
{
  LasHeader Header;
  LasScaling Scaling;
  std::string Arrays; ///< the Extra Bytes
  std::string Wkt;
  std::string Crs;     ///< that Wkt was made from
  bool HasTime = true; ///< TimeShift is known
  bool HasWaves = false;
  std::uint32_t Spacing = 0; ///< of samples [ps]; 0: there are none yet

  /// The records behind the header, and their number.
  std::string EncodeRecords(std::uint32_t& count) const;

  /// The Extra Bytes in words.
  std::string ListArrays() const;

  /// Takes what a file says that is to be gone on with, and counts its points; says what is wrong
  /// with it, or returns an empty text. packetsEnd becomes where the last packet ends, if that is
  /// larger.
  std::string Read(
    const std::string& path, vtkIdType records, bool hasWaves, std::uint64_t& packetsEnd);
};

/// The time that GpsTime counts from; 0: it is not known. False: the array is no number.
bool TakeGpsEpoch(vtkPolyData* echoes, double& epoch);

} // namespace helios

#endif
