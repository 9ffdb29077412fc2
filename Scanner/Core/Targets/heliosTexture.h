// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Images on surfaces.

#ifndef heliosTexture_h
#define heliosTexture_h

#include "heliosStatus.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace helios
{

/// Red, green, blue, [0..1].
using Rgb = std::array<double, 3>;

/// An image that repeats in both directions.
class VTKHELIOSSCANNERCORE_EXPORT Texture
{
public:
  /// Reads an image: PNG, JPEG, TIFF, BMP or PNM, of 8 or 16 bits, grey or coloured.
  Status Read(const std::string& path);

  /// The colour at texture coordinates, bilinear between the centres of pixels: (0, 0) is the lower
  /// left corner of the image, (1, 1) the upper right one.
  Rgb Get(double u, double v) const;

private:
  const unsigned char* GetPixel(int column, int row) const;

  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Pixels; // red green blue, from the lowest row
};

/// Images by path, each read once.
class VTKHELIOSSCANNERCORE_EXPORT TextureStore
{
public:
  /// Null if it cannot be read: then the first call adds the reason to the faults.
  std::shared_ptr<const Texture> Get(const std::string& path, std::vector<std::string>& faults);

private:
  std::map<std::string, std::shared_ptr<const Texture>> Known;
};

} // namespace helios

#endif
