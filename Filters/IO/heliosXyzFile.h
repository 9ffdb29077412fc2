// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The lines of a stretch of a text file, so that a file can be read in pieces.

#ifndef heliosXyzFile_h
#define heliosXyzFile_h

#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace helios
{

/// Reads in blocks, so that memory does not grow with the file.
class XyzFile
{
public:
  XyzFile() = default;
  ~XyzFile();
  XyzFile(const XyzFile&) = delete;
  void operator=(const XyzFile&) = delete;

  /// Called after every block with the number of bytes read in all; false stops the reading.
  std::function<bool(std::int64_t)> OnBlock;

  /// Says in words why a file cannot be read, or returns an empty text. Lines come after SetRange.
  std::string Open(const std::string& path);

  std::int64_t GetSize() const { return this->Size; }

  /**
   * From here on the lines whose first byte lies in [begin, end): stretches that follow each other
   * give every line of the file once.
   */
  void SetRange(std::int64_t begin, std::int64_t end);

  /**
   * The next line without its end (LF or CR LF) and without a byte-order mark; valid until the next
   * call. False at the end of the stretch, at an error and when stopped.
   */
  bool NextLine(std::string_view& line);

  const std::string& GetPath() const { return this->Path; }
  /// Where in the file the line last read starts.
  std::int64_t GetLineStart() const { return this->LineStart; }
  /// "path:line: " of the line last read; counts the lines before it, so for messages only.
  std::string GetPlace() const;
  bool IsStopped() const { return this->Stopped; }
  /// What went wrong while reading, or an empty text.
  const std::string& GetError() const { return this->Error; }

private:
  bool ReadBlock();
  bool FindLineEnd();
  void SkipLine();

  std::string Path;
  std::string Error;
  std::FILE* File = nullptr;
  std::int64_t Size = 0;
  std::int64_t Stop = 0; // lines that start here or later are not read
  std::int64_t Next = 0; // where in the file Begin is
  std::int64_t LineStart = 0;
  std::int64_t Done = 0;
  std::vector<char> Buffer;
  char* Begin = nullptr;   // of what is not yet handed out
  char* LineEnd = nullptr; // of the line at Begin
  char* End = nullptr;
  bool AtEnd = false;
  bool Stopped = false;
};

} // namespace helios

#endif
