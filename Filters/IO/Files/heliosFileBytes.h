// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// All bytes of a file.

#ifndef heliosFileBytes_h
#define heliosFileBytes_h

#include "heliosStatus.h"

#include <string>

namespace helios
{

/// Reads a file as a whole, if there is memory of bytesPerByte for each of its bytes.
Status ReadBytes(const std::string& path, double bytesPerByte, std::string& bytes);

} // namespace helios

#endif
