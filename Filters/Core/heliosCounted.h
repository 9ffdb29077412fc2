// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause

// Counts with their nouns, for messages.

#ifndef heliosCounted_h
#define heliosCounted_h

#include <cstdint>
#include <string>

namespace helios
{

/// A count with its noun, whose plural ends in s: 1 point, 2 points.
inline std::string Counted(std::int64_t count, const std::string& noun)
{
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

} // namespace helios

#endif
