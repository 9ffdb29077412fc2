// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Colours of 8 bits in the 16 bits of LAS.

#ifndef heliosLasColors_h
#define heliosLasColors_h

namespace helios
{

class LasFile;
class Status;

/// LAS has colours of 16 bits, 65535 is full; many programs write 8 bits, 255 is full.
struct LasColorBits
{
  static constexpr int LargestOf8 = 255;
  static constexpr int Scale = 257; ///< 255 becomes 65535

  bool AreColors8 = false;
  bool IsInfrared8 = false;

  /// Factors of the stored numbers.
  int GetColorScale() const { return this->AreColors8 ? Scale : 1; }
  int GetInfraredScale() const { return this->IsInfrared8 ? Scale : 1; }
};

/// Finds the bits of the colours in all points of a file: 8 if the largest is 1 to 255. Reads up to
/// the first colour above that. Files of vtkHelios always have 16 bits.
Status FindColorBits(LasFile& file, LasColorBits& bits);

} // namespace helios

#endif
