// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPCDWriter.h"

#include "heliosPartFile.h"
#include "heliosPcdBlock.h"
#include "heliosSceneCrs.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <fstream>

vtkStandardNewMacro(vtkHeliosPCDWriter);

namespace
{
constexpr vtkIdType PointsPerRound = 1 << 14;
constexpr double LargestError = 1e-3; // [m], limit for a warning
}

//------------------------------------------------------------------------------
vtkHeliosPCDWriter::vtkHeliosPCDWriter() = default;

//------------------------------------------------------------------------------
vtkHeliosPCDWriter::~vtkHeliosPCDWriter()
{
  if (this->IsOpen())
  {
    this->Abandon();
  }
}

//------------------------------------------------------------------------------
void vtkHeliosPCDWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Storage: " << (this->Storage == Ascii ? "Ascii" : "Binary") << "\n"
     << indent << "Precision: " << (this->Precision == Float ? "Float" : "Double") << "\n"
     << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << " " << this->Origin[2]
     << "\n"
     << indent << "UseOrigin: " << this->UseOrigin << "\n"
     << indent << "Resolution: " << this->Resolution << "\n";
}

//------------------------------------------------------------------------------
const char* vtkHeliosPCDWriter::GetBlockSource() const
{
  return "the echoes of vtkHeliosScanner (output port 0)";
}

//------------------------------------------------------------------------------
bool vtkHeliosPCDWriter::GetHasFloatPoints() const
{
  return this->Header ? this->Header->Fields[0].Size == 4 : this->Precision == Float;
}

//------------------------------------------------------------------------------
bool vtkHeliosPCDWriter::Refuse(const std::string& problem)
{
  vtkErrorMacro(<< this->GetOpenName() << ": " << problem);
  return false;
}

//------------------------------------------------------------------------------
bool vtkHeliosPCDWriter::Open()
{
  this->Header.reset();
  this->HasWarnedFar = false;
  this->HasWarnedColors = false;
  const double* o = this->Origin;
  if (!std::isfinite(o[0]) || !std::isfinite(o[1]) || !std::isfinite(o[2]))
  {
    vtkErrorMacro(<< "Origin is (" << o[0] << ", " << o[1] << ", " << o[2]
                  << "); set finite numbers");
    return false;
  }
  return this->Superclass::Open();
}

//------------------------------------------------------------------------------
bool vtkHeliosPCDWriter::Reopen(
  vtkIdType fileSize, vtkIdType numberOfRecords, vtkIdType numberOfBytes)
{
  this->Header.reset();
  this->HasWarnedFar = false;
  this->HasWarnedColors = false;
  if (!this->Superclass::Reopen(fileSize, numberOfRecords, numberOfBytes))
  {
    return false;
  }
  if (fileSize == 0)
  {
    return true;
  }
  const std::string path = this->GetOpenName() + helios::PartEnding;
  std::ifstream file(path, std::ios::binary);
  this->Header = std::make_unique<helios::PcdHeader>();
  const helios::Status status = this->Header->Read(path, file);
  if (!status.IsOk())
  {
    this->FailFile(status.Message());
    this->Superclass::Abandon();
    return false;
  }
  this->Header->Width = static_cast<std::uint64_t>(numberOfRecords);
  return this->OverwriteBytes(0, this->Header->Format());
}

//------------------------------------------------------------------------------
void vtkHeliosPCDWriter::ChooseOrigin(const helios::PcdBlock& block, double origin[3]) const
{
  block.GetMiddle(origin);
  if (this->UseOrigin)
  {
    std::copy(this->Origin, this->Origin + 3, origin);
  }
}

//------------------------------------------------------------------------------
/// Sets the first block, which decides on the types of the fields.
helios::Status vtkHeliosPCDWriter::SetFirst(vtkPolyData* echoes, helios::PcdBlock& block) const
{
  helios::PcdBlock::Types types;
  types.IsText = this->Storage == Ascii;
  types.HasFloats = types.HasFloatPoints = this->Precision == Float;
  types.HasFullColors = !types.HasFloats;
  helios::Status status = block.Set(echoes, types);
  if (!status.IsOk() || !types.HasFloats)
  {
    return status;
  }
  types.HasFullColors = block.HasFineColors();
  if (this->Resolution > 0.0)
  {
    double origin[3];
    this->ChooseOrigin(block, origin);
    types.HasFloatPoints = block.FindLargestError(origin) <= 0.5 * this->Resolution;
  }
  return block.Set(echoes, types);
}

//------------------------------------------------------------------------------
helios::Status vtkHeliosPCDWriter::SetNext(vtkPolyData* echoes, helios::PcdBlock& block) const
{
  helios::PcdBlock::Types types;
  types.IsText = this->Header->Storage == helios::PcdStorage::Ascii;
  types.HasFloatPoints = this->Header->Fields[0].Size == 4;
  types.HasFloats = this->Precision == Float;
  types.HasFullColors = this->Header->Find(vtkHeliosArrayNames::RGB) >= 0;
  return block.Set(echoes, types);
}

//------------------------------------------------------------------------------
/// Creates the header from the first block.
bool vtkHeliosPCDWriter::MakeHeader(vtkPolyData* echoes, const helios::PcdBlock& block)
{
  auto header = std::make_unique<helios::PcdHeader>();
  header->Fields = block.GetFields();
  header->HasAmplitude = block.HasAmplitude();
  header->HasWholeIntensity = block.HasWholeIntensity();
  header->Storage = this->Storage == Ascii ? helios::PcdStorage::Ascii : helios::PcdStorage::Binary;
  if (header->Fields[0].Size == 4)
  {
    this->ChooseOrigin(block, header->Origin);
  }
  header->Crs = helios::GetCRS(echoes);
  std::replace_if(
    header->Crs.begin(), header->Crs.end(), [](unsigned char c) { return c < ' '; }, ' ');
  vtkDataArray* epoch = echoes->GetFieldData()->GetArray(vtkHeliosArrayNames::GpsEpoch);
  if (epoch && epoch->GetNumberOfValues() == 1 && std::isfinite(epoch->GetTuple1(0)))
  {
    header->HasEpoch = true;
    header->Epoch = epoch->GetTuple1(0);
  }
  this->Header = std::move(header);
  return this->WriteHeader();
}

//------------------------------------------------------------------------------
bool vtkHeliosPCDWriter::WriteHeader()
{
  const std::string text = this->Header->Format();
  return this->WriteText(text);
}

//------------------------------------------------------------------------------
bool vtkHeliosPCDWriter::WritePoints(helios::PcdBlock& block, vtkIdType count, vtkIdType start)
{
  std::string text;
  for (vtkIdType begin = 0; begin < count; begin += PointsPerRound)
  {
    text.clear();
    block.Append(begin, std::min(count, begin + PointsPerRound), *this->Header, text);
    if (!this->WriteBytes(text.data(), text.size(), start))
    {
      return false;
    }
  }
  this->Header->Width += static_cast<std::uint64_t>(block.GetNumberOfWritten());
  return this->OverwriteBytes(0, this->Header->Format());
}

//------------------------------------------------------------------------------
void vtkHeliosPCDWriter::Warn(const helios::PcdBlock& block, vtkIdType count)
{
  if (block.GetNumberOfDropped() > 0)
  {
    vtkWarningMacro(<< this->GetOpenName() << ": " << block.GetNumberOfDropped() << " of " << count
                    << " points of a block are not finite: left out");
  }
  if (block.HasFineColors() && !this->HasWarnedColors &&
    this->Header->Find(vtkHeliosArrayNames::RGB) < 0)
  {
    this->HasWarnedColors = true;
    vtkWarningMacro(<< this->GetOpenName() << ": colours are stored in 8 bits, as those of the "
                    << "first block; set Precision to Double for all bits");
  }
  const double limit = this->Resolution > 0.0 ? 0.5 * this->Resolution : LargestError;
  if (block.GetLargestError() > limit && this->Resolution > 0.0 && !this->HasWarnedFar)
  {
    this->HasWarnedFar = true;
    vtkWarningMacro(<< this->GetOpenName() << ": as float, a coordinate is "
                    << block.GetLargestError() << " off, more than half of the Resolution "
                    << this->Resolution << ", which the first block kept; set Precision to Double. "
                    << "Further ones are not reported");
  }
  if (block.GetLargestError() >= limit && !this->HasWarnedFar)
  {
    this->HasWarnedFar = true;
    vtkWarningMacro(<< this->GetOpenName() << ": as float, a coordinate is "
                    << 1e3 * block.GetLargestError() << " mm off; set Precision to Double, or an "
                    << "Origin nearer to the points. Further ones are not reported");
  }
}

//------------------------------------------------------------------------------
bool vtkHeliosPCDWriter::Write(vtkDataObject* data)
{
  vtkPolyData* echoes = this->CheckOpen() ? this->GetPoints(data) : nullptr;
  if (!echoes)
  {
    return false;
  }
  const vtkIdType count = echoes->GetNumberOfPoints();
  if (count == 0)
  {
    return true;
  }
  helios::PcdBlock block;
  const helios::Status status =
    this->Header ? this->SetNext(echoes, block) : this->SetFirst(echoes, block);
  if (!status.IsOk())
  {
    return this->Refuse(status.Message());
  }
  if (this->Header && this->Header->Fields != block.GetFields())
  {
    return this->Refuse("a block has other point arrays than the first one, or of other types; "
                        "write it to another file");
  }
  const vtkIdType start = this->GetFileSize();
  const bool isFirst = !this->Header;
  if ((isFirst && !this->MakeHeader(echoes, block)) || !this->WritePoints(block, count, start))
  {
    if (isFirst)
    {
      this->Header.reset();
    }
    return false;
  }
  this->NumberOfRecords += block.GetNumberOfWritten();
  this->NumberOfBytes += this->GetFileSize() - start;
  this->Warn(block, count);
  return true;
}

//------------------------------------------------------------------------------
/// Closes the file; without points it has the fields x, y and z.
bool vtkHeliosPCDWriter::Close()
{
  if (this->IsOpen() && !this->Header && this->GetFileSize() == 0)
  {
    this->Header = std::make_unique<helios::PcdHeader>();
    for (const char* name : { "x", "y", "z" })
    {
      this->Header->Fields.push_back({ name, this->Precision == Float ? 4 : 8, 'F', 1 });
    }
    this->Header->Storage =
      this->Storage == Ascii ? helios::PcdStorage::Ascii : helios::PcdStorage::Binary;
    if (!this->WriteHeader())
    {
      return false;
    }
    this->NumberOfBytes += this->GetFileSize();
  }
  return this->Superclass::Close();
}
