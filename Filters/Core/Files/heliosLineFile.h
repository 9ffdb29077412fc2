// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The lines of a byte range of a text file, for reading a file in pieces.

#ifndef heliosLineFile_h
#define heliosLineFile_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace helios
{

/// Returns "path:line: ", the start of a message.
VTKHELIOSFILTERSCORE_EXPORT std::string Place(const std::string& path, std::int64_t line);

/// Returns an error if the first bytes of a text file are UTF-16 or UTF-32.
VTKHELIOSFILTERSCORE_EXPORT Status CheckEncoding(std::string_view bytes);

struct FileCloser
{
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using InputFile = std::unique_ptr<std::FILE, FileCloser>;

/// Opens a file without a buffer and gets its size.
VTKHELIOSFILTERSCORE_EXPORT Status OpenInput(
  const std::string& path, InputFile& file, std::int64_t& size);

/// Reads in blocks, so that memory does not grow with the file.
class VTKHELIOSFILTERSCORE_EXPORT LineFile
{
public:
  LineFile() = default;
  LineFile(const LineFile&) = delete;
  void operator=(const LineFile&) = delete;

  /// Runs after every block with the total number of bytes read; false stops reading.
  std::function<bool(std::int64_t)> OnBlock;

  /// Opens a file, which is not UTF-16, and finds what ends its lines. Call SetRange before NextLine.
  Status Open(const std::string& path);

  std::int64_t GetSize() const { return this->Size; }

  /**
   * Selects the lines whose first byte is in [begin, end): adjacent ranges return every line of the
   * file exactly once.
   */
  void SetRange(std::int64_t begin, std::int64_t end);

  /// Sets the length above which a line is an error, since the file is hardly text [bytes].
  /// Default: 1 MiB.
  void SetLongestLine(std::size_t length) { this->LongestLine = length; }

  /**
   * Reads the next line without its end (LF or CR LF; CR in files of the old Macintosh) and without
   * a byte-order mark; it stays valid until the next call. False at the end of the range, after an
   * error and when stopped.
   */
  bool NextLine(std::string_view& line);

  const std::string& GetPath() const { return this->Path; }
  /// Returns the file position of the start of the last line read.
  std::int64_t GetLineStart() const { return this->LineStart; }
  /// Returns the file position of the next line.
  std::int64_t GetNextLine() const { return this->Next; }
  /// Returns "path:line: " of the last line read; it counts all previous lines, so use it for
  /// messages only.
  std::string GetPlace() const;
  bool IsStopped() const { return this->Stopped; }
  /// Returns the error message of reading, empty without an error.
  const std::string& GetError() const { return this->Error; }

private:
  Status ReadHead();
  bool ReadBlock();
  bool FindLineEnd();
  void SkipLine();

  std::string Path;
  std::string Error;
  InputFile File;
  char LineBreak = '\n';
  std::int64_t Size = 0;
  std::int64_t Stop = 0; // lines that start here or later are not read
  std::int64_t Next = 0; // file position of Begin
  std::int64_t LineStart = 0;
  std::int64_t Done = 0;
  std::size_t LongestLine = std::size_t(1) << 20;
  std::vector<char> Buffer;
  char* Begin = nullptr;   // first unread byte
  char* LineEnd = nullptr; // end of the line at Begin
  char* End = nullptr;
  bool AtEnd = false;
  bool Stopped = false;
};

} // namespace helios

#endif
