// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSurveyWriter.h"

#include "heliosMessages.h"
#include "heliosPlannerScan.h"
#include "heliosSceneCrs.h"
#include "heliosStatus.h"
#include "heliosSurveyDocument.h"
#include "heliosXmlFilter.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFlightArrayNames.h"
#include "vtkHeliosSurvey.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>
#include <exception>
#include <filesystem>
#include <memory>

vtkStandardNewMacro(vtkHeliosSurveyWriter);

namespace
{

constexpr const char* TemplateId = "plan"; // id of scanner and platform settings

std::string Text(const char* text)
{
  return text ? text : "";
}

/// Returns the number of a strip, so that names of files sort.
std::string MakeStripId(double number)
{
  const std::string digits = std::to_string(static_cast<int>(number));
  return std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

} // namespace

/// One file being written.
class vtkHeliosSurveyWriter::Internals
{
public:
  Internals(vtkHeliosSurveyWriter* writer, vtkPolyData* positions)
    : Writer(writer)
    , Log(writer)
    , Positions(positions)
    , Speeds(positions->GetPointData()->GetArray(vtkHeliosArrayNames::Speed))
    , Strips(positions->GetPointData()->GetArray(vtkHeliosArrayNames::LegIds))
    , Active(positions->GetPointData()->GetArray(vtkHeliosFlightArrayNames::Active))
    , Crs(helios::GetCRS(positions))
  {
  }

  bool Write(vtkHeliosSurvey* survey);

private:
  using Document = std::unique_ptr<helios::SurveyDocument>;

  bool CheckSettings(bool isFile);
  bool CheckPositions();
  bool CheckSpeeds();
  bool CheckSurvey(const helios::SurveyData& survey, bool hasError);
  Document Make(const helios::Vec3& instrument) const;
  helios::LegSettings MakeSettings() const;
  void AddLegs(const helios::Vec3& instrument, helios::SurveyDocument& document) const;
  std::string GetName() const;
  bool Fail(const std::string& text);

  vtkHeliosSurveyWriter* Writer;
  helios::Messages Log;
  vtkPolyData* Positions;
  vtkDataArray* Speeds; // speeds of waypoints; null: scan positions
  vtkDataArray* Strips; // strips of waypoints; null: every leg has its own files
  vtkDataArray* Active; // active waypoints; null: all
  std::string Crs;      // system of the legs; empty: the scene's
};

//------------------------------------------------------------------------------
/// Writes the file, or makes a survey without one.
bool vtkHeliosSurveyWriter::Internals::Write(vtkHeliosSurvey* survey)
{
  if (!this->CheckSettings(!survey) || !this->CheckPositions() || !this->CheckSpeeds())
  {
    return false;
  }
  // First read with uncorrected positions: the references give the offset to the platform's foot.
  Document document = this->Make({ 0.0, 0.0, 0.0 });
  const helios::SurveyData data = document->Resolve(this->Writer);
  if (!this->CheckSurvey(data, document->HasError()))
  {
    return false;
  }
  const bool isOfScene = Text(this->Writer->Scene).empty() || this->Crs == data.Scene.Crs;
  this->Crs = isOfScene ? "" : this->Crs;
  document = this->Make(helios::FindInstrument(data.Platforms.front(), data.Scanners.front()));
  if (survey)
  {
    return survey->ReadDocument(std::move(document), nullptr); // messages are known;
  }
  const helios::Status status = document->Write(this->Writer->FileName);
  return status.IsOk() || this->Fail(status.Message() + "; give another FileName");
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyWriter::Internals::CheckSettings(bool isFile)
{
  const auto isSet = [this](const char* name, const char* value, const char* cure)
  { return (value && *value) || this->Fail(std::string(name) + " is not set; give " + cure); };
  return (!isFile || isSet("FileName", this->Writer->FileName, "the survey file to write")) &&
    (!isFile || isSet("Scene", this->Writer->Scene, "what is scanned, file.xml#id or a mesh")) &&
    isSet("Platform", this->Writer->Platform, "what carries the scanner, file.xml#id") &&
    isSet("Scanner", this->Writer->Scanner, "the scanner, file.xml#id");
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyWriter::Internals::CheckPositions()
{
  if (this->Positions->GetNumberOfPoints() == 0)
  {
    return this->Fail(this->GetName() +
      ": not written: the input has no position; give it the positions that a "
      "vtkHeliosScanPositionPlanner has selected");
  }
  for (vtkIdType i = 0; i < this->Positions->GetNumberOfPoints(); ++i)
  {
    const double* p = this->Positions->GetPoint(i);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      helios::MessageBuilder text;
      text << this->GetName() << ": not written: position " << i << " is (" << p[0] << ", " << p[1]
           << ", " << p[2] << "); give finite coordinates";
      return this->Fail(text.str());
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyWriter::Internals::CheckSpeeds()
{
  for (vtkIdType i = 0; this->Speeds && i < this->Speeds->GetNumberOfTuples(); ++i)
  {
    const double speed = this->Speeds->GetTuple1(i);
    if (!(std::isfinite(speed) && speed > 0.0))
    {
      helios::MessageBuilder text;
      text << this->GetName() << ": not written: " << vtkHeliosArrayNames::Speed << " of waypoint "
           << i << " is " << speed << " m/s; give a positive speed";
      return this->Fail(text.str());
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyWriter::Internals::CheckSurvey(const helios::SurveyData& survey, bool hasError)
{
  const std::string file = this->GetName();
  if (this->Speeds && !survey.Legs.empty() && !survey.IsMoving(0))
  {
    return this->Fail(file + ": not written: Platform " + this->Writer->Platform +
      " is static, but waypoints need a moving one; give a platform such as "
      "platforms.xml#airplane_linearpath");
  }
  if (hasError)
  {
    return this->Fail(file +
      ": not written: the survey could not be run; correct the properties "
      "named in the preceding messages");
  }
  if (!this->Speeds && survey.IsMoving(0))
  {
    return this->Fail(file + ": not written: Platform " + this->Writer->Platform +
      " moves, but scan positions need a static one; give a platform of type=\"static\"");
  }
  return true;
}

//------------------------------------------------------------------------------
vtkHeliosSurveyWriter::Internals::Document vtkHeliosSurveyWriter::Internals::Make(
  const helios::Vec3& instrument) const
{
  const std::string name = Text(this->Writer->SurveyName);
  const std::string stem = std::filesystem::path(this->GetName()).stem().string();
  auto document = std::make_unique<helios::SurveyDocument>(this->Writer, this->GetName());
  document->SetAssetDirectories(this->Writer->AssetDirectories);
  const bool hasScene = !Text(this->Writer->Scene).empty();
  document->SetNeeds(hasScene ? helios::AssetNeed::Required : helios::AssetNeed::Replaced,
    helios::AssetNeed::Required);
  document->SetComment(this->Speeds ? " Flight lines, written by vtkHelios. "
                                    : " Scan positions, written by vtkHelios. ");
  document->Set({ helios::SurveyItem::Survey }, "name", name.empty() ? stem : name);
  document->SetSources(
    Text(this->Writer->Scene), Text(this->Writer->Platform), Text(this->Writer->Scanner));
  if (helios::FindLoader(Text(this->Writer->Scene)))
  {
    document->Set({ helios::SurveyItem::Scene }, "crs", helios::GetCRS(this->Positions));
  }
  document->AddTemplate(TemplateId, this->MakeSettings());
  this->AddLegs(instrument, *document);
  return document;
}

//------------------------------------------------------------------------------
/// Returns the settings of all legs; the CRS only once, since WKT is long.
helios::LegSettings vtkHeliosSurveyWriter::Internals::MakeSettings() const
{
  helios::LegSettings all;
  all.Leg.Crs = this->Crs;
  all.PulseFrequency = this->Writer->PulseFrequency;
  all.ScanFrequency = this->Writer->ScanFrequency;
  all.ScanAngle = this->Writer->ScanAngle;
  all.VerticalAngleMin = this->Writer->VerticalAngleMin;
  all.VerticalAngleMax = this->Writer->VerticalAngleMax;
  if (!this->Speeds)
  {
    all.Scan.HeadRotateStart = this->Writer->HeadRotateStart;
    all.Scan.HeadRotateStop = this->Writer->HeadRotateStop;
    all.Scan.HeadRotateSpeed = this->Writer->HeadRotatePerSecond;
  }
  return all;
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyWriter::Internals::AddLegs(
  const helios::Vec3& instrument, helios::SurveyDocument& document) const
{
  // A moving platform turns the horizontal offset with its heading; only the vertical one stays.
  const helios::Vec3 offset = this->Speeds ? helios::Vec3(0.0, 0.0, instrument[2]) : instrument;
  for (vtkIdType i = 0; i < this->Positions->GetNumberOfPoints(); ++i)
  {
    helios::LegSettings leg;
    leg.Leg.Position = helios::RoundComputed(helios::Vec3(this->Positions->GetPoint(i)) - offset);
    leg.Leg.Speed = this->Speeds ? this->Speeds->GetTuple1(i) : leg.Leg.Speed;
    leg.Leg.Strip =
      this->Speeds && this->Strips ? MakeStripId(this->Strips->GetTuple1(i)) : std::string();
    leg.Leg.Active = !this->Active || this->Active->GetTuple1(i) != 0.0;
    document.AddLeg(leg, TemplateId);
  }
}

//------------------------------------------------------------------------------
/// Returns the file in messages, or what stands for one.
std::string vtkHeliosSurveyWriter::Internals::GetName() const
{
  const std::string file = Text(this->Writer->FileName);
  return file.empty() ? "survey" : file;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyWriter::Internals::Fail(const std::string& text)
{
  this->Log.Error(text);
  return false;
}

//------------------------------------------------------------------------------
vtkHeliosSurveyWriter::vtkHeliosSurveyWriter()
{
  this->SetNumberOfOutputPorts(0);
}

//------------------------------------------------------------------------------
vtkHeliosSurveyWriter::~vtkHeliosSurveyWriter()
{
  this->SetFileName(nullptr);
  this->SetSurveyName(nullptr);
  this->SetScene(nullptr);
  this->SetPlatform(nullptr);
  this->SetScanner(nullptr);
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyWriter::AddAssetDirectory(const char* directory)
{
  if (directory && *directory)
  {
    this->AssetDirectories.emplace_back(directory);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyWriter::RemoveAllAssetDirectories()
{
  this->AssetDirectories.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyWriter::Write()
{
  return this->BuildSurvey(nullptr);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyWriter::BuildSurvey(vtkHeliosSurvey* survey)
{
  this->IsWritten = false;
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    vtkErrorMacro(<< "no positions to write; give them with SetInputData or SetInputConnection");
    return false;
  }
  this->Modified(); // write again, even if nothing changed
  this->Survey = survey;
  this->Update();
  this->Survey = nullptr;
  return this->IsWritten;
}

//------------------------------------------------------------------------------
int vtkHeliosSurveyWriter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  try
  {
    Internals internals(this, vtkPolyData::GetData(inputVector[0]));
    this->IsWritten = internals.Write(this->Survey);
  }
  catch (const std::exception& error) // standard library errors: out of memory, file system
  {
    vtkErrorMacro(<< Text(this->FileName) << ": cannot be written: " << error.what());
  }
  return this->IsWritten ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << Text(this->FileName) << "\n"
     << indent << "SurveyName: " << Text(this->SurveyName) << "\n"
     << indent << "Scene: " << Text(this->Scene) << "\n"
     << indent << "Platform: " << Text(this->Platform) << "\n"
     << indent << "Scanner: " << Text(this->Scanner) << "\n"
     << indent << "PulseFrequency: " << this->PulseFrequency << "\n"
     << indent << "ScanFrequency: " << this->ScanFrequency << "\n"
     << indent << "ScanAngle: " << this->ScanAngle << "\n"
     << indent << "VerticalAngleMin: " << this->VerticalAngleMin << "\n"
     << indent << "VerticalAngleMax: " << this->VerticalAngleMax << "\n"
     << indent << "HeadRotateStart: " << this->HeadRotateStart << "\n"
     << indent << "HeadRotateStop: " << this->HeadRotateStop << "\n"
     << indent << "HeadRotatePerSecond: " << this->HeadRotatePerSecond << "\n";
  for (const std::string& directory : this->AssetDirectories)
  {
    os << indent << "AssetDirectory: " << directory << "\n";
  }
}
