// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A file that carries .part until it is whole. Calls of the operating system are here.

#ifndef heliosPartFile_h
#define heliosPartFile_h

#include "vtkHeliosFiltersIOModule.h"

#include <cstdint>
#include <string>

namespace helios
{

class VTKHELIOSFILTERSIO_EXPORT PartFile
{
public:
  PartFile() = default;
  ~PartFile();
  PartFile(const PartFile&) = delete;
  void operator=(const PartFile&) = delete;

  /// Makes the folders and an empty <path>.part. False: see GetProblem().
  bool Open(const std::string& path);
  bool IsOpen() const { return this->Descriptor >= 0; }

  /// Appends a block; where that fails, takes back what was written of it.
  bool Append(const char* bytes, std::size_t count);

  /// Gives the file its final name.
  bool Close();

  /// Leaves the file as <path>.part.
  void Abandon();

  std::uint64_t GetSize() const { return this->Size; }
  const std::string& GetPath() const { return this->Path; }
  std::string GetPartPath() const { return this->Path + ".part"; }

  /// The last failure in words: file and cause.
  const std::string& GetProblem() const { return this->Problem; }

private:
  bool Fail(const std::string& path, int error);

  std::string Path;
  std::string Problem;
  int Descriptor = -1;
  std::uint64_t Size = 0;
};

/// Renames a file, replacing another; says what went wrong, or returns an empty text.
VTKHELIOSFILTERSIO_EXPORT std::string RenameFile(const std::string& from, const std::string& to);

/// Makes the folders above a file; says what went wrong, or returns an empty text.
VTKHELIOSFILTERSIO_EXPORT std::string MakeFoldersFor(const std::string& path);

} // namespace helios

#endif
