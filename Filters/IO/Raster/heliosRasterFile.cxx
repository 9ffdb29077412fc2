// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRasterFile.h"

#include "heliosStatus.h"

#include <dlfcn.h>

namespace helios
{

Status MakeRasterFile(std::unique_ptr<RasterFile>& file)
{
  return MakeRasterFile(HELIOS_GDAL_LIBRARY, file);
}

Status MakeRasterFile(const std::string& library, std::unique_ptr<RasterFile>& file)
{
  using Load = const char* (*)();
  using Make = RasterFile* (*)();
  void* loaded = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL); // again: the same
  const auto make =
    loaded ? reinterpret_cast<Make>(::dlsym(loaded, "heliosMakeRasterFile")) : nullptr;
  if (!make)
  {
    return Status::Error(std::string("rasters cannot be read: ") + ::dlerror() +
      "; install GDAL (Debian: apt-get install gdal-bin), and vtkHelios with all its libraries");
  }
  // Only in builds that are not linked to GDAL.
  const auto load = reinterpret_cast<Load>(::dlsym(loaded, "heliosLoadGdal"));
  if (const char* reason = load ? load() : nullptr)
  {
    return Status::Error(std::string("rasters cannot be read: ") + reason);
  }
  file.reset(make());
  return {};
}

} // namespace helios
