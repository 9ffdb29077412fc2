// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosTrajectoryReader.h"

#include "heliosPathCell.h"
#include "heliosPoseText.h"
#include "heliosRecordedPath.h"
#include "heliosSbetFile.h"
#include "heliosSceneCrs.h"
#include "heliosStatus.h"
#include "heliosTrajectoryParser.h"
#include "heliosTrajectoryShape.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <iterator>
#include <new>
#include <numeric>

vtkStandardNewMacro(vtkHeliosTrajectoryReader);

namespace names = vtkHeliosArrayNames;

//------------------------------------------------------------------------------
vtkHeliosTrajectoryReader::vtkHeliosTrajectoryReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHeliosTrajectoryReader::~vtkHeliosTrajectoryReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkHeliosTrajectoryReader::UseWriterFormat()
{
  this->SetSeparators(" ");
  this->SetXColumn(0);
  this->SetYColumn(1);
  this->SetZColumn(2);
  this->SetTimeColumn(3);
  this->SetRollColumn(4);
  this->SetPitchColumn(5);
  this->SetYawColumn(6);
  this->SetAngleUnitToDegrees();
  this->SetAngleConventionToCanonical();
}

//------------------------------------------------------------------------------
bool vtkHeliosTrajectoryReader::CheckProperties()
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro(<< "FileName is not set; give the file of the trajectory with SetFileName");
    return false;
  }
  if (this->Separators.empty() ||
    !std::all_of(this->Separators.begin(), this->Separators.end(), helios::TextRow::IsSeparator))
  {
    vtkErrorMacro(<< "Separators is \"" << this->Separators
                  << "\"; give characters other than letters, digits and + - . # /, such as \",\"");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
helios::TrajectoryFormat vtkHeliosTrajectoryReader::MakeFormat() const
{
  helios::TrajectoryFormat format;
  format.Separators = this->Separators;
  format.Columns = { { this->TimeColumn, this->RollColumn, this->PitchColumn, this->YawColumn,
    this->XColumn, this->YColumn, this->ZColumn } };
  format.HasAttitude = this->Domain == POSITION_AND_ATTITUDE;
  return format;
}

//------------------------------------------------------------------------------
int vtkHeliosTrajectoryReader::FindFormat() const
{
  if (this->FileFormat != AUTOMATIC || !this->FileName)
  {
    return this->FileFormat == AUTOMATIC ? COLUMNS : this->FileFormat;
  }
  const std::string ending =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(this->FileName));
  if (ending == ".sbet" || ending == ".out")
  {
    return SBET;
  }
  return ending == ".tum" ? TUM : COLUMNS;
}

//------------------------------------------------------------------------------
bool vtkHeliosTrajectoryReader::ReadFile(helios::TextReport& report, helios::RecordedPath& path)
{
  return this->IsSbet() ? this->ReadSbet(report, path) : this->ReadText(report, path);
}

//------------------------------------------------------------------------------
bool vtkHeliosTrajectoryReader::ReadSbet(helios::TextReport& report, helios::RecordedPath& path)
{
  helios::SbetReader reader(this->FileName);
  reader.OnBlock = [this](double fraction)
  {
    this->UpdateProgress(fraction);
    return !this->AbortExecute;
  };
  const helios::Status status = reader.Read(this->FileCRS, this->TargetCRS, path, report);
  return status.IsOk() || report.Fail(status.Message());
}

//------------------------------------------------------------------------------
bool vtkHeliosTrajectoryReader::ReadText(helios::TextReport& report, helios::RecordedPath& path)
{
  helios::LineFile file;
  const helios::Status status = file.Open(this->FileName);
  if (!status.IsOk())
  {
    return report.Fail(status.Message());
  }
  file.OnBlock = [this, size = static_cast<double>(file.GetSize())](std::int64_t bytes)
  {
    this->UpdateProgress(std::min(1.0, static_cast<double>(bytes) / size));
    return !this->AbortExecute;
  };
  const int kind = this->FindFormat();
  if (kind == COLUMNS)
  {
    const helios::TrajectoryFormat format = this->MakeFormat();
    return helios::TrajectoryParser(format, report).Read(file, path.Rows);
  }
  const helios::PoseColumns& columns = kind == TUM ? helios::TumColumns : helios::EurocColumns;
  if (!helios::PoseTextParser(columns, report).Read(file, path))
  {
    return false;
  }
  const auto axes = helios::ToBodyAxes(static_cast<helios::BodyAxes>(this->BodyFrame));
  for (helios::Quaternion& attitude : path.Attitudes)
  {
    attitude = attitude * axes;
  }
  return true;
}

//------------------------------------------------------------------------------
/// Makes the attitudes of rows that have angles, or none.
void vtkHeliosTrajectoryReader::FindAttitudes(helios::RecordedPath& path) const
{
  if (this->Domain == POSITION)
  {
    path.Attitudes = helios::HeadingsOfFlight(path.Rows, this->MinimumSpeed);
  }
  else if (path.Attitudes.empty())
  {
    const double unit = this->AngleUnit == DEGREES ? vtkMath::RadiansFromDegrees(1.0) : 1.0;
    const auto convert = this->AngleConvention == CANONICAL ? helios::FromCanonical
      : this->AngleConvention == NAVIGATION                 ? helios::FromNavigation
                                                            : helios::FromArinc705;
    std::transform(path.Rows.begin(), path.Rows.end(), std::back_inserter(path.Attitudes),
      [unit, convert](const helios::TrajectoryRow& row) { return convert(unit * row.Angles); });
  }
}

//------------------------------------------------------------------------------
void vtkHeliosTrajectoryReader::Fill(
  const helios::RecordedPath& path, vtkPolyData* trajectory) const
{
  const std::vector<helios::TrajectoryRow>& rows = path.Rows;
  const std::vector<helios::Quaternion>& attitudes = path.Attitudes;
  std::vector<std::size_t> kept(rows.size());
  std::iota(kept.begin(), kept.end(), std::size_t(0));
  if (this->SlopeFilterThreshold > 0.0)
  {
    kept = helios::FilterSlopes(rows, attitudes, this->SlopeFilterThreshold);
  }

  const auto count = static_cast<vtkIdType>(kept.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkDoubleArray> times;
  times->SetName(names::GpsTime);
  times->SetNumberOfValues(count);
  vtkNew<vtkDoubleArray> orientations;
  orientations->SetName(names::Orientation);
  orientations->SetNumberOfComponents(4);
  orientations->SetNumberOfTuples(count);
  vtkNew<vtkDoubleArray> velocities;
  velocities->SetName(names::Velocity);
  velocities->SetNumberOfComponents(3);
  velocities->SetNumberOfTuples(path.Velocities.empty() ? 0 : count);
  helios::Quaternion before(1.0, 0.0, 0.0, 0.0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const std::size_t row = kept[static_cast<std::size_t>(i)];
    const helios::Quaternion& q = attitudes[row];
    const double dot = std::inner_product(q.GetData(), q.GetData() + 4, before.GetData(), 0.0);
    before = dot < 0.0 ? q * -1.0 : q;
    points->SetPoint(i, rows[row].Position.GetData());
    times->SetValue(i, rows[row].Time);
    orientations->SetTypedTuple(i, before.GetData());
    if (!path.Velocities.empty())
    {
      velocities->SetTypedTuple(i, path.Velocities[row].GetData());
    }
  }
  trajectory->SetPoints(points);
  trajectory->GetPointData()->AddArray(times);
  trajectory->GetPointData()->AddArray(orientations);
  if (!path.Velocities.empty())
  {
    trajectory->GetPointData()->AddArray(velocities);
  }
  helios::AddPathCell(trajectory);
  helios::SetCRS(trajectory, path.Crs);
}

//------------------------------------------------------------------------------
int vtkHeliosTrajectoryReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->CheckProperties())
  {
    return 0;
  }
  helios::TextReport report;
  helios::RecordedPath path;
  bool isRead = false;
  try
  {
    isRead = this->ReadFile(report, path);
    if (isRead)
    {
      this->FindAttitudes(path);
      this->Fill(path, vtkPolyData::GetData(outputVector));
    }
  }
  catch (const std::bad_alloc&)
  {
    isRead = report.Fail(std::string(this->FileName) +
      ": not enough memory for its rows; split the file by time and read the part that is flown");
  }
  for (const std::string& warning : report.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  if (!isRead)
  {
    vtkErrorMacro(<< report.Error);
  }
  return isRead;
}

//------------------------------------------------------------------------------
void vtkHeliosTrajectoryReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const formats[] = { "Automatic", "Columns", "SBET", "TUM", "EuRoC" };
  const char* const frames[] = { "RightForwardUp", "ForwardLeftUp", "ForwardRightDown" };
  const char* const conventions[] = { "Arinc705", "Canonical", "Navigation" };
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n"
     << indent << "FileFormat: " << formats[this->FileFormat] << "\n"
     << indent << "FileCRS: " << this->FileCRS << "\n"
     << indent << "TargetCRS: " << this->TargetCRS << "\n"
     << indent << "BodyFrame: " << frames[this->BodyFrame] << "\n"
     << indent << "Separators: \"" << this->Separators << "\"\n"
     << indent << "TimeColumn: " << this->TimeColumn << "\n"
     << indent << "RollColumn: " << this->RollColumn << "\n"
     << indent << "PitchColumn: " << this->PitchColumn << "\n"
     << indent << "YawColumn: " << this->YawColumn << "\n"
     << indent << "XColumn: " << this->XColumn << "\n"
     << indent << "YColumn: " << this->YColumn << "\n"
     << indent << "ZColumn: " << this->ZColumn << "\n"
     << indent << "Domain: " << (this->Domain == POSITION ? "Position" : "PositionAndAttitude")
     << "\n"
     << indent << "AngleUnit: " << (this->AngleUnit == DEGREES ? "Degrees" : "Radians") << "\n"
     << indent << "AngleConvention: " << conventions[this->AngleConvention] << "\n"
     << indent << "SlopeFilterThreshold: " << this->SlopeFilterThreshold << " m/s, deg/s\n"
     << indent << "MinimumSpeed: " << this->MinimumSpeed << " m/s\n";
}
