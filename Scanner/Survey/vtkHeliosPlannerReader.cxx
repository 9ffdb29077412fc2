// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPlannerReader.h"

#include "heliosMessages.h"
#include "heliosMovingInstances.h"
#include "heliosPlannerData.h"
#include "heliosSceneBuilder.h"
#include "heliosXmlPlanner.h"
#include "vtkHeliosScene.h"

#include <vtkDataObject.h>
#include <vtkDemandDrivenPipeline.h>
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

/// Returns a scene with its moving parts where they are at the start, and those that deform as their first
/// frame; null after an error.
vtkSmartPointer<vtkPolyData> PlaceAtStart(
  const helios::SurveyData& survey, vtkPolyData* scene, helios::Messages& log)
{
  helios::MovingInstances parts(survey.Scene, scene, {}, survey.Convention, log);
  parts.StandStill();
  return log.HasError() ? nullptr : parts.GetScene();
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
  this->SetNumberOfInputPorts(1);
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
  helios::Messages log(this);
  helios::PlannerRequest request;
  request.FileName = Text(this->FileName);
  request.HasScene = this->GetNumberOfInputConnections(0) > 0;
  if (request.FileName.empty() && !request.HasScene)
  {
    vtkErrorMacro(<< "FileName is not set, and there is no scene on port 0; give the name of a "
                     "planner, survey or scene file, or connect a scene");
    return false;
  }
  request.AssetDirectories = this->Reader->AssetDirectories;
  request.Platform = Text(this->Platform);
  request.Scanner = Text(this->Scanner);
  request.DefaultPlatform = Text(this->DefaultPlatform);
  request.DefaultScanner = Text(this->DefaultScanner);
  request.UseScannerLimits = this->UseScannerLimits;
  request.UseMovingParts = this->UseMovingParts;
  request.Resolution = this->Resolution;
  request.PulseFrequency = this->PulseFrequency;
  try
  {
    this->Reader->Data = helios::ReadPlanner(request, log);
    this->Reader->IsGood = !log.HasError();
  }
  catch (const std::exception& error) // standard library errors: out of memory, file system
  {
    vtkErrorMacro(<< request.FileName << ": cannot be read: " << error.what());
  }
  this->Reader->ReadTime = this->GetMTime();
  return this->Reader->IsGood;
}

//------------------------------------------------------------------------------
int vtkHeliosPlannerReader::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
vtkTypeBool vtkHeliosPlannerReader::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, inputs, outputs);
  }
  vtkPolyData* given = vtkPolyData::GetData(inputs[0]);
  const bool isScene = given ? vtkHeliosScene::SafeDownCast(given) != nullptr : this->Instances;
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (!output || isScene != (vtkHeliosScene::SafeDownCast(output) != nullptr))
  {
    const auto made = isScene ? vtkSmartPointer<vtkPolyData>(vtkSmartPointer<vtkHeliosScene>::New())
                              : vtkSmartPointer<vtkPolyData>::New();
    outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosPlannerReader::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputVector)
{
  const bool isCurrent = this->Reader->IsGood && this->Reader->ReadTime == this->GetMTime();
  if (!isCurrent && !this->Read())
  {
    return 0;
  }
  if (vtkPolyData* given = vtkPolyData::GetData(inputs[0]))
  {
    this->Reader->Grids.clear();
    vtkPolyData::GetData(outputVector)->ShallowCopy(given);
    return 1;
  }
  helios::Messages log(this);
  helios::SceneBuilder builder(this->GetData().Survey.Scene, log);
  builder.SetInstances(this->Instances);
  const auto onStep = [this](const std::string& step)
  {
    this->SetProgressText(step.c_str());
    this->UpdateProgress(this->GetProgress());
    return this->GetAbortExecute() == 0;
  };
  const vtkSmartPointer<vtkPolyData> scene =
    PlaceAtStart(this->GetData().Survey, builder.Build(onStep), log);
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

//------------------------------------------------------------------------------
const helios::PlannerSettings& vtkHeliosPlannerReader::GetSettings() const
{
  return this->GetData().Settings;
}

namespace
{

/// Returns the scan of a plan's leg; all zero if none was read.
helios::ScanData GetScan(const helios::PlannerData& data)
{
  const auto& legs = data.Survey.Legs;
  return legs.empty() || legs.front().Scans.empty() ? helios::ScanData()
                                                    : legs.front().Scans.front();
}

} // namespace

// Values of what was read.
#define HELIOS_VALUE(Type, Name, Value)                                                            \
  Type vtkHeliosPlannerReader::Get##Name() const                                                   \
  {                                                                                                \
    return Value;                                                                                  \
  }

HELIOS_VALUE(std::string, Kind, this->GetData().Kind)
HELIOS_VALUE(std::string, PlanName, this->GetData().Survey.Name)
HELIOS_VALUE(std::string, SceneReference, this->GetData().SceneReference)
HELIOS_VALUE(std::string, PlatformReference, this->GetData().PlatformReference)
HELIOS_VALUE(std::string, ScannerReference, this->GetData().ScannerReference)
HELIOS_VALUE(std::string, Method, this->GetSettings().Method)
HELIOS_VALUE(std::string, RemoveOrder, this->GetSettings().RemoveOrder)
HELIOS_VALUE(bool, ScannerLimits, this->GetSettings().HasScannerLimits)
HELIOS_VALUE(bool, MovingParts, this->GetSettings().HasMovingParts)
HELIOS_VALUE(double, LegPulseFrequency, GetScan(this->GetData()).PulseFrequency)
HELIOS_VALUE(double, LegScanFrequency, GetScan(this->GetData()).ScanFrequency)
HELIOS_VALUE(double, LegScanAngle, GetScan(this->GetData()).ScanAngle)
HELIOS_VALUE(double, LegVerticalAngleMin, GetScan(this->GetData()).VerticalAngleMin)
HELIOS_VALUE(double, LegVerticalAngleMax, GetScan(this->GetData()).VerticalAngleMax)
HELIOS_VALUE(double, LegHeadRotateStart, GetScan(this->GetData()).HeadRotateStart)
HELIOS_VALUE(double, LegHeadRotateStop, GetScan(this->GetData()).HeadRotateStop)
HELIOS_VALUE(double, LegHeadRotatePerSecond, GetScan(this->GetData()).HeadRotateSpeed)

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
     << indent << "UseMovingParts: " << this->UseMovingParts << "\n"
     << indent << "KeepGrids: " << this->KeepGrids << "\n"
     << indent << "Instances: " << this->Instances << "\n"
     << indent << "Resolution: " << this->Resolution << "\n"
     << indent << "PulseFrequency: " << this->PulseFrequency << "\n"
     << indent << "Kind: " << this->GetKind() << "\n"
     << indent << "PlanName: " << this->GetPlanName() << "\n";
  for (const std::string& directory : this->Reader->AssetDirectories)
  {
    os << indent << "AssetDirectory: " << directory << "\n";
  }
}
