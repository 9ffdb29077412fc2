// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosChecksum.h"

#include "heliosHexadecimal.h"

#include <openssl/core_names.h>
#include <openssl/evp.h>
#include <openssl/params.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace helios
{

namespace
{

constexpr std::uint64_t BufferSize = std::uint64_t(1) << 20;

void Check(bool result)
{
  if (!result)
  {
    throw std::runtime_error("libcrypto has no GMAC with AES-128");
  }
}

} // namespace

struct Checksum::Context
{
  Context()
    : Algorithm(EVP_MAC_fetch(nullptr, "GMAC", nullptr))
    , Mac(EVP_MAC_CTX_new(this->Algorithm))
  {
    Check(this->Mac != nullptr);
  }
  ~Context()
  {
    EVP_MAC_CTX_free(this->Mac);
    EVP_MAC_free(this->Algorithm);
  }
  Context(const Context&) = delete;
  void operator=(const Context&) = delete;

  EVP_MAC* Algorithm;
  EVP_MAC_CTX* Mac;
};

Checksum::Checksum()
  : State(std::make_unique<Context>())
{
  this->Reset();
}

Checksum::~Checksum() = default;

void Checksum::Reset()
{
  char cipher[] = "AES-128-GCM";
  unsigned char nonce[12] = {};
  const unsigned char key[16] = {};
  const OSSL_PARAM parameters[] = { OSSL_PARAM_construct_utf8_string(
                                      OSSL_MAC_PARAM_CIPHER, cipher, 0),
    OSSL_PARAM_construct_octet_string(OSSL_MAC_PARAM_IV, nonce, sizeof(nonce)),
    OSSL_PARAM_construct_end() };
  Check(EVP_MAC_init(this->State->Mac, key, sizeof(key), parameters) == 1);
}

void Checksum::Add(const void* bytes, std::size_t count)
{
  const auto* next = static_cast<const unsigned char*>(bytes);
  Check(count == 0 || EVP_MAC_update(this->State->Mac, next, count) == 1);
}

bool Checksum::AddFile(const std::string& path, std::uint64_t begin, std::uint64_t end)
{
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(begin));
  std::vector<char> buffer(std::min(BufferSize, end - begin));
  for (std::uint64_t at = begin; at < end && file;)
  {
    const std::uint64_t count = std::min(BufferSize, end - at);
    file.read(buffer.data(), static_cast<std::streamsize>(count));
    this->Add(buffer.data(), static_cast<std::size_t>(file.gcount()));
    at += count;
  }
  return static_cast<bool>(file);
}

std::string Checksum::Finish()
{
  unsigned char bytes[ChecksumDigits / 2];
  std::size_t count = 0;
  Check(EVP_MAC_final(this->State->Mac, bytes, &count, sizeof(bytes)) == 1);
  this->Reset();
  return ToHexadecimal(bytes, count);
}

std::string ComputeChecksum(const std::string& path, std::uint64_t begin, std::uint64_t end)
{
  Checksum sum;
  return sum.AddFile(path, begin, end) ? sum.Finish() : std::string();
}

} // namespace helios
