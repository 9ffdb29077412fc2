// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosInputFile.h"

#include "heliosStatus.h"

#include <algorithm>
#include <utility>

#include <sys/stat.h>
#include <time.h>

namespace helios
{

namespace
{

bool GetStatus(const std::string& path, struct stat& status)
{
  return path.find('\0') == std::string::npos && ::stat(path.c_str(), &status) == 0;
}

/// Describes a non-regular file and gives a remedy; empty for regular files.
std::string DescribeKind(mode_t mode)
{
  switch (mode & S_IFMT)
  {
    case S_IFREG:
      return {};
    case S_IFDIR:
      return "a folder; give the name of a file";
    case S_IFIFO:
      return "a FIFO, not a regular file; copy it to a file";
    case S_IFSOCK:
      return "a socket, not a regular file; copy what it sends to a file";
    case S_IFCHR:
      return "a character device, not a regular file; copy what is read to a file";
    case S_IFBLK:
      return "a block device, not a regular file; copy what is read to a file";
    default:
      return "not a regular file; copy it to a file";
  }
}

/// Returns whether the kernel generates the file content on reading.
bool IsOfKernel(const struct stat& status)
{
  struct stat root;
  const bool hasRoot = GetStatus("/", root);
  const auto isOn = [&](const char* mount)
  {
    struct stat own;
    return GetStatus(mount, own) && own.st_dev == status.st_dev && own.st_dev != root.st_dev;
  };
  return hasRoot && (isOn("/proc") || isOn("/sys"));
}

std::string ToText(const timespec& time)
{
  return " " + std::to_string(time.tv_sec) + "." + std::to_string(time.tv_nsec);
}

std::string ToStamp(const struct stat& status)
{
  return std::to_string(status.st_size) + ToText(status.st_mtim) + ToText(status.st_ctim) + " " +
    std::to_string(status.st_ino);
}

/// Called with the files that this thread opens; null: nobody wants them.
thread_local const InputWatch::OpenCallback* CurrentWatch = nullptr;

} // namespace

Status CheckInputFile(const std::string& path)
{
  struct stat status;
  if (!GetStatus(path, status))
  {
    return {};
  }
  std::string kind = DescribeKind(status.st_mode);
  if (kind.empty() && IsOfKernel(status))
  {
    kind = "a file of the kernel (/proc, /sys), not a regular file; copy it to a file";
  }
  if (!kind.empty())
  {
    return Status::Error("cannot be read: it is " + kind);
  }
  if (CurrentWatch)
  {
    (*CurrentWatch)(path, ToStamp(status));
  }
  return {};
}

std::string StampFile(const std::string& path)
{
  struct stat status;
  return GetStatus(path, status) ? ToStamp(status) : std::string();
}

double GetAge(const std::string& path)
{
  struct stat status;
  timespec now;
  if (!GetStatus(path, status) || ::clock_gettime(CLOCK_REALTIME, &now) != 0)
  {
    return 0.0;
  }
  return static_cast<double>(now.tv_sec - status.st_ctim.tv_sec) +
    1e-9 * static_cast<double>(now.tv_nsec - status.st_ctim.tv_nsec);
}

bool AreUnchanged(const InputFiles& files)
{
  return std::all_of(files.begin(), files.end(),
    [](const auto& file) { return StampFile(file.first) == file.second; });
}

InputWatch::InputWatch(OpenCallback onOpen)
  : OnOpen(std::move(onOpen))
  , Before(CurrentWatch)
{
  CurrentWatch = &this->OnOpen;
}

InputWatch::InputWatch(InputFiles& files)
  : InputWatch(
      [&files](const std::string& path, const std::string& stamp) { files.emplace(path, stamp); })
{
}

InputWatch::~InputWatch()
{
  CurrentWatch = this->Before;
}

bool InputWatch::IsOn()
{
  return CurrentWatch != nullptr;
}

} // namespace helios
