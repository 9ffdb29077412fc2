// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSha256.h"

#include "heliosHexadecimal.h"
#include "heliosInputFile.h"

#include <openssl/evp.h>

#include <fstream>
#include <stdexcept>
#include <vector>

namespace helios
{

namespace
{

constexpr std::size_t BufferSize = std::size_t(1) << 20;

void Check(int result)
{
  if (result != 1)
  {
    throw std::runtime_error("libcrypto has no SHA-256");
  }
}

} // namespace

struct Sha256::Context
{
  Context()
    : Digest(EVP_MD_CTX_new())
  {
    Check(EVP_DigestInit_ex(this->Digest, EVP_sha256(), nullptr));
  }
  ~Context() { EVP_MD_CTX_free(this->Digest); }
  Context(const Context&) = delete;
  void operator=(const Context&) = delete;

  EVP_MD_CTX* Digest;
};

Sha256::Sha256()
  : State(std::make_unique<Context>())
{
}

Sha256::~Sha256() = default;

void Sha256::Add(const void* bytes, std::size_t count)
{
  Check(EVP_DigestUpdate(this->State->Digest, bytes, count));
}

std::string Sha256::Finish()
{
  unsigned char bytes[EVP_MAX_MD_SIZE];
  unsigned int count = 0;
  Check(EVP_DigestFinal_ex(this->State->Digest, bytes, &count));
  return ToHexadecimal(bytes, count);
}

std::string HashFile(const std::string& path)
{
  std::ifstream file;
  if (CheckInputFile(path).IsOk())
  {
    file.open(path, std::ios::binary);
  }
  if (!file.is_open())
  {
    return {};
  }
  Sha256 hash;
  std::vector<char> buffer(BufferSize);
  while (file.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || file.gcount() > 0)
  {
    hash.Add(buffer.data(), static_cast<std::size_t>(file.gcount()));
  }
  return file.bad() ? std::string() : hash.Finish();
}

} // namespace helios
