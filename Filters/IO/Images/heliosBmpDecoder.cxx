// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// BMP of OS/2 and Windows: 1 to 32 bits, palettes, bit fields, run lengths, from the bottom or the
// top. No library that vtkHelios has reads all of them with a check of every colour.

#include "heliosImageDecoder.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace helios
{

namespace
{

constexpr std::size_t FileHeaderSize = 14;
constexpr std::size_t PixelsAtAt = 10;     // in it, where the pixels are
constexpr std::size_t CoreHeaderSize = 12; // header of OS/2
constexpr std::size_t OldHeaderSize = 64;  // header of OS/2 2.x, whose compressions above 2 differ
constexpr std::size_t InfoHeaderSize = 40; // header of Windows
constexpr std::size_t LongestHeader = 124;
constexpr std::size_t MasksAt = 40; // in a header, or behind it
constexpr std::size_t MaskBytes = 12;
constexpr std::size_t AlphaMaskAt = 52;      // place of the alpha mask, if a header has one
constexpr int ColorsUsed = 32;               // its place in a header
constexpr double MaximumRowsPerByte = 64.0;  // runs can leave out pixels: 255 rows by a move,
constexpr double MaximumPixelsPerByte = 1e4; // or the rest of a row

enum Compression : unsigned
{
  Plain = 0,
  RunsOfBytes = 1,
  RunsOfNibbles = 2,
  BitFields = 3,
  BitFieldsWithAlpha = 6
};

/// Bits of a pixel that are a colour.
class Mask
{
public:
  Mask() = default;
  explicit Mask(unsigned bits)
    : Bits(bits)
  {
    while (this->Bits != 0 && (this->Bits >> this->Shift & 1U) == 0)
    {
      ++this->Shift;
    }
    this->Largest = this->Bits >> this->Shift;
  }

  unsigned GetBits() const { return this->Bits; }

  /// Returns whether the bits are next to each other.
  bool IsValid() const { return this->Bits != 0 && (this->Largest & (this->Largest + 1U)) == 0; }

  unsigned char GetColor(unsigned pixel) const
  {
    const std::uint64_t value = (pixel & this->Bits) >> this->Shift;
    const std::uint64_t maximum = this->Largest;
    return static_cast<unsigned char>(
      maximum == 255 ? value : (255 * value + maximum / 2) / maximum);
  }

private:
  unsigned Bits = 0;
  unsigned Shift = 0;
  unsigned Largest = 0; // value
};

class BmpDecoder final : public ImageDecoder
{
public:
  explicit BmpDecoder(const ImageFile& file)
    : File(file)
  {
  }

  const char* GetFormat() const override { return "BMP"; }
  Status ReadHeader(StoredImage& stored) override;
  Status ReadPixels(const ImageRows& rows) override;

private:
  unsigned Get(std::size_t at, std::size_t size) const;
  bool ReadHeaderBytes();
  Status ReadFields();
  Status CheckBits() const;
  bool ReadMasks();
  bool ReadPalette();
  bool HasRuns() const { return this->Packing == RunsOfBytes || this->Packing == RunsOfNibbles; }
  bool HasMasks() const
  {
    return this->Packing == BitFields || this->Packing == BitFieldsWithAlpha;
  }
  std::int64_t GetRowSize() const { return (this->Columns * this->Bits + 7) / 8; }
  std::int64_t GetRowStep() const { return (this->GetRowSize() + 3) / 4 * 4; }
  unsigned char* GetRow(const ImageRows& rows, std::int64_t row) const;
  bool ReadPlainRow(unsigned char* pixels);
  bool SetColor(unsigned index, unsigned char* pixel);
  bool ReadRuns(const ImageRows& rows);
  bool ReadEscape(int code, const ImageRows& rows);
  bool ReadSeparate(int count, const ImageRows& rows);
  bool SetNext(unsigned index, const ImageRows& rows);
  bool Fail(const std::string& fault);
  bool FailAtEnd() { return this->Fail("it ends too early"); }

  ImageFile File;
  std::array<unsigned char, LongestHeader> Header{};
  std::size_t HeaderSize = 0;
  std::int64_t Columns = 0;
  std::int64_t Rows = 0;
  std::int64_t PixelsAt = 0; // in the file
  bool IsFromTop = false;
  int Bits = 0; // bits of a pixel
  unsigned Packing = Plain;
  std::array<Mask, 3> Masks;
  std::vector<std::array<unsigned char, 3>> Palette;
  std::vector<unsigned char> Bytes; // bytes of a row
  std::int64_t Column = 0;          // column of the next pixel of a run
  std::int64_t Row = 0;
  bool IsAtEnd = false; // the runs have ended
  std::string Fault;
};

// Returns a number of the header, which is little-endian.
unsigned BmpDecoder::Get(std::size_t at, std::size_t size) const
{
  unsigned value = 0;
  for (std::size_t i = size; i > 0; --i)
  {
    value = value << 8U | this->Header[at + i - 1];
  }
  return value;
}

bool BmpDecoder::Fail(const std::string& fault)
{
  this->Fault = "is damaged: " + fault;
  return false;
}

bool BmpDecoder::ReadHeaderBytes()
{
  std::array<unsigned char, FileHeaderSize + 4> start{};
  if (std::fread(start.data(), 1, start.size(), this->File.File) != start.size())
  {
    return this->FailAtEnd();
  }
  std::memcpy(this->Header.data(), start.data() + PixelsAtAt, 4);
  this->PixelsAt = this->Get(0, 4);
  std::memcpy(this->Header.data(), start.data() + FileHeaderSize, 4);
  const std::size_t size = this->Get(0, 4);
  if (size < CoreHeaderSize || size > LongestHeader)
  {
    return this->Fail("its header has " + std::to_string(size) + " bytes");
  }
  this->HeaderSize = size;
  return std::fread(this->Header.data() + 4, 1, size - 4, this->File.File) == size - 4 ||
    this->FailAtEnd();
}

Status BmpDecoder::ReadFields()
{
  const bool isCore = this->HeaderSize == CoreHeaderSize;
  if (!isCore && this->HeaderSize < 16)
  {
    return Status::Error(
      "is damaged: its header has " + std::to_string(this->HeaderSize) + " bytes");
  }
  const auto getSide = [this, isCore](std::size_t coreAt, std::size_t at)
  {
    return isCore ? std::int64_t(this->Get(coreAt, 2))
                  : std::int64_t(static_cast<std::int32_t>(this->Get(at, 4)));
  };
  this->Columns = getSide(4, 4);
  const std::int64_t rows = getSide(6, 8);
  this->IsFromTop = rows < 0;
  this->Rows = rows < 0 ? -rows : rows;
  this->Bits = static_cast<int>(isCore ? this->Get(10, 2) : this->Get(14, 2));
  this->Packing = isCore ? Plain : this->Get(16, 4);
  return this->CheckBits();
}

Status BmpDecoder::CheckBits() const
{
  const int bits = this->Bits;
  const bool isOld = this->HeaderSize < InfoHeaderSize || this->HeaderSize == OldHeaderSize;
  const bool isKnown = this->Packing == Plain
    ? bits == 1 || bits == 2 || bits == 4 || bits == 8 || bits == 16 || bits == 24 || bits == 32
    : (this->Packing == RunsOfBytes && bits == 8) ||
      (this->Packing == RunsOfNibbles && bits == 4) ||
      (this->HasMasks() && !isOld && (bits == 16 || bits == 32));
  if (!isKnown)
  {
    return Status::Error("has pixels of " + std::to_string(bits) + " bits with compression " +
      std::to_string(this->Packing) + ", which are not read; save it with 24 bits");
  }
  return this->HasRuns() && this->IsFromTop
    ? Status::Error("is damaged: it has run lengths from the top")
    : Status();
}

// Reads the masks of red, green and blue, in the header or behind it.
bool BmpDecoder::ReadMasks()
{
  this->Masks = this->Bits == 16
    ? std::array<Mask, 3>{ Mask(0x7c00U), Mask(0x3e0U), Mask(0x1fU) }
    : std::array<Mask, 3>{ Mask(0xff0000U), Mask(0xff00U), Mask(0xffU) };
  if (!this->HasMasks())
  {
    return true;
  }
  const bool isBehind = this->HeaderSize < MasksAt + MaskBytes;
  if (isBehind &&
    std::fread(this->Header.data() + MasksAt, 1, MaskBytes, this->File.File) != MaskBytes)
  {
    return this->FailAtEnd();
  }
  for (std::size_t c = 0; c < this->Masks.size(); ++c)
  {
    this->Masks[c] = Mask(this->Get(MasksAt + 4 * c, 4));
    if (!this->Masks[c].IsValid())
    {
      return this->Fail("the bits of a colour are " + std::to_string(this->Masks[c].GetBits()));
    }
  }
  return true;
}

// Reads the palette up to the pixels: a missing colour is an error once it is used.
bool BmpDecoder::ReadPalette()
{
  if (this->Bits > 8)
  {
    return true;
  }
  const bool isCore = this->HeaderSize == CoreHeaderSize;
  const std::size_t entry = isCore ? 3 : 4;
  const std::size_t maximum = std::size_t(1) << static_cast<unsigned>(this->Bits);
  const std::size_t used = isCore ? 0 : this->Get(ColorsUsed, 4);
  const auto start = static_cast<std::int64_t>(FileHeaderSize + this->HeaderSize);
  const auto room = static_cast<std::size_t>(this->PixelsAt - start) / entry;
  this->Palette.resize(std::min({ used > 0 ? used : maximum, maximum, room }));
  for (auto& color : this->Palette)
  {
    std::array<unsigned char, 4> bytes{}; // blue green red
    if (std::fread(bytes.data(), 1, entry, this->File.File) != entry)
    {
      return this->FailAtEnd();
    }
    color = { bytes[2], bytes[1], bytes[0] };
  }
  return true;
}

Status BmpDecoder::ReadHeader(StoredImage& stored)
{
  if (!this->ReadHeaderBytes())
  {
    return Status::Error(this->Fault);
  }
  const Status status = this->ReadFields();
  if (!status.IsOk())
  {
    return status;
  }
  if (this->PixelsAt < static_cast<std::int64_t>(FileHeaderSize + this->HeaderSize))
  {
    return Status::Error("is damaged: its pixels begin at byte " + std::to_string(this->PixelsAt));
  }
  if (!this->ReadMasks() || !this->ReadPalette())
  {
    return Status::Error(this->Fault);
  }
  stored.HasAlpha =
    this->HasMasks() && this->HeaderSize >= AlphaMaskAt + 4 && this->Get(AlphaMaskAt, 4) != 0;
  stored.Columns = this->Columns;
  stored.Rows = this->Rows;
  const std::int64_t rowBytes = this->GetRowSize();
  const double pixels = static_cast<double>(this->GetRowStep()) *
      static_cast<double>(std::max<std::int64_t>(0, this->Rows - 1)) +
    static_cast<double>(rowBytes);
  const double runs = std::max(static_cast<double>(this->Rows) / MaximumRowsPerByte,
    stored.CountPixels() / MaximumPixelsPerByte);
  stored.MinimumBytes = static_cast<double>(this->PixelsAt) + (this->HasRuns() ? runs : pixels);
  stored.ExtraBytesPerPixel = static_cast<double>(this->Bits) / 8.0 /
    static_cast<double>(std::max<std::int64_t>(1, this->Rows));
  return {};
}

unsigned char* BmpDecoder::GetRow(const ImageRows& rows, std::int64_t row) const
{
  return rows.Get(this->IsFromTop ? row : this->Rows - 1 - row);
}

bool BmpDecoder::SetColor(unsigned index, unsigned char* pixel)
{
  if (index >= this->Palette.size())
  {
    return this->Fail("a pixel has colour " + std::to_string(index) + " of a palette of " +
      std::to_string(this->Palette.size()));
  }
  std::memcpy(pixel, this->Palette[index].data(), 3);
  return true;
}

bool BmpDecoder::ReadPlainRow(unsigned char* pixels)
{
  if (std::fread(this->Bytes.data(), 1, this->Bytes.size(), this->File.File) != this->Bytes.size())
  {
    return this->FailAtEnd();
  }
  const auto bits = static_cast<unsigned>(this->Bits);
  for (std::size_t i = 0; i < static_cast<std::size_t>(this->Columns); ++i, pixels += 3)
  {
    if (bits <= 8)
    {
      const unsigned shift = 8U - bits - static_cast<unsigned>(i * bits % 8);
      const unsigned byte = this->Bytes[i * bits / 8];
      if (!this->SetColor(byte >> shift & ((1U << bits) - 1U), pixels))
      {
        return false;
      }
      continue;
    }
    const unsigned char* from = this->Bytes.data() + i * bits / 8;
    unsigned pixel = from[0] | static_cast<unsigned>(from[1]) << 8U;
    pixel |= bits > 16 ? static_cast<unsigned>(from[2]) << 16U : 0U;
    pixel |= bits > 24 ? static_cast<unsigned>(from[3]) << 24U : 0U;
    for (std::size_t c = 0; c < 3; ++c)
    {
      pixels[c] = this->Masks[c].GetColor(pixel);
    }
  }
  return true;
}

// Sets the next pixel. Some programs also pack the bytes that pad a row.
bool BmpDecoder::SetNext(unsigned index, const ImageRows& rows)
{
  const std::int64_t padded = 8 * this->GetRowStep() / this->Bits;
  if (this->Column >= padded || this->Row >= this->Rows)
  {
    return this->Fail("a run of pixels leaves the image");
  }
  const std::int64_t column = this->Column++;
  return column >= this->Columns ||
    this->SetColor(index, this->GetRow(rows, this->Row) + 3 * column);
}

// Pixels one by one, padded to an even number of bytes.
bool BmpDecoder::ReadSeparate(int count, const ImageRows& rows)
{
  const bool areBytes = this->Packing == RunsOfBytes;
  const int size = areBytes ? count : (count + 1) / 2;
  for (int i = 0; i < size + size % 2; ++i)
  {
    const int byte = std::getc(this->File.File);
    if (byte == EOF)
    {
      return this->FailAtEnd();
    }
    const auto value = static_cast<unsigned>(byte);
    const bool isSet = i >= size ||
      (areBytes ? this->SetNext(value, rows)
                : this->SetNext(value >> 4U, rows) &&
            (2 * i + 1 >= count || this->SetNext(value & 15U, rows)));
    if (!isSet)
    {
      return false;
    }
  }
  return true;
}

// Reads the end of a row, the end of the image, a move, or a number of pixels.
bool BmpDecoder::ReadEscape(int code, const ImageRows& rows)
{
  if (code > 2)
  {
    return this->ReadSeparate(code, rows);
  }
  this->IsAtEnd = code == 1;
  if (code == 2)
  {
    const int right = std::getc(this->File.File);
    const int up = std::getc(this->File.File);
    if (up == EOF)
    {
      return this->FailAtEnd();
    }
    this->Column += right;
    this->Row += up;
  }
  if (code == 0)
  {
    this->Column = 0;
    ++this->Row;
  }
  return true;
}

// Pixels that the runs leave out have the first colour.
bool BmpDecoder::ReadRuns(const ImageRows& rows)
{
  for (std::int64_t row = 0; row < this->Rows; ++row)
  {
    for (std::int64_t column = 0; column < this->Columns; ++column)
    {
      if (!this->SetColor(0, rows.Get(row) + 3 * column))
      {
        return false;
      }
    }
  }
  while (!this->IsAtEnd)
  {
    const int count = std::getc(this->File.File);
    const int value = std::getc(this->File.File);
    if (value == EOF)
    {
      return this->Row >= this->Rows || this->FailAtEnd(); // only the mark of the end is missing
    }
    if (count == 0 && !this->ReadEscape(value, rows))
    {
      return false;
    }
    for (int i = 0; i < count; ++i)
    {
      const auto both = static_cast<unsigned>(value);
      const unsigned index = this->Packing == RunsOfBytes ? both
        : i % 2 == 0                                      ? both >> 4U
                                                          : both & 15U;
      if (!this->SetNext(index, rows))
      {
        return false;
      }
    }
  }
  return this->Row + 1 >= this->Rows ||
    this->Fail(
      "it has " + std::to_string(this->Row + 1) + " of " + std::to_string(this->Rows) + " rows");
}

Status BmpDecoder::ReadPixels(const ImageRows& rows)
{
  bool isRead = fseeko(this->File.File, this->PixelsAt, SEEK_SET) == 0 || this->FailAtEnd();
  if (this->HasRuns())
  {
    isRead = isRead && this->ReadRuns(rows);
    return isRead ? Status() : Status::Error(this->Fault);
  }
  this->Bytes.resize(static_cast<std::size_t>(this->GetRowSize()));
  const std::int64_t padding = this->GetRowStep() - this->GetRowSize();
  for (std::int64_t row = 0; isRead && row < this->Rows; ++row)
  {
    isRead = this->ReadPlainRow(this->GetRow(rows, row));
    for (std::int64_t i = 0; i < padding; ++i)
    {
      std::getc(this->File.File);
    }
  }
  return isRead ? Status() : Status::Error(this->Fault);
}

} // namespace

std::unique_ptr<ImageDecoder> MakeBmpDecoder(const ImageFile& file)
{
  return std::make_unique<BmpDecoder>(file);
}

} // namespace helios
