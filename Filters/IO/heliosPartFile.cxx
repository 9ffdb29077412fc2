// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPartFile.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
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

PartFile::~PartFile()
{
  this->Abandon();
}

bool PartFile::Fail(const std::string& path, int error)
{
  this->Problem = path + " cannot be written: " + std::strerror(error);
  return false;
}

bool PartFile::Open(const std::string& path)
{
  this->Abandon();
  this->Path = path;
  this->Size = 0;
  this->Problem = MakeFoldersFor(path);
  if (!this->Problem.empty())
  {
    return false;
  }
  this->Descriptor = ::open(this->GetPartPath().c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  return this->Descriptor >= 0 || this->Fail(this->GetPartPath(), errno);
}

bool PartFile::Append(const char* bytes, std::size_t count)
{
  std::size_t done = 0;
  while (done < count)
  {
    const ssize_t written = ::write(this->Descriptor, bytes + done, count - done);
    if (written < 0 && errno == EINTR)
    {
      continue;
    }
    if (written <= 0)
    {
      this->Fail(this->GetPartPath(), written < 0 ? errno : EIO);
      const auto whole = static_cast<off_t>(this->Size);
      if (::ftruncate(this->Descriptor, whole) == 0)
      {
        ::lseek(this->Descriptor, whole, SEEK_SET);
      }
      return false;
    }
    done += static_cast<std::size_t>(written);
  }
  this->Size += count;
  return true;
}

bool PartFile::Close()
{
  const int descriptor = this->Descriptor;
  this->Descriptor = -1;
  if (::close(descriptor) != 0)
  {
    return this->Fail(this->GetPartPath(), errno);
  }
  this->Problem = RenameFile(this->GetPartPath(), this->Path);
  return this->Problem.empty();
}

void PartFile::Abandon()
{
  if (this->Descriptor >= 0)
  {
    ::close(this->Descriptor);
    this->Descriptor = -1;
  }
}

} // namespace helios
