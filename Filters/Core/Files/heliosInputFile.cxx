// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosInputFile.h"

#include "heliosStatus.h"

#include <sys/stat.h>

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

/// Whether the kernel generates the file content on reading.
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
  return kind.empty() ? Status() : Status::Error("cannot be read: it is " + kind);
}

} // namespace helios
