// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSurveyWriter.h"

#include "heliosAssets.h"
#include "heliosMessages.h"
#include "heliosPartFile.h"
#include "heliosPlannerScan.h"
#include "heliosSceneCrs.h"
#include "heliosStatus.h"
#include "heliosXmlFilter.h"
#include "heliosXmlSurvey.h"
#include "heliosXmlText.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFlightArrayNames.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <pugixml.hpp>

#include <cmath>
#include <exception>

vtkStandardNewMacro(vtkHeliosSurveyWriter);

namespace
{

constexpr const char* TemplateId = "plan"; // id of scanner and platform settings
constexpr const char* SceneId = "scene";

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

  bool Write();

private:
  bool CheckSettings();
  bool CheckPositions();
  bool CheckSpeeds();
  bool CheckSurvey(const helios::SurveyData& survey);
  helios::SurveyData Read(const std::string& text);
  std::string MakeText(const helios::Vec3& instrument) const;
  void AddSettings(pugi::xml_node root) const;
  void AddScene(pugi::xml_node root) const;
  void AddLegs(pugi::xml_node survey, const helios::Vec3& instrument) const;
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
bool vtkHeliosSurveyWriter::Internals::Write()
{
  if (!this->CheckSettings() || !this->CheckPositions() || !this->CheckSpeeds())
  {
    return false;
  }
  // First read with uncorrected positions: the references give the offset to the platform's foot.
  const helios::SurveyData survey = this->Read(this->MakeText({ 0.0, 0.0, 0.0 }));
  if (!this->CheckSurvey(survey))
  {
    return false;
  }
  this->Crs = this->Crs == survey.Scene.Crs ? "" : this->Crs;
  const helios::Vec3 instrument =
    helios::FindInstrument(survey.Platforms.front(), survey.Scanners.front());
  const helios::Status status =
    helios::WriteWhole(this->Writer->FileName, this->MakeText(instrument));
  return status.IsOk() || this->Fail(status.Message() + "; give another FileName");
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyWriter::Internals::CheckSettings()
{
  const auto isSet = [this](const char* name, const char* value, const char* cure)
  { return (value && *value) || this->Fail(std::string(name) + " is not set; give " + cure); };
  return isSet("FileName", this->Writer->FileName, "the survey file to write") &&
    isSet("Scene", this->Writer->Scene, "what is scanned, file.xml#id or a mesh") &&
    isSet("Platform", this->Writer->Platform, "what carries the scanner, file.xml#id") &&
    isSet("Scanner", this->Writer->Scanner, "the scanner, file.xml#id");
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyWriter::Internals::CheckPositions()
{
  if (this->Positions->GetNumberOfPoints() == 0)
  {
    return this->Fail(Text(this->Writer->FileName) +
      ": not written: the input has no position; give it the positions that a "
      "vtkHeliosScanPositionPlanner has selected");
  }
  for (vtkIdType i = 0; i < this->Positions->GetNumberOfPoints(); ++i)
  {
    const double* p = this->Positions->GetPoint(i);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      helios::MessageBuilder text;
      text << this->Writer->FileName << ": not written: position " << i << " is (" << p[0] << ", "
           << p[1] << ", " << p[2] << "); give finite coordinates";
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
      text << this->Writer->FileName << ": not written: " << vtkHeliosArrayNames::Speed
           << " of waypoint " << i << " is " << speed << " m/s; give a positive speed";
      return this->Fail(text.str());
    }
  }
  return true;
}

//------------------------------------------------------------------------------
helios::SurveyData vtkHeliosSurveyWriter::Internals::Read(const std::string& text)
{
  helios::Assets assets(this->Log, this->Writer->AssetDirectories);
  return helios::ReadSurvey(
    assets.Add(helios::XmlDocument::Make(this->Writer->FileName, text, this->Log)), assets,
    this->Log);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyWriter::Internals::CheckSurvey(const helios::SurveyData& survey)
{
  const std::string file = this->Writer->FileName;
  if (this->Speeds && !survey.Legs.empty() && !survey.IsMoving(0))
  {
    return this->Fail(file + ": not written: Platform " + this->Writer->Platform +
      " is static, but waypoints need a moving one; give a platform such as "
      "platforms.xml#airplane_linearpath");
  }
  if (this->Log.HasError())
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
std::string vtkHeliosSurveyWriter::Internals::MakeText(const helios::Vec3& instrument) const
{
  pugi::xml_document document;
  pugi::xml_node root = helios::StartDocument(document,
    this->Speeds ? " Flight lines, written by vtkHelios. "
                 : " Scan positions, written by vtkHelios. ");
  this->AddScene(root);
  this->AddSettings(root);
  pugi::xml_node survey = root.append_child("survey");
  helios::SetAttribute(survey, "name", Text(this->Writer->SurveyName));
  helios::SetAttribute(survey, "scene", root.child("scene") ? SceneId : this->Writer->Scene);
  helios::SetAttribute(survey, "platform", this->Writer->Platform);
  helios::SetAttribute(survey, "scanner", this->Writer->Scanner);
  this->AddLegs(survey, instrument);
  return helios::ToXmlText(document);
}

//------------------------------------------------------------------------------
/// Adds a scene for a mesh.
void vtkHeliosSurveyWriter::Internals::AddScene(pugi::xml_node root) const
{
  const std::string text = helios::MakeMeshDocument(this->Writer->Scene, SceneId);
  pugi::xml_document mesh;
  if (!text.empty() && mesh.load_string(text.c_str()))
  {
    pugi::xml_node scene = root.append_copy(mesh.document_element().first_child());
    helios::SetAttribute(scene, "crs", helios::GetCRS(this->Positions));
  }
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyWriter::Internals::AddSettings(pugi::xml_node root) const
{
  if (!this->Crs.empty())
  {
    pugi::xml_node place = root.append_child("platformSettings");
    helios::SetAttribute(place, "id", TemplateId);
    helios::SetAttribute(place, "crs", this->Crs); // only once, since WKT is long
  }
  pugi::xml_node settings = root.append_child("scannerSettings");
  helios::SetAttribute(settings, "id", TemplateId);
  helios::LegSettings leg;
  leg.PulseFrequency = this->Writer->PulseFrequency;
  leg.ScanFrequency = this->Writer->ScanFrequency;
  leg.ScanAngle = this->Writer->ScanAngle;
  leg.VerticalAngleMin = this->Writer->VerticalAngleMin;
  leg.VerticalAngleMax = this->Writer->VerticalAngleMax;
  if (!this->Speeds)
  {
    leg.Scan.HeadRotateStart = this->Writer->HeadRotateStart;
    leg.Scan.HeadRotateStop = this->Writer->HeadRotateStop;
    leg.Scan.HeadRotateSpeed = this->Writer->HeadRotatePerSecond;
  }
  helios::SetStored(settings, leg);
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyWriter::Internals::AddLegs(
  pugi::xml_node survey, const helios::Vec3& instrument) const
{
  // A moving platform turns the horizontal offset with its heading; only the vertical one stays.
  const helios::Vec3 offset = this->Speeds ? helios::Vec3(0.0, 0.0, instrument[2]) : instrument;
  for (vtkIdType i = 0; i < this->Positions->GetNumberOfPoints(); ++i)
  {
    const helios::Vec3 foot = helios::Vec3(this->Positions->GetPoint(i)) - offset;
    pugi::xml_node leg = survey.append_child("leg");
    if (this->Speeds && this->Strips)
    {
      helios::SetAttribute(leg, "stripId", MakeStripId(this->Strips->GetTuple1(i)));
    }
    pugi::xml_node place = leg.append_child("platformSettings");
    helios::SetAttribute(place, "template", this->Crs.empty() ? "" : TemplateId);
    helios::LegSettings settings;
    settings.Leg.Position = helios::RoundComputed(foot);
    settings.Leg.Speed = this->Speeds ? this->Speeds->GetTuple1(i) : settings.Leg.Speed;
    helios::SetStored(place, settings);
    pugi::xml_node scan = leg.append_child("scannerSettings");
    helios::SetAttribute(scan, "template", TemplateId);
    if (this->Active && this->Active->GetTuple1(i) == 0.0)
    {
      helios::SetAttribute(scan, "active", "false");
    }
  }
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
  this->IsWritten = false;
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    vtkErrorMacro(<< "no positions to write; give them with SetInputData or SetInputConnection");
    return false;
  }
  this->Modified(); // write again, even if nothing changed
  this->Update();
  return this->IsWritten;
}

//------------------------------------------------------------------------------
int vtkHeliosSurveyWriter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  try
  {
    Internals internals(this, vtkPolyData::GetData(inputVector[0]));
    this->IsWritten = internals.Write();
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
