// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLazCodec.h"

#include <arithmeticdecoder.hpp>
#include <arithmeticencoder.hpp>
#include <bytestreamin_array.hpp>
#include <bytestreamout_array.hpp>
#include <integercompressor.hpp>
#include <lasreadpoint.hpp>
#include <laswritepoint.hpp>
#include <laszip.hpp>

#include <vtkSMPTools.h>

#include <algorithm>
#include <cstring>
#include <new>

namespace helios
{

namespace
{

constexpr std::uint64_t PointsPerRound = 4096;
constexpr std::size_t TableHead = 8;   // version, number of chunks
constexpr std::size_t PointSize = 64;  // fields of a point in LASzip, which are more than in a file
constexpr std::size_t LongTypeAt = 22; // there: whether a point has the fields of formats 6 to 10

/// The form in LASzip. A chunk is a file of one chunk, for which no table is needed.
void SetForm(const LazForm& form, std::uint32_t chunkSize, LASzip& zip)
{
  zip.compressor =
    form.IsLayered ? LASZIP_COMPRESSOR_LAYERED_CHUNKED : LASZIP_COMPRESSOR_POINTWISE_CHUNKED;
  zip.coder = LASZIP_CODER_ARITHMETIC;
  zip.chunk_size = chunkSize;
  zip.num_items = static_cast<unsigned short>(form.Items.size());
  zip.items = new LASitem[form.Items.size()]; // LASzip deletes them
  for (std::size_t i = 0; i < form.Items.size(); ++i)
  {
    zip.items[i].type = static_cast<LASitem::Type>(form.Items[i].Type);
    zip.items[i].size = static_cast<unsigned short>(form.Items[i].Size);
    zip.items[i].version = static_cast<unsigned short>(form.Items[i].Version);
  }
}

/// A point as LASzip has it, item by item.
class Point
{
public:
  explicit Point(const LazForm& form)
  {
    for (const LazItem& item : form.Items)
    {
      this->Fields.emplace_back(std::max(PointSize, static_cast<std::size_t>(item.Size)));
    }
    for (std::vector<U8>& field : this->Fields)
    {
      this->Items.push_back(field.data());
    }
    this->Items[0][LongTypeAt] = form.IsLayered ? 1 : 0;
  }

  U8** Get() { return this->Items.data(); }

private:
  std::vector<std::vector<U8>> Fields;
  std::vector<U8*> Items;
};

/// Calls an action of LASzip, whose errors are false, numbers, or lack of memory.
template <typename ActionT>
Status Call(const char* what, const ActionT& action)
{
  try
  {
    return action() ? Status() : Status::Error(what);
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (...)
  {
    return Status::Error(what);
  }
}

const U8* GetBytes(std::string_view bytes)
{
  return reinterpret_cast<const U8*>(bytes.data());
}

} // namespace

Status EncodeLazChunk(
  const LazForm& form, const char* records, std::uint64_t count, std::string& bytes)
{
  const auto encode = [&]
  {
    LASzip zip;
    SetForm(form, static_cast<std::uint32_t>(count), zip);
    ByteStreamInArrayLE in(
      reinterpret_cast<const U8*>(records), static_cast<I64>(count) * form.PointLength);
    ByteStreamOutArrayLE out(static_cast<I64>(count) * form.PointLength / 4 + 4096);
    LASreadPoint reader;
    LASwritePoint writer;
    if (!reader.setup(zip.num_items, zip.items) || !reader.init(&in) ||
      !writer.setup(zip.num_items, zip.items, &zip) || !writer.init(&out))
    {
      return false;
    }
    Point point(form);
    for (std::uint64_t i = 0; i < count; ++i)
    {
      if (!reader.read(point.Get()) || !writer.write(point.Get()))
      {
        return false;
      }
    }
    if (!writer.done()) // writes a table, too, and before the chunk its place
    {
      return false;
    }
    const auto* begin = reinterpret_cast<const char*>(out.getData());
    bytes.assign(begin + LazTablePlaceSize, begin + LoadLas<std::uint64_t>(begin));
    return true;
  };
  return Call("points cannot be compressed", encode);
}

Status EncodeLazChunks(
  const LazForm& form, const char* records, std::uint64_t count, std::vector<LazBytes>& chunks)
{
  const auto length = static_cast<std::uint64_t>(form.PointLength);
  chunks.assign((count + LazPointsPerChunk - 1) / LazPointsPerChunk, LazBytes());
  std::vector<Status> states(chunks.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(chunks.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const std::uint64_t first = i * LazPointsPerChunk;
        chunks[i].Points = std::min(LazPointsPerChunk, count - first);
        states[i] =
          EncodeLazChunk(form, records + first * length, chunks[i].Points, chunks[i].Bytes);
      }
    });
  const auto failed =
    std::find_if(states.begin(), states.end(), [](const Status& status) { return !status.IsOk(); });
  return failed == states.end() ? Status() : *failed;
}

/// The state of a decompression; members are destroyed before those that they use.
struct LazDecoder::Parts
{
  explicit Parts(const LazForm& form)
    : Fields(form)
    , Length(static_cast<std::uint64_t>(form.PointLength))
  {
  }

  std::string Bytes;
  LASzip Zip;
  ByteStreamInArrayLE In;
  ByteStreamOutArrayLE Out;
  LASreadPoint Reader;
  LASwritePoint Writer;
  Point Fields;
  std::uint64_t Length;
};

LazDecoder::LazDecoder() = default;
LazDecoder::~LazDecoder() = default;

Status LazDecoder::Open(const LazForm& form, std::string bytes, std::uint64_t points)
{
  if (form.IsLayered)
  {
    LazChunk chunk;
    if (const Status status = form.DecodeHead(bytes, bytes.size(), chunk); !status.IsOk())
    {
      return status;
    }
  }
  this->Own = std::make_unique<Parts>(form);
  Parts& own = *this->Own;
  own.Bytes = std::string(LazTablePlaceSize, '\0') + std::move(bytes); // no table: at place 0
  own.In.init(GetBytes(own.Bytes), static_cast<I64>(own.Bytes.size()));
  const auto open = [&own, &form, points]
  {
    SetForm(form,
      static_cast<std::uint32_t>(std::min<std::uint64_t>(points, LazForm::Variable - 1)), own.Zip);
    const U32 items = own.Zip.num_items;
    return own.Reader.setup(items, own.Zip.items, &own.Zip) && own.Reader.init(&own.In) &&
      own.Writer.setup(items, own.Zip.items, nullptr) && own.Writer.init(&own.Out);
  };
  return Call("has compressed items that cannot be read", open);
}

Status LazDecoder::Read(std::uint64_t count, char* records)
{
  Parts& own = *this->Own;
  const auto read = [&own, &count, &records]
  {
    for (std::uint64_t done = 0; done < count;)
    {
      const std::uint64_t round = std::min(PointsPerRound, count - done);
      own.Out.seek(0);
      for (std::uint64_t i = 0; i < round; ++i)
      {
        if (!own.Reader.read(own.Fields.Get()) || !own.Writer.write(own.Fields.Get()))
        {
          return false;
        }
      }
      std::memcpy(records + done * own.Length, own.Out.getData(), round * own.Length);
      done += round;
    }
    return true;
  };
  return Call("cannot be decompressed", read);
}

std::string EncodeLazTable(const std::vector<LazChunk>& chunks)
{
  std::string table(TableHead, '\0');
  StoreLas(table.data() + 4, static_cast<std::uint32_t>(chunks.size()));
  if (chunks.empty())
  {
    return table;
  }
  ByteStreamOutArrayLE out;
  ArithmeticEncoder encoder;
  encoder.init(&out);
  IntegerCompressor integers(&encoder, 32, 2);
  integers.initCompressor();
  LazChunk last;
  for (const LazChunk& chunk : chunks)
  {
    integers.compress(static_cast<I32>(last.Points), static_cast<I32>(chunk.Points), 0);
    integers.compress(static_cast<I32>(last.Bytes), static_cast<I32>(chunk.Bytes), 1);
    last = chunk;
  }
  encoder.done();
  const auto* begin = reinterpret_cast<const char*>(out.getData());
  return table.append(begin, static_cast<std::size_t>(out.getCurr()));
}

Status DecodeLazTable(std::string_view bytes, const LazForm& form, std::uint64_t points,
  std::uint64_t room, std::vector<LazChunk>& chunks)
{
  chunks.clear();
  const std::uint32_t version = bytes.size() < TableHead ? 1 : LoadLas<std::uint32_t>(bytes.data());
  if (version != 0)
  {
    return Status::Error("has a table of chunks that is cut off or damaged");
  }
  const auto count = LoadLas<std::uint32_t>(bytes.data() + 4);
  if (count > room / static_cast<std::uint64_t>(form.PointLength)) // a chunk has a whole point
  {
    return Status::Error("has a table of " + std::to_string(count) + " chunks for " +
      std::to_string(points) + " points in " + std::to_string(room) + " bytes");
  }
  const bool isVariable = form.ChunkSize == LazForm::Variable;
  const auto decode = [&]
  {
    ByteStreamInArrayLE in(
      GetBytes(bytes.substr(TableHead)), static_cast<I64>(bytes.size() - TableHead));
    ArithmeticDecoder decoder;
    decoder.init(&in);
    IntegerCompressor integers(&decoder, 32, 2);
    integers.initDecompressor();
    LazChunk last;
    std::uint64_t rest = points;
    for (std::uint32_t i = 0; i < count; ++i)
    {
      last.Points = isVariable
        ? static_cast<U32>(integers.decompress(static_cast<I32>(last.Points), 0))
        : std::min<std::uint64_t>(form.ChunkSize, rest);
      last.Bytes = static_cast<U32>(integers.decompress(static_cast<I32>(last.Bytes), 1));
      rest -= std::min(rest, last.Points);
      chunks.push_back(last);
    }
    return true;
  };
  return count == 0 ? Status() : Call("has a table of chunks that is cut off or damaged", decode);
}

} // namespace helios
