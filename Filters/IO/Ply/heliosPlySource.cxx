// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlySource.h"

#include "heliosLineFile.h"
#include "heliosTextFile.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

namespace helios
{

namespace
{

constexpr std::size_t BlockSize = 1 << 20;          // [bytes]
constexpr double LargestWhole = 9007199254740992.0; // 2^53: doubles hold whole numbers below
constexpr const char* CutOff = "the file ends here, so it is cut off; copy or write it again";

template <typename T>
double Convert(const unsigned char* bytes)
{
  T value{};
  std::memcpy(&value, bytes, sizeof(value));
  return static_cast<double>(value);
}

/// Returns a number in the byte order of this machine.
double ToDouble(const unsigned char* bytes, PlyType type)
{
  switch (type)
  {
    case PlyType::Int8:
      return Convert<std::int8_t>(bytes);
    case PlyType::UInt8:
      return Convert<std::uint8_t>(bytes);
    case PlyType::Int16:
      return Convert<std::int16_t>(bytes);
    case PlyType::UInt16:
      return Convert<std::uint16_t>(bytes);
    case PlyType::Int32:
      return Convert<std::int32_t>(bytes);
    case PlyType::UInt32:
      return Convert<std::uint32_t>(bytes);
    case PlyType::Float32:
      return Convert<float>(bytes);
    case PlyType::Float64:
      return Convert<double>(bytes);
  }
  return 0.0;
}

bool IsLittleEndian()
{
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

/// Numbers one after the other.
class BinarySource : public PlySource
{
public:
  BinarySource(const std::string& path, bool isLittle)
    : Path(path)
    , IsSwapped(isLittle != IsLittleEndian())
    , Block(BlockSize + 8) // the last number, too, is copied as eight bytes
  {
  }

  Status Open(std::int64_t begin)
  {
    std::int64_t size = 0;
    const Status status = OpenInput(this->Path, this->File, size);
    if (status.IsOk() && std::fseek(this->File.get(), static_cast<long>(begin), SEEK_SET) != 0)
    {
      return Status::Error(this->Path + ": cannot be read; check the disk");
    }
    return status;
  }

  bool StartRow() override { return true; }
  bool EndRow() override { return true; }

  bool Read(PlyType type, double& value) override
  {
    const std::size_t size = GetSize(type);
    if (this->End - this->Begin < size && !this->Fill(size))
    {
      return this->Fail(CutOff);
    }
    value = this->Decode(type);
    return true;
  }

  bool ReadAll(const std::vector<PlyType>& types, double* values) override
  {
    std::size_t size = 0;
    for (const PlyType type : types)
    {
      size += GetSize(type);
    }
    if (size > BlockSize)
    {
      return this->PlySource::ReadAll(types, values);
    }
    if (this->End - this->Begin < size && !this->Fill(size))
    {
      return this->Fail(CutOff);
    }
    std::transform(
      types.begin(), types.end(), values, [this](PlyType type) { return this->Decode(type); });
    return true;
  }

  std::string GetPlace(const std::string& element, std::int64_t row) const override
  {
    return this->Path + ": " + element + ' ' + std::to_string(row) + ": ";
  }

  std::int64_t CountRest() override
  {
    auto rest = static_cast<std::int64_t>(this->End - this->Begin);
    for (std::size_t size = BlockSize; size == BlockSize; rest += static_cast<std::int64_t>(size))
    {
      size = std::fread(this->Block.data(), 1, BlockSize, this->File.get());
    }
    return rest;
  }

private:
  /// Returns the next number, whose bytes are there.
  double Decode(PlyType type)
  {
    const std::size_t size = GetSize(type);
    unsigned char bytes[8];
    std::memcpy(bytes, this->Block.data() + this->Begin, 8);
    if (this->IsSwapped)
    {
      std::reverse(bytes, bytes + size);
    }
    this->Begin += size;
    return ToDouble(bytes, type);
  }

  /// Reads on until a number of bytes is there.
  bool Fill(std::size_t wanted)
  {
    std::copy(this->Block.begin() + static_cast<std::ptrdiff_t>(this->Begin),
      this->Block.begin() + static_cast<std::ptrdiff_t>(this->End), this->Block.begin());
    this->End -= this->Begin;
    this->Begin = 0;
    this->End +=
      std::fread(this->Block.data() + this->End, 1, BlockSize - this->End, this->File.get());
    return this->End >= wanted;
  }

  std::string Path;
  bool IsSwapped;
  InputFile File;
  std::vector<unsigned char> Block;
  std::size_t Begin = 0; // first byte not yet used
  std::size_t End = 0;
};

/// One line per row.
class TextSource : public PlySource
{
public:
  Status Open(const std::string& path, std::int64_t firstLine)
  {
    const Status status = this->File.Open(path);
    std::string_view line;
    while (status.IsOk() && this->File.GetLine() + 1 < firstLine && this->File.NextLine(line))
    {
    }
    return status;
  }

  bool StartRow() override
  {
    std::string_view line;
    while (this->File.NextLine(line))
    {
      this->Words = TextWords(line);
      if (this->Words.HasMore())
      {
        return true;
      }
    }
    return this->Fail(this->File.GetError().empty() ? CutOff : this->File.GetError());
  }

  bool Read(PlyType type, double& value) override
  {
    TextWords ahead = this->Words;
    const TextWords::Number status = this->Words.Next(value);
    if (status == TextWords::Number::None)
    {
      return this->Fail("too few numbers for the properties of the header; add them");
    }
    const bool isWhole =
      type >= PlyType::Float32 || (std::abs(value) < LargestWhole && std::floor(value) == value);
    return (status == TextWords::Number::Good && isWhole) ||
      this->Fail(Quote(ahead.Next()) + " is not a " +
        (status == TextWords::Number::Good ? "whole number" : "number") + "; correct it");
  }

  bool EndRow() override
  {
    return !this->Words.HasMore() ||
      this->Fail(Quote(this->Words.Next()) +
        " is one number more than the header has properties; "
        "remove it, or add a property");
  }

  std::string GetPlace(const std::string&, std::int64_t) const override
  {
    return this->File.GetPlace();
  }

  std::int64_t CountRest() override
  {
    std::int64_t rest = 0;
    std::string_view line;
    while (this->File.NextLine(line))
    {
      rest += TextWords(line).HasMore();
    }
    return rest;
  }

private:
  TextFile File;
  TextWords Words{ {} };
};

} // namespace

//------------------------------------------------------------------------------
std::unique_ptr<PlySource> OpenPlySource(
  const std::string& path, const PlyHeader& header, std::string& error)
{
  if (header.Storage == PlyStorage::Text)
  {
    auto text = std::make_unique<TextSource>();
    error = text->Open(path, header.DataLine).Message();
    return text;
  }
  auto binary = std::make_unique<BinarySource>(path, header.Storage == PlyStorage::LittleEndian);
  error = binary->Open(header.DataBegin).Message();
  return binary;
}

} // namespace helios
