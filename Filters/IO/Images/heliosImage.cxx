// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosImage.h"

#include "heliosImageDecoder.h"
#include "heliosInputFile.h"
#include "heliosLineFile.h"
#include "heliosMemoryCheck.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <limits>
#include <new>
#include <string_view>
#include <system_error>

namespace helios
{

namespace
{

constexpr std::size_t Channels = 3;
constexpr std::size_t BufferSize = 65536;
constexpr std::int64_t LongestSide = std::numeric_limits<int>::max();

/// How a format begins, and its decoder.
struct Format
{
  std::string_view Start;
  std::unique_ptr<ImageDecoder> (*Make)(const ImageFile& file);
};

constexpr std::array<Format, 14> Formats = { { { "\x89PNG\r\n\x1a\n", MakePngDecoder },
  { "\xff\xd8\xff", MakeJpegDecoder }, { { "II*\0", 4 }, MakeTiffDecoder },
  { { "MM\0*", 4 }, MakeTiffDecoder }, { { "II+\0", 4 }, MakeTiffDecoder },
  { { "MM\0+", 4 }, MakeTiffDecoder }, { "BM", MakeBmpDecoder }, { "P1", MakePnmDecoder },
  { "P2", MakePnmDecoder }, { "P3", MakePnmDecoder }, { "P4", MakePnmDecoder },
  { "P5", MakePnmDecoder }, { "P6", MakePnmDecoder }, { "P7", MakePnmDecoder } } };

/// Makes the decoder for the first bytes of a file; null: of no format.
std::unique_ptr<ImageDecoder> MakeDecoder(const ImageFile& file)
{
  std::array<char, 8> start{};
  const std::size_t count = std::fread(start.data(), 1, start.size(), file.File);
  std::rewind(file.File);
  const std::string_view bytes(start.data(), count);
  const auto found = std::find_if(Formats.begin(), Formats.end(),
    [bytes](const Format& format) { return bytes.substr(0, format.Start.size()) == format.Start; });
  return found == Formats.end() ? nullptr : found->Make(file);
}

bool IsTransposed(ImageOrientation orientation)
{
  return orientation >= ImageOrientation::LeftTop;
}

/// Returns whether a side of the file is at the right, or bottom, of what is seen.
bool IsMirrored(ImageOrientation orientation)
{
  return orientation == ImageOrientation::TopRight ||
    orientation == ImageOrientation::BottomRight || orientation == ImageOrientation::RightTop ||
    orientation == ImageOrientation::RightBottom;
}

bool IsUpsideDown(ImageOrientation orientation)
{
  return orientation == ImageOrientation::BottomRight ||
    orientation == ImageOrientation::BottomLeft || orientation == ImageOrientation::RightBottom ||
    orientation == ImageOrientation::LeftBottom;
}

/// Returns whether the rows of the file are those that are seen, from the top or from the bottom.
bool HasRows(ImageOrientation orientation)
{
  return !IsTransposed(orientation) && !IsMirrored(orientation);
}

/// An image file that is open, with its header.
class OpenImage
{
public:
  Status Open(const ImageSource& source, ImageContent content = ImageContent::Colors);
  Status Read(Image& image);
  const ImageHeader& GetHeader() const { return this->Header; }

private:
  Status OpenBytes(const ImageSource& source);
  Status CheckSize() const;
  void SetHeader();
  Status Fail(const std::string& fault) const;
  void Turn(const unsigned char* stored, unsigned char* pixels) const;

  std::string Path;
  InputFile File;
  std::int64_t Size = 0;
  std::unique_ptr<ImageDecoder> Decoder; // uses the file
  StoredImage Stored;
  ImageHeader Header;
};

Status OpenImage::Fail(const std::string& fault) const
{
  return Status::Error(this->Path + ": " + this->Decoder->GetFormat() + " image " + fault +
    "; get it again, or save it with another program");
}

// Opens bytes in memory, or a file.
Status OpenImage::OpenBytes(const ImageSource& source)
{
  const std::string& path = source.Path;
  if (!source.Bytes.empty())
  {
    this->Size = static_cast<std::int64_t>(source.Bytes.size());
    this->File.reset(fmemopen(const_cast<char*>(source.Bytes.data()), source.Bytes.size(), "rb"));
    return this->File ? Status() : throw std::bad_alloc();
  }
  std::error_code error;
  if (CheckInputFile(path).IsOk() && !std::filesystem::exists(path, error))
  {
    return Status::Error(path + " does not exist; give it");
  }
  return OpenInput(path, this->File, this->Size);
}

Status OpenImage::Open(const ImageSource& source, ImageContent content)
{
  this->Path = source.Path;
  if (const Status status = this->OpenBytes(source); !status.IsOk())
  {
    return status;
  }
  const bool isOpacity = content == ImageContent::Opacity;
  std::setvbuf(this->File.get(), nullptr, _IOFBF, BufferSize);
  this->Decoder = MakeDecoder({ this->File.get(), this->Size, isOpacity });
  if (!this->Decoder)
  {
    return Status::Error(this->Path +
      (this->Size == 0 ? " is empty" : " is no image that is read") +
      "; give PNG, JPEG, TIFF, BMP or PNM");
  }
  Status status = this->Decoder->ReadHeader(this->Stored);
  if (status.IsOk())
  {
    status = this->CheckSize();
  }
  this->SetHeader();
  if (status.IsOk() && isOpacity && !this->Decoder->ReadsOpacity())
  {
    return Status::Error(this->Path + ": the transparency of " + this->Header.Format +
      " images is not read; save it as PNG");
  }
  return status.IsOk() ? Status() : this->Fail(status.Message());
}

// Pixels that the file cannot have are not allocated.
Status OpenImage::CheckSize() const
{
  const StoredImage& s = this->Stored;
  const std::string size = std::to_string(s.Columns) + " x " + std::to_string(s.Rows) + " pixels";
  if (s.Columns < 1 || s.Rows < 1 || s.Columns > LongestSide || s.Rows > LongestSide)
  {
    return Status::Error("is damaged: it has " + size);
  }
  if (s.MinimumBytes > static_cast<double>(this->Size))
  {
    return Status::Error("is damaged: " + size + " do not fit into a file of " +
      std::to_string(this->Size) + " bytes");
  }
  return {};
}

void OpenImage::SetHeader()
{
  const StoredImage& s = this->Stored;
  const bool isTransposed = IsTransposed(s.Orientation);
  this->Header.Format = this->Decoder->GetFormat();
  this->Header.Width = static_cast<int>(isTransposed ? s.Rows : s.Columns);
  this->Header.Height = static_cast<int>(isTransposed ? s.Columns : s.Rows);
  this->Header.BytesPerPixel =
    (HasRows(s.Orientation) ? 1.0 : 2.0) * Channels + s.ExtraBytesPerPixel;
  this->Header.HasAlpha = s.HasAlpha;
  if (s.ExifOrientation != 1)
  {
    this->Header.Warning = this->Path + ": EXIF orientation " + std::to_string(s.ExifOrientation) +
      " is not applied: texture coordinates are those of the pixels as stored; if they are not, "
      "save the image upright";
  }
}

Status OpenImage::Read(Image& image)
{
  const std::string things = std::string("pixels of a ") + this->Header.Format + " image";
  if (const Status status =
        CheckMemory(things, this->Header.CountPixels(), this->Header.BytesPerPixel);
      !status.IsOk())
  {
    return Status::Error(this->Path + ": " + status.Message());
  }
  const StoredImage& s = this->Stored;
  const std::size_t rowSize = Channels * static_cast<std::size_t>(s.Columns);
  const auto rows = static_cast<std::size_t>(s.Rows);
  const auto allocate = [rowSize, rows]() // zeros take memory once they are written
  {
    void* memory = std::calloc(rows, rowSize);
    return memory ? static_cast<unsigned char*>(memory) : throw std::bad_alloc();
  };
  image.Header = this->Header;
  image.Pixels.reset(allocate());
  const bool hasRows = HasRows(s.Orientation);
  const decltype(image.Pixels) turned(hasRows ? nullptr : allocate());
  unsigned char* first = hasRows ? image.Pixels.get() : turned.get();
  const auto step = static_cast<std::ptrdiff_t>(rowSize);
  const bool isFromTop = hasRows && !IsUpsideDown(s.Orientation);
  const Status status = this->Decoder->ReadPixels(
    isFromTop ? ImageRows{ first + (rows - 1) * rowSize, -step } : ImageRows{ first, step });
  if (!status.IsOk())
  {
    image.Pixels.reset();
    return this->Fail(status.Message());
  }
  if (!hasRows)
  {
    this->Turn(turned.get(), image.Pixels.get());
  }
  return {};
}

// Moves pixels in the order of the file to where they are seen.
void OpenImage::Turn(const unsigned char* stored, unsigned char* pixels) const
{
  const StoredImage& s = this->Stored;
  const bool isTransposed = IsTransposed(s.Orientation);
  const bool isMirrored = IsMirrored(s.Orientation);
  const bool isUpsideDown = IsUpsideDown(s.Orientation);
  const auto width = static_cast<std::int64_t>(this->Header.Width);
  const auto height = static_cast<std::int64_t>(this->Header.Height);
  for (std::int64_t row = 0; row < s.Rows; ++row)
  {
    for (std::int64_t column = 0; column < s.Columns; ++column, stored += Channels)
    {
      const std::int64_t x = isTransposed ? row : column;
      const std::int64_t y = isTransposed ? column : row;
      const std::int64_t fromLeft = isMirrored ? width - 1 - x : x;
      const std::int64_t fromBottom = isUpsideDown ? y : height - 1 - y;
      std::memcpy(pixels + Channels * static_cast<std::size_t>(fromBottom * width + fromLeft),
        stored, Channels);
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
Status ReadImageHeader(const ImageSource& source, ImageHeader& header)
{
  OpenImage file;
  const Status status = file.Open(source);
  header = file.GetHeader();
  return status;
}

//------------------------------------------------------------------------------
Status ReadImage(const ImageSource& source, Image& image, ImageContent content)
{
  try
  {
    OpenImage file;
    const Status status = file.Open(source, content);
    return status.IsOk() ? file.Read(image) : status;
  }
  catch (const std::bad_alloc&)
  {
    image.Pixels.reset();
    return Status::Error(source.Path + ": not enough memory for its pixels; use a smaller image");
  }
}

//------------------------------------------------------------------------------
Status MakeTextureError(const Status& status)
{
  return Status::Error("texture " + status.Message() + ", or remove map_Kd");
}

} // namespace helios
