// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Small images by the bytes of their formats, and their pixels as text.

#ifndef heliosImageTesting_h
#define heliosImageTesting_h

#include "heliosImage.h"
#include "heliosTempFolder.h"

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace helios
{

/// Bytes of a little-endian number.
inline std::string ToBytes(std::uint64_t value, int size)
{
  std::string bytes;
  for (int i = 0; i < size; ++i)
  {
    bytes += static_cast<char>(value >> (8 * i) & 255U);
  }
  return bytes;
}

inline std::string ToBytes(const std::vector<int>& values)
{
  return { values.begin(), values.end() };
}

/// An image with its rows from the top: "2x1: ff0000 000000"; rows are separated by " / ".
inline std::string Describe(const Image& image)
{
  const int width = image.Header.Width;
  const int height = image.Header.Height;
  std::string text = std::to_string(width) + "x" + std::to_string(height) + ":";
  for (int row = height - 1; row >= 0; --row)
  {
    for (int column = 0; column < width; ++column)
    {
      const unsigned char* p = image.Pixels.get() + 3 * (row * width + column);
      char color[8];
      std::snprintf(color, sizeof(color), " %02x%02x%02x", p[0], p[1], p[2]);
      text += color;
    }
    text += row > 0 ? " /" : "";
  }
  return text;
}

/// Describes the image that bytes are, or gives the error, in which "image" stands for its path.
inline std::string ReadBytesAsImage(const std::string& bytes)
{
  const TempFolder folder;
  const std::string path = folder / "image";
  std::ofstream(path, std::ios::binary) << bytes;
  Image image;
  const Status status = ReadImage({ path }, image);
  if (status.IsOk())
  {
    return Describe(image);
  }
  std::string message = status.Message();
  message.replace(message.find(path), path.size(), "image");
  return message;
}

/// Returns the message about a damaged image.
inline std::string Damaged(const std::string& format, const std::string& fault)
{
  return "image: " + format + " image " + fault + "; get it again, or save it with another program";
}

/// A BMP of Windows: 40 bytes of header, further parts, pixels.
struct TestBmp
{
  int Columns = 2;
  int Rows = 2;
  int Bits = 24;
  int Compression = 0;
  int Colors = 0;
  std::string Between; ///< masks and palette
  std::string Pixels;
  int HeaderSize = 40;

  std::string Write() const
  {
    const std::size_t at = 14 + 40 + this->Between.size();
    return "BM" + ToBytes(at + this->Pixels.size(), 4) + ToBytes(0, 4) + ToBytes(at, 4) +
      ToBytes(static_cast<std::uint64_t>(this->HeaderSize), 4) +
      ToBytes(static_cast<std::uint32_t>(this->Columns), 4) +
      ToBytes(static_cast<std::uint32_t>(this->Rows), 4) + ToBytes(1, 2) +
      ToBytes(static_cast<std::uint64_t>(this->Bits), 2) +
      ToBytes(static_cast<std::uint64_t>(this->Compression), 4) + std::string(12, '\0') +
      ToBytes(static_cast<std::uint64_t>(this->Colors), 4) + ToBytes(0, 4) + this->Between +
      this->Pixels;
  }
};

/// A TIFF without compression: one strip after its entries.
struct TestTiff
{
  /// Tag, type (3: 2 bytes, 4: 4 bytes) and value.
  struct Entry
  {
    int Tag;
    int Type;
    std::uint32_t Value;
  };

  std::uint32_t Columns = 3;
  std::uint32_t Rows = 2;
  std::uint32_t Bits = 8;
  std::uint32_t Samples = 3;
  std::uint32_t Photometric = 2; ///< RGB
  std::uint32_t Orientation = 1;
  std::uint32_t Compression = 1;
  std::uint32_t Format = 1;
  std::string Pixels;

  std::string Write() const
  {
    const std::uint32_t count = 12;
    const std::uint32_t at = 8 + 2 + 12 * count + 4;
    const std::vector<Entry> entries = { { 256, 4, this->Columns }, { 257, 4, this->Rows },
      { 258, 3, this->Bits }, { 259, 3, this->Compression }, { 262, 3, this->Photometric },
      { 273, 4, at }, { 274, 3, this->Orientation }, { 277, 3, this->Samples },
      { 278, 4, this->Rows }, { 279, 4, static_cast<std::uint32_t>(this->Pixels.size()) },
      { 284, 3, 1 }, { 339, 3, this->Format } };
    std::string bytes = "II" + ToBytes(42, 2) + ToBytes(8, 4) + ToBytes(count, 2);
    for (const Entry& entry : entries)
    {
      bytes += ToBytes(static_cast<std::uint64_t>(entry.Tag), 2) +
        ToBytes(static_cast<std::uint64_t>(entry.Type), 2) + ToBytes(1, 4) +
        ToBytes(entry.Value, 4);
    }
    return bytes + ToBytes(0, 4) + this->Pixels;
  }
};

} // namespace helios

#endif
