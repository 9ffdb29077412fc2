// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosLASReader.h"

#include "heliosCoordinateSystem.h"
#include "heliosFiniteCheck.h"
#include "heliosInputFile.h"
#include "heliosLasArrays.h"
#include "heliosLasColors.h"
#include "heliosLasFile.h"
#include "heliosLasPackets.h"
#include "heliosPointNames.h"
#include "heliosSceneCrs.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <new>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkHeliosLASReader);

namespace
{

/// Returns the first point of piece i of n, computed without overflow of count * i.
std::uint64_t GetPieceBegin(std::uint64_t count, std::uint64_t i, std::uint64_t n)
{
  return count / n * i + count % n * i / n;
}

/// Parses classes separated by blanks; an error for a word that is none.
helios::Status ParseClasses(const std::string& text, std::vector<char>& isWanted)
{
  isWanted.assign(256, text.empty() ? 1 : 0);
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    unsigned int number = 256;
    const char* end = word.data() + word.size();
    const auto parsed = std::from_chars(word.data(), end, number);
    if (parsed.ec != std::errc() || parsed.ptr != end || number > 255)
    {
      return helios::Status::Error(
        "Classes has \"" + word + "\"; give classes from 0 to 255, with blanks between them");
    }
    isWanted[number] = 1;
  }
  return {};
}

/// Returns whether a point has one of these classes.
bool HasClass(const std::vector<char>& isWanted, vtkDataArray* classes, vtkIdType i)
{
  const double value = classes->GetComponent(i, 0);
  return value >= 0.0 && value < 256.0 && isWanted[static_cast<std::size_t>(value)];
}

bool IsWithheld(vtkDataArray* flags, vtkIdType i)
{
  constexpr int withheld = 4;
  return (static_cast<int>(flags->GetComponent(i, 0)) & withheld) != 0;
}

/// Copies the points with these indices over all points.
void CopyPoints(vtkIdList* ids, vtkPolyData* cloud)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  cloud->GetPoints()->GetPoints(ids, points);
  vtkNew<vtkPointData> data;
  data->CopyAllocate(cloud->GetPointData(), ids->GetNumberOfIds());
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    data->CopyData(cloud->GetPointData(), ids->GetId(i), i);
  }
  cloud->SetPoints(points);
  cloud->GetPointData()->ShallowCopy(data);
}

/// Sets the field data of the file.
void SetFields(const helios::LasFile& file, const std::string& crs, vtkPolyData* output)
{
  helios::SetCRS(output, crs);
  helios::CoordinateSteps steps;
  steps.Scale = file.GetHeader().Scale;
  steps.Offset = file.GetHeader().Offset;
  steps.HasOffset = true;
  helios::SetCoordinateSteps(output, steps);
  if (file.GetHeader().Epoch != 0.0)
  {
    vtkNew<vtkDoubleArray> epoch;
    epoch->SetName(vtkHeliosArrayNames::GpsEpoch);
    epoch->InsertNextValue(file.GetHeader().Epoch);
    output->GetFieldData()->AddArray(epoch);
  }
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosLASReader::vtkHeliosLASReader()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkHeliosLASReader::~vtkHeliosLASReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkHeliosLASReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n"
     << indent << "ReadWaveforms: " << this->ReadWaveforms << "\n"
     << indent << "Classes: " << this->Classes << "\n"
     << indent << "SkipWithheld: " << this->SkipWithheld << "\n";
}

//------------------------------------------------------------------------------
int vtkHeliosLASReader::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 1 ? "vtkTable" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosLASReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    outputVector->GetInformationObject(port)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
/// Reads points begin to end.
helios::Status vtkHeliosLASReader::ReadPoints(helios::LasFile& file, std::uint64_t begin,
  std::uint64_t end, vtkPolyData* output, vtkTable* waveforms)
{
  const helios::LasHeader& header = file.GetHeader();
  std::vector<char> isWanted;
  if (const helios::Status parsed = ParseClasses(this->Classes, isWanted); !parsed.IsOk())
  {
    return parsed;
  }
  const bool isSelected = !this->Classes.empty() || this->SkipWithheld;
  const bool hasWaves =
    this->ReadWaveforms && !isSelected && helios::GetLasPointForm(header.Format).Wave >= 0;
  helios::LasPackets packets;
  helios::Status status = hasWaves ? packets.Open(file) : helios::Status();
  if (!packets.GetWarning().empty() && this->WarnedName != file.GetPath())
  {
    this->WarnedName = file.GetPath(); // once, not per piece
    vtkWarningMacro(<< packets.GetWarning());
  }
  helios::LasColorBits colors;
  status = status.IsOk() ? this->FindColors(file, colors) : status;
  helios::LasArrays arrays(header, file.GetExtras(), colors, static_cast<vtkIdType>(end - begin));
  const std::uint64_t round = file.GetPointsPerRound();
  std::vector<char> bytes(
    std::min(round, end - begin) * static_cast<std::uint64_t>(header.PointLength));
  for (std::uint64_t first = begin; first < end && status.IsOk();)
  {
    const std::uint64_t count = std::min(round, end - first);
    const auto row = static_cast<vtkIdType>(first - begin);
    status = file.Read(first, count, bytes.data());
    arrays.Decode(bytes.data(), row, static_cast<vtkIdType>(count));
    if (hasWaves)
    {
      packets.Add(bytes.data(), row, static_cast<vtkIdType>(count));
    }
    first += count;
    this->UpdateProgress(static_cast<double>(first - begin) / static_cast<double>(end - begin));
    if (this->AbortExecute)
    {
      return helios::Status::Error(file.GetPath() + ": reading was aborted at point " +
        std::to_string(first) + "; update again to read it");
    }
  }
  if (!status.IsOk())
  {
    return status;
  }
  arrays.MoveTo(output);
  this->WarnOfNotes(file.GetPath(), arrays);
  if (isSelected)
  {
    this->SelectPoints(isWanted, output);
  }
  SetFields(file, this->FindCrs(file), output);
  this->ReadNames(static_cast<vtkIdType>(header.Points.Count), output);
  this->WarnOfValues(file.GetPath(), output);
  status = hasWaves ? packets.Read(output, waveforms) : helios::Status();
  if (!status.IsOk())
  {
    output->Initialize();
    waveforms->Initialize();
    return helios::Status::Error(file.GetPath() + ": " + status.Message());
  }
  return {};
}

//------------------------------------------------------------------------------
/// Returns the coordinate system of a file; empty, with a warning, if PROJ does not know it.
std::string vtkHeliosLASReader::FindCrs(const helios::LasFile& file)
{
  std::string crs = file.GetCrs();
  helios::CoordinateSystem system;
  if (crs.empty() || crs == this->KnownCrs)
  {
    return crs;
  }
  if (const helios::Status status = system.Set(crs); !status.IsOk())
  {
    if (this->WarnedCrs != file.GetPath())
    {
      this->WarnedCrs = file.GetPath();
      vtkWarningMacro(<< file.GetPath() << ": its coordinate system is not known and is ignored: "
                      << status.Message());
    }
    return {};
  }
  this->KnownCrs = crs;
  return crs;
}

//------------------------------------------------------------------------------
/// Finds the bits of the colours, once for all pieces of a file.
helios::Status vtkHeliosLASReader::FindColors(helios::LasFile& file, helios::LasColorBits& colors)
{
  const std::string state = file.GetPath() + " " + helios::StampFile(file.GetPath());
  if (state != this->ColorsFile)
  {
    if (const helios::Status status = helios::FindColorBits(file, colors); !status.IsOk())
    {
      return status;
    }
    this->ColorsFile = state;
    this->AreColors8 = colors.AreColors8;
    this->IsInfrared8 = colors.IsInfrared8;
  }
  colors.AreColors8 = this->AreColors8;
  colors.IsInfrared8 = this->IsInfrared8;
  return {};
}

//------------------------------------------------------------------------------
/// Removes the points of other classes, and withheld points with SkipWithheld, which are counted.
void vtkHeliosLASReader::SelectPoints(const std::vector<char>& isWanted, vtkPolyData* cloud)
{
  vtkPointData* data = cloud->GetPointData();
  vtkDataArray* classes = data->GetArray(vtkHeliosArrayNames::ClassificationIds);
  vtkDataArray* flags = data->GetArray(vtkHeliosArrayNames::ClassificationFlags);
  const bool skips = this->SkipWithheld && flags;
  const vtkIdType count = cloud->GetNumberOfPoints();
  vtkIdType withheld = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (!this->Classes.empty() && !(classes && HasClass(isWanted, classes, i)))
    {
      continue;
    }
    if (skips && IsWithheld(flags, i))
    {
      ++withheld;
      continue;
    }
    ids->InsertNextId(i);
  }
  if (ids->GetNumberOfIds() < count)
  {
    CopyPoints(ids, cloud);
  }
  if (withheld > 0)
  {
    vtkWarningMacro(<< this->FileName << ": " << withheld << " of " << count
                    << " points are withheld; they are left out");
  }
}

//------------------------------------------------------------------------------
/// Adds the names of parts and materials, if there is a file of them.
void vtkHeliosLASReader::ReadNames(vtkIdType points, vtkPolyData* cloud)
{
  const helios::Status status =
    helios::ReadPointNames(this->FileName, points, cloud->GetFieldData());
  if (!status.IsOk() && this->WarnedNames != status.Message())
  {
    this->WarnedNames = status.Message(); // once, not per piece
    vtkWarningMacro(<< status.Message());
  }
}

//------------------------------------------------------------------------------
/// Warns once per file, not per piece.
void vtkHeliosLASReader::WarnOfNotes(const std::string& path, const helios::LasArrays& arrays)
{
  if (this->WarnedNotes == path)
  {
    return;
  }
  for (const std::string& note : arrays.GetNotes())
  {
    this->WarnedNotes = path;
    vtkWarningMacro(<< this->FileName << ": " << note);
  }
}

//------------------------------------------------------------------------------
void vtkHeliosLASReader::WarnOfValues(const std::string& path, vtkPolyData* cloud)
{
  const auto counts = helios::CountNotFinite(cloud->GetPointData());
  if (counts.empty() || this->WarnedValues == path)
  {
    return;
  }
  this->WarnedValues = path;
  for (const auto& [name, count] : counts)
  {
    vtkWarningMacro(<< this->FileName << ": " << name << " is not finite at " << count << " of "
                    << cloud->GetNumberOfPoints()
                    << " points, and is kept so; is the file damaged? Those of further pieces are "
                    << "not reported");
  }
}

//------------------------------------------------------------------------------
int vtkHeliosLASReader::RequestData(
  vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro(<< "FileName is not set; give the LAS file with SetFileName");
    return 0;
  }
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int port = std::max(0, request->Get(Pipeline::FROM_OUTPUT_PORT()));
  vtkInformation* outInfo = outputVector->GetInformationObject(port);
  const bool isPiece = outInfo->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) != 0;
  const int count = isPiece ? std::max(1, outInfo->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())) : 1;
  const int piece = isPiece ? outInfo->Get(Pipeline::UPDATE_PIECE_NUMBER()) : 0;
  if (piece < 0 || piece >= count)
  {
    return 1; // no part of the file
  }
  helios::LasFile file;
  helios::Status status;
  try
  {
    status = file.Open(this->FileName);
    const auto points = file.GetHeader().Points.Count;
    const auto n = static_cast<std::uint64_t>(count);
    const auto i = static_cast<std::uint64_t>(piece);
    status = status.IsOk()
      ? this->ReadPoints(file, GetPieceBegin(points, i, n), GetPieceBegin(points, i + 1, n),
          vtkPolyData::GetData(outputVector), vtkTable::GetData(outputVector, 1))
      : status;
  }
  catch (const std::bad_alloc&)
  {
    status = helios::Status::Error(
      std::string(this->FileName) + ": not enough memory for its points; ask for it in pieces");
  }
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  return 1;
}
