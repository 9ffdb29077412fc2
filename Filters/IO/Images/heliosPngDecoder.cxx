// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// PNG, by libpng. Its errors jump out of its functions: what they jump over has no destructors.

#include "heliosImageDecoder.h"

#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace helios
{

namespace
{

constexpr double LargestRatio = 1032.0; // largest ratio of deflate
constexpr int AllButUsed = -1;          // chunks, for png_set_keep_unknown_chunks()
constexpr int BitsOfSample = 8;         // written samples
constexpr int ChannelsOfPixel = 3;

class PngDecoder final : public ImageDecoder
{
public:
  explicit PngDecoder(const ImageFile& file)
    : File(file.File)
    , IsOpacity(file.IsOpacity)
  {
  }
  ~PngDecoder() override { png_destroy_read_struct(&this->Png, &this->Info, nullptr); }

  const char* GetFormat() const override { return "PNG"; }
  Status ReadHeader(StoredImage& stored) override;
  Status ReadPixels(const ImageRows& rows) override;
  bool ReadsOpacity() const override { return true; }

private:
  static void SpreadAlpha(png_structp png, png_row_infop row, png_bytep bytes);
  static void Fail(png_structp png, png_const_charp message);
  static void Ignore(png_structp, png_const_charp) {}
  static void Read(png_structp png, png_bytep bytes, std::size_t count);

  bool Start();
  bool ParseHeader();
  bool Decode();
  Status MakeError() const;
  double CountMinimumBytes() const;

  std::FILE* File;
  bool IsOpacity;
  png_structp Png = nullptr;
  png_infop Info = nullptr;
  std::vector<png_bytep> Rows;
  char Message[256] = {};
};

void PngDecoder::Fail(png_structp png, png_const_charp message)
{
  auto* self = static_cast<PngDecoder*>(png_get_error_ptr(png));
  std::snprintf(self->Message, sizeof(self->Message), "%s", message);
  png_longjmp(png, 1);
}

void PngDecoder::Read(png_structp png, png_bytep bytes, std::size_t count)
{
  auto* self = static_cast<PngDecoder*>(png_get_io_ptr(png));
  if (std::fread(bytes, 1, count, self->File) != count)
  {
    png_error(png, "the file ends too early");
  }
}

Status PngDecoder::MakeError() const
{
  return Status::Error(std::string("cannot be read: ") + this->Message);
}

// Starts libpng. It checks the checksum of every chunk, and skips chunks without pixels.
bool PngDecoder::Start()
{
  this->Png =
    png_create_read_struct(PNG_LIBPNG_VER_STRING, this, PngDecoder::Fail, PngDecoder::Ignore);
  this->Info = this->Png ? png_create_info_struct(this->Png) : nullptr;
  if (!this->Info)
  {
    std::snprintf(this->Message, sizeof(this->Message), "libpng has no memory");
    return false;
  }
  png_set_read_fn(this->Png, this, PngDecoder::Read);
  return this->ParseHeader();
}

bool PngDecoder::ParseHeader()
{
  if (setjmp(png_jmpbuf(this->Png)))
  {
    return false;
  }
  png_set_crc_action(this->Png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  png_set_keep_unknown_chunks(this->Png, PNG_HANDLE_CHUNK_NEVER, nullptr, AllButUsed);
  png_read_info(this->Png, this->Info);
  return true;
}

// Computes the smallest size of IDAT, at the highest compression.
double PngDecoder::CountMinimumBytes() const
{
  const double bits = static_cast<double>(png_get_bit_depth(this->Png, this->Info)) *
    png_get_channels(this->Png, this->Info);
  return bits / 8.0 * png_get_image_width(this->Png, this->Info) *
    png_get_image_height(this->Png, this->Info) / LargestRatio;
}

Status PngDecoder::ReadHeader(StoredImage& stored)
{
  if (!this->Start())
  {
    return this->MakeError();
  }
  stored.Columns = png_get_image_width(this->Png, this->Info);
  stored.Rows = png_get_image_height(this->Png, this->Info);
  stored.MinimumBytes = this->CountMinimumBytes();
  stored.HasAlpha = (png_get_color_type(this->Png, this->Info) & PNG_COLOR_MASK_ALPHA) != 0 ||
    png_get_valid(this->Png, this->Info, PNG_INFO_tRNS) != 0;
  stored.ExtraBytesPerPixel = static_cast<double>(sizeof(png_bytep)) /
    static_cast<double>(stored.Columns > 0 ? stored.Columns : 1);
  return {};
}

// Replaces red green blue alpha by three times alpha.
void PngDecoder::SpreadAlpha(png_structp, png_row_infop row, png_bytep bytes)
{
  for (png_uint_32 i = 0; i < row->width; ++i)
  {
    std::memset(
      bytes + std::size_t{ ChannelsOfPixel } * i, bytes[std::size_t{ 4 } * i + 3], ChannelsOfPixel);
  }
}

bool PngDecoder::Decode()
{
  if (setjmp(png_jmpbuf(this->Png)))
  {
    return false;
  }
  png_set_expand(this->Png);
  png_set_scale_16(this->Png);
  png_set_gray_to_rgb(this->Png);
  if (this->IsOpacity)
  {
    png_set_read_user_transform_fn(this->Png, PngDecoder::SpreadAlpha);
    png_set_user_transform_info(this->Png, nullptr, BitsOfSample, ChannelsOfPixel);
  }
  else
  {
    png_set_strip_alpha(this->Png);
  }
  png_set_interlace_handling(this->Png);
  png_read_update_info(this->Png, this->Info);
  png_read_image(this->Png, this->Rows.data());
  png_read_end(this->Png, nullptr);
  return true;
}

Status PngDecoder::ReadPixels(const ImageRows& rows)
{
  const std::int64_t count = png_get_image_height(this->Png, this->Info);
  const bool hasPalette = png_get_color_type(this->Png, this->Info) == PNG_COLOR_TYPE_PALETTE;
  png_colorp palette = nullptr;
  int colors = 0;
  if (hasPalette)
  {
    png_get_PLTE(this->Png, this->Info, &palette, &colors);
  }
  this->Rows.reserve(static_cast<std::size_t>(count));
  for (std::int64_t row = 0; row < count; ++row)
  {
    this->Rows.push_back(rows.Get(row));
  }
  if (!this->Decode())
  {
    return this->MakeError();
  }
  const int last = hasPalette ? png_get_palette_max(this->Png, this->Info) : -1;
  return last < colors ? Status()
                       : Status::Error("is damaged: a pixel has colour " + std::to_string(last) +
                           " of a palette of " + std::to_string(colors));
}

} // namespace

std::unique_ptr<ImageDecoder> MakePngDecoder(const ImageFile& file)
{
  return std::make_unique<PngDecoder>(file);
}

} // namespace helios
