// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRayCasterFactory.h"

#include "vtkHeliosBeamRayCaster.h"
#include "vtkHeliosBvhRayCaster.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{

struct Backend
{
  std::string Name;
  int Priority;
  vtkHeliosRayCasterFactory::Creator Create;
};

/// Returns the backends, in order of priority.
std::vector<Backend>& GetBackends()
{
  static std::vector<Backend> backends = {
    { "beam", 4, []() -> vtkHeliosRayCaster* { return vtkHeliosBeamRayCaster::New(); } },
    { "bvh", 2, []() -> vtkHeliosRayCaster* { return vtkHeliosBvhRayCaster::New(); } }
  };
  return backends;
}

} // namespace

bool vtkHeliosRayCasterFactory::Register(const char* name, int priority, Creator create)
{
  std::vector<Backend>& backends = GetBackends();
  const auto before = std::find_if(backends.begin(), backends.end(),
    [priority](const Backend& backend) { return backend.Priority < priority; });
  backends.insert(before, { name, priority, create });
  return true;
}

vtkHeliosRayCaster* vtkHeliosRayCasterFactory::Create(const char* name)
{
  const std::string wanted = name ? name : "";
  std::string names;
  for (const Backend& backend : GetBackends())
  {
    if (wanted.empty() || wanted == backend.Name)
    {
      return backend.Create();
    }
    names += (names.empty() ? "" : ", ") + backend.Name;
  }
  vtkErrorWithObjectMacro(
    nullptr, << "There is no ray caster \"" << wanted << "\" in this build; give one of " << names);
  return nullptr;
}

int vtkHeliosRayCasterFactory::GetNumberOfBackends()
{
  return static_cast<int>(GetBackends().size());
}

const char* vtkHeliosRayCasterFactory::GetBackendName(int index)
{
  const bool isThere = index >= 0 && index < vtkHeliosRayCasterFactory::GetNumberOfBackends();
  return isThere ? GetBackends()[static_cast<std::size_t>(index)].Name.c_str() : nullptr;
}
