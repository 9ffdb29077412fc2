// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The samples of TIFF as red, green and blue.

#ifndef heliosTiffSamples_h
#define heliosTiffSamples_h

#include "heliosStatus.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace helios
{

/// Samples of 1, 2, 4, 8 or 16 bits, in the order of bytes of this machine.
class TiffSamples
{
public:
  int Bits = 8;
  int PerPixel = 1; ///< in a row: 1 of planes

  /// Sets the kind of the samples by the tags of TIFF; an error for a kind that is not read.
  Status SetKind(int photometric, int count, int inkSet);

  /// Sets tables with a colour for each value of a sample, before SetKind().
  void SetPalette(const std::array<std::uint16_t*, 3>& colors);

  /// Returns the number of samples of a pixel that make its colour; further ones are ignored.
  int GetNumberOfInks() const;

  std::size_t GetRowSize(std::int64_t columns) const
  {
    return (static_cast<std::size_t>(columns) *
               static_cast<std::size_t>(this->PerPixel * this->Bits) +
             7) /
      8;
  }

  /// Converts a row of pixels, whose samples are in one row, or in planes of one each.
  void Convert(const std::array<const unsigned char*, 4>& rows, bool arePlanes, std::int64_t count,
    unsigned char* pixels) const;

private:
  enum class Kind
  {
    White, // 0 is white
    Black, // 0 is black
    Color,
    Palette,
    Ink
  };

  unsigned Get(const unsigned char* row, std::size_t at) const;
  unsigned char GetByte(const unsigned char* row, std::size_t at) const;

  Kind Means = Kind::Black;
  std::vector<std::array<unsigned char, 3>> Colors; // colours of the palette
};

} // namespace helios

#endif
