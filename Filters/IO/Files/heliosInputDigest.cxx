// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosInputDigest.h"

#include "heliosInputFile.h"
#include "heliosSha256.h"

#include <filesystem>
#include <map>
#include <mutex>
#include <system_error>

namespace helios
{

namespace
{

/// A file that is younger may change again within the resolution of its times.
constexpr double YoungestAge = 2.0; // [s]

std::mutex Mutex;
std::map<std::string, InputDigest> Known; // by path

bool FindDigest(const std::string& path, InputDigest& digest)
{
  const std::lock_guard<std::mutex> lock(Mutex);
  const auto found = Known.find(path);
  const bool isKnown = found != Known.end() && found->second.Stamp == digest.Stamp;
  digest = isKnown ? found->second : digest;
  return isKnown;
}

} // namespace

//------------------------------------------------------------------------------
InputDigest ComputeInputDigest(const std::string& path)
{
  InputDigest digest;
  digest.Stamp = StampFile(path);
  if (digest.Stamp.empty() || FindDigest(path, digest))
  {
    return digest;
  }
  const bool isOld = GetAge(path) > YoungestAge;
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  digest.Size = error ? 0 : static_cast<std::int64_t>(size);
  digest.Sha256 = HashFile(path);
  if (isOld && StampFile(path) == digest.Stamp)
  {
    const std::lock_guard<std::mutex> lock(Mutex);
    Known[path] = digest;
  }
  return digest;
}

} // namespace helios
