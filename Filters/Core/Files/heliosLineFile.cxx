// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLineFile.h"

#include "heliosInputFile.h"
#include "heliosStatus.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace helios
{

namespace
{

constexpr std::size_t BlockSize = std::size_t(1) << 20;
constexpr std::size_t HeadSize = std::size_t(1) << 16;

/// Counts the line ends in the first bytes of a file.
std::int64_t CountLineEnds(const std::string& path, std::int64_t bytes, char lineBreak)
{
  InputFile file(std::fopen(path.c_str(), "rb"));
  std::vector<char> block(BlockSize);
  std::int64_t count = 0;
  while (file && bytes > 0)
  {
    const std::size_t size = static_cast<std::size_t>(std::min<std::int64_t>(bytes, BlockSize));
    const std::size_t read = std::fread(block.data(), 1, size, file.get());
    count +=
      std::count(block.begin(), block.begin() + static_cast<std::ptrdiff_t>(read), lineBreak);
    bytes = read > 0 ? bytes - static_cast<std::int64_t>(read) : 0;
  }
  return count;
}

} // namespace

std::string Place(const std::string& path, std::int64_t line)
{
  return path + ':' + std::to_string(line) + ": ";
}

Status OpenInput(const std::string& path, InputFile& file, std::int64_t& size)
{
  if (const Status status = CheckInputFile(path); !status.IsOk())
  {
    return Status::Error(path + ": " + status.Message());
  }
  file.reset(std::fopen(path.c_str(), "rb"));
  if (!file)
  {
    return Status::Error(
      path + ": cannot be read: " + std::strerror(errno) + "; check the file name");
  }
  std::setvbuf(file.get(), nullptr, _IONBF, 0);
  std::error_code error;
  size = static_cast<std::int64_t>(std::filesystem::file_size(path, error));
  return error ? Status::Error(path + ": cannot be read: " + error.message() + "; check the disk")
               : Status();
}

Status CheckEncoding(std::string_view bytes)
{
  const auto isZero = [bytes](std::size_t at) { return at < bytes.size() && bytes[at] == '\0'; };
  const bool isMarked = bytes.substr(0, 2) == "\xFF\xFE" || bytes.substr(0, 2) == "\xFE\xFF";
  const bool isPlain = bytes.size() >= 4 && isZero(0) == isZero(2) && isZero(1) == isZero(3) &&
    isZero(0) != isZero(1); // ASCII characters have one zero byte
  return isMarked || isPlain
    ? Status::Error(
        "is text of UTF-16 or UTF-32; save it as UTF-8, such as by iconv -f UTF-16 -t UTF-8")
    : Status();
}

Status LineFile::Open(const std::string& path)
{
  this->Path = path;
  const Status status = OpenInput(path, this->File, this->Size);
  return status.IsOk() ? this->ReadHead() : status;
}

Status LineFile::ReadHead()
{
  std::vector<char> head(HeadSize);
  const std::string_view bytes(
    head.data(), std::fread(head.data(), 1, head.size(), this->File.get()));
  const bool isOld = bytes.find('\n') == std::string_view::npos &&
    bytes.substr(0, bytes.size() - (bytes.empty() ? 0 : 1)).find('\r') != std::string_view::npos;
  this->LineBreak = isOld ? '\r' : '\n';
  const Status status = CheckEncoding(bytes);
  return status.IsOk() ? status : Status::Error(this->Path + ": " + status.Message());
}

void LineFile::SetRange(std::int64_t begin, std::int64_t end)
{
  this->Buffer.resize(std::max(this->Buffer.size(), BlockSize));
  this->Begin = this->End = this->Buffer.data();
  this->AtEnd = false;
  this->Stop = std::min(end, this->Size);
  // A line starts at begin if the previous byte is a line end.
  this->Next = std::max<std::int64_t>(begin - 1, 0);
  if (std::fseek(this->File.get(), static_cast<long>(this->Next), SEEK_SET) != 0)
  {
    this->Error = this->Path + ": cannot be read: " + std::strerror(errno) + "; check the disk";
  }
  else if (begin > 0 && begin < this->Stop)
  {
    this->SkipLine();
  }
}

bool LineFile::ReadBlock()
{
  const std::size_t left = static_cast<std::size_t>(this->End - this->Begin);
  std::memmove(this->Buffer.data(), this->Begin, left);
  if (left == this->Buffer.size())
  {
    this->Buffer.resize(2 * left);
  }
  this->Begin = this->Buffer.data();
  this->End = this->Begin + left;
  const std::size_t count = std::fread(this->End, 1, this->Buffer.size() - left, this->File.get());
  if (std::ferror(this->File.get()))
  {
    this->Error =
      this->Path + ": cannot be read any further: " + std::strerror(errno) + "; check the disk";
    return false;
  }
  this->End += count;
  this->AtEnd = count == 0;
  this->Done += static_cast<std::int64_t>(count);
  this->Stopped = this->OnBlock && !this->OnBlock(this->Done);
  return !this->Stopped;
}

// Finds the end of the line at Begin, and reads more if needed.
bool LineFile::FindLineEnd()
{
  std::size_t searched = 0;
  for (;;)
  {
    const std::size_t left = static_cast<std::size_t>(this->End - this->Begin);
    this->LineEnd =
      static_cast<char*>(std::memchr(this->Begin + searched, this->LineBreak, left - searched));
    if (!this->LineEnd && this->AtEnd && left > 0)
    {
      this->LineEnd = this->End; // last line without line end
    }
    if (this->LineEnd)
    {
      return true;
    }
    searched = left;
    if (this->AtEnd || this->Stopped || left > this->LongestLine || !this->ReadBlock())
    {
      return false;
    }
  }
}

void LineFile::SkipLine()
{
  while (!this->FindLineEnd() && this->End - this->Begin > static_cast<std::ptrdiff_t>(BlockSize))
  {
    this->Next += this->End - this->Begin;
    this->Begin = this->End;
  }
  if (this->LineEnd)
  {
    char* const begin = std::min(this->LineEnd + 1, this->End);
    this->Next += begin - this->Begin;
    this->Begin = begin;
  }
}

bool LineFile::NextLine(std::string_view& line)
{
  if (this->Next >= this->Stop || !this->Error.empty())
  {
    return false;
  }
  this->LineStart = this->Next;
  if (!this->FindLineEnd())
  {
    if (this->Error.empty() && !this->Stopped && !this->AtEnd)
    {
      this->Error = this->GetPlace() + "the line is longer than 1 MiB; is this a text file?";
    }
    return false;
  }
  line = { this->Begin, static_cast<std::size_t>(this->LineEnd - this->Begin) };
  char* const begin = std::min(this->LineEnd + 1, this->End);
  this->Next += begin - this->Begin;
  this->Begin = begin;
  if (!line.empty() && line.back() == '\r')
  {
    line.remove_suffix(1);
  }
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  if (this->LineStart == 0 && line.substr(0, byteOrderMark.size()) == byteOrderMark)
  {
    line.remove_prefix(byteOrderMark.size());
  }
  return true;
}

std::string LineFile::GetPlace() const
{
  return Place(this->Path, 1 + CountLineEnds(this->Path, this->LineStart, this->LineBreak));
}

} // namespace helios
