// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reader of a LAS file: validated header and records, and the points as bytes.

#ifndef heliosLasFile_h
#define heliosLasFile_h

#include "heliosLasFormat.h"
#include "heliosStatus.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <fstream>
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

  /// Reads the raw points.
  Status Read(std::uint64_t first, std::uint64_t count, char* bytes);

  const LasHeader& GetHeader() const { return this->Header; }
  const std::vector<LasRecord>& GetRecords() const { return this->Records; }
  const std::vector<LasExtra>& GetExtras() const { return this->Extras; }
  const std::string& GetPath() const { return this->Path; }

  /// Returns the coordinate system: WKT, or "EPSG:n" from GeoTIFF keys; empty: none.
  std::string GetCrs() const;

  /// Finds a record; null if it does not exist.
  const LasRecord* Find(const char* user, int id) const;

private:
  Status OpenFile();
  Status CheckCount() const;
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
};

} // namespace helios

#endif
