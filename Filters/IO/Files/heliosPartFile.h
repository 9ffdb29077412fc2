// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Files with the suffix .part until they are complete. Contains the system calls of the writers.

#ifndef heliosPartFile_h
#define heliosPartFile_h

#include "heliosChecksum.h"
#include "heliosStatus.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <cstdint>
#include <string>

namespace helios
{

/// Ending of the names of files that are not complete.
inline constexpr const char* PartEnding = ".part";

/// Bytes of a file that were appended together, and their checksum.
struct FileBlock
{
  std::string Name; ///< final file name, without folder
  std::uint64_t Begin = 0;
  std::uint64_t End = 0; ///< one past the last byte
  std::string Checksum;
  bool IsWhole = false; ///< the file is complete
};

/// Whether the parent folders of a file are created or must exist.
enum class Folders
{
  Make,
  Need
};

class VTKHELIOSFILTERSIO_EXPORT PartFile
{
public:
  PartFile() = default;
  ~PartFile();
  PartFile(const PartFile&) = delete;
  void operator=(const PartFile&) = delete;

  /// Creates an empty <path>.part. All return false on failure: see GetProblem().
  bool Open(const std::string& path, Folders folders = Folders::Make);
  bool IsOpen() const { return this->Descriptor >= 0; }

  /// Opens the file that an earlier run left at <path>.part, or at path if already renamed,
  /// truncated to a size.
  bool Reopen(const std::string& path, std::uint64_t size);

  /// Counts bytes without writing them.
  bool OpenCountOnly(const std::string& path);

  /// Appends bytes; on failure some of them may be in the file.
  bool Append(const char* bytes, std::size_t count);

  /// Overwrites bytes that were appended before.
  bool Overwrite(std::uint64_t place, const char* bytes, std::size_t count);

  /// Truncates the file to a size.
  bool Cut(std::uint64_t size);

  /// Gets the bytes appended since the last call, BeginBlock(), or the opening of the file.
  FileBlock CollectBlock();

  /// Marks the start of the next block.
  void BeginBlock();

  /// Returns whether the open file was removed.
  bool IsRemoved() const;

  /// Fsyncs the file, also while another thread appends to it. Fails if the file was removed in the
  /// meantime.
  Status Sync();

  /// Closes the file, gives it its final name and fsyncs it.
  bool Close();

  /// Closes the file as <path>.part; keeps the error message, if any.
  bool Abandon();

  /// Closes the file as <path>.part, and gives its final name to another one that was made of it,
  /// which is the block of the file from then on.
  bool ReplaceBy(const std::string& made);

  /// Returns the size without truncated bytes [bytes].
  std::uint64_t GetSize() const { return this->Size; }

  /// Returns the path of the last Open().
  const std::string& GetPath() const { return this->Path; }
  std::string GetPartPath() const { return this->Path + PartEnding; }

  /// Returns the error message of the last failure: file and cause.
  const std::string& GetProblem() const { return this->Problem; }

private:
  bool Fail(const char* what, int error);

  std::string Path;
  std::string Problem;
  int Descriptor = -1;
  std::uint64_t Size = 0;
  Checksum BlockSum;
  std::uint64_t BlockBegin = 0;
  bool IsNowhere = false;
  bool IsInFolder = false; // its name is fsynced
  bool IsReplaced = false;
};

/// An append-only file, written line by line and locked by one process.
class VTKHELIOSFILTERSIO_EXPORT LogFile
{
public:
  LogFile() = default;
  ~LogFile() { this->Close(); }
  LogFile(const LogFile&) = delete;
  void operator=(const LogFile&) = delete;

  /// Opens an existing file; all return false on failure: see GetProblem().
  bool Open(const std::string& path);

  /// Returns whether the file still exists.
  bool Check();

  /// Truncates the file to a size.
  bool Cut(std::uint64_t size);

  /// Appends a text and fsyncs it.
  bool Append(const std::string& text);

  void Close();

  const std::string& GetProblem() const { return this->Problem; }

private:
  bool Fail(const std::string& what);

  std::string Path;
  std::string Problem;
  int Descriptor = -1;
};

///@{
/// Changes of the file system, with the paths in their errors.
VTKHELIOSFILTERSIO_EXPORT Status MakeFoldersFor(const std::string& path);
VTKHELIOSFILTERSIO_EXPORT Status RenameFile(const std::string& from, const std::string& to);
VTKHELIOSFILTERSIO_EXPORT Status SyncFile(const std::string& path);     ///< fsync
VTKHELIOSFILTERSIO_EXPORT Status SyncFolderOf(const std::string& path); ///< its folder
///@}

/// Creates an empty <path>.part and opens it for writing; returns its descriptor, or -1 with errno. A
/// file or link of this name is removed first, and never followed.
VTKHELIOSFILTERSIO_EXPORT int CreatePart(const std::string& path);

///@{
/// Writes a file that has its name when it is complete; the error has file and cause. WriteUnsynced()
/// does not flush it to disk.
VTKHELIOSFILTERSIO_EXPORT Status WriteWhole(const std::string& path, const std::string& text);
VTKHELIOSFILTERSIO_EXPORT Status WriteUnsynced(const std::string& path, const std::string& text);
///@}

/// Returns the size of a file [bytes] if its last bytes are the given ending; else -1.
VTKHELIOSFILTERSIO_EXPORT std::int64_t GetSizeOfWhole(
  const std::string& path, const std::string& ending);

/// Creates the block of a complete file.
VTKHELIOSFILTERSIO_EXPORT FileBlock MakeFileBlock(
  const std::string& path, std::uint64_t begin, std::uint64_t end);

/// Removes a file if it exists.
VTKHELIOSFILTERSIO_EXPORT void RemoveFile(const std::string& path);

} // namespace helios

#endif
