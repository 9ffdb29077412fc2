// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosExif.h"

#include <cstddef>

namespace helios
{

namespace
{

constexpr std::string_view ExifStart("Exif\0\0", 6);
constexpr unsigned OrientationTag = 274;
constexpr std::size_t EntrySize = 12;
constexpr std::size_t ValueInEntry = 8;

/// Numbers in the order of bytes of a TIFF header; 0 beyond its end.
class ExifBytes
{
public:
  explicit ExifBytes(std::string_view bytes)
    : Bytes(bytes)
    , IsLittle(bytes.substr(0, 2) == "II")
  {
  }

  unsigned Get(std::size_t at, std::size_t size) const
  {
    if (this->Bytes.size() < size || at > this->Bytes.size() - size)
    {
      return 0;
    }
    unsigned value = 0;
    for (std::size_t i = 0; i < size; ++i)
    {
      const std::size_t place = at + (this->IsLittle ? size - 1 - i : i);
      value = value << 8U | static_cast<unsigned char>(this->Bytes[place]);
    }
    return value;
  }

private:
  std::string_view Bytes;
  bool IsLittle;
};

} // namespace

//------------------------------------------------------------------------------
int FindExifOrientation(std::string_view segment)
{
  if (segment.substr(0, ExifStart.size()) != ExifStart)
  {
    return 0;
  }
  const ExifBytes exif(segment.substr(ExifStart.size()));
  const std::size_t directory = exif.Get(4, 4);
  const unsigned count = exif.Get(directory, 2);
  for (unsigned i = 0; i < count; ++i)
  {
    const std::size_t entry = directory + 2 + EntrySize * i;
    if (exif.Get(entry, 2) == OrientationTag)
    {
      const unsigned value = exif.Get(entry + ValueInEntry, 2);
      return value >= 1 && value <= 8 ? static_cast<int>(value) : 0;
    }
  }
  return 0;
}

} // namespace helios
