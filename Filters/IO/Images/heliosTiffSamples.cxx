// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTiffSamples.h"

#include <tiff.h>

#include <cstring>
#include <string>

namespace helios
{

//------------------------------------------------------------------------------
Status TiffSamples::SetKind(int photometric, int count, int inkSet)
{
  switch (photometric)
  {
    case PHOTOMETRIC_MINISWHITE:
      this->Means = Kind::White;
      break;
    case PHOTOMETRIC_MINISBLACK:
      this->Means = Kind::Black;
      break;
    case PHOTOMETRIC_RGB:
      this->Means = Kind::Color;
      break;
    case PHOTOMETRIC_PALETTE:
      this->Means = Kind::Palette;
      break;
    case PHOTOMETRIC_SEPARATED:
      this->Means = Kind::Ink;
      break;
    default:
      return Status::Error(
        "has colours of kind " + std::to_string(photometric) + ", which are not read; give it RGB");
  }
  if (this->Means == Kind::Ink && inkSet != INKSET_CMYK)
  {
    return Status::Error("has inks other than cyan, magenta, yellow and black; give it RGB");
  }
  const bool hasBits =
    this->Bits == 1 || this->Bits == 2 || this->Bits == 4 || this->Bits == 8 || this->Bits == 16;
  const bool hasColors = this->Means != Kind::Palette ||
    (hasBits && this->Colors.size() == std::size_t(1) << static_cast<unsigned>(this->Bits));
  return hasBits && hasColors && count >= this->GetNumberOfInks()
    ? Status()
    : Status::Error("has " + std::to_string(count) + " samples of " + std::to_string(this->Bits) +
        " bits, which are not read; give it RGB of 8 or 16 bits");
}

//------------------------------------------------------------------------------
void TiffSamples::SetPalette(const std::array<std::uint16_t*, 3>& colors)
{
  constexpr unsigned maximumBits = 16;
  const auto bits = static_cast<unsigned>(this->Bits);
  this->Colors.resize(bits <= maximumBits ? std::size_t(1) << bits : 0);
  bool areBytes = true; // some programs write bytes as 16 bits
  for (std::size_t i = 0; i < this->Colors.size(); ++i)
  {
    areBytes = areBytes && colors[0][i] < 256 && colors[1][i] < 256 && colors[2][i] < 256;
  }
  for (std::size_t i = 0; i < this->Colors.size(); ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->Colors[i][c] = static_cast<unsigned char>(colors[c][i] >> (areBytes ? 0U : 8U));
    }
  }
}

//------------------------------------------------------------------------------
int TiffSamples::GetNumberOfInks() const
{
  return this->Means == Kind::Color ? 3 : this->Means == Kind::Ink ? 4 : 1;
}

//------------------------------------------------------------------------------
unsigned TiffSamples::Get(const unsigned char* row, std::size_t at) const
{
  if (this->Bits == 16)
  {
    std::uint16_t value;
    std::memcpy(&value, row + 2 * at, sizeof(value));
    return value;
  }
  const auto bits = static_cast<unsigned>(this->Bits);
  const std::size_t first = at * bits;
  const unsigned shift = 8U - bits - static_cast<unsigned>(first % 8);
  return (static_cast<unsigned>(row[first / 8]) >> shift) & ((1U << bits) - 1U);
}

//------------------------------------------------------------------------------
/// Returns a sample as 8 bits, rounded.
unsigned char TiffSamples::GetByte(const unsigned char* row, std::size_t at) const
{
  if (this->Bits == 8)
  {
    return row[at];
  }
  const unsigned largest = (1U << static_cast<unsigned>(this->Bits)) - 1U;
  return static_cast<unsigned char>((255U * this->Get(row, at) + largest / 2U) / largest);
}

//------------------------------------------------------------------------------
void TiffSamples::Convert(const std::array<const unsigned char*, 4>& rows, bool arePlanes,
  std::int64_t count, unsigned char* pixels) const
{
  const auto step = static_cast<std::size_t>(this->PerPixel);
  const auto inks = static_cast<std::size_t>(this->GetNumberOfInks());
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i, pixels += 3)
  {
    if (this->Means == Kind::Palette)
    {
      std::memcpy(pixels, this->Colors[this->Get(rows[0], i * step)].data(), 3);
      continue;
    }
    std::array<unsigned char, 4> values{};
    for (std::size_t c = 0; c < inks; ++c)
    {
      values[c] = arePlanes ? this->GetByte(rows[c], i) : this->GetByte(rows[0], i * step + c);
    }
    const int light = 255 - values[3]; // light that black leaves
    for (std::size_t c = 0; c < 3; ++c)
    {
      const int value = values[inks < 3 ? 0 : c];
      const int colored = this->Means == Kind::Ink ? ((255 - value) * light + 127) / 255 : value;
      pixels[c] = static_cast<unsigned char>(this->Means == Kind::White ? 255 - value : colored);
    }
  }
}

} // namespace helios
