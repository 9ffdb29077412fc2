// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosDetectorPlugin.h"

#include "heliosDetectorRegistry.h"
#include "vtkHeliosVersion.h"

#include <dlfcn.h>

#include <filesystem>
#include <iterator>

namespace fs = std::filesystem;

namespace helios
{

namespace
{

constexpr const char* Register = "vtkhelios_register_plugin";

std::string ListDetectors()
{
  std::string names;
  for (const DetectorKind& kind : GetDetectorKinds())
  {
    names += (names.empty() ? "" : ", ") + kind.Name;
  }
  return names;
}

/// Calls the function of a library that registers detectors.
Status RegisterDetectors(const std::string& file)
{
  void* library = ::dlopen(fs::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL); // for good
  if (!library)
  {
    return Status::Error(file + ": cannot be loaded: " + ::dlerror() + "; build it for vtkHelios " +
      vtkHeliosVersion::GetVersion() + ", the version of this program");
  }
  const auto add = reinterpret_cast<bool (*)()>(::dlsym(library, Register));
  if (!add)
  {
    return Status::Error(file + ": is no plug-in; give it extern \"C\" bool " + Register + "()");
  }
  if (!add())
  {
    return Status::Error(file + ": " + Register +
      "() failed: the name of a detector is taken, or not valid; known are " + ListDetectors());
  }
  return {};
}

} // namespace

//------------------------------------------------------------------------------
Status LoadDetectorPlugin(const std::string& file)
{
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored))
  {
    return Status::Error(file + ": no such file; give a plug-in");
  }
  if (fs::path(file).extension() != ".so")
  {
    return Status::Error(file +
      ": is no library (.so), the plug-ins of this program; vtkhelios run loads those in Python");
  }
  std::list<DetectorKind>& kinds = GetDetectorKinds();
  const std::size_t before = kinds.size();
  Status status = RegisterDetectors(file);
  if (status.IsOk() && kinds.size() == before)
  {
    status = Status::Error(file + ": registers no echo detector of vtkHelios " +
      vtkHeliosVersion::GetVersion() + "; call AddDetector() in it");
  }
  const auto first = std::next(kinds.begin(), static_cast<std::ptrdiff_t>(before));
  for (auto kind = first; kind != kinds.end(); ++kind)
  {
    kind->File = file;
  }
  status.IsOk() ? kinds.end() : kinds.erase(first, kinds.end());
  return status;
}

} // namespace helios
