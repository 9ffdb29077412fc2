// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLazForm.h"

#include <algorithm>
#include <numeric>

namespace helios
{

namespace
{

constexpr std::size_t ItemsBegin = 34; // in the data of the record
constexpr std::size_t ItemSize = 6;

/// The ways in which points are compressed; 0: they are not.
enum Compressor
{
  Pointwise = 1,
  PointwiseChunked = 2,
  Layered = 3
};

/// A type of items, as LASzip numbers them.
struct ItemType
{
  int Type;
  int Size; ///< [bytes]; 0: any
  bool IsLayered;
  int Layers; ///< 0: one a byte, if it has layers
  int FirstVersion;
  int LastVersion;
  int Written; ///< version
};

constexpr int BytesType = 0;
constexpr int LayeredBytesType = 14;
constexpr ItemType Types[] = { { BytesType, 0, false, 0, 1, 2, 2 }, { 6, 20, false, 0, 1, 2, 2 },
  { 7, 8, false, 0, 1, 2, 2 }, { 8, 6, false, 0, 1, 2, 2 }, { 9, 29, false, 0, 1, 1, 1 },
  { 10, 30, true, 9, 2, 4, 3 }, { 11, 6, true, 1, 2, 4, 3 }, { 12, 8, true, 2, 2, 4, 3 },
  { 13, 29, true, 1, 3, 4, 3 }, { LayeredBytesType, 0, true, 0, 2, 4, 3 } };

/// Items of the point formats, without Extra Bytes.
const std::vector<int> FormatItems[] = { { 6 }, { 6, 7 }, { 6, 8 }, { 6, 7, 8 }, { 6, 7, 9 },
  { 6, 7, 8, 9 }, { 10 }, { 10, 11 }, { 10, 12 }, { 10, 13 }, { 10, 12, 13 } };

const ItemType* FindType(int type)
{
  const auto* found = std::find_if(
    std::begin(Types), std::end(Types), [type](const ItemType& row) { return row.Type == type; });
  return found == std::end(Types) ? nullptr : found;
}

template <typename T>
void Append(std::string& bytes, T value)
{
  bytes += EncodeLas(value);
}

Status CheckItem(const LazItem& item, bool isLayered)
{
  const ItemType* type = FindType(item.Type);
  const bool isKnown = type && type->IsLayered == isLayered && item.Size > 0 &&
    (type->Size == 0 || type->Size == item.Size) && item.Version >= type->FirstVersion &&
    item.Version <= type->LastVersion;
  return isKnown
    ? Status()
    : Status::Error("has a compressed item of type " + std::to_string(item.Type) + ", version " +
        std::to_string(item.Version) + ", with " + std::to_string(item.Size) +
        " bytes, which cannot be read; decompress it with the program that wrote it");
}

/// Checks that the items are those of a point format, and then Extra Bytes.
Status CheckItems(const LazForm& form, const LasHeader& header)
{
  std::vector<int> types;
  int size = 0;
  for (const LazItem& item : form.Items)
  {
    if (Status status = CheckItem(item, form.IsLayered); !status.IsOk())
    {
      return status;
    }
    size += item.Size;
    types.push_back(item.Type);
  }
  if (!types.empty() && (types.back() == BytesType || types.back() == LayeredBytesType))
  {
    types.pop_back();
  }
  return types == FormatItems[header.Format] && size == header.PointLength
    ? Status()
    : Status::Error("has compressed items of " + std::to_string(size) +
        " bytes that are not the fields of its points, format " + std::to_string(header.Format) +
        " with " + std::to_string(header.PointLength) + " bytes; it is damaged, copy it again");
}

} // namespace

LazForm LazForm::Make(int format, int pointLength)
{
  LazForm form;
  form.IsLayered = GetLasPointForm(format).IsLong;
  form.PointLength = pointLength;
  int rest = pointLength;
  for (const int type : FormatItems[format])
  {
    form.Items.push_back({ type, FindType(type)->Size, FindType(type)->Written });
    rest -= form.Items.back().Size;
  }
  if (rest > 0)
  {
    const int type = form.IsLayered ? LayeredBytesType : BytesType;
    form.Items.push_back({ type, rest, FindType(type)->Written });
  }
  return form;
}

LasRecord LazForm::Encode() const
{
  std::string data;
  Append<std::uint16_t>(data, this->IsLayered ? Layered : PointwiseChunked);
  Append<std::uint16_t>(data, 0); // arithmetic coder
  Append<std::uint8_t>(data, 3);  // version of LASzip: 3.5, revision 1
  Append<std::uint8_t>(data, 5);
  Append<std::uint16_t>(data, 1);
  Append<std::uint32_t>(data, 0); // options
  Append<std::uint32_t>(data, this->ChunkSize);
  Append<std::int64_t>(data, -1); // special extended records: number, place
  Append<std::int64_t>(data, -1);
  Append<std::uint16_t>(data, static_cast<std::uint16_t>(this->Items.size()));
  for (const LazItem& item : this->Items)
  {
    Append<std::uint16_t>(data, static_cast<std::uint16_t>(item.Type));
    Append<std::uint16_t>(data, static_cast<std::uint16_t>(item.Size));
    Append<std::uint16_t>(data, static_cast<std::uint16_t>(item.Version));
  }
  return { User, RecordId, "compression by LASzip", data };
}

Status LazForm::Decode(std::string_view data, const LasHeader& header)
{
  const std::size_t count =
    data.size() < ItemsBegin ? 0 : LoadLas<std::uint16_t>(data.data() + ItemsBegin - 2);
  if (data.size() < ItemsBegin || data.size() < ItemsBegin + ItemSize * count)
  {
    return Status::Error("has a record of LASzip of " + std::to_string(data.size()) +
      " bytes, which is cut off; copy it again");
  }
  const int compressor = LoadLas<std::uint16_t>(data.data());
  const int coder = LoadLas<std::uint16_t>(data.data() + 2);
  if (compressor < Pointwise || compressor > Layered || coder != 0)
  {
    return Status::Error("is compressed by compressor " + std::to_string(compressor) + ", coder " +
      std::to_string(coder) +
      ", which cannot be read; decompress it with the program that wrote it");
  }
  this->IsLayered = compressor == Layered;
  this->HasChunks = compressor != Pointwise;
  this->ChunkSize = LoadLas<std::uint32_t>(data.data() + 12);
  this->PointLength = header.PointLength;
  this->Items.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    const char* item = data.data() + ItemsBegin + ItemSize * i;
    this->Items.push_back({ LoadLas<std::uint16_t>(item), LoadLas<std::uint16_t>(item + 2),
      LoadLas<std::uint16_t>(item + 4) });
  }
  return CheckItems(*this, header);
}

std::uint64_t LazForm::GetNumberOfLayers() const
{
  return std::accumulate(this->Items.begin(), this->Items.end(), std::uint64_t(0),
    [](std::uint64_t sum, const LazItem& item)
    {
      const int layers = FindType(item.Type)->Layers;
      return sum + static_cast<std::uint64_t>(layers > 0 ? layers : item.Size);
    });
}

std::uint64_t LazForm::GetHeadSize() const
{
  return static_cast<std::uint64_t>(this->PointLength) + 4 * (1 + this->GetNumberOfLayers());
}

Status LazForm::DecodeHead(std::string_view head, std::uint64_t room, LazChunk& chunk) const
{
  const std::uint64_t size = this->GetHeadSize();
  if (head.size() < size || room < size)
  {
    return Status::Error("has a chunk of " + std::to_string(room) + " bytes that is cut off");
  }
  const char* numbers = head.data() + this->PointLength;
  chunk.Points = LoadLas<std::uint32_t>(numbers);
  chunk.Bytes = size;
  for (std::uint64_t i = 1; i <= this->GetNumberOfLayers(); ++i)
  {
    chunk.Bytes += LoadLas<std::uint32_t>(numbers + 4 * i);
  }
  return chunk.Bytes <= room
    ? Status()
    : Status::Error("has a chunk with layers of " + std::to_string(chunk.Bytes) + " bytes in " +
        std::to_string(room) + " bytes");
}

} // namespace helios
