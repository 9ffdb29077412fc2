// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A LAZ file, as an uncompressed LAS file in the temporary folder.

#ifndef heliosLazFile_h
#define heliosLazFile_h

#include "heliosStatus.h"

#include <string>

namespace helios
{

/// Returns whether a file has the header of a LAS file with compressed points.
bool IsLazFile(const std::string& path);

/**
 * Owner of the LAS file. No C++ library for LAZ is among our dependencies: the program vtkhelios of
 * this installation, or of PATH, converts it, with the Python packages laspy and lazrs.
 */
class LazFile
{
public:
  LazFile() = default;
  LazFile(const LazFile&) = delete;
  LazFile& operator=(const LazFile&) = delete;
  ~LazFile();

  /// Converts a file, unless it is the last one and unchanged. Errors name the file.
  Status Convert(const std::string& path);

  /// Returns the LAS file; it exists as long as this object.
  const std::string& GetLasPath() const { return this->LasPath; }

private:
  void Remove();

  std::string Source; // the file converted, and its state
  std::string Folder;
  std::string LasPath;
};

} // namespace helios

#endif
