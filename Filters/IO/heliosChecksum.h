// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A checksum of bytes that were written, to find out later whether they are damaged. It does not protect
// against intent: see heliosSha256.h. GMAC of OpenSSL's libcrypto with a key and nonce of zeros: 128 bits,
// and with the carry-less multiplication of today's processors about ten times as fast as SHA-256 or CRC-32.

#ifndef heliosChecksum_h
#define heliosChecksum_h

#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace helios
{

class VTKHELIOSFILTERSIO_EXPORT Checksum
{
public:
  Checksum();
  ~Checksum();
  Checksum(const Checksum&) = delete;
  void operator=(const Checksum&) = delete;

  void Add(const void* bytes, std::size_t count);
  void Add(const std::string& text) { this->Add(text.data(), text.size()); }

  /// Adds the bytes of a file from begin to before end; false where it does not have them.
  bool AddFile(const std::string& path, std::uint64_t begin, std::uint64_t end);

  /// The checksum as 32 hexadecimal digits; starts anew.
  std::string Finish();

  /// Starts anew.
  void Reset();

private:
  struct Context;
  std::unique_ptr<Context> State;
};

/// The checksum of the bytes of a file from begin to before end; empty where it does not have them.
VTKHELIOSFILTERSIO_EXPORT std::string ComputeChecksum(
  const std::string& path, std::uint64_t begin, std::uint64_t end);

/// The digits of Checksum::Finish().
constexpr std::size_t ChecksumDigits = 32;

} // namespace helios

#endif
