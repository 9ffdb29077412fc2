// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The decoders of images, one for each format.

#ifndef heliosImageDecoder_h
#define heliosImageDecoder_h

#include "heliosStatus.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>

namespace helios
{

/// Where row 0 and column 0 of the file are seen, as tag 274 of TIFF counts them: from 1 to 8.
enum class ImageOrientation
{
  TopLeft = 1, ///< all formats but TIFF
  TopRight,
  BottomRight,
  BottomLeft,
  LeftTop, ///< row 0 is the left column, column 0 the top row
  RightTop,
  RightBottom,
  LeftBottom
};

/// Where a decoder writes rows of red green blue, in the order of the file.
struct ImageRows
{
  unsigned char* First;
  std::ptrdiff_t Step; ///< from a row to the next [bytes]

  unsigned char* Get(std::int64_t row) const { return this->First + row * this->Step; }
};

/// Image in the file's own order of rows and columns.
struct StoredImage
{
  std::int64_t Columns = 0;
  std::int64_t Rows = 0;
  ImageOrientation Orientation = ImageOrientation::TopLeft;
  double ExtraBytesPerPixel = 0.0; ///< memory beside the 3 bytes of a pixel, while it is read
  double MinimumBytes = 0.0;       ///< fewest bytes of the pixels in any file
  int ExifOrientation = 1;         ///< which is not applied
  bool HasAlpha = false;

  double CountPixels() const
  {
    return static_cast<double>(this->Columns) * static_cast<double>(this->Rows);
  }
};

/// Reads one file; messages are without its name and remedy.
class ImageDecoder
{
public:
  virtual ~ImageDecoder() = default;
  ImageDecoder(const ImageDecoder&) = delete;
  void operator=(const ImageDecoder&) = delete;

  virtual const char* GetFormat() const = 0;

  /// Reads the header; runs once, first.
  virtual Status ReadHeader(StoredImage& stored) = 0;

  /// Returns whether pixels can be those of the transparency.
  virtual bool ReadsOpacity() const { return false; }

  /// Writes all pixels, or fails. Called once, after ReadHeader().
  virtual Status ReadPixels(const ImageRows& rows) = 0;

protected:
  ImageDecoder() = default;
};

/// The file of an image, open at its start, its size [bytes], and whether pixels are opacities.
struct ImageFile
{
  std::FILE* File;
  std::int64_t Size;
  bool IsOpacity;
};

std::unique_ptr<ImageDecoder> MakePngDecoder(const ImageFile& file);
std::unique_ptr<ImageDecoder> MakeJpegDecoder(const ImageFile& file);
std::unique_ptr<ImageDecoder> MakeTiffDecoder(const ImageFile& file);
std::unique_ptr<ImageDecoder> MakeBmpDecoder(const ImageFile& file);
std::unique_ptr<ImageDecoder> MakePnmDecoder(const ImageFile& file);

} // namespace helios

#endif
