// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks whether a path is a readable file.

#ifndef heliosInputFile_h
#define heliosInputFile_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <string>

namespace helios
{

/**
 * Returns an error if a path cannot be read as a file ("cannot be read: it is a FIFO ..."): folders,
 * FIFOs, sockets, devices and files of /proc and /sys, which may have no end or no size. Regular
 * files are accepted, and missing ones, which the caller reports on opening.
 */
VTKHELIOSFILTERSCORE_EXPORT Status CheckInputFile(const std::string& path);

} // namespace helios

#endif
