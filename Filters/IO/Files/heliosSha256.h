// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// SHA-256, to verify that bytes are unchanged. Computed by OpenSSL's libcrypto, which is already a
// dependency of GDAL.

#ifndef heliosSha256_h
#define heliosSha256_h

#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <cstddef>
#include <memory>
#include <string>

namespace helios
{

class VTKHELIOSFILTERSIO_EXPORT Sha256
{
public:
  Sha256();
  ~Sha256();
  Sha256(const Sha256&) = delete;
  void operator=(const Sha256&) = delete;

  void Add(const void* bytes, std::size_t count);
  void Add(const std::string& text) { this->Add(text.data(), text.size()); }

  /// Returns the digest as 64 hexadecimal digits; nothing may be added after it.
  std::string Finish();

private:
  struct Context;
  std::unique_ptr<Context> State;
};

/// Returns the digest of a file; empty if it cannot be read.
VTKHELIOSFILTERSIO_EXPORT std::string HashFile(const std::string& path);

} // namespace helios

#endif
