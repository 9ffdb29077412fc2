// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosLASWriter.h"

#include "heliosCoordinateSystem.h"
#include "heliosLasBlock.h"
#include "heliosLasEncoder.h"
#include "heliosLasFileHead.h"
#include "heliosLasNamesFile.h"
#include "heliosLasScaling.h"
#include "heliosLasWaves.h"
#include "heliosLazSink.h"
#include "heliosPartFile.h"
#include "heliosSceneCrs.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosVersion.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <filesystem>
#include <vector>

vtkStandardNewMacro(vtkHeliosLASWriter);

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr std::size_t LongestRecord = 65535;

} // namespace

//------------------------------------------------------------------------------
vtkHeliosLASWriter::vtkHeliosLASWriter()
  : Names(std::make_unique<helios::LasNamesFile>())
{
}

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
     << indent << "WriteWaveforms: " << this->WriteWaveforms << "\n"
     << indent << "WriteCompressed: " << this->WriteCompressed << "\n"
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
void vtkHeliosLASWriter::SetWaveforms(vtkTable* waveforms)
{
  this->Waveforms = waveforms;
}

//------------------------------------------------------------------------------
/// Starts a file, for Open() and Reopen().
void vtkHeliosLASWriter::Start(bool isResumed)
{
  this->Names->Begin(this->GetOpenName(), isResumed);
  this->Head.reset();
  this->Compressed.reset();
  this->HasWarnedReturns = this->HasWarnedClasses = false;
  this->Packets = this->WriteWaveforms ? std::make_unique<helios::PartFile>() : nullptr;
}

//------------------------------------------------------------------------------
std::string vtkHeliosLASWriter::GetPacketsName() const
{
  return std::filesystem::path(this->GetOpenName()).replace_extension(".wdp").string();
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::Open()
{
  if (!this->Superclass::Open())
  {
    return false;
  }
  this->Start(false);
  if (!this->Packets)
  {
    return true;
  }
  const std::string head = helios::LasWaves::EncodeFileHead(helios::LasRecord::ExtendedHeadSize);
  const std::string path = this->GetPacketsName();
  if (!(this->CountOnly ? this->Packets->OpenCountOnly(path) : this->Packets->Open(path)) ||
    !this->Packets->Append(head.data(), head.size()))
  {
    this->FailFile(this->Packets->GetProblem());
    this->Superclass::Abandon();
    return false;
  }
  this->Packets->BeginBlock();
  this->NumberOfBytes += static_cast<vtkIdType>(head.size());
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
  this->Start(true);
  std::uint64_t packetsEnd = helios::LasRecord::ExtendedHeadSize;
  helios::Status status;
  if (fileSize > 0)
  {
    this->Head = std::make_unique<helios::LasFileHead>();
    status = this->Head->Read(this->GetOpenName() + helios::PartEnding, numberOfRecords,
      this->Packets != nullptr, packetsEnd);
  }
  if (status.IsOk() && this->Packets &&
    (!this->Packets->Reopen(this->GetPacketsName(), packetsEnd) || !this->WritePacketsHead()))
  {
    status = helios::Status::Error(this->Packets->GetProblem());
  }
  if (!status.IsOk())
  {
    this->FailFile(status.Message());
    this->Superclass::Abandon();
    return false;
  }
  return !this->Head ||
    (this->ResumeCompressed() && this->OverwriteBytes(0, this->Head->Header.Encode()));
}

//------------------------------------------------------------------------------
/// Goes on after the chunks of a resumed file, whose table, if it had one, is cut off.
bool vtkHeliosLASWriter::ResumeCompressed()
{
  const helios::LasHeader& header = this->Head->Header;
  if (header.IsCompressed)
  {
    this->Compressed = std::make_unique<helios::LazSink>(
      helios::LazForm::Make(header.Format, header.PointLength), this->Head->Chunks);
  }
  return !header.IsCompressed ||
    this->OverwriteBytes(header.PointsBegin, helios::EncodeLas<std::uint64_t>(header.PointsBegin));
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::RefusePoints(const std::string& problem)
{
  vtkErrorMacro(<< this->GetOpenName() << ": " << problem);
  return false;
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::RefuseNames(const std::string& problem)
{
  vtkErrorMacro(<< problem);
  return false;
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::AddNames(vtkPolyData* echoes)
{
  const helios::Status status =
    this->CountOnly ? helios::Status() : this->Names->Add(echoes->GetFieldData());
  return status.IsOk() || this->RefuseNames(status.Message());
}

//------------------------------------------------------------------------------
/// Creates the file properties from the first block.
bool vtkHeliosLASWriter::DescribeFile(
  vtkPolyData* echoes, const helios::LasBlock& block, helios::LasFileHead& head)
{
  head.Crs = helios::GetCRS(echoes);
  const bool isKnown = this->Head && this->Head->Crs == head.Crs;
  helios::CoordinateSystem system;
  const helios::Status status =
    head.Crs.empty() || isKnown ? helios::Status() : system.Set(head.Crs);
  if (!status.IsOk())
  {
    return this->RefusePoints("the field array CRS of a block: " + status.Message());
  }
  head.Wkt = isKnown ? this->Head->Wkt : (system.IsSet() ? system.GetWkt() : std::string());
  if (head.Wkt.size() >= LongestRecord)
  {
    return this->RefusePoints("the CRS of a block is longer than the 65534 characters of a record");
  }
  double epoch = 0.0;
  if (!helios::ReadGpsEpoch(echoes, epoch))
  {
    return this->RefusePoints("the field array GpsEpoch of a block is not one number; give seconds "
                              "of GPS time since 6 January 1980");
  }
  head.Scaling.TimeShift = epoch != 0.0 ? epoch - helios::LasHeader::StandardTimeOffset : 0.0;
  head.Arrays = helios::EncodeLasExtras(block.GetExtras());
  head.Header.Encoding = helios::LasHeader::HasWkt |
    (epoch != 0.0 ? helios::LasHeader::StandardTime : 0) |
    (this->Packets ? helios::LasHeader::ExternalWaves : 0);
  head.HasWaves = this->Packets != nullptr;
  head.Header.Format = block.GetFormat();
  head.Header.PointLength = block.GetPointLength();
  head.Header.IsCompressed = this->WriteCompressed;
  return true;
}

//------------------------------------------------------------------------------
/// Writes the header and the records at the first block.
bool vtkHeliosLASWriter::MakeHead(const helios::LasBlock& block, vtkPolyData* echoes)
{
  auto head = std::make_unique<helios::LasFileHead>();
  if (!this->DescribeFile(echoes, block, *head))
  {
    return false;
  }
  if (head->Wkt.empty() && !head->Crs.empty())
  {
    vtkWarningMacro(<< this->GetOpenName() << ": the CRS " << head->Crs
                    << " cannot be written as WKT; the file has no CRS");
  }
  head->Scaling.FullIntensity = this->FullIntensity;
  helios::CoordinateSystem system;
  static_cast<void>(system.Set(head->Crs)); // checked above; may be none
  helios::ChooseLasScaling(echoes, system, this->Scale, head->Scaling);
  head->Header.Scale = head->Scaling.Scale;
  head->Header.Offset = head->Scaling.Offset;
  const helios::Status status = head->Header.CheckScaling();
  if (!status.IsOk())
  {
    return this->RefusePoints("a block " + status.Message());
  }
  this->Head = std::move(head);
  return this->WriteHead();
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::WriteHead()
{
  helios::LasHeader& header = this->Head->Header;
  header.System = this->SystemIdentifier;
  header.Software = std::string("vtkHelios ") + vtkHeliosVersion::GetVersion();
  header.CreationDay = this->CreationDay;
  header.CreationYear = this->CreationYear;
  const std::string records = this->Head->EncodeRecords(header.NumberOfRecords);
  header.PointsBegin = static_cast<std::uint32_t>(helios::LasHeader::Size14 + records.size());
  // the place of the table: not known yet
  const std::string place =
    header.IsCompressed ? helios::EncodeLas<std::uint64_t>(header.PointsBegin) : std::string();
  const bool isWritten = this->WriteText(header.Encode() + records + place);
  this->EndHead();
  if (header.IsCompressed)
  {
    this->Compressed = std::make_unique<helios::LazSink>(
      helios::LazForm::Make(header.Format, header.PointLength), std::vector<helios::LazChunk>());
  }
  return isWritten;
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::CheckSame(const helios::LasBlock& block, vtkPolyData* echoes)
{
  helios::LasFileHead next;
  helios::LasFileHead& head = *this->Head;
  if (!this->DescribeFile(echoes, block, next))
  {
    return false;
  }
  if (next.Arrays != head.Arrays || next.Header.PointLength != head.Header.PointLength)
  {
    return this->RefusePoints("a block has other arrays than those before, which had the Extra "
                              "Bytes " +
      head.ListArrays() + " and points of " + std::to_string(head.Header.PointLength) +
      " bytes, and not " + next.ListArrays() + " and " + std::to_string(next.Header.PointLength) +
      " bytes; write it to another file");
  }
  if (next.Wkt != head.Wkt)
  {
    return this->RefusePoints(
      "a block has the CRS \"" + next.Crs + "\", unlike those before; write it to another file");
  }
  if (next.Header.Encoding != head.Header.Encoding ||
    (head.HasTime && next.Scaling.TimeShift != head.Scaling.TimeShift))
  {
    return this->RefusePoints(
      "a block has another GpsEpoch than those before; write it to another file");
  }
  if (!head.HasTime)
  {
    head.Scaling.TimeShift = next.Scaling.TimeShift;
    head.Scaling.FullIntensity = this->FullIntensity;
    head.HasTime = true;
    head.Crs = next.Crs;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::WritePoints(helios::LasBlock& block, vtkIdType count)
{
  const vtkIdType start = this->GetFileSize();
  helios::LasEncoder encoder(block, this->Head->Scaling, count);
  std::vector<char> bytes;
  const auto append = [this](const std::string& chunk) { return this->AppendChunk(chunk); };
  if (this->Compressed)
  {
    this->Compressed->Mark();
  }
  while (encoder.HasPoints())
  {
    if (!encoder.NextRound(bytes))
    {
      this->RemovePoints(start);
      return this->RefusePoints(
        block.CheckRange(this->Head->Scaling, encoder.GetNext(), count).Message());
    }
    if (this->Compressed ? !this->CheckCompressed(this->Compressed->Add(bytes, append))
                         : !this->WriteBytes(bytes.data(), bytes.size(), start))
    {
      return false;
    }
  }
  this->Head->Header.Points.Add(encoder.GetSummary());
  return this->Compressed || this->OverwriteBytes(0, this->Head->Header.Encode());
}

//------------------------------------------------------------------------------
/// Removes the points of a block that is refused.
bool vtkHeliosLASWriter::RemovePoints(vtkIdType size)
{
  if (this->Compressed)
  {
    this->Compressed->Restore();
  }
  return this->GetFileSize() <= size || this->TruncateTo(size);
}

//------------------------------------------------------------------------------
/// Appends a chunk; of the points, those in the file are safe after an error.
bool vtkHeliosLASWriter::AppendChunk(const std::string& bytes)
{
  const vtkIdType records = this->NumberOfRecords;
  this->NumberOfRecords = this->Compressed->GetNumberOfPoints();
  const bool isWritten = this->WriteBytes(bytes.data(), bytes.size(), this->GetFileSize());
  this->NumberOfRecords = isWritten ? records : this->NumberOfRecords;
  return isWritten;
}

//------------------------------------------------------------------------------
/// After an error the file stays without a table of chunks; errors of the file are reported already.
bool vtkHeliosLASWriter::CheckCompressed(const helios::Status& status)
{
  if (!status.IsOk())
  {
    this->Compressed.reset();
  }
  const bool isReported = status.IsOk() || status.Message() == helios::LazSink::NotAppended;
  return isReported ? status.IsOk() : this->RefusePoints(status.Message());
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::EndBlock()
{
  if (!this->Compressed)
  {
    return true;
  }
  const vtkIdType start = this->GetFileSize();
  const bool isWritten = this->CheckCompressed(this->Compressed->Finish(
    [this](const std::string& chunk) { return this->AppendChunk(chunk); }));
  this->NumberOfBytes += this->GetFileSize() - start;
  return isWritten && this->OverwriteBytes(0, this->Head->Header.Encode());
}

//------------------------------------------------------------------------------
/// Ends the last chunk, and writes the table of chunks.
bool vtkHeliosLASWriter::WriteTable()
{
  if (!this->Compressed)
  {
    return true;
  }
  const auto place = [this] { return static_cast<std::uint64_t>(this->GetFileSize()); };
  if (!this->EndBlock() ||
    !this->OverwriteBytes(
      this->Head->Header.PointsBegin, helios::EncodeLas<std::uint64_t>(place())))
  {
    return false;
  }
  const std::string table = this->Compressed->EncodeTable();
  this->NumberOfBytes += static_cast<vtkIdType>(table.size());
  return this->AppendChunk(table);
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
/// Reads the arrays of a block and its waveforms.
bool vtkHeliosLASWriter::SetBlock(
  vtkPolyData* echoes, helios::LasBlock& points, helios::LasWaves& waves)
{
  helios::Status status = this->Packets ? waves.Set(this->Waveforms) : helios::Status();
  points.SetWaves(this->Packets ? &waves : nullptr);
  status = status.IsOk() ? points.Set(echoes, this->WriteExtraBytes) : status;
  if (status.IsOk() && this->Packets)
  {
    status = points.GetWaveformIds().IsSet()
      ? waves.MakePackets(
          points.GetWaveformIds(), echoes->GetNumberOfPoints(), this->Packets->GetSize())
      : helios::Status::Error(std::string("a block has no array ") + names::WaveformIds +
          "; switch WriteWaveforms off, or let the scanner generate them");
  }
  return status.IsOk() || this->RefusePoints(status.Message());
}

//------------------------------------------------------------------------------
/// Writes the sample spacing to the descriptors, once it is known.
bool vtkHeliosLASWriter::CheckSpacing(const helios::LasWaves& waves)
{
  const std::uint32_t spacing = waves.GetSpacing();
  if (spacing == 0 || spacing == this->Head->Spacing)
  {
    return true;
  }
  if (this->Head->Spacing != 0)
  {
    return this->RefusePoints("the waveforms of a block have a BinSize of " +
      std::to_string(spacing) + " ps, and those before " + std::to_string(this->Head->Spacing) +
      " ps; write them to another file");
  }
  this->Head->Spacing = spacing;
  std::uint32_t count = 0;
  return this->OverwriteBytes(helios::LasHeader::Size14, this->Head->EncodeRecords(count));
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::WritePacketsHead()
{
  const std::string head = helios::LasWaves::EncodeFileHead(this->Packets->GetSize());
  return this->Packets->Overwrite(0, head.data(), head.size());
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::WritePackets(const helios::LasWaves& waves)
{
  const std::vector<char>& bytes = waves.GetPackets();
  return !this->Packets ||
    (this->Packets->Append(bytes.data(), bytes.size()) && this->WritePacketsHead()) ||
    this->FailBlock(this->Packets->GetProblem(), this->GetFileSize());
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
  helios::LasWaves waves;
  if (!this->SetBlock(echoes, points, waves) || !this->AddNames(echoes))
  {
    return false;
  }
  const vtkIdType start = this->GetFileSize();
  const std::uint64_t packetsStart = this->Packets ? this->Packets->GetSize() : 0;
  const bool isFirst = !this->Head;
  const bool isKept = isFirst ? this->MakeHead(points, echoes) : this->CheckSame(points, echoes);
  if (!isKept || !this->CheckSpacing(waves) || !this->WritePackets(waves) ||
    !this->WritePoints(points, count))
  {
    if (this->Packets && this->Packets->Cut(packetsStart))
    {
      this->WritePacketsHead();
    }
    if (isFirst)
    {
      this->Head.reset(); // another block may become the first
      this->Compressed.reset();
      this->TruncateTo(0);
    }
    return false;
  }
  this->NumberOfRecords += count;
  this->NumberOfBytes += this->GetFileSize() - start +
    static_cast<vtkIdType>(this->Packets ? this->Packets->GetSize() - packetsStart : 0);
  this->Warn(points);
  return true;
}

//------------------------------------------------------------------------------
std::string vtkHeliosLASWriter::Sync()
{
  const std::string problem = this->Packets ? this->Packets->Sync().Message() : std::string();
  return problem.empty() ? this->Superclass::Sync() : problem;
}

//------------------------------------------------------------------------------
std::vector<helios::FileBlock> vtkHeliosLASWriter::CollectBlocks()
{
  std::vector<helios::FileBlock> blocks = this->Superclass::CollectBlocks();
  if (this->Packets)
  {
    blocks.push_back(this->Packets->CollectBlock());
  }
  if (!this->IsOpen() && this->Head) // the heads are final
  {
    const std::uint64_t place = this->Compressed ? helios::LazTablePlaceSize : 0;
    blocks.push_back(
      helios::MakeFileBlock(this->GetOpenName(), 0, this->Head->Header.PointsBegin + place));
  }
  if (!this->IsOpen() && this->Packets)
  {
    blocks.push_back(
      helios::MakeFileBlock(this->GetPacketsName(), 0, helios::LasRecord::ExtendedHeadSize));
  }
  if (!this->IsOpen() && !this->CountOnly)
  {
    this->Names->CollectBlock(blocks);
  }
  return blocks;
}

//------------------------------------------------------------------------------
std::string vtkHeliosLASWriter::GetHeadChecksum() const
{
  return this->Head && this->IsOpen()
    ? helios::ComputeChecksum(
        this->GetOpenName() + helios::PartEnding, 0, this->Head->Header.PointsBegin)
    : std::string();
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::RestoreHead(const std::string& checksum)
{
  if (this->Superclass::RestoreHead(checksum) || !this->Head || this->Head->Spacing == 0)
  {
    return this->GetHeadChecksum() == checksum;
  }
  // A block that is removed may be the first with waveforms.
  this->Head->Spacing = 0;
  std::uint32_t count = 0;
  return this->OverwriteBytes(helios::LasHeader::Size14, this->Head->EncodeRecords(count)) &&
    this->Superclass::RestoreHead(checksum);
}

//------------------------------------------------------------------------------
/// Writes a file without points if there was no block.
bool vtkHeliosLASWriter::WriteEmpty()
{
  this->Head = std::make_unique<helios::LasFileHead>();
  this->Head->Header.Encoding = helios::LasHeader::HasWkt;
  if (this->Packets)
  {
    this->Head->HasWaves = true;
    this->Head->Header.Encoding |= helios::LasHeader::ExternalWaves;
    this->Head->Header.Format = 9;
    this->Head->Header.PointLength = helios::GetLasPointForm(9).Length;
  }
  this->Head->Header.IsCompressed = this->WriteCompressed;
  const bool isWritten = this->WriteHead();
  this->NumberOfBytes += this->GetFileSize();
  return isWritten;
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::Close()
{
  if (!this->CheckOpen())
  {
    this->Abandon();
    return false;
  }
  if ((!this->Head && !this->WriteEmpty()) || !this->WriteTable())
  {
    this->Abandon();
    return false;
  }
  if (this->Packets && !this->Packets->Close())
  {
    this->FailFile(this->Packets->GetProblem());
    this->Superclass::Abandon();
    return false;
  }
  const vtkIdType count = this->NumberOfRecords;
  if (!this->FinishFile())
  {
    return false;
  }
  const helios::Status status = this->CountOnly ? helios::Status() : this->Names->Finish(count);
  return status.IsOk() || this->RefuseNames(status.Message());
}

//------------------------------------------------------------------------------
bool vtkHeliosLASWriter::Abandon()
{
  bool good = !this->IsOpen() || ((this->Head || this->WriteEmpty()) && this->WriteTable());
  if (this->Packets && !this->Packets->Abandon())
  {
    good = this->FailFile(this->Packets->GetProblem());
  }
  return this->Superclass::Abandon() && good;
}
