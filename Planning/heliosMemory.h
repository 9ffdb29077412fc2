// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rejects requests beyond a memory limit before they are tried.

#ifndef heliosMemory_h
#define heliosMemory_h

#include <iomanip>
#include <sstream>
#include <string>

namespace helios
{

/**
 * "3.2e+07 places need 2300 MiB, more than the memory limit (2048 MiB)" if n items of a size in bytes
 * exceed a limit in MiB; else an empty string.
 */
inline std::string DescribeExcess(
  const char* things, double count, double bytesEach, double limitMiB)
{
  const double size = count * bytesEach / 1048576.0;
  std::ostringstream text;
  if (size > limitMiB)
  {
    text << std::setprecision(4) << count << " " << things << " need " << size
         << " MiB, more than the memory limit (" << limitMiB << " MiB)";
  }
  return text.str();
}

} // namespace helios

#endif
