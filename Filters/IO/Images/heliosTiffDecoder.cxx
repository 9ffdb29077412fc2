// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The first image of a TIFF file, in strips or tiles, by libtiff.

#include "heliosImageDecoder.h"
#include "heliosTiffSamples.h"
#include "vtkHeliosMemoryLimit.h"

#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <string>
#include <vector>

namespace helios
{

namespace
{

constexpr double LargestRatio = 1e5; // largest ratio of a compression
constexpr double Mebibyte = 1048576.0;
constexpr double MaximumMemory = 1e15; // where the system tells none

struct TiffCloser
{
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

/// Returns the access of libtiff to a file: nothing is mapped, as a mapped file that shrinks ends a
/// process.
tmsize_t ReadBytes(thandle_t handle, void* bytes, tmsize_t count)
{
  return static_cast<tmsize_t>(std::fread(
    bytes, 1, static_cast<std::size_t>(count), static_cast<const ImageFile*>(handle)->File));
}

tmsize_t WriteNothing(thandle_t, void*, tmsize_t)
{
  return 0;
}

toff_t MoveTo(thandle_t handle, toff_t offset, int whence)
{
  std::FILE* file = static_cast<const ImageFile*>(handle)->File;
  const bool isMoved = fseeko(file, static_cast<off_t>(offset), whence) == 0;
  return isMoved ? static_cast<toff_t>(ftello(file)) : static_cast<toff_t>(-1);
}

int LeaveOpen(thandle_t)
{
  return 0;
}

toff_t GetSize(thandle_t handle)
{
  return static_cast<toff_t>(static_cast<const ImageFile*>(handle)->Size);
}

class TiffDecoder final : public ImageDecoder
{
public:
  explicit TiffDecoder(const ImageFile& file)
    : File(file)
  {
  }

  const char* GetFormat() const override { return "TIFF"; }
  Status ReadHeader(StoredImage& stored) override;
  Status ReadPixels(const ImageRows& rows) override;

private:
  static int Fail(TIFF*, void* self, const char* module, const char* format, va_list values);
  static int Warn(TIFF*, void* self, const char* module, const char* format, va_list values);

  bool Open();
  Status FindLayout();
  Status FindColors();
  Status CheckVariant(std::uint16_t compression, std::uint16_t format) const;
  bool ReadBlock(std::int64_t column, std::int64_t row, std::int64_t rowCount);
  Status MakeError() const;
  std::uint16_t GetShort(std::uint32_t tag) const;
  bool HasAlpha() const;
  bool IsTiled() const { return TIFFIsTiled(this->Tiff.get()) != 0; }

  ImageFile File;
  std::unique_ptr<TIFF, TiffCloser> Tiff;
  TiffSamples Samples;
  bool IsPlanar = false;
  std::int64_t Columns = 0;
  std::int64_t Rows = 0;
  std::int64_t BlockColumns = 0; // columns of a block; of a strip: all
  std::int64_t BlockRows = 0;
  std::size_t BlockSize = 0;                        // [bytes]
  std::array<std::vector<unsigned char>, 4> Blocks; // one block per plane
  std::string Message;                              // the first one
  bool IsDecoding = false;
  bool HasWarning = false; // about pixels, which are guessed then
};

int TiffDecoder::Fail(TIFF*, void* self, const char* /*module*/, const char* format, va_list values)
{
  std::string& message = static_cast<TiffDecoder*>(self)->Message;
  if (message.empty())
  {
    std::array<char, 256> text{};
    std::vsnprintf(text.data(), text.size(), format, values);
    message = text.data();
  }
  return 1; // nothing is printed
}

int TiffDecoder::Warn(
  TIFF* tiff, void* self, const char* module, const char* format, va_list values)
{
  TiffDecoder* decoder = static_cast<TiffDecoder*>(self);
  if (!decoder->IsDecoding)
  {
    return 1; // about entries that are not used
  }
  decoder->HasWarning = true;
  return TiffDecoder::Fail(tiff, self, module, format, values);
}

Status TiffDecoder::MakeError() const
{
  return Status::Error("cannot be read: " +
    (this->Message.empty() ? std::string("its pixels are incomplete") : this->Message));
}

bool TiffDecoder::Open()
{
  TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
  const double memory = std::min(MaximumMemory, Mebibyte * vtkHeliosMemoryLimit::GetAvailable());
  TIFFOpenOptionsSetMaxSingleMemAlloc(options, static_cast<tmsize_t>(std::max(1.0, memory)));
  TIFFOpenOptionsSetErrorHandlerExtR(options, TiffDecoder::Fail, this);
  TIFFOpenOptionsSetWarningHandlerExtR(options, TiffDecoder::Warn, this);
  this->Tiff.reset(TIFFClientOpenExt("image", "rm", &this->File, helios::ReadBytes, WriteNothing,
    MoveTo, LeaveOpen, helios::GetSize, nullptr, nullptr, options));
  TIFFOpenOptionsFree(options);
  return this->Tiff != nullptr;
}

// Returns the value of a tag, or the default of TIFF.
std::uint16_t TiffDecoder::GetShort(std::uint32_t tag) const
{
  std::uint16_t value = 0;
  TIFFGetFieldDefaulted(this->Tiff.get(), tag, &value);
  return value;
}

Status TiffDecoder::CheckVariant(std::uint16_t compression, std::uint16_t format) const
{
  if (!TIFFIsCODECConfigured(compression) || compression == COMPRESSION_OJPEG)
  {
    return Status::Error(
      "has compression " + std::to_string(compression) + ", which is not read; give it another");
  }
  if (format != SAMPLEFORMAT_UINT && format != SAMPLEFORMAT_VOID)
  {
    return Status::Error("has samples of format " + std::to_string(format) +
      ", which are not read; give it whole numbers without a sign");
  }
  return {};
}

// Finds the meaning of the samples.
Status TiffDecoder::FindColors()
{
  const std::uint16_t compression = this->GetShort(TIFFTAG_COMPRESSION);
  Status status = this->CheckVariant(compression, this->GetShort(TIFFTAG_SAMPLEFORMAT));
  std::uint16_t photometric = 0;
  if (!status.IsOk() || !TIFFGetField(this->Tiff.get(), TIFFTAG_PHOTOMETRIC, &photometric))
  {
    return status.IsOk() ? Status::Error("does not tell what its samples are") : status;
  }
  if (photometric == PHOTOMETRIC_YCBCR && compression == COMPRESSION_JPEG)
  {
    TIFFSetField(this->Tiff.get(), TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
    photometric = PHOTOMETRIC_RGB;
  }
  this->Samples.Bits = this->GetShort(TIFFTAG_BITSPERSAMPLE);
  this->IsPlanar = this->GetShort(TIFFTAG_PLANARCONFIG) == PLANARCONFIG_SEPARATE;
  const std::uint16_t count = this->GetShort(TIFFTAG_SAMPLESPERPIXEL);
  this->Samples.PerPixel = this->IsPlanar ? 1 : count;
  std::array<std::uint16_t*, 3> palette{};
  if (photometric == PHOTOMETRIC_PALETTE &&
    TIFFGetField(this->Tiff.get(), TIFFTAG_COLORMAP, palette.data(), &palette[1], &palette[2]))
  {
    this->Samples.SetPalette(palette);
  }
  return this->Samples.SetKind(photometric, count, this->GetShort(TIFFTAG_INKSET));
}

Status TiffDecoder::FindLayout()
{
  TIFF* tiff = this->Tiff.get();
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &columns);
  TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &rows);
  this->Columns = columns;
  this->Rows = rows;
  std::uint32_t blockColumns = columns;
  std::uint32_t blockRows = rows;
  if (this->IsTiled())
  {
    TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &blockColumns);
    TIFFGetField(tiff, TIFFTAG_TILELENGTH, &blockRows);
  }
  else
  {
    TIFFGetFieldDefaulted(tiff, TIFFTAG_ROWSPERSTRIP, &blockRows);
    blockRows = std::min(blockRows, rows);
  }
  this->BlockColumns = blockColumns;
  this->BlockRows = blockRows;
  const tmsize_t size = this->IsTiled() ? TIFFTileSize(tiff) : TIFFStripSize(tiff);
  const auto perRow = static_cast<tmsize_t>(this->Samples.GetRowSize(this->BlockColumns));
  if (blockColumns == 0 || blockRows == 0 || size / blockRows != perRow)
  {
    return Status::Error("is damaged: a block of " + std::to_string(blockColumns) + " x " +
      std::to_string(blockRows) + " pixels has " + std::to_string(size) + " bytes");
  }
  this->BlockSize = static_cast<std::size_t>(size);
  return {};
}

bool TiffDecoder::HasAlpha() const
{
  std::uint16_t count = 0;
  std::uint16_t* kinds = nullptr;
  return TIFFGetFieldDefaulted(this->Tiff.get(), TIFFTAG_EXTRASAMPLES, &count, &kinds) != 0 &&
    std::any_of(kinds, kinds + count,
      [](std::uint16_t kind)
      { return kind == EXTRASAMPLE_ASSOCALPHA || kind == EXTRASAMPLE_UNASSALPHA; });
}

Status TiffDecoder::ReadHeader(StoredImage& stored)
{
  if (!this->Open())
  {
    return this->MakeError();
  }
  Status status = this->FindColors();
  if (status.IsOk())
  {
    status = this->FindLayout();
  }
  if (!status.IsOk())
  {
    return status;
  }
  stored.Columns = this->Columns;
  stored.Rows = this->Rows;
  const std::uint16_t orientation = this->GetShort(TIFFTAG_ORIENTATION);
  if (orientation >= ORIENTATION_TOPLEFT && orientation <= ORIENTATION_LEFTBOT)
  {
    stored.Orientation = static_cast<ImageOrientation>(orientation);
  }
  const int planes = this->IsPlanar ? this->Samples.GetNumberOfInks() : 1;
  const bool isPlain = this->GetShort(TIFFTAG_COMPRESSION) == COMPRESSION_NONE;
  stored.MinimumBytes = static_cast<double>(this->Samples.Bits) / 8.0 * this->Samples.PerPixel *
    planes * stored.CountPixels() / (isPlain ? 1.0 : LargestRatio);
  stored.ExtraBytesPerPixel =
    static_cast<double>(planes) * static_cast<double>(this->BlockSize) / stored.CountPixels();
  stored.HasAlpha = this->HasAlpha();
  return {};
}

// Decodes the strip or tile of a pixel; the last strip may have fewer rows.
bool TiffDecoder::ReadBlock(std::int64_t column, std::int64_t row, std::int64_t rowCount)
{
  TIFF* tiff = this->Tiff.get();
  const int planes = this->IsPlanar ? this->Samples.GetNumberOfInks() : 1;
  const auto x = static_cast<std::uint32_t>(column);
  const auto y = static_cast<std::uint32_t>(row);
  const tmsize_t size = this->IsTiled() ? static_cast<tmsize_t>(this->BlockSize)
                                        : static_cast<tmsize_t>(rowCount) *
      static_cast<tmsize_t>(this->Samples.GetRowSize(this->BlockColumns));
  for (int plane = 0; plane < planes; ++plane)
  {
    std::vector<unsigned char>& block = this->Blocks[static_cast<std::size_t>(plane)];
    block.resize(this->BlockSize);
    const auto sample = static_cast<std::uint16_t>(plane);
    const tmsize_t count = this->IsTiled()
      ? TIFFReadEncodedTile(tiff, TIFFComputeTile(tiff, x, y, 0, sample), block.data(), size)
      : TIFFReadEncodedStrip(tiff, TIFFComputeStrip(tiff, y, sample), block.data(), size);
    if (count != size || this->HasWarning)
    {
      return false;
    }
  }
  return true;
}

Status TiffDecoder::ReadPixels(const ImageRows& rows)
{
  this->IsDecoding = true;
  this->Message.clear();
  const std::size_t blockRow = this->Samples.GetRowSize(this->BlockColumns);
  for (std::int64_t row = 0; row < this->Rows; row += this->BlockRows)
  {
    const std::int64_t rowCount = std::min(this->BlockRows, this->Rows - row);
    for (std::int64_t column = 0; column < this->Columns; column += this->BlockColumns)
    {
      const std::int64_t count = std::min(this->BlockColumns, this->Columns - column);
      if (!this->ReadBlock(column, row, rowCount))
      {
        return this->MakeError();
      }
      for (std::int64_t i = 0; i < rowCount; ++i)
      {
        std::array<const unsigned char*, 4> planes{};
        std::transform(this->Blocks.begin(), this->Blocks.end(), planes.begin(),
          [i, blockRow](const std::vector<unsigned char>& block)
          { return block.data() + static_cast<std::size_t>(i) * blockRow; });
        this->Samples.Convert(planes, this->IsPlanar, count, rows.Get(row + i) + 3 * column);
      }
    }
  }
  return {};
}

} // namespace

std::unique_ptr<ImageDecoder> MakeTiffDecoder(const ImageFile& file)
{
  return std::make_unique<TiffDecoder>(file);
}

} // namespace helios
