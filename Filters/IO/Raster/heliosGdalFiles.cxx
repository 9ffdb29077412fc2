// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGdalFiles.h"

#include "heliosGdalMessages.h"
#include "heliosInputFile.h"

#include <filesystem>
#include <set>
#include <system_error>

namespace helios
{

namespace
{

/// Finds the file on disk that a name of GDAL means: the archive of a name such as
/// /vsizip/tiles.zip/a.tif. Returns the name itself if no such file exists.
std::string FindFileOnDisk(const std::string& name)
{
  std::string path = name;
  while (path.compare(0, 4, "/vsi") == 0 && path.find('/', 1) != std::string::npos)
  {
    path.erase(0, path.find('/', 1) + 1);
  }
  std::error_code ignored;
  for (std::string file = path; path != name && !file.empty() && file != "/";
       file = std::filesystem::path(file).parent_path().string())
  {
    if (std::filesystem::is_regular_file(file, ignored))
    {
      return file;
    }
  }
  return name;
}

/// Has GDAL test the names of files beside a raster, in place of reading its folder for each tile.
class NameTests
{
public:
  NameTests() { CPLSetThreadLocalConfigOption(Option, "TRUE"); }
  ~NameTests() { CPLSetThreadLocalConfigOption(Option, nullptr); }
  NameTests(const NameTests&) = delete;
  void operator=(const NameTests&) = delete;

private:
  static constexpr const char* Option = "GDAL_DISABLE_READDIR_ON_OPEN";
};

Status CheckFiles(GDALDatasetH raster, std::set<std::string>& known)
{
  const auto release = [](char** names) { CSLDestroy(names); };
  const std::unique_ptr<char*, decltype(release)> files(GDALGetFileList(raster), release);
  Status status;
  for (char** file = files.get(); file && *file && status.IsOk(); ++file)
  {
    if (!known.insert(*file).second)
    {
      continue;
    }
    const std::string path = FindFileOnDisk(*file);
    status = CheckInputFile(path);
    if (!status.IsOk())
    {
      return Status::Error("needs " + path + ", which " + status.Message());
    }
    const GdalDataset tile = OpenGdalDataset(*file, 0);
    status = tile ? CheckFiles(tile.get(), known) : status;
  }
  return status;
}

} // namespace

//------------------------------------------------------------------------------
GdalDataset OpenGdalDataset(const std::string& path, unsigned int flags)
{
  static const char* const drivers[] = { "GTiff", "VRT", nullptr };
  return GdalDataset(
    GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | flags, drivers, nullptr, nullptr));
}

//------------------------------------------------------------------------------
Status CheckGdalFiles(const std::string& path, GDALDatasetH raster)
{
  const NameTests tests;
  const GdalMessages quiet; // most files beside a raster are no rasters
  std::set<std::string> known = { path };
  return CheckFiles(raster, known);
}

} // namespace helios
