// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What may be read as a file.

#ifndef heliosInputFile_h
#define heliosInputFile_h

#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <string>

namespace helios
{

/**
 * Why a path cannot be read as a file, in words ("cannot be read: it is a FIFO ..."): folders, FIFOs,
 * sockets, devices and files of /proc and /sys, which may have no end or no size. Empty for regular
 * files and where there is nothing: that the one who opens it says.
 */
VTKHELIOSFILTERSCORE_EXPORT std::string CheckInputFile(const std::string& path);

} // namespace helios

#endif
