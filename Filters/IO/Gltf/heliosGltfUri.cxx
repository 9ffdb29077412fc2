// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGltfUri.h"

#include "heliosFileBytes.h"
#include "heliosTextFile.h"

#include <openssl/evp.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string_view>

namespace helios
{

namespace
{

constexpr std::size_t ShownBytes = 40; // bytes of a URI shown in messages

bool HasScheme(const std::string& uri)
{
  const std::size_t colon = uri.find(':');
  return colon != std::string::npos && uri.find_first_of("/?#") > colon;
}

/// Decodes percent signs: "%20" becomes a blank.
std::string DecodePercent(const std::string& text)
{
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    unsigned value = 0;
    const char* digits = text.data() + i + 1;
    const bool isCode = text[i] == '%' && i + 2 < text.size() &&
      std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2;
    decoded += isCode ? static_cast<char>(value) : text[i];
    i += isCode ? 2 : 0;
  }
  return decoded;
}

Status DecodeBase64(std::string_view text, std::string& bytes)
{
  const std::size_t padding = text.size() - std::min(text.find_last_not_of('=') + 1, text.size());
  if (text.size() % 4 != 0 || padding > 2 ||
    text.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
  {
    return Status::Error("has " + std::to_string(text.size()) +
      " characters of base64, not a multiple of 4 below 2^31; write the file again");
  }
  bytes.resize(text.size() / 4 * 3);
  const int size = EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
    reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
  bytes.resize(size < 0
      ? 0
      : static_cast<std::size_t>(size) - std::min(padding, static_cast<std::size_t>(size)));
  return size < 0 ? Status::Error("has characters that are not base64; write the file again")
                  : Status();
}

} // namespace

//------------------------------------------------------------------------------
Status ReadUri(const std::string& uri, const std::string& document, std::string& bytes)
{
  if (uri.rfind("data:", 0) == 0)
  {
    const std::size_t comma = uri.find(',');
    const std::string_view head = std::string_view(uri).substr(0, comma);
    const std::string_view mark = ";base64";
    return comma != std::string::npos && head.size() >= mark.size() &&
        head.substr(head.size() - mark.size()) == mark
      ? DecodeBase64(std::string_view(uri).substr(comma + 1), bytes)
      : Status::Error(
          Quote(uri.substr(0, ShownBytes)) + " is not data in base64; write the file again");
  }
  if (uri.empty() || HasScheme(uri))
  {
    return Status::Error(Quote(uri.substr(0, ShownBytes)) +
      " is not the name of a file beside the document; give one, or embed the buffer");
  }
  const std::filesystem::path folder = std::filesystem::path(document).parent_path();
  return ReadBytes((folder / DecodePercent(uri)).string(), 1.0, bytes);
}

} // namespace helios
