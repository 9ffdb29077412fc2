// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rejects requests beyond a memory limit before they are tried.

#ifndef heliosMemory_h
#define heliosMemory_h

#include "heliosStatus.h"

#include <iomanip>
#include <sstream>
#include <string>

namespace helios
{

/**
 * Returns an error if items of a size in bytes exceed a limit in MiB: "3.2e+07 places need 2300 MiB,
 * more than the memory limit (2048 MiB)".
 */
inline Status CheckMemoryLimit(const char* things, double count, double bytesEach, double limitMiB)
{
  const double size = count * bytesEach / 1048576.0;
  if (size <= limitMiB)
  {
    return {};
  }
  std::ostringstream text;
  text << std::setprecision(4) << count << " " << things << " need " << size
       << " MiB, more than the memory limit (" << limitMiB << " MiB)";
  return Status::Error(text.str());
}

} // namespace helios

#endif
