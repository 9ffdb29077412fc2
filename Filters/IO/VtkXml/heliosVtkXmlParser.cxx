// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosVtkXmlParser.h"

#include "heliosStatus.h"

#include <vtkBase64InputStream.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkXMLDataElement.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <vector>

namespace helios
{

vtkStandardNewMacro(VtkXmlParser);

namespace
{

constexpr int LargestDepth = 32;            // VTK frees elements recursively
constexpr double LargestBlock = 2147483647; // [bytes], limit of the decompressors

/// Suppresses the messages of an object: a single error is reported, with the file name.
void Silence(vtkObject* object)
{
  vtkNew<vtkCallbackCommand> nothing;
  nothing->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  object->AddObserver(vtkCommand::ErrorEvent, nothing);
  object->AddObserver(vtkCommand::WarningEvent, nothing);
}

} // namespace

vtkXMLDataElement* VtkXmlParser::ParseFile(double size)
{
  this->Size = size;
  Silence(this);
  const bool isParsed = this->Parse() != 0;
  return isParsed && this->Problem.empty() ? this->GetRootElement() : nullptr;
}

void VtkXmlParser::StartElement(const char* name, const char** attributes)
{
  if (++this->Depth > LargestDepth && this->Problem.empty())
  {
    this->Problem = "has elements nested deeper than " + std::to_string(LargestDepth);
  }
  if (this->Problem.empty())
  {
    this->Superclass::StartElement(name, attributes);
  }
}

void VtkXmlParser::EndElement(const char* name)
{
  if (this->Problem.empty())
  {
    --this->Depth;
    this->Superclass::EndElement(name);
  }
}

int VtkXmlParser::ParseBuffer(const char* buffer, unsigned int count)
{
  return this->Problem.empty() && this->Superclass::ParseBuffer(buffer, count) &&
      this->Problem.empty()
    ? 1
    : 0;
}

void VtkXmlParser::ReportXmlParseError()
{
  if (this->Problem.empty())
  {
    this->Problem = "is not complete XML";
  }
}

bool VtkXmlParser::SetCompressorOf(vtkXMLDataElement* root)
{
  const char* name = root->GetAttribute("compressor");
  if (!name || !*name)
  {
    return true;
  }
  const vtkNew<vtkZLibDataCompressor> zlib;
  const vtkNew<vtkLZ4DataCompressor> lz4;
  const vtkNew<vtkLZMADataCompressor> lzma;
  for (vtkDataCompressor* each : { static_cast<vtkDataCompressor*>(zlib),
         static_cast<vtkDataCompressor*>(lz4), static_cast<vtkDataCompressor*>(lzma) })
  {
    if (std::strcmp(name, each->GetClassName()) == 0)
    {
      Silence(each);
      this->SetCompressor(each);
      return true;
    }
  }
  return false;
}

Status VtkXmlParser::CheckData(vtkXMLDataElement* array, double values, double bytes, double limit)
{
  const char* format = array->GetAttribute("format");
  const char* place = array->GetAttribute("offset");
  const bool isBinary = format && std::strcmp(format, "binary") == 0;
  if (!place && !isBinary)
  {
    this->Total = this->Size;
    return 2.0 * values - 1.0 > this->Size
      ? Status::Error("has more values than the file has room for")
      : Status();
  }
  if (!place)
  {
    this->SeekInlineDataPosition(array);
    this->InlineDataStream->SetStream(this->Stream);
    return this->CheckHead(
      this->InlineDataStream, bytes, this->Size - static_cast<double>(this->TellG()), limit);
  }
  vtkTypeInt64 offset = -1;
  const char* end = place + std::strlen(place);
  const auto [last, error] = std::from_chars(place, end, offset);
  const double room = this->Size - static_cast<double>(this->AppendedDataPosition);
  if (error != std::errc() || last != end || offset < 0 || static_cast<double>(offset) > room ||
    this->AppendedDataPosition <= 0)
  {
    return Status::Error(std::string("has offset=\"") + std::string(place).substr(0, 40) +
      "\", which is not within the data of the file");
  }
  this->SeekG(this->AppendedDataPosition + offset);
  this->AppendedDataStream->SetStream(this->Stream);
  return this->CheckHead(
    this->AppendedDataStream, bytes, room - static_cast<double>(offset), limit);
}

bool VtkXmlParser::ReadWords(vtkInputStream* stream, std::size_t count, vtkTypeUInt64* words)
{
  const std::size_t size = this->HeaderType == 64 ? 8 : 4;
  for (std::size_t i = 0; i < count; ++i)
  {
    vtkTypeUInt32 narrow = 0;
    void* word = size == 8 ? static_cast<void*>(words + i) : &narrow;
    if (stream->Read(word, size) < size)
    {
      return false;
    }
    this->PerformByteSwap(word, 1, size);
    words[i] = size == 8 ? words[i] : narrow;
  }
  return true;
}

Status VtkXmlParser::CheckHead(vtkInputStream* stream, double bytes, double room, double limit)
{
  constexpr const char* CutOff = "is cut off, or states a wrong size";
  room = vtkBase64InputStream::SafeDownCast(stream) ? 0.75 * room : room;
  const double wordSize = this->HeaderType == 64 ? 8.0 : 4.0;
  vtkTypeUInt64 head[3] = { 0, 0, 0 };
  stream->StartReading();
  const bool isCompressed = this->Compressor != nullptr;
  bool isGood = this->ReadWords(stream, isCompressed ? 3 : 1, head);
  double used = wordSize * (isCompressed ? 3.0 : 1.0);
  double total = static_cast<double>(head[0]);
  if (isGood && !isCompressed)
  {
    used += total;
  }
  else if (isGood)
  {
    const auto block = static_cast<double>(head[1]);
    const auto partial = static_cast<double>(head[2]);
    const auto blocks = static_cast<double>(head[0]);
    total = blocks * block + (partial > 0.0 ? partial - block : 0.0);
    used += blocks * wordSize;
    isGood =
      used <= room && (blocks == 0.0 || (block > 0.0 && block <= LargestBlock && partial <= block));
    total = blocks == 0.0 ? 0.0 : total;
    for (vtkTypeUInt64 i = 0; isGood && i < head[0]; ++i)
    {
      vtkTypeUInt64 size = 0;
      isGood = this->ReadWords(stream, 1, &size) && static_cast<double>(size) <= LargestBlock;
      used += static_cast<double>(size);
    }
    isGood = isGood && (blocks == 0.0 || block <= limit);
  }
  stream->EndReading();
  if (!isGood || used > room || (bytes > 0.0 && total > limit))
  {
    return Status::Error(CutOff);
  }
  this->Total = total;
  return total < bytes ? Status::Error("has fewer values than its counts state") : Status();
}

std::size_t VtkXmlParser::Read(
  vtkXMLDataElement* array, void* words, vtkTypeUInt64 first, std::size_t count, int type)
{
  const char* place = array->GetAttribute("offset");
  if (place)
  {
    return this->ReadAppendedData(std::strtoll(place, nullptr, 10), words, first, count, type);
  }
  const char* format = array->GetAttribute("format");
  const int isAscii = format && std::strcmp(format, "binary") == 0 ? 0 : 1;
  return this->ReadInlineData(array, isAscii, words, first, count, type);
}

bool VtkXmlParser::HasTexts(vtkXMLDataElement* array, double count)
{
  if (count == 0.0)
  {
    return true;
  }
  std::vector<char> text(static_cast<std::size_t>(this->Total));
  const std::size_t size = this->Read(array, text.data(), 0, text.size(), VTK_CHAR);
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(size, text.size()));
  return end != text.begin() && end[-1] == '\0' &&
    static_cast<double>(std::count(text.begin(), end, '\0')) == count;
}

bool VtkXmlParser::ReadNumber(
  vtkXMLDataElement* array, vtkTypeInt64 index, int type, double& number)
{
  unsigned char word[8] = {};
  if (this->Read(array, word, static_cast<vtkTypeUInt64>(index), 1, type) != 1)
  {
    return false;
  }
  switch (type)
  {
    vtkTemplateMacro(VTK_TT value{}; std::memcpy(&value, word, sizeof(value));
                     number = static_cast<double>(value));
    default:
      return false;
  }
  return true;
}

} // namespace helios
