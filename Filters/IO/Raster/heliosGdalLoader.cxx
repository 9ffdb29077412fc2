// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGdal.h"

#include "heliosGdalExport.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace helios
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* Variable = "VTKHELIOS_GDAL_LIBRARY";
constexpr int NewestName = 40; // libgdal.so.N; GDAL 3.12 has 38
constexpr int OldestName = 31; // GDAL 3.5, the first with all functions of heliosLoadedGdal.h

void* Library = nullptr;

/// Returns the folder of the Python packages, which the package vtkhelios with this library is in.
fs::path GetPackageFolder()
{
  Dl_info info;
  return ::dladdr(&Library, &info) ? fs::path(info.dli_fname).parent_path().parent_path()
                                   : fs::path();
}

/// Returns the libraries that are tried, in this order.
std::vector<std::string> ListLibraries()
{
  if (const char* given = std::getenv(Variable); given && *given)
  {
    return { given };
  }
  std::vector<std::string> libraries;
  std::error_code error;
  const fs::path folder = GetPackageFolder() / "rasterio.libs";
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
  {
    if (entry.path().filename().string().rfind("libgdal", 0) == 0)
    {
      libraries.push_back(entry.path().string());
    }
  }
  for (int number = NewestName; number >= OldestName; --number)
  {
    libraries.push_back("libgdal.so." + std::to_string(number));
  }
  return libraries;
}

/// Names the tables of units and coordinate systems that the package rasterio has in folders of its
/// own.
void SetRasterioData(const std::string& library)
{
  const fs::path package = fs::path(library).parent_path().parent_path() / "rasterio";
  const std::string tables = (package / "gdal_data").string();
  const std::string systems = (package / "proj_data").string();
  if (fs::exists(tables) && fs::exists(systems))
  {
    CPLSetConfigOption("GDAL_DATA", tables.c_str());
    const char* const folders[] = { systems.c_str(), nullptr };
    OSRSetPROJSearchPaths(folders);
  }
}

/// Loads the first library that can be; returns why none can, or an empty text.
std::string Load()
{
  std::string reason;
  for (const std::string& name : ListLibraries())
  {
    Library = ::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (Library && ::dlsym(Library, "GDALGetRasterNoDataValueAsInt64"))
    {
      SetRasterioData(name);
      return {};
    }
    if (reason.empty())
    {
      reason = Library ? name + " is older than GDAL 3.5" : ::dlerror();
    }
  }
  return reason + "; install GDAL (python -m pip install rasterio), or set the variable " +
    Variable + " to the path of a libgdal.so";
}

} // namespace

void* FindGdalFunction(const char* name)
{
  return ::dlsym(Library, name);
}

} // namespace helios

/// Returns why no GDAL can be loaded; null once one is.
extern "C" HELIOSGDAL_EXPORT const char* heliosLoadGdal()
{
  static const std::string reason = helios::Load();
  return reason.empty() ? nullptr : reason.c_str();
}
