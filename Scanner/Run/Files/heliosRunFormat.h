// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Properties that files of a format can store.

#ifndef heliosRunFormat_h
#define heliosRunFormat_h

#include "heliosStatus.h"

#include <string>

namespace helios
{

struct RunSettings;

/// Sets the format and what it always writes. The error names what is wanted but cannot be stored.
Status SetFormat(const std::string& format, RunSettings& settings);

} // namespace helios

#endif
