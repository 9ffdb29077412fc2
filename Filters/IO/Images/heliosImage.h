// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Images in files: PNG, JPEG, TIFF, BMP and PNM.

#ifndef heliosImage_h
#define heliosImage_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

namespace helios
{

struct FreeMemory
{
  void operator()(void* memory) const { std::free(memory); }
};

/// An image as it is seen: size and memory from its header.
struct ImageHeader
{
  std::string Format; ///< such as PNG
  int Width = 0;      ///< [pixels]
  int Height = 0;
  double BytesPerPixel = 3.0; ///< largest memory while the image is read
  bool HasAlpha = false;      ///< transparency, which ReadImage() reads on request
  std::string Warning;        ///< names what is not applied; empty: none

  double CountPixels() const { return static_cast<double>(this->Width) * this->Height; }
};

/// An image in a file, or in bytes that a path names in messages.
struct ImageSource
{
  std::string Path;
  std::string_view Bytes = {}; ///< empty: those of the file
};

/// The meaning of pixels that are read.
enum class ImageContent
{
  Colors,
  Opacity ///< red, green and blue are all the alpha of the image, which it must have
};

/// Red, green and blue of all pixels, row by row from the lowest, 8 bits each; greys have them equal.
struct Image
{
  ImageHeader Header;
  std::unique_ptr<unsigned char, FreeMemory> Pixels;
};

/**
 * Reads size and kind of an image. The first bytes give the kind, whatever the name. Errors begin
 * with the path: a file that is missing, not regular, of another kind, damaged, or of a variant
 * that is not read.
 */
VTKHELIOSFILTERSIO_EXPORT Status ReadImageHeader(const ImageSource& source, ImageHeader& header);

/**
 * Reads an image: upright as its format says, 16 bits rounded to 8, without transparency unless
 * opacities are asked for, which are read from PNG only. Nothing is guessed: an image that is damaged or incomplete is an error, as is one that needs more memory than
 * vtkHeliosMemoryLimit allows; it is not allocated.
 */
VTKHELIOSFILTERSIO_EXPORT Status ReadImage(
  const ImageSource& source, Image& image, ImageContent content = ImageContent::Colors);

/// Turns an error of an image into an error of a texture, with a remedy by map_Kd.
VTKHELIOSFILTERSIO_EXPORT Status MakeTextureError(const Status& status);

} // namespace helios

#endif
