// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A LAS file that is read: its header and records, checked, and its points as bytes.

#ifndef heliosLasFile_h
#define heliosLasFile_h

#include "heliosLasFormat.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <fstream>
#include <string>
#include <vector>

namespace helios
{

class VTKHELIOSFILTERSIO_EXPORT LasFile
{
public:
  /// Reads all but the points, or says what is wrong: "a.las: has ...". Sizes are checked against
  /// that of the file.
  std::string Open(const std::string& path);

  /// As Open(), for a file whose header may not count all of its points yet: those up to its end.
  std::string OpenGrowing(const std::string& path);

  /// Reads points as they are, or says what is wrong.
  std::string Read(std::uint64_t first, std::uint64_t count, char* bytes);

  const LasHeader& GetHeader() const { return this->Header; }
  const std::vector<LasRecord>& GetRecords() const { return this->Records; }
  const std::vector<LasExtra>& GetExtras() const { return this->Extras; }
  const std::string& GetPath() const { return this->Path; }

  /// The coordinate system: WKT, or "EPSG:n" of GeoTIFF keys; empty: none.
  std::string GetCrs() const;

  /// A record; null: there is none.
  const LasRecord* Find(const char* user, int id) const;

private:
  std::string OpenFile();
  std::string CheckCount() const;
  std::string ReadRecords();
  std::string ReadRecord(std::uint64_t& place, std::uint64_t end, bool isExtended);
  std::string CheckExtras() const;
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
