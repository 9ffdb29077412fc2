// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosLASWriter.h"

#include "heliosCoordinateSystem.h"
#include "heliosLasBlock.h"
#include "heliosLasFile.h"
#include "heliosSceneCrs.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosVersion.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkHeliosLASWriter);

namespace names = vtkHeliosArrayNames;

namespace helios
{

/// What is the same for all blocks of a file.
struct LasSheet
{
  LasHeader Header;
  std::string Records; // after the header
  LasScaling Scaling;
  std::string Arrays; // the Extra Bytes
  std::string Wkt;
  std::string Crs;     // that Wkt was made from
  bool HasTime = true; // TimeShift is known
};

} // namespace helios

namespace
{

constexpr vtkIdType PointsPerChunk = 4096;
constexpr double StandardTimeOffset = 1e9; // [s]
constexpr std::size_t LongestRecord = 65535;

/// Encodes the points of a block in rounds of chunks; a round is in memory at a time.
class PointEncoder
{
public:
  PointEncoder(helios::LasBlock& block, const helios::LasScaling& scaling, vtkIdType count)
    : Block(block)
    , Scaling(scaling)
    , Count(count)
    , Chunks(8 * static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads()))
  {
  }

  bool HasPoints() const { return this->Next < this->Count; }
  vtkIdType GetNext() const { return this->Next; }
  const helios::LasSummary& GetSummary() const { return this->Summary; }

  /// Encodes the next round into bytes; false where a point of it cannot be.
  bool NextRound(std::vector<char>& bytes)
  {
    const vtkIdType length = this->Block.GetPointLength();
    const vtkIdType first = this->Next;
    const vtkIdType count =
      std::min(this->Count - first, PointsPerChunk * static_cast<vtkIdType>(this->Chunks.size()));
    bytes.resize(static_cast<std::size_t>(count * length));
    const vtkIdType chunks = (count + PointsPerChunk - 1) / PointsPerChunk;
    const auto encode = [&](vtkIdType chunk)
    {
      const vtkIdType begin = chunk * PointsPerChunk;
      const vtkIdType end = std::min(count, begin + PointsPerChunk);
      Chunk& result = this->Chunks[static_cast<std::size_t>(chunk)];
      result = Chunk();
      char* records = bytes.data() + begin * length;
      result.IsGood = this->Block.Encode(this->Scaling, first + begin, first + end, records);
      if (result.IsGood)
      {
        result.Summary.Add(records, end - begin, length);
      }
    };
    vtkSMPTools::For(0, chunks, 1,
      [&encode](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType chunk = begin; chunk < end; ++chunk)
        {
          encode(chunk);
        }
      });
    return this->Take(chunks, count);
  }

private:
  struct Chunk
  {
    helios::LasSummary Summary;
    bool IsGood = false;
  };

  bool Take(vtkIdType chunks, vtkIdType count)
  {
    const bool isGood = std::all_of(this->Chunks.begin(), this->Chunks.begin() + chunks,
      [](const Chunk& chunk) { return chunk.IsGood; });
    for (vtkIdType chunk = 0; isGood && chunk < chunks; ++chunk)
    {
      this->Summary.Add(this->Chunks[static_cast<std::size_t>(chunk)].Summary);
    }
    this->Next += isGood ? count : 0;
    return isGood;
  }

  helios::LasBlock& Block;
  const helios::LasScaling& Scaling;
  vtkIdType Count;
  vtkIdType Next = 0;
  std::vector<Chunk> Chunks;
  helios::LasSummary Summary;
};

/// The time that GpsTime counts from; 0: it is not known. False: the array is no number.
bool TakeEpoch(vtkPolyData* echoes, double& epoch)
{
  vtkAbstractArray* any = echoes->GetFieldData()->GetAbstractArray(names::GpsEpoch);
  auto* array = vtkDataArray::SafeDownCast(any);
  if (any && (!array || array->GetNumberOfValues() != 1 || !std::isfinite(array->GetTuple1(0))))
  {
    return false;
  }
  epoch = array ? array->GetTuple1(0) : 0.0;
  return true;
}

/// The records of a sheet.
std::string MakeRecords(const helios::LasSheet& sheet, std::uint32_t& count)
{
  helios::LasRecord wkt{ helios::LasProjectionUser, helios::LasWktId, "OGC coordinate system WKT",
    sheet.Wkt + '\0' };
  helios::LasRecord extras{ helios::LasSpecUser, helios::LasExtraBytesId, "Extra Bytes",
    sheet.Arrays };
  const std::string records = (sheet.Wkt.empty() ? std::string() : wkt.Encode()) +
    (sheet.Arrays.empty() ? std::string() : extras.Encode());
  count = (sheet.Wkt.empty() ? 0 : 1) + (sheet.Arrays.empty() ? 0 : 1);
  return records;
}

std::string ListExtras(const std::string& arrays)
{
  std::vector<helios::LasExtra> extras;
  helios::DecodeLasExtras(arrays, extras);
  std::string text;
  for (const helios::LasExtra& extra : extras)
  {
    text += (text.empty() ? "" : ", ") + extra.Name + " (type " + std::to_string(extra.Type) + ")";
  }
  return text.empty() ? "none" : text;
}

/// The counts of all points of a file.
std::string Summarize(helios::LasFile& file, helios::LasSummary& summary)
{
  const helios::LasHeader& header = file.GetHeader();
  std::vector<char> bytes;
  std::string problem;
  for (std::uint64_t first = 0; first < header.Points.Count && problem.empty();)
  {
    const auto count = std::min<std::uint64_t>(PointsPerChunk, header.Points.Count - first);
    bytes.resize(count * static_cast<std::uint64_t>(header.PointLength));
    problem = file.Read(first, count, bytes.data());
    summary.Add(bytes.data(), static_cast<std::int64_t>(count), header.PointLength);
    first += count;
  }
  return problem;
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosLASWriter::vtkHeliosLASWriter() = default;

//------------------------------------------------------------------------------
vtkHeliosLASWriter::~vtkHeliosLASWriter()
{
  if (this->IsOpen())
  {
    this->Abandon();
  }
}

//------------------------------------------------------------------------------
void vtkHeliosLASWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scale: " << this->Scale << "\n"
     << indent << "FullIntensity: " << this->FullIntensity << " W\n"
     << indent << "WriteExtraBytes: " << this->WriteExtraBytes << "\n"
     << indent << "CreationDay: " << this->CreationDay << "\n"
     << indent << "CreationYear: " << this->CreationYear << "\n"
     << indent << "SystemIdentifier: " << this->SystemIdentifier << "\n";
}

//------------------------------------------------------------------------------
const char* vtkHeliosLASWriter::GetBlockSource() const
{
  return "the echoes of vtkHeliosScanner (output port 0)";
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::Open()
{
  if (!this->Superclass::Open())
  {
    return false;
  }
  this->Sheet.reset();
  this->HasWarnedReturns = this->HasWarnedClasses = false;
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::Reopen(
  vtkIdType fileSize, vtkIdType numberOfRecords, vtkIdType numberOfBytes)
{
  if (!this->Superclass::Reopen(fileSize, numberOfRecords, numberOfBytes))
  {
    return false;
  }
  this->Sheet.reset();
  this->HasWarnedReturns = this->HasWarnedClasses = false;
  if (fileSize == 0)
  {
    return true;
  }
  auto sheet = std::make_unique<helios::LasSheet>();
  helios::LasFile file;
  std::string problem = file.OpenGrowing(this->GetOpenName() + ".part");
  sheet->Header = file.GetHeader();
  helios::LasSummary summary;
  problem = problem.empty() ? Summarize(file, summary) : problem;
  if (problem.empty() && summary.Count != static_cast<std::uint64_t>(numberOfRecords))
  {
    problem = this->GetOpenName() + ".part has " + std::to_string(summary.Count) +
      " points and not " + std::to_string(numberOfRecords) + ", and cannot be gone on with";
  }
  if (!problem.empty())
  {
    this->FailFile(problem);
    this->Superclass::Abandon();
    return false;
  }
  const helios::LasRecord* extras = file.Find(helios::LasSpecUser, helios::LasExtraBytesId);
  sheet->Header.Points = summary;
  sheet->Arrays = extras ? extras->Data : std::string();
  sheet->Wkt = file.GetCrs();
  sheet->Scaling.Scale = sheet->Header.Scale;
  sheet->Scaling.Offset = sheet->Header.Offset;
  sheet->HasTime = false;
  this->Sheet = std::move(sheet);
  return this->OverwriteBytes(0, this->Sheet->Header.Encode());
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::RefusePoints(const std::string& problem)
{
  vtkErrorMacro(<< this->GetOpenName() << ": " << problem);
  return false;
}

//------------------------------------------------------------------------------
/// What the block says of the file.
bool vtkHeliosLASWriter::MakeSheet(
  vtkPolyData* echoes, const helios::LasBlock& block, helios::LasSheet& sheet)
{
  sheet.Crs = helios::GetCRS(echoes);
  const bool isKnown = this->Sheet && this->Sheet->Crs == sheet.Crs;
  helios::CoordinateSystem system;
  const std::string problem = sheet.Crs.empty() || isKnown ? std::string() : system.Set(sheet.Crs);
  if (!problem.empty())
  {
    return this->RefusePoints("the field array CRS of a block: " + problem);
  }
  sheet.Wkt = isKnown ? this->Sheet->Wkt : (system.IsSet() ? system.GetWkt() : std::string());
  if (sheet.Wkt.size() >= LongestRecord)
  {
    return this->RefusePoints("the CRS of a block is longer than the 65534 characters of a record");
  }
  double epoch = 0.0;
  if (!TakeEpoch(echoes, epoch))
  {
    return this->RefusePoints("the field array GpsEpoch of a block is not one number; give seconds "
                              "of GPS time since 6 January 1980");
  }
  sheet.Scaling.TimeShift = epoch != 0.0 ? epoch - StandardTimeOffset : 0.0;
  sheet.Arrays = helios::EncodeLasExtras(block.GetExtras());
  sheet.Header.Encoding =
    helios::LasHeader::HasWkt | (epoch != 0.0 ? helios::LasHeader::StandardTime : 0);
  sheet.Header.Format = block.GetFormat();
  sheet.Header.PointLength = block.GetPointLength();
  return true;
}

//------------------------------------------------------------------------------
/// The header and the records of the first block.
bool vtkHeliosLASWriter::MakeHead(const helios::LasBlock& block, vtkPolyData* echoes)
{
  auto sheet = std::make_unique<helios::LasSheet>();
  if (!this->MakeSheet(echoes, block, *sheet))
  {
    return false;
  }
  if (sheet->Wkt.empty() && !sheet->Crs.empty())
  {
    vtkWarningMacro(<< this->GetOpenName() << ": the CRS " << sheet->Crs
                    << " cannot be said in WKT: the file has none");
  }
  sheet->Scaling.FullIntensity = this->FullIntensity;
  block.ChooseScaling(sheet->Scaling, this->Scale);
  sheet->Header.Scale = sheet->Scaling.Scale;
  sheet->Header.Offset = sheet->Scaling.Offset;
  this->Sheet = std::move(sheet);
  return this->WriteHead();
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::WriteHead()
{
  helios::LasHeader& header = this->Sheet->Header;
  header.System = this->SystemIdentifier;
  header.Software = std::string("vtkHelios ") + vtkHeliosVersion::GetVersion();
  header.CreationDay = this->CreationDay;
  header.CreationYear = this->CreationYear;
  const std::string records = MakeRecords(*this->Sheet, header.NumberOfRecords);
  header.PointsBegin = static_cast<std::uint32_t>(helios::LasHeader::Size14 + records.size());
  return this->WriteText(header.Encode() + records);
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::CheckSame(const helios::LasBlock& block, vtkPolyData* echoes)
{
  helios::LasSheet next;
  helios::LasSheet& sheet = *this->Sheet;
  if (!this->MakeSheet(echoes, block, next))
  {
    return false;
  }
  if (next.Arrays != sheet.Arrays || next.Header.PointLength != sheet.Header.PointLength)
  {
    return this->RefusePoints("a block has other arrays than those before, which had the Extra "
                              "Bytes " +
      ListExtras(sheet.Arrays) + " and points of " + std::to_string(sheet.Header.PointLength) +
      " bytes, and not " + ListExtras(next.Arrays) + " and " +
      std::to_string(next.Header.PointLength) + " bytes; write it to another file");
  }
  if (next.Wkt != sheet.Wkt)
  {
    return this->RefusePoints("a block has the CRS \"" + next.Crs +
      "\", another one than those before; write it to another file");
  }
  if (next.Header.Encoding != sheet.Header.Encoding ||
    (sheet.HasTime && next.Scaling.TimeShift != sheet.Scaling.TimeShift))
  {
    return this->RefusePoints(
      "a block has another GpsEpoch than those before; write it to another file");
  }
  if (!sheet.HasTime)
  {
    sheet.Scaling.TimeShift = next.Scaling.TimeShift;
    sheet.Scaling.FullIntensity = this->FullIntensity;
    sheet.HasTime = true;
    sheet.Crs = next.Crs;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::WritePoints(helios::LasBlock& block, vtkIdType count)
{
  const vtkIdType start = this->GetFileSize();
  PointEncoder encoder(block, this->Sheet->Scaling, count);
  std::vector<char> bytes;
  while (encoder.HasPoints())
  {
    if (!encoder.NextRound(bytes))
    {
      this->TakeBack(start);
      return this->RefusePoints(block.Explain(this->Sheet->Scaling, encoder.GetNext(), count));
    }
    if (!this->WriteBytes(bytes.data(), bytes.size(), start))
    {
      return false;
    }
  }
  this->Sheet->Header.Points.Add(encoder.GetSummary());
  return this->OverwriteBytes(0, this->Sheet->Header.Encode());
}

//------------------------------------------------------------------------------
void vtkHeliosLASWriter::Warn(const helios::LasBlock& block)
{
  if (block.GetNumberOfLateReturns() > 0 && !this->HasWarnedReturns)
  {
    this->HasWarnedReturns = true;
    vtkWarningMacro(<< this->GetOpenName() << ": " << block.GetNumberOfLateReturns()
                    << " points of a block have a ReturnNumber or NumberOfReturns above 15, which "
                    << "is written as 15; further ones are not reported");
  }
  if (block.GetNumberOfOddClasses() > 0 && !this->HasWarnedClasses)
  {
    this->HasWarnedClasses = true;
    vtkWarningMacro(<< this->GetOpenName() << ": " << block.GetNumberOfOddClasses()
                    << " points of a block have ClassificationIds beyond 0 to 255, written as 1 "
                    << "(unclassified); further ones are not reported");
  }
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::Write(vtkDataObject* block)
{
  vtkPolyData* echoes = this->CheckOpen() ? this->GetPoints(block) : nullptr;
  if (!echoes)
  {
    return false;
  }
  const vtkIdType count = echoes->GetNumberOfPoints();
  if (count == 0)
  {
    return true;
  }
  helios::LasBlock points;
  const std::string problem = points.Take(echoes, this->WriteExtraBytes);
  if (!problem.empty())
  {
    return this->RefusePoints(problem);
  }
  const vtkIdType start = this->GetFileSize();
  const bool isFirst = !this->Sheet;
  const bool isKept = isFirst ? this->MakeHead(points, echoes) : this->CheckSame(points, echoes);
  if (!isKept || !this->WritePoints(points, count))
  {
    if (isFirst)
    {
      this->Sheet.reset(); // another block may be the first
      this->TakeBack(0);
    }
    return false;
  }
  this->NumberOfRecords += count;
  this->NumberOfBytes += this->GetFileSize() - start;
  this->Warn(points);
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::Close()
{
  if (!this->CheckOpen())
  {
    this->Abandon();
    return false;
  }
  if (!this->Sheet)
  {
    this->Sheet = std::make_unique<helios::LasSheet>();
    if (!this->WriteHead())
    {
      this->Superclass::Abandon();
      return false;
    }
    this->NumberOfBytes += this->GetFileSize();
  }
  return this->Superclass::Close();
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::Abandon()
{
  bool good = true;
  if (this->IsOpen() && !this->Sheet)
  {
    this->Sheet = std::make_unique<helios::LasSheet>();
    good = this->WriteHead();
  }
  return this->Superclass::Abandon() && good;
}
