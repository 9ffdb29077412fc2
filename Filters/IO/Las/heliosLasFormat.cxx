// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLasFormat.h"

#include "heliosStatus.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "LAS files are little-endian"
#endif

namespace helios
{

namespace
{

///@{
/// Offsets of the header fields.
constexpr std::size_t AtEncoding = 6;
constexpr std::size_t AtVersion = 24;
constexpr std::size_t AtSystem = 26;
constexpr std::size_t AtSoftware = 58;
constexpr std::size_t AtDay = 90;
constexpr std::size_t AtYear = 92;
constexpr std::size_t AtHeaderSize = 94;
constexpr std::size_t AtPointsBegin = 96;
constexpr std::size_t AtNumberOfRecords = 100;
constexpr std::size_t AtFormat = 104;
constexpr std::size_t AtPointLength = 105;
constexpr std::size_t AtOldCount = 107;
constexpr std::size_t AtScale = 131;
constexpr std::size_t AtOffset = 155;
constexpr std::size_t AtBox = 179;
constexpr std::size_t AtWavesBegin = 227;
constexpr std::size_t AtExtendedBegin = 235;
constexpr std::size_t AtNumberOfExtended = 243;
constexpr std::size_t AtCount = 247;
constexpr std::size_t AtByReturn = 255;
constexpr std::size_t AtTimeOffset = 391;
///@}

constexpr std::size_t TextSize = 32;
constexpr std::string_view Signature = "LASF";
constexpr std::uint32_t HeaderSizes[] = { 227, 227, 227, 235, 375, 393 }; // LAS 1.0 to 1.5
constexpr int LargestMinor = 5;
constexpr double TimeOffsetUnit = 1e6; // [s]

///@{
/// Coordinates outside this range are damaged: all identical, or beyond unit precision of double.
constexpr double SmallestScale = 1e-15;
constexpr double LargestCoordinate = 1e15;
///@}

constexpr int CompressedBits = 0xC0; // bits of the format in files of LASzip
constexpr int CompressedBit = 0x80;  // the one that is written

///@{
/// An entry of Extra Bytes.
constexpr std::size_t ExtraSize = 192;
constexpr std::size_t AtExtraType = 2;
constexpr std::size_t AtExtraOptions = 3;
constexpr std::size_t AtExtraName = 4;
constexpr std::size_t AtExtraNoData = 40;
constexpr std::size_t AtExtraScale = 112;
constexpr std::size_t AtExtraOffset = 136;
constexpr std::size_t AtExtraDescription = 160;
constexpr int NoDataOption = 1;
constexpr int ScaleOption = 8;
constexpr int OffsetOption = 16;
constexpr int TypeSizes[] = { 1, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8 };
///@}

void StoreText(std::string& bytes, std::size_t at, std::size_t size, const std::string& text)
{
  bytes.replace(at, std::min(size, text.size()), text, 0, size);
}

template <typename T>
void Store(std::string& bytes, std::size_t at, T value)
{
  StoreLas(bytes.data() + at, value);
}

template <typename T>
T Get(std::string_view bytes, std::size_t at)
{
  return LoadLas<T>(bytes.data() + at);
}

std::string Show(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

bool IsFinite(double value)
{
  return std::isfinite(value);
}

/// Returns the values of 8 bytes that stand for no value: integers with or without sign, or double.
std::array<double, 3> GetNoData(std::string_view entry, int type)
{
  constexpr int firstFloat = 9;
  std::array<double, 3> values{};
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    const std::size_t at = AtExtraNoData + 8 * k;
    values[k] = type >= firstFloat ? Get<double>(entry, at)
      : type % 2 == 1              ? static_cast<double>(Get<std::uint64_t>(entry, at))
                                   : static_cast<double>(Get<std::int64_t>(entry, at));
  }
  return values;
}

std::array<double, 3> GetTriple(std::string_view bytes, std::size_t at)
{
  return { Get<double>(bytes, at), Get<double>(bytes, at + 8), Get<double>(bytes, at + 16) };
}

} // namespace

std::string GetLasText(std::string_view bytes)
{
  return std::string(bytes.substr(0, bytes.find('\0')));
}

LasPointForm GetLasPointForm(int format)
{
  static const LasPointForm forms[] = { { 20, false, -1, -1, -1, -1 },
    { 28, false, 20, -1, -1, -1 }, { 26, false, -1, 20, -1, -1 }, { 34, false, 20, 28, -1, -1 },
    { 57, false, 20, -1, -1, 28 }, { 63, false, 20, 28, -1, 34 }, { 30, true, 22, -1, -1, -1 },
    { 36, true, 22, 30, -1, -1 }, { 38, true, 22, 30, 36, -1 }, { 59, true, 22, -1, -1, 30 },
    { 67, true, 22, 30, 36, 38 } };
  return format >= 0 && format <= 10 ? forms[format] : LasPointForm();
}

void LasSummary::Add(const char* records, std::int64_t count, std::int64_t length)
{
  for (const char* record = records; record != records + count * length; record += length)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto number = LoadLas<std::int32_t>(record + 4 * axis);
      const bool isFirst = this->Count == 0;
      this->Minimum[axis] = isFirst ? number : std::min(this->Minimum[axis], number);
      this->Maximum[axis] = isFirst ? number : std::max(this->Maximum[axis], number);
    }
    const int number = record[14] & 15;
    this->ByReturn[number > 0 ? number - 1 : 0] += number > 0 ? 1 : 0;
    ++this->Count;
  }
}

void LasSummary::Add(const LasSummary& other)
{
  for (int axis = 0; axis < 3 && other.Count > 0; ++axis)
  {
    const bool isFirst = this->Count == 0;
    this->Minimum[axis] =
      isFirst ? other.Minimum[axis] : std::min(this->Minimum[axis], other.Minimum[axis]);
    this->Maximum[axis] =
      isFirst ? other.Maximum[axis] : std::max(this->Maximum[axis], other.Maximum[axis]);
  }
  this->Count += other.Count;
  for (std::size_t i = 0; i < this->ByReturn.size(); ++i)
  {
    this->ByReturn[i] += other.ByReturn[i];
  }
}

std::string LasHeader::Encode() const
{
  std::string bytes(Size14, '\0');
  bytes.replace(0, Signature.size(), Signature);
  Store(bytes, AtEncoding, static_cast<std::uint16_t>(this->Encoding));
  bytes[AtVersion] = 1;
  bytes[AtVersion + 1] = 4;
  StoreText(bytes, AtSystem, TextSize, this->System);
  StoreText(bytes, AtSoftware, TextSize, this->Software);
  Store(bytes, AtDay, static_cast<std::uint16_t>(this->CreationDay));
  Store(bytes, AtYear, static_cast<std::uint16_t>(this->CreationYear));
  Store(bytes, AtHeaderSize, static_cast<std::uint16_t>(Size14));
  Store(bytes, AtPointsBegin, this->PointsBegin);
  Store(bytes, AtNumberOfRecords, this->NumberOfRecords);
  bytes[AtFormat] = static_cast<char>(this->Format | (this->IsCompressed ? CompressedBit : 0));
  Store(bytes, AtPointLength, static_cast<std::uint16_t>(this->PointLength));
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool hasBox = this->Points.Count > 0;
    const std::int32_t maximum = this->Points.Maximum[axis];
    const std::int32_t minimum = this->Points.Minimum[axis];
    Store(bytes, AtScale + 8 * axis, this->Scale[axis]);
    Store(bytes, AtOffset + 8 * axis, this->Offset[axis]);
    Store(bytes, AtBox + 16 * axis, hasBox ? this->GetCoordinate(maximum, axis) : 0.0);
    Store(bytes, AtBox + 16 * axis + 8, hasBox ? this->GetCoordinate(minimum, axis) : 0.0);
  }
  Store(bytes, AtCount, this->Points.Count);
  for (std::size_t i = 0; i < this->Points.ByReturn.size(); ++i)
  {
    Store(bytes, AtByReturn + 8 * i, this->Points.ByReturn[i]);
  }
  return bytes;
}

Status LasHeader::Decode(std::string_view bytes)
{
  if (bytes.substr(0, Signature.size()) != Signature)
  {
    return Status::Error("is not a LAS file: it does not start with LASF");
  }
  if (bytes.size() < HeaderSizes[0])
  {
    return Status::Error(
      "ends within its header, after " + std::to_string(bytes.size()) + " bytes");
  }
  const int major = static_cast<unsigned char>(bytes[AtVersion]);
  this->Minor = static_cast<unsigned char>(bytes[AtVersion + 1]);
  if (major != 1 || this->Minor > LargestMinor)
  {
    return Status::Error("is LAS " + std::to_string(major) + "." + std::to_string(this->Minor) +
      "; versions 1.0 to 1.5 can be read");
  }
  this->HeaderSize = Get<std::uint16_t>(bytes, AtHeaderSize);
  if (this->HeaderSize < HeaderSizes[this->Minor])
  {
    return Status::Error("has a header of " + std::to_string(this->HeaderSize) + " bytes; LAS 1." +
      std::to_string(this->Minor) + " has " + std::to_string(HeaderSizes[this->Minor]));
  }
  if (bytes.size() < HeaderSizes[this->Minor])
  {
    return Status::Error(
      "ends within its header, after " + std::to_string(bytes.size()) + " bytes");
  }
  // the bytes are reserved in LAS 1.0 and 1.1
  this->Encoding = this->Minor < 2 ? 0 : Get<std::uint16_t>(bytes, AtEncoding);
  this->Epoch = this->DecodeEpoch(bytes);
  this->System = GetLasText(bytes.substr(AtSystem, TextSize));
  this->Software = GetLasText(bytes.substr(AtSoftware, TextSize));
  this->CreationDay = Get<std::uint16_t>(bytes, AtDay);
  this->CreationYear = Get<std::uint16_t>(bytes, AtYear);
  this->PointsBegin = Get<std::uint32_t>(bytes, AtPointsBegin);
  this->NumberOfRecords = Get<std::uint32_t>(bytes, AtNumberOfRecords);
  this->Format = static_cast<unsigned char>(bytes[AtFormat]) & ~CompressedBits;
  this->IsCompressed = (bytes[AtFormat] & CompressedBits) != 0;
  this->PointLength = Get<std::uint16_t>(bytes, AtPointLength);
  this->Scale = GetTriple(bytes, AtScale);
  this->Offset = GetTriple(bytes, AtOffset);
  const Status status = this->CheckNumbers();
  return status.IsOk() ? this->DecodeCounts(bytes) : status;
}

//------------------------------------------------------------------------------
double LasHeader::DecodeEpoch(std::string_view bytes) const
{
  if (!(this->Encoding & StandardTime))
  {
    return 0.0;
  }
  return this->Minor >= LargestMinor && (this->Encoding & OffsetTime)
    ? TimeOffsetUnit * Get<std::uint16_t>(bytes, AtTimeOffset)
    : StandardTimeOffset;
}

//------------------------------------------------------------------------------
Status LasHeader::CheckNumbers() const
{
  const LasPointForm form = GetLasPointForm(this->Format);
  if (!form.IsKnown())
  {
    return Status::Error(
      "has points of format " + std::to_string(this->Format) + "; 0 to 10 can be read");
  }
  if (this->PointLength < form.Length)
  {
    return Status::Error("has points of " + std::to_string(this->PointLength) + " bytes; format " +
      std::to_string(this->Format) + " needs " + std::to_string(form.Length));
  }
  if (this->PointsBegin < this->HeaderSize)
  {
    return Status::Error(
      "has points from byte " + std::to_string(this->PointsBegin) + " on, within its header");
  }
  return this->CheckScaling();
}

Status LasHeader::CheckScaling() const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double step = std::abs(this->Scale[axis]);
    const double largest = std::ldexp(step, 31) + std::abs(this->Offset[axis]);
    if (!(step >= SmallestScale) || !(largest <= LargestCoordinate))
    {
      return Status::Error("has a scale of " + Show(this->Scale[axis]) + " and an offset of " +
        Show(this->Offset[axis]) + ", which give no valid coordinates: a scale is at least " +
        Show(SmallestScale) + ", a coordinate at most " + Show(LargestCoordinate));
    }
  }
  return {};
}

Status LasHeader::DecodeCounts(std::string_view bytes)
{
  const auto old = Get<std::uint32_t>(bytes, AtOldCount);
  this->Points.Count = old;
  this->WavesBegin = this->Minor < 3 ? 0 : Get<std::uint64_t>(bytes, AtWavesBegin);
  if (this->Minor < 4)
  {
    return {};
  }
  this->ExtendedBegin = Get<std::uint64_t>(bytes, AtExtendedBegin);
  this->NumberOfExtended = Get<std::uint32_t>(bytes, AtNumberOfExtended);
  this->Points.Count = Get<std::uint64_t>(bytes, AtCount);
  if (old != 0 && old != this->Points.Count)
  {
    return Status::Error("states two numbers of points, " + std::to_string(this->Points.Count) +
      " and " + std::to_string(old));
  }
  return {};
}

std::string LasRecord::Encode() const
{
  std::string bytes(HeadSize, '\0');
  StoreText(bytes, 2, 16, this->User);
  Store(bytes, 18, static_cast<std::uint16_t>(this->Id));
  Store(bytes, 20, static_cast<std::uint16_t>(this->Data.size()));
  StoreText(bytes, 22, TextSize, this->Description);
  return bytes + this->Data;
}

std::string LasRecord::EncodeExtended() const
{
  std::string bytes(ExtendedHeadSize, '\0');
  StoreText(bytes, 2, 16, this->User);
  Store(bytes, 18, static_cast<std::uint16_t>(this->Id));
  Store(bytes, 20, static_cast<std::uint64_t>(this->Data.size()));
  StoreText(bytes, 28, TextSize, this->Description);
  return bytes + this->Data;
}

std::string EncodeLasExtras(const std::vector<LasExtra>& extras)
{
  std::string data;
  for (const LasExtra& extra : extras)
  {
    std::string entry(ExtraSize, '\0');
    entry[AtExtraType] = static_cast<char>(extra.Type);
    StoreText(entry, AtExtraName, TextSize, extra.Name);
    StoreText(entry, AtExtraDescription, TextSize, extra.Description);
    data += entry;
  }
  return data;
}

Status DecodeLasExtras(std::string_view data, std::vector<LasExtra>& extras)
{
  if (data.size() % ExtraSize != 0)
  {
    return Status::Error("has an Extra Bytes record of " + std::to_string(data.size()) +
      " bytes, which is not a multiple of " + std::to_string(ExtraSize));
  }
  for (; !data.empty(); data.remove_prefix(ExtraSize))
  {
    LasExtra extra;
    const int type = static_cast<unsigned char>(data[AtExtraType]);
    const int options = static_cast<unsigned char>(data[AtExtraOptions]);
    extra.Name = GetLasText(data.substr(AtExtraName, TextSize));
    if (type > 30)
    {
      return Status::Error("has Extra Bytes \"" + extra.Name + "\" of type " +
        std::to_string(type) + "; types 0 to 30 can be read");
    }
    extra.Description = GetLasText(data.substr(AtExtraDescription, TextSize));
    extra.Type = type == 0 ? 0 : (type - 1) % 10 + 1;
    extra.Components = type == 0 ? options : (type - 1) / 10 + 1;
    extra.Size = extra.Components * TypeSizes[extra.Type];
    extra.IsScaled = type != 0 && (options & (ScaleOption | OffsetOption)) != 0;
    if (options & ScaleOption)
    {
      extra.Scale = GetTriple(data, AtExtraScale);
    }
    extra.HasNoData = type != 0 && (options & NoDataOption) != 0;
    if (extra.HasNoData)
    {
      extra.NoData = GetNoData(data, extra.Type);
    }
    if (options & OffsetOption)
    {
      extra.Offset = GetTriple(data, AtExtraOffset);
    }
    const bool isGood = std::all_of(extra.Scale.begin(), extra.Scale.end(), IsFinite) &&
      std::all_of(extra.Offset.begin(), extra.Offset.end(), IsFinite);
    if (!isGood)
    {
      return Status::Error(
        "has Extra Bytes \"" + extra.Name + "\" whose scale or offset is not a number");
    }
    extras.push_back(extra);
  }
  return {};
}

} // namespace helios
