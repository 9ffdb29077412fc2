// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Files that carry .part until they are whole. What writers ask of the operating system is here.

#ifndef heliosPartFile_h
#define heliosPartFile_h

#include "heliosChecksum.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <cstdint>
#include <string>

namespace helios
{

/// Bytes of a file that were appended together, and their checksum.
struct FileBlock
{
  std::string Name; ///< the final one of the file, without its folder
  std::uint64_t Begin = 0;
  std::uint64_t End = 0; ///< the place after the last
  std::string Checksum;
  bool IsWhole = false; ///< no more is written to the file
};

/// Whether the folders of a file that is opened are made, or need to be there.
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

  /// Makes an empty <path>.part. False here and below: see GetProblem().
  bool Open(const std::string& path, Folders folders = Folders::Make);
  bool IsOpen() const { return this->Descriptor >= 0; }

  /// Opens what an earlier run left at <path>.part, or at path where it was renamed already, cut to
  /// a size.
  bool Reopen(const std::string& path, std::uint64_t size);

  /// Takes bytes and keeps none of them: they are counted.
  bool OpenNowhere(const std::string& path);

  /// Appends bytes; where that fails, some of them may be in the file.
  bool Append(const char* bytes, std::size_t count);

  /// Writes over bytes that were appended before.
  bool Overwrite(std::uint64_t place, const char* bytes, std::size_t count);

  /// Takes back what was appended after a size.
  bool Cut(std::uint64_t size);

  /// The bytes that were appended since this or BeginBlock() was called, or since the file was opened.
  FileBlock TakeBlock();

  /// The next block begins here.
  void BeginBlock();

  /// Whether the file that is open was removed.
  bool IsRemoved() const;

  /// Returns when the disk has what was appended. A file that was removed meanwhile is a failure.
  bool Sync();

  /// Ends the file and gives it its final name, on the disk too.
  bool Close();

  /// Ends the file as <path>.part; the problem, if any, stays.
  bool Abandon();

  /// What was appended and not taken back [bytes].
  std::uint64_t GetSize() const { return this->Size; }

  /// Of the last Open().
  const std::string& GetPath() const { return this->Path; }
  std::string GetPartPath() const { return this->Path + ".part"; }

  /// The last failure in words: file and cause.
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
  bool IsInFolder = false; // on the disk
};

/// A file that is appended to, line by line, and that one process at a time may have open.
class VTKHELIOSFILTERSIO_EXPORT LogFile
{
public:
  LogFile() = default;
  ~LogFile() { this->Close(); }
  LogFile(const LogFile&) = delete;
  void operator=(const LogFile&) = delete;

  /// Opens a file that there is; false here and below: see GetProblem().
  bool Open(const std::string& path);

  /// Whether it is still there.
  bool Check();

  /// Takes away what is beyond a size.
  bool Cut(std::uint64_t size);

  /// Appends a text, and returns when the disk has it.
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
/// Each says what went wrong, or returns an empty text.
VTKHELIOSFILTERSIO_EXPORT std::string MakeFoldersFor(const std::string& path);
VTKHELIOSFILTERSIO_EXPORT std::string RenameFile(const std::string& from, const std::string& to);
VTKHELIOSFILTERSIO_EXPORT std::string SyncFile(const std::string& path);     ///< to the disk
VTKHELIOSFILTERSIO_EXPORT std::string SyncFolderOf(const std::string& path); ///< its names
///@}

/// The size of a file [bytes] whose last bytes are an ending; -1 where they are not.
VTKHELIOSFILTERSIO_EXPORT std::int64_t GetSizeOfWhole(
  const std::string& path, const std::string& ending);

/// A block of a file that is whole.
VTKHELIOSFILTERSIO_EXPORT FileBlock MakeFileBlock(
  const std::string& path, std::uint64_t begin, std::uint64_t end);

/// Removes a file, if it is there.
VTKHELIOSFILTERSIO_EXPORT void RemoveFile(const std::string& path);

} // namespace helios

#endif
