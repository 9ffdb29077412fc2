// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Plug-ins that are shared libraries.

#ifndef heliosDetectorPlugin_h
#define heliosDetectorPlugin_h

#include "heliosStatus.h"

#include <string>

namespace helios
{

/// Loads a shared library that registers echo detectors. After an error none of its detectors is
/// known.
Status LoadDetectorPlugin(const std::string& file);

} // namespace helios

#endif
