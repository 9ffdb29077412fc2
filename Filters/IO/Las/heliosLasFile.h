// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reader of a LAS or LAZ file: validated header and records, and the points as bytes.

#ifndef heliosLasFile_h
#define heliosLasFile_h

#include "heliosLasFormat.h"
#include "heliosLazPoints.h"
#include "heliosStatus.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <fstream>
#include <mutex>
#include <string>
#include <vector>

namespace helios
{

class VTKHELIOSFILTERSIO_EXPORT LasFile
{
public:
  /// Reads all but the points. Errors are "a.las: has ...". Sizes are checked against the file
  /// size.
  Status Open(const std::string& path);

  /// Opens a file whose header may not count all points yet: reads the points up to its end.
  Status OpenGrowing(const std::string& path);

  /// Returns the bytes before the points: header and records.
  std::string ReadHead();

  /// Returns how many points are best read at once.
  std::uint64_t GetPointsPerRound() const;

  /// Reads the raw points; those of LAZ are decompressed.
  Status Read(std::uint64_t first, std::uint64_t count, char* bytes);

  const LasHeader& GetHeader() const { return this->Header; }
  const std::vector<LasRecord>& GetRecords() const { return this->Records; }
  const std::vector<LasExtra>& GetExtras() const { return this->Extras; }
  const std::vector<LazChunk>& GetChunks() const { return this->Compressed.GetChunks(); }
  const std::string& GetPath() const { return this->Path; }

  /// Returns the coordinate system: WKT, or "EPSG:n" from GeoTIFF keys; empty: none.
  std::string GetCrs() const;

  /// Finds a record; null if it does not exist.
  const LasRecord* Find(const char* user, int id) const;

private:
  Status OpenFile();
  Status OpenPoints();
  Status OpenGrowingPoints();
  Status ReadRecords();
  Status ReadRecord(std::uint64_t& place, std::uint64_t end, bool isExtended);
  Status CheckExtras() const;
  bool ReadBytes(std::uint64_t place, std::uint64_t count, char* bytes);

  std::string Path;
  std::ifstream File;
  std::uint64_t Size = 0;
  LasHeader Header;
  std::vector<LasRecord> Records;
  std::vector<LasExtra> Extras;
  LazPoints Compressed; // points of LAZ
  std::mutex Reading;   // held while a thread reads bytes
};

} // namespace helios

#endif
