// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What would be too much is refused before it is tried.

#ifndef heliosMemory_h
#define heliosMemory_h

#include <iomanip>
#include <sstream>
#include <string>

namespace helios
{

/**
 * "3.2e+07 places take 2300 MiB, more than MemoryLimit (2048 MiB)" where so many things of a size in
 * bytes go beyond a limit in MiB; an empty text where they do not.
 */
inline std::string DescribeExcess(
  const char* things, double count, double bytesEach, double limitMiB)
{
  const double size = count * bytesEach / 1048576.0;
  std::ostringstream text;
  if (size > limitMiB)
  {
    text << std::setprecision(4) << count << " " << things << " take " << size
         << " MiB, more than MemoryLimit (" << limitMiB << " MiB)";
  }
  return text.str();
}

} // namespace helios

#endif
