// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// PNM: P1 to P6, of 1 to 16 bits, by their description in Netpbm. No library that vtkHelios has reads
// all six.

#include "heliosImageDecoder.h"

#include <array>
#include <cstdio>
#include <string>
#include <vector>

namespace helios
{

namespace
{

constexpr std::int64_t Largest = 65535;          // value
constexpr std::int64_t LongestSide = 2147483647; // [pixels]

bool IsBlank(int c)
{
  return c == ' ' || (c >= '\t' && c <= '\r');
}

bool IsDigit(int c)
{
  return c >= '0' && c <= '9';
}

class PnmDecoder final : public ImageDecoder
{
public:
  explicit PnmDecoder(const ImageFile& file)
    : File(file.File)
  {
  }

  const char* GetFormat() const override { return "PNM"; }
  Status ReadHeader(StoredImage& stored) override;
  Status ReadPixels(const ImageRows& rows) override;

private:
  int GetNext();
  bool ReadNumber(std::int64_t largest, std::int64_t& number);
  bool ReadRow();
  bool ReadWords();
  bool ReadBytes();
  bool IsText() const { return this->Kind <= '3'; }
  bool IsBits() const { return this->Kind == '1' || this->Kind == '4'; }

  std::FILE* File;
  char Kind = 0; // '1' to '6'
  std::int64_t Columns = 0;
  std::int64_t Rows = 0;
  std::int64_t Maximum = 1; // value
  std::size_t Channels = 1;
  std::vector<unsigned> Values; // values of a row
  std::vector<unsigned char> Bytes;
  std::string Fault;
};

// Returns the next character that is not in a comment.
int PnmDecoder::GetNext()
{
  int c = std::getc(this->File);
  while (c == '#')
  {
    while (c != '\n' && c != '\r' && c != EOF)
    {
      c = std::getc(this->File);
    }
  }
  return c;
}

// Reads a number after blanks, and the character behind it.
bool PnmDecoder::ReadNumber(std::int64_t largest, std::int64_t& number)
{
  int c = this->GetNext();
  while (IsBlank(c))
  {
    c = this->GetNext();
  }
  if (!IsDigit(c))
  {
    this->Fault = c == EOF
      ? "is damaged: it ends too early"
      : "is damaged: it has byte " + std::to_string(c) + " in place of a number";
    return false;
  }
  number = 0;
  for (; IsDigit(c); c = this->GetNext())
  {
    number = 10 * number + (c - '0');
    if (number > largest)
    {
      this->Fault = "is damaged: it has a number above " + std::to_string(largest);
      return false;
    }
  }
  if (c != EOF && !IsBlank(c))
  {
    this->Fault = "is damaged: it has byte " + std::to_string(c) + " after a number";
    return false;
  }
  return true;
}

Status PnmDecoder::ReadHeader(StoredImage& stored)
{
  std::getc(this->File); // P
  this->Kind = static_cast<char>(std::getc(this->File));
  if (this->Kind == '7')
  {
    return Status::Error("is of kind P7 (PAM), which is not read");
  }
  this->Channels = this->Kind == '3' || this->Kind == '6' ? 3 : 1;
  if (!this->ReadNumber(LongestSide, this->Columns) || !this->ReadNumber(LongestSide, this->Rows) ||
    (!this->IsBits() && !this->ReadNumber(Largest, this->Maximum)))
  {
    return Status::Error(this->Fault);
  }
  if (this->Maximum < 1)
  {
    return Status::Error("is damaged: its largest value is 0");
  }
  stored.Columns = this->Columns;
  stored.Rows = this->Rows;
  const double samples = static_cast<double>(this->Channels) * stored.CountPixels();
  const double minimum = this->IsBits() ? 1.0 : 2.0; // a digit, and a blank
  const double bytes = this->IsBits() ? 0.125 : this->Maximum > 255 ? 2.0 : 1.0;
  stored.MinimumBytes = samples * (this->IsText() ? minimum : bytes) - 1.0;
  stored.ExtraBytesPerPixel = static_cast<double>(this->Channels * (sizeof(unsigned) + 2)) /
    static_cast<double>(this->Rows > 0 ? this->Rows : 1);
  return {};
}

bool PnmDecoder::ReadWords()
{
  for (unsigned& value : this->Values)
  {
    std::int64_t number = 0;
    if (this->Kind != '1')
    {
      if (!this->ReadNumber(this->Maximum, number))
      {
        return false;
      }
      value = static_cast<unsigned>(number);
      continue;
    }
    int c = this->GetNext(); // bits need no blanks
    while (IsBlank(c))
    {
      c = this->GetNext();
    }
    if (c != '0' && c != '1')
    {
      this->Fault = c == EOF
        ? "is damaged: it ends too early"
        : "is damaged: it has byte " + std::to_string(c) + " in place of a bit";
      return false;
    }
    value = static_cast<unsigned>(c - '0');
  }
  return true;
}

bool PnmDecoder::ReadBytes()
{
  const std::size_t count = this->Values.size();
  const std::size_t wide = this->Maximum > 255 ? 2 : 1;
  this->Bytes.resize(this->IsBits() ? (count + 7) / 8 : wide * count);
  if (std::fread(this->Bytes.data(), 1, this->Bytes.size(), this->File) != this->Bytes.size())
  {
    this->Fault = "is damaged: it ends too early";
    return false;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const unsigned value = this->IsBits() ? this->Bytes[i / 8] >> (7 - i % 8) & 1U
      : wide == 2 ? static_cast<unsigned>(this->Bytes[2 * i]) << 8U | this->Bytes[2 * i + 1]
                  : this->Bytes[i];
    if (value > static_cast<unsigned>(this->Maximum))
    {
      this->Fault = "is damaged: it has a value of " + std::to_string(value) + ", above " +
        std::to_string(this->Maximum);
      return false;
    }
    this->Values[i] = value;
  }
  return true;
}

bool PnmDecoder::ReadRow()
{
  return this->IsText() ? this->ReadWords() : this->ReadBytes();
}

Status PnmDecoder::ReadPixels(const ImageRows& rows)
{
  this->Values.resize(this->Channels * static_cast<std::size_t>(this->Columns));
  const auto maximum = static_cast<unsigned>(this->Maximum);
  const unsigned flip = this->IsBits() ? 255U : 0U; // a bit is ink
  for (std::int64_t row = 0; row < this->Rows; ++row)
  {
    if (!this->ReadRow())
    {
      return Status::Error(this->Fault);
    }
    unsigned char* pixel = rows.Get(row);
    for (std::size_t i = 0; i < this->Values.size(); ++i)
    {
      const unsigned value = ((255U * this->Values[i] + maximum / 2U) / maximum) ^ flip;
      for (std::size_t copies = this->Channels == 1 ? 3 : 1; copies > 0; --copies)
      {
        *pixel++ = static_cast<unsigned char>(value);
      }
    }
  }
  return {};
}

} // namespace

std::unique_ptr<ImageDecoder> MakePnmDecoder(const ImageFile& file)
{
  return std::make_unique<PnmDecoder>(file);
}

} // namespace helios
