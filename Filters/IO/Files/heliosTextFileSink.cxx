// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTextFileSink.h"

#include "heliosPartFile.h"
#include "heliosStatus.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <stdio.h> // For fdopen()

namespace helios
{

namespace
{
constexpr std::size_t BufferSize = std::size_t(1) << 20;
}

TextFileSink::~TextFileSink()
{
  if (this->File)
  {
    std::fclose(this->File);
    std::remove((this->Path + PartEnding).c_str());
  }
}

std::string TextFileSink::Explain(int error) const
{
  return this->Path + ": cannot be written: " + std::strerror(error) +
    "; choose another folder, or make this one writable with space left";
}

Status TextFileSink::Open(const std::string& path)
{
  this->Path = path;
  const int descriptor = CreatePart(path);
  this->File = descriptor < 0 ? nullptr : ::fdopen(descriptor, "wb");
  if (!this->File)
  {
    return Status::Error(this->Explain(errno));
  }
  std::setvbuf(this->File, nullptr, _IONBF, 0);
  this->Buffer.resize(BufferSize);
  return {};
}

void TextFileSink::Append(std::string_view text)
{
  while (!text.empty())
  {
    char* at = this->Reserve(std::min(text.size(), this->Buffer.size()));
    const std::size_t count = std::min(text.size(), this->Buffer.size() - this->Used);
    std::memcpy(at, text.data(), count);
    this->Used += count;
    text.remove_prefix(count);
  }
}

void TextFileSink::Flush()
{
  if (!this->Error && std::fwrite(this->Buffer.data(), 1, this->Used, this->File) != this->Used)
  {
    this->Error = errno;
  }
  this->Used = 0;
}

Status TextFileSink::Close()
{
  this->Flush();
  if (std::fclose(this->File) != 0 && !this->Error)
  {
    this->Error = errno;
  }
  this->File = nullptr;
  const std::string part = this->Path + PartEnding;
  if (!this->Error && std::rename(part.c_str(), this->Path.c_str()) != 0)
  {
    this->Error = errno;
  }
  if (this->Error)
  {
    std::remove(part.c_str());
    return Status::Error(this->Explain(this->Error));
  }
  return {};
}

} // namespace helios
