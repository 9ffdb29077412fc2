// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Properties shared by all blocks of a LAS file being written.

#ifndef heliosLasFileHead_h
#define heliosLasFileHead_h

#include "heliosLasBlock.h"
#include "heliosLazForm.h"
#include "heliosStatus.h"

#include <string>
#include <vector>

namespace helios
{

struct LasFileHead
{
  LasHeader Header;
  LasScaling Scaling;
  std::string Arrays; ///< Extra Bytes
  std::string Wkt;
  std::string Crs;     ///< source of Wkt
  bool HasTime = true; ///< TimeShift is known
  bool HasWaves = false;
  std::vector<LazChunk> Chunks; ///< the chunks of a LAZ file that is resumed
  std::uint32_t Spacing = 0;    ///< spacing of samples [ps]; 0: no waveforms yet

  /// Encodes the records after the header, and counts them.
  std::string EncodeRecords(std::uint32_t& count) const;

  /// Returns the Extra Bytes as text.
  std::string ListArrays() const;

  /// Restores the state from a file to be resumed, and counts its points. packetsEnd is raised to
  /// the end of the last packet.
  Status Read(const std::string& path, vtkIdType records, bool hasWaves, std::uint64_t& packetsEnd);
};

/// Gets the epoch of GpsTime; 0: unknown. False if the array is not numeric.
bool ReadGpsEpoch(vtkPolyData* echoes, double& epoch);

} // namespace helios

#endif
