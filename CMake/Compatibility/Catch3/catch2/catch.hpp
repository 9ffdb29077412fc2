// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The header of Catch2 2 for Catch2 3, which divided it and moved or renamed what tests here use.

#ifndef heliosCatch3_h
#define heliosCatch3_h

#include <catch2/catch_all.hpp>

#include <string>

using Catch::Approx;

namespace Catch
{

using Matchers::EndsWith;

/// Matches texts that contain another. Catch2 3 uses this name for the elements of containers.
inline auto Contains(const std::string& part)
{
  return Matchers::ContainsSubstring(part);
}

} // namespace Catch

#endif
