// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTextFile.h"

#include "heliosInputFile.h"
#include "heliosStatus.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace helios
{

namespace
{
constexpr std::size_t BlockSize = std::size_t(1) << 20;
}

std::string Quote(std::string_view word)
{
  constexpr std::size_t longest = 60;
  std::string text(word.substr(0, longest));
  std::replace_if(
    text.begin(), text.end(), [](unsigned char c) { return c < 32 || c == 127; }, '?');
  return '"' + text + (word.size() > longest ? "...\"" : "\"");
}

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

Status TextFile::Open(const std::string& path)
{
  this->Path = path;
  this->Buffer.resize(BlockSize);
  this->Begin = this->End = this->Buffer.data();
  return OpenInput(path, this->File, this->Size);
}

// Moves the incomplete line to the front of the buffer and reads more after it.
bool TextFile::ReadBlock()
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
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  if (this->Done == 0.0 && std::string_view(this->Begin, count).substr(0, 3) == byteOrderMark)
  {
    this->Begin += byteOrderMark.size();
  }
  this->End += count;
  this->AtEnd = count == 0;
  this->Done += static_cast<double>(count);
  this->Stopped = this->OnBlock &&
    !this->OnBlock(
      this->Size > 0 ? std::min(1.0, this->Done / static_cast<double>(this->Size)) : 0.0);
  return !this->Stopped;
}

bool TextFile::NextRawLine(std::string_view& line)
{
  std::size_t searched = 0;
  for (;;)
  {
    const std::size_t left = static_cast<std::size_t>(this->End - this->Begin);
    char* end = static_cast<char*>(std::memchr(this->Begin + searched, '\n', left - searched));
    if (!end && this->AtEnd && left > 0)
    {
      end = this->End; // last line without line end
    }
    if (end)
    {
      line = { this->Begin, static_cast<std::size_t>(end - this->Begin) };
      this->Begin = std::min(end + 1, this->End);
      ++this->RawLine;
      if (!line.empty() && line.back() == '\r')
      {
        line.remove_suffix(1);
      }
      return true;
    }
    searched = left;
    if (this->AtEnd || this->Stopped || !this->ReadBlock())
    {
      return false;
    }
  }
}

bool TextFile::Join(std::string_view& line)
{
  const std::size_t start = line.find_first_not_of(" \t");
  if (line[start] == '#')
  {
    return true;
  }
  this->Joined.clear();
  while (!line.empty() && line.back() == '\\')
  {
    line.remove_suffix(1);
    this->Joined.append(line).append(" ");
    if (!this->NextRawLine(line))
    {
      line = {};
    }
  }
  this->Joined.append(line);
  line = this->Joined;
  return this->Error.empty() && !this->Stopped;
}

std::string_view TextWords::NextTitle()
{
  this->HasMore();
  const char* begin = this->At;
  std::string_view word = this->ReadWord();
  while (this->HasMore())
  {
    word = this->ReadWord();
  }
  return { begin, static_cast<std::size_t>(word.data() + word.size() - begin) };
}

std::string_view TextWords::Rest()
{
  this->HasMore();
  while (this->End != this->At && IsBlank(this->End[-1]))
  {
    --this->End;
  }
  return { this->At, static_cast<std::size_t>(this->End - this->At) };
}

template <typename T>
TextWords::Number TextWords::NextNumber(T& value)
{
  if (!this->HasMore())
  {
    return Number::None;
  }
  const char* begin = this->At;
  if (*begin == '+' && begin + 1 != this->End && begin[1] != '-')
  {
    ++begin;
  }
  const auto [end, error] = std::from_chars(begin, this->End, value);
  if (error == std::errc::result_out_of_range)
  {
    return Number::Excessive;
  }
  if (error != std::errc() || (end != this->End && !IsBlank(*end)))
  {
    return Number::Malformed;
  }
  this->At = end;
  return Number::Good;
}

TextWords::Number TextWords::Next(double& value)
{
  return this->NextNumber(value);
}

TextWords::Number TextWords::Next(int& value)
{
  return this->NextNumber(value);
}

TextWords::Number TextWords::Next(std::int64_t& value)
{
  return this->NextNumber(value);
}

} // namespace helios
