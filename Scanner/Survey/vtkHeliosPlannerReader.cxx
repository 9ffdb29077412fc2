// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPlannerReader.h"

#include "heliosMessages.h"
#include "heliosPlannerData.h"
#include "heliosSceneBuilder.h"
#include "heliosXmlPlanner.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <exception>

vtkStandardNewMacro(vtkHeliosPlannerReader);

namespace
{

std::string Text(const char* text)
{
  return text ? text : "";
}

} // namespace

/// The data of the last Read(), and whether they are up to date with the properties.
class vtkHeliosPlannerReader::Internals
{
public:
  helios::PlannerData Data;
  std::vector<std::string> AssetDirectories;
  std::vector<vtkSmartPointer<vtkImageData>> Grids;
  vtkMTimeType ReadTime = 0;
  bool IsGood = false;
};

//------------------------------------------------------------------------------
vtkHeliosPlannerReader::vtkHeliosPlannerReader()
  : Reader(new Internals)
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHeliosPlannerReader::~vtkHeliosPlannerReader()
{
  this->SetFileName(nullptr);
  this->SetPlatform(nullptr);
  this->SetScanner(nullptr);
  this->SetDefaultPlatform(nullptr);
  this->SetDefaultScanner(nullptr);
}

//------------------------------------------------------------------------------
void vtkHeliosPlannerReader::AddAssetDirectory(const char* directory)
{
  if (directory && *directory)
  {
    this->Reader->AssetDirectories.emplace_back(directory);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHeliosPlannerReader::RemoveAllAssetDirectories()
{
  this->Reader->AssetDirectories.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkHeliosPlannerReader::Read()
{
  this->Reader->IsGood = false;
  this->Reader->Data = helios::PlannerData();
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro(<< "FileName is not set; give the name of a planner, survey or scene file");
    return false;
  }
  helios::Messages log(this);
  helios::PlannerRequest request;
  request.FileName = this->FileName;
  request.AssetDirectories = this->Reader->AssetDirectories;
  request.Platform = Text(this->Platform);
  request.Scanner = Text(this->Scanner);
  request.DefaultPlatform = Text(this->DefaultPlatform);
  request.DefaultScanner = Text(this->DefaultScanner);
  request.UseScannerLimits = this->UseScannerLimits;
  request.Resolution = this->Resolution;
  request.PulseFrequency = this->PulseFrequency;
  try
  {
    this->Reader->Data = helios::ReadPlanner(request, log);
    this->Reader->IsGood = !log.HasError();
  }
  catch (const std::exception& error) // standard library errors: out of memory, file system
  {
    vtkErrorMacro(<< this->FileName << ": cannot be read: " << error.what());
  }
  this->Reader->ReadTime = this->GetMTime();
  return this->Reader->IsGood;
}

//------------------------------------------------------------------------------
int vtkHeliosPlannerReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const bool isCurrent = this->Reader->IsGood && this->Reader->ReadTime == this->GetMTime();
  if (!isCurrent && !this->Read())
  {
    return 0;
  }
  helios::Messages log(this);
  helios::SceneBuilder builder(this->GetData().Survey.Scene, log);
  const auto onStep = [this](const std::string& step)
  {
    this->SetProgressText(step.c_str());
    this->UpdateProgress(this->GetProgress());
    return this->GetAbortExecute() == 0;
  };
  const vtkSmartPointer<vtkPolyData> scene = builder.Build(onStep);
  this->Reader->Grids.clear();
  if (scene)
  {
    this->Reader->Grids =
      this->KeepGrids ? builder.GetGrids() : std::vector<vtkSmartPointer<vtkImageData>>();
    vtkPolyData::GetData(outputVector)->ShallowCopy(scene);
  }
  else if (!log.HasError())
  {
    vtkErrorMacro(<< this->FileName << ": stopped while the scene was loaded");
  }
  return scene ? 1 : 0;
}

//------------------------------------------------------------------------------
vtkImageData* vtkHeliosPlannerReader::GetGrid(int grid) const
{
  const auto& grids = this->Reader->Grids;
  const auto index = static_cast<std::size_t>(grid);
  return index < grids.size() ? grids[index].Get() : nullptr;
}

//------------------------------------------------------------------------------
const helios::PlannerData& vtkHeliosPlannerReader::GetData() const
{
  return this->Reader->Data;
}

namespace
{

/// The scan of a plan's leg; all zero if none was read.
helios::ScanData GetScan(const helios::PlannerData& data)
{
  const auto& legs = data.Survey.Legs;
  return legs.empty() || legs.front().Scans.empty() ? helios::ScanData()
                                                    : legs.front().Scans.front();
}

} // namespace

//------------------------------------------------------------------------------
std::string vtkHeliosPlannerReader::GetKind() const
{
  return this->GetData().Kind;
}

//------------------------------------------------------------------------------
std::string vtkHeliosPlannerReader::GetPlanName() const
{
  return this->GetData().Survey.Name;
}

//------------------------------------------------------------------------------
std::string vtkHeliosPlannerReader::GetSceneReference() const
{
  return this->GetData().SceneReference;
}

//------------------------------------------------------------------------------
std::string vtkHeliosPlannerReader::GetPlatformReference() const
{
  return this->GetData().PlatformReference;
}

//------------------------------------------------------------------------------
std::string vtkHeliosPlannerReader::GetScannerReference() const
{
  return this->GetData().ScannerReference;
}

//------------------------------------------------------------------------------
std::string vtkHeliosPlannerReader::GetMethod() const
{
  return this->GetData().Method;
}

//------------------------------------------------------------------------------
std::string vtkHeliosPlannerReader::GetRemoveOrder() const
{
  return this->GetData().RemoveOrder;
}

//------------------------------------------------------------------------------
bool vtkHeliosPlannerReader::GetRemoveLargestFirst() const
{
  return this->GetData().RemoveFirst == "largest";
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetMinimumCoverage() const
{
  return this->GetData().MinimumCoverage;
}

//------------------------------------------------------------------------------
bool vtkHeliosPlannerReader::GetCoverageOfAll() const
{
  return this->GetData().CoverageOf == "all";
}

//------------------------------------------------------------------------------
bool vtkHeliosPlannerReader::GetUseAreas() const
{
  return this->GetData().UseAreas;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetMinimumOverlap() const
{
  return this->GetData().MinimumOverlap / 100.0;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetTimeLimit() const
{
  return this->GetData().TimeLimit;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetXStep() const
{
  return this->GetData().PositionStep[0];
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetYStep() const
{
  return this->GetData().PositionStep[1];
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetTestPointStep() const
{
  return this->GetData().TestPointStep;
}

//------------------------------------------------------------------------------
std::string vtkHeliosPlannerReader::GetTestLines() const
{
  return this->GetData().TestLines;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetMaximumSlope() const
{
  return this->GetData().MaximumSlope;
}

//------------------------------------------------------------------------------
bool vtkHeliosPlannerReader::GetEnclosed() const
{
  return this->GetData().TakesEnclosed;
}

//------------------------------------------------------------------------------
std::string vtkHeliosPlannerReader::GetGroundOnly() const
{
  return this->GetData().GroundOnly;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetScannerHeight() const
{
  return this->GetData().ScannerHeight;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetHitTolerance() const
{
  return this->GetData().HitTolerance;
}

//------------------------------------------------------------------------------
bool vtkHeliosPlannerReader::GetHitBehind() const
{
  return this->GetData().SeesBefore;
}

//------------------------------------------------------------------------------
bool vtkHeliosPlannerReader::GetScannerLimits() const
{
  return this->GetData().HasScannerLimits;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetRangeMin() const
{
  return this->GetData().RangeMin;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetRangeMax() const
{
  return this->GetData().RangeMax;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetElevationMin() const
{
  return this->GetData().ElevationMin;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetElevationMax() const
{
  return this->GetData().ElevationMax;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetMaximumIncidenceAngle() const
{
  return this->GetData().MaximumIncidenceAngle;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetMinimumPointDensity() const
{
  return this->GetData().MinimumPointDensity;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetLegPulseFrequency() const
{
  return GetScan(this->GetData()).PulseFrequency;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetLegScanFrequency() const
{
  return GetScan(this->GetData()).ScanFrequency;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetLegScanAngle() const
{
  return GetScan(this->GetData()).ScanAngle;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetLegVerticalAngleMin() const
{
  return GetScan(this->GetData()).VerticalAngleMin;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetLegVerticalAngleMax() const
{
  return GetScan(this->GetData()).VerticalAngleMax;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetLegHeadRotateStart() const
{
  return GetScan(this->GetData()).HeadRotateStart;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetLegHeadRotateStop() const
{
  return GetScan(this->GetData()).HeadRotateStop;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetLegHeadRotatePerSecond() const
{
  return GetScan(this->GetData()).HeadRotateSpeed;
}

//------------------------------------------------------------------------------
bool vtkHeliosPlannerReader::HasRotatingMirror() const
{
  const auto& scanners = this->GetData().Survey.Scanners;
  return !scanners.empty() && scanners.front().Type == helios::Optics::RotatingMirror;
}

//------------------------------------------------------------------------------
double vtkHeliosPlannerReader::GetLegAngularStep() const
{
  const helios::ScanData scan = GetScan(this->GetData());
  if (!this->HasRotatingMirror() || scan.PulseFrequency <= 0.0 || scan.ScanFrequency <= 0.0)
  {
    return 0.0;
  }
  const double sweep = 2.0 * this->GetData().Survey.Scanners.front().ScanAngleMax;
  return std::max(sweep * scan.ScanFrequency / scan.PulseFrequency,
    std::abs(scan.HeadRotateSpeed) / scan.ScanFrequency);
}

//------------------------------------------------------------------------------
void vtkHeliosPlannerReader::GetInstrument(double position[3]) const
{
  const helios::Vec3 instrument = this->GetData().Instrument;
  std::copy_n(instrument.GetData(), 3, position);
}

//------------------------------------------------------------------------------
void vtkHeliosPlannerReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << Text(this->FileName) << "\n"
     << indent << "Platform: " << Text(this->Platform) << "\n"
     << indent << "Scanner: " << Text(this->Scanner) << "\n"
     << indent << "DefaultPlatform: " << Text(this->DefaultPlatform) << "\n"
     << indent << "DefaultScanner: " << Text(this->DefaultScanner) << "\n"
     << indent << "UseScannerLimits: " << this->UseScannerLimits << "\n"
     << indent << "KeepGrids: " << this->KeepGrids << "\n"
     << indent << "Resolution: " << this->Resolution << "\n"
     << indent << "PulseFrequency: " << this->PulseFrequency << "\n"
     << indent << "Kind: " << this->GetKind() << "\n"
     << indent << "PlanName: " << this->GetPlanName() << "\n";
  for (const std::string& directory : this->Reader->AssetDirectories)
  {
    os << indent << "AssetDirectory: " << directory << "\n";
  }
}
