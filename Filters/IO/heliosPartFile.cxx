// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPartFile.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace helios
{

std::string MakeFoldersFor(const std::string& path)
{
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty() && !std::filesystem::is_directory(folder, error))
  {
    std::filesystem::create_directories(folder, error);
    if (error)
    {
      return "the folder " + folder.string() + " cannot be made: " + error.message();
    }
  }
  return {};
}

std::string RenameFile(const std::string& from, const std::string& to)
{
  if (std::rename(from.c_str(), to.c_str()) != 0)
  {
    return from + " cannot be renamed to " + to + ": " + std::strerror(errno);
  }
  return {};
}

std::int64_t GetSizeOfWhole(const std::string& path, const std::string& ending)
{
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::int64_t size = file.tellg();
  std::string last(ending.size(), '\0');
  file.seekg(-static_cast<std::int64_t>(ending.size()), std::ios::end);
  file.read(last.data(), static_cast<std::streamsize>(last.size()));
  return file && last == ending ? size : -1;
}

void RemoveFile(const std::string& path)
{
  std::remove(path.c_str());
}

PartFile::~PartFile()
{
  this->Abandon();
}

bool PartFile::Fail(const char* what, int error)
{
  this->Problem = this->GetPartPath() + " cannot be " + what + ": " + std::strerror(error);
  return false;
}

bool PartFile::Open(const std::string& path)
{
  this->Abandon();
  this->Path = path;
  this->Size = 0;
  this->Problem = MakeFoldersFor(path);
  std::error_code error;
  if (this->Problem.empty() && std::filesystem::is_directory(path, error))
  {
    this->Problem = path + " is a folder, not a file";
  }
  if (!this->Problem.empty())
  {
    return false;
  }
  this->Descriptor =
    ::open(this->GetPartPath().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  return this->Descriptor >= 0 || this->Fail("opened", errno);
}

bool PartFile::Append(const char* bytes, std::size_t count)
{
  while (count > 0)
  {
    const ssize_t written = ::write(this->Descriptor, bytes, count);
    if (written < 0 && errno == EINTR)
    {
      continue;
    }
    if (written <= 0)
    {
      return this->Fail("written", written < 0 ? errno : EIO);
    }
    this->Size += static_cast<std::uint64_t>(written);
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

bool PartFile::Cut(std::uint64_t size)
{
  const auto end = static_cast<off_t>(size);
  if (::ftruncate(this->Descriptor, end) != 0 || ::lseek(this->Descriptor, end, SEEK_SET) != end)
  {
    return this->Fail("cut", errno);
  }
  this->Size = size;
  return true;
}

bool PartFile::Close()
{
  if (!this->Abandon())
  {
    return false;
  }
  this->Problem = RenameFile(this->GetPartPath(), this->Path);
  return this->Problem.empty();
}

bool PartFile::Abandon()
{
  const int descriptor = this->Descriptor;
  this->Descriptor = -1;
  return descriptor < 0 || ::close(descriptor) == 0 || this->Fail("closed", errno);
}

} // namespace helios
