// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosMemoryLimit.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <limits>
#include <string>

#include <unistd.h>

vtkStandardNewMacro(vtkHeliosMemoryLimit);

namespace
{

constexpr double Mebibyte = 1048576.0;
constexpr double KibibytesPerMebibyte = 1024.0;
constexpr double Unlimited = std::numeric_limits<double>::infinity();

std::atomic<double> Limit{ 0.0 }; // [MiB]

/// Reads the first number of a file; infinite without a number ("max").
double ReadNumber(const std::string& path)
{
  std::ifstream file(path);
  double value = 0.0;
  return file >> value ? value : Unlimited;
}

/// Reads the number after a word in a file, or returns otherwise.
double FindNumber(const std::string& path, const std::string& wanted, double otherwise)
{
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    if (line.compare(0, wanted.size(), wanted) == 0)
    {
      return std::stod(line.substr(wanted.size()));
    }
  }
  return otherwise;
}

/// Returns the memory left by a control group [MiB]; its file cache is reclaimable.
double GetRoom(const std::string& group, const std::string& maximum, const std::string& used)
{
  const double files = FindNumber(group + "/memory.stat", "inactive_file ", 0.0);
  const double room = ReadNumber(group + maximum) - ReadNumber(group + used) + files;
  return room == room ? std::max(0.0, room) / Mebibyte : Unlimited;
}

/// Returns the smallest memory left by the control groups above this process [MiB].
double GetRoomOfGroups()
{
  double room = GetRoom(
    "/sys/fs/cgroup/memory", "/memory.limit_in_bytes", "/memory.usage_in_bytes"); // version 1
  std::ifstream file("/proc/self/cgroup");
  for (std::string line; std::getline(file, line);)
  {
    const bool isUnified = line.compare(0, 3, "0::") == 0;
    for (std::string path = isUnified ? line.substr(3) : ""; !path.empty();
         path.resize(path.find_last_of('/') == std::string::npos ? 0 : path.find_last_of('/')))
    {
      room = std::min(room, GetRoom("/sys/fs/cgroup" + path, "/memory.max", "/memory.current"));
    }
  }
  return std::min(room, GetRoom("/sys/fs/cgroup", "/memory.max", "/memory.current"));
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosMemoryLimit::SetLimit(double mebibytes)
{
  Limit = mebibytes > 0.0 ? mebibytes : 0.0;
}

//------------------------------------------------------------------------------
double vtkHeliosMemoryLimit::GetLimit()
{
  return Limit;
}

//------------------------------------------------------------------------------
double vtkHeliosMemoryLimit::GetUsed()
{
  std::ifstream file("/proc/self/statm");
  double all = 0.0;
  double resident = 0.0;
  double ofFiles = 0.0;
  file >> all >> resident >> ofFiles;
  return file ? (resident - ofFiles) * static_cast<double>(sysconf(_SC_PAGESIZE)) / Mebibyte : 0.0;
}

//------------------------------------------------------------------------------
double vtkHeliosMemoryLimit::GetAvailable()
{
  const double limit = Limit;
  if (limit > 0.0)
  {
    return std::max(0.0, limit - GetUsed());
  }
  const double machine =
    FindNumber("/proc/meminfo", "MemAvailable:", Unlimited) / KibibytesPerMebibyte;
  return std::min(machine, GetRoomOfGroups());
}
