// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Digests of input files, computed once for each state of a file.

#ifndef heliosInputDigest_h
#define heliosInputDigest_h

#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <cstdint>
#include <string>

namespace helios
{

struct InputDigest
{
  std::string Sha256; ///< 64 hexadecimal digits; empty: it cannot be read
  std::int64_t Size = 0;
  std::string Stamp; ///< StampFile() before it was read
};

/// Returns the digest of a file. That of a file that has not changed since is remembered in this
/// process.
VTKHELIOSFILTERSIO_EXPORT InputDigest ComputeInputDigest(const std::string& path);

} // namespace helios

#endif
