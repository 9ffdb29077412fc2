// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Names and descriptions of the Extra Bytes that store arrays.

#ifndef heliosLasNames_h
#define heliosLasNames_h

#include <string>

namespace helios
{

struct LasName
{
  std::string Name;
  std::string Description;
};

/**
 * Returns the Extra Bytes of an array: names of RIEGL's programs for points with decibels, whose
 * Amplitude is in dB ("LAS extrabytes implementation in RIEGL software"); else the array's own
 * name.
 */
LasName GetLasName(const std::string& array, bool hasDecibels);

/// Returns the array of Extra Bytes: the reverse of GetLasName(), also for files of RIEGL's
/// programs.
std::string GetLasArray(const std::string& name, const std::string& description);

} // namespace helios

#endif
