// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Checksum of written bytes, to detect damage later. It does not protect against tampering: see
// heliosSha256.h. GMAC of OpenSSL's libcrypto with a zero key and nonce: 128 bits, about ten times
// as fast as SHA-256 or CRC-32 on processors with carry-less multiplication.

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

  /// Adds the bytes [begin, end) of a file; false if the file is shorter.
  bool AddFile(const std::string& path, std::uint64_t begin, std::uint64_t end);

  /// Returns the checksum as 32 hexadecimal digits; also resets.
  std::string Finish();

  /// Resets to the initial state.
  void Reset();

private:
  struct Context;
  std::unique_ptr<Context> State;
};

/// Returns the checksum of the bytes [begin, end) of a file; empty if the file is shorter.
VTKHELIOSFILTERSIO_EXPORT std::string ComputeChecksum(
  const std::string& path, std::uint64_t begin, std::uint64_t end);

/// Number of digits of Checksum::Finish().
constexpr std::size_t ChecksumDigits = 32;

} // namespace helios

#endif
