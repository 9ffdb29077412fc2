// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Makes a coordinate system of a text. Internal to this folder.

#ifndef heliosCoordinateSystemMaking_h
#define heliosCoordinateSystemMaking_h

#include "heliosCoordinateSystemData.h"
#include "heliosStatus.h"

#include <string>

namespace helios
{

/// The datum of a vertical part that only states a unit.
constexpr const char* UnknownSurface = "unknown";

/// Parses a text; an error says what is wrong and which forms there are.
Status MakeSystem(const std::string& text, CoordinateSystemData& data);

} // namespace helios

#endif
