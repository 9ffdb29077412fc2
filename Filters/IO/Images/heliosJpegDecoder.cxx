// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// JPEG, by libjpeg. Its errors jump out of its functions: what they jump over has no destructors.

#include "heliosExif.h"
#include "heliosImageDecoder.h"

#include <cstdio> // before jpeglib.h, which needs FILE

#include <jpeglib.h>

#include <csetjmp>
#include <string>
#include <string_view>
#include <vector>

namespace helios
{

namespace
{

constexpr int MaximumScans = 500;         // programs write ten; more are made to take time
constexpr int ExifMarker = JPEG_APP0 + 1; // and its longest segment
constexpr unsigned LongestSegment = 0xffff;
constexpr double BytesPerCoefficient = 2.0; // a progressive image is kept as a whole

class JpegDecoder final : public ImageDecoder
{
public:
  explicit JpegDecoder(const ImageFile& file);
  ~JpegDecoder() override { jpeg_destroy_decompress(&this->Jpeg); }

  const char* GetFormat() const override { return "JPEG"; }
  Status ReadHeader(StoredImage& stored) override;
  Status ReadPixels(const ImageRows& rows) override;

private:
  static JpegDecoder* Get(j_common_ptr jpeg)
  {
    return static_cast<JpegDecoder*>(jpeg->client_data);
  }
  [[noreturn]] static void Fail(j_common_ptr jpeg);
  static void Warn(j_common_ptr jpeg, int level);
  static void CountScans(j_common_ptr jpeg);
  static void Ignore(j_common_ptr) {}

  bool Start();
  bool ParseHeader();
  bool Decode(const ImageRows& rows);
  bool HasInk() const { return this->Jpeg.out_color_space == JCS_CMYK; }
  void ConvertInk(unsigned char* row) const;
  Status MakeError() const
  {
    return Status::Error(std::string("cannot be read: ") + this->Message);
  }

  std::FILE* File;
  jpeg_decompress_struct Jpeg{};
  jpeg_error_mgr Errors{};
  jpeg_progress_mgr Progress{};
  std::jmp_buf Return;
  std::vector<unsigned char> Ink; // cyan magenta yellow black of a row
  char Message[JMSG_LENGTH_MAX] = {};
};

JpegDecoder::JpegDecoder(const ImageFile& file)
  : File(file.File)
{
  this->Jpeg.err = jpeg_std_error(&this->Errors);
  this->Errors.error_exit = JpegDecoder::Fail;
  this->Errors.emit_message = JpegDecoder::Warn;
  this->Errors.output_message = JpegDecoder::Ignore;
  this->Jpeg.client_data = this;
}

void JpegDecoder::Fail(j_common_ptr jpeg)
{
  JpegDecoder* self = JpegDecoder::Get(jpeg);
  jpeg->err->format_message(jpeg, self->Message);
  std::longjmp(self->Return, 1);
}

// Warnings (below 0) are about data that are damaged and guessed; others are traces.
void JpegDecoder::Warn(j_common_ptr jpeg, int level)
{
  if (level < 0)
  {
    JpegDecoder::Fail(jpeg);
  }
}

void JpegDecoder::CountScans(j_common_ptr jpeg)
{
  JpegDecoder* self = JpegDecoder::Get(jpeg);
  if (self->Jpeg.input_scan_number > MaximumScans)
  {
    std::snprintf(self->Message, sizeof(self->Message), "it has more than %d scans", MaximumScans);
    std::longjmp(self->Return, 1);
  }
}

bool JpegDecoder::Start()
{
  if (setjmp(this->Return))
  {
    return false;
  }
  jpeg_create_decompress(&this->Jpeg);
  this->Progress.progress_monitor = JpegDecoder::CountScans;
  this->Jpeg.progress = &this->Progress;
  this->Jpeg.client_data = this;
  jpeg_stdio_src(&this->Jpeg, this->File);
  jpeg_save_markers(&this->Jpeg, ExifMarker, LongestSegment);
  return true;
}

bool JpegDecoder::ParseHeader()
{
  if (setjmp(this->Return))
  {
    return false;
  }
  jpeg_read_header(&this->Jpeg, TRUE);
  return true;
}

Status JpegDecoder::ReadHeader(StoredImage& stored)
{
  if (!this->Start() || !this->ParseHeader())
  {
    return this->MakeError();
  }
  stored.Columns = this->Jpeg.image_width;
  stored.Rows = this->Jpeg.image_height;
  stored.ExtraBytesPerPixel =
    jpeg_has_multiple_scans(&this->Jpeg) ? BytesPerCoefficient * this->Jpeg.num_components : 0.0;
  for (jpeg_saved_marker_ptr marker = this->Jpeg.marker_list; marker; marker = marker->next)
  {
    const std::string_view segment(
      reinterpret_cast<const char*>(marker->data), marker->data_length);
    if (const int orientation = FindExifOrientation(segment); orientation != 0)
    {
      stored.ExifOrientation = orientation;
    }
  }
  const J_COLOR_SPACE space = this->Jpeg.jpeg_color_space;
  const bool isInk = space == JCS_CMYK || space == JCS_YCCK;
  if (space == JCS_UNKNOWN)
  {
    return Status::Error(
      "has " + std::to_string(this->Jpeg.num_components) + " channels whose colours are not known");
  }
  this->Jpeg.out_color_space = isInk ? JCS_CMYK : JCS_RGB;
  return {};
}

// Converts the ink of a row to colours. Programs of Adobe, which leave a mark, store how much is
// left of the light.
void JpegDecoder::ConvertInk(unsigned char* row) const
{
  const int flip = this->Jpeg.saw_Adobe_marker ? 0 : 255;
  for (std::size_t i = 0; i < this->Ink.size(); i += 4)
  {
    const int black = this->Ink[i + 3] ^ flip;
    for (std::size_t c = 0; c < 3; ++c)
    {
      *row++ = static_cast<unsigned char>(((this->Ink[i + c] ^ flip) * black + 127) / 255);
    }
  }
}

bool JpegDecoder::Decode(const ImageRows& rows)
{
  if (setjmp(this->Return))
  {
    return false;
  }
  jpeg_start_decompress(&this->Jpeg);
  while (this->Jpeg.output_scanline < this->Jpeg.output_height)
  {
    unsigned char* row = rows.Get(this->Jpeg.output_scanline);
    JSAMPROW target = this->HasInk() ? this->Ink.data() : row;
    jpeg_read_scanlines(&this->Jpeg, &target, 1);
    if (this->HasInk())
    {
      this->ConvertInk(row);
    }
  }
  jpeg_finish_decompress(&this->Jpeg);
  return true;
}

Status JpegDecoder::ReadPixels(const ImageRows& rows)
{
  if (this->HasInk())
  {
    this->Ink.resize(4 * static_cast<std::size_t>(this->Jpeg.image_width));
  }
  return this->Decode(rows) ? Status() : this->MakeError();
}

} // namespace

std::unique_ptr<ImageDecoder> MakeJpegDecoder(const ImageFile& file)
{
  return std::make_unique<JpegDecoder>(file);
}

} // namespace helios
