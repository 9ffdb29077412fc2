// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCloudReader.h"

#include "heliosCloud.h"
#include "heliosCoordinateTransform.h"
#include "heliosErrorText.h"
#include "heliosInputFile.h"
#include "heliosJsonText.h"
#include "heliosSceneCrs.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosLASReader.h"
#include "vtkHeliosPLYPointReader.h"
#include "vtkHeliosPointTextReader.h"
#include "vtkHeliosPointXMLReader.h"
#include "vtkHeliosRunFiles.h"
#include "vtkHeliosTrajectoryReader.h"

#include <vtkCallbackCommand.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;
namespace names = vtkHeliosArrayNames;
using RunFiles = vtkHeliosRunFiles;

namespace helios::viewer
{

namespace
{

constexpr vtkIdType BlockSize = 1 << 17; // points
constexpr double PieceBytes = 32.0 * 1024.0 * 1024.0;
constexpr const char* Endings[] = { ".xyz", ".txt", ".asc", ".csv", ".pts", ".ptx", ".las", ".laz",
  ".vtp", ".pvtp", ".ply" };

std::string GetEnding(const std::string& path)
{
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

std::string ListEndings()
{
  std::string all;
  for (const char* ending : Endings)
  {
    all += (all.empty() ? "" : ", ") + std::string(ending);
  }
  return all;
}

bool IsText(const std::string& ending)
{
  return ending == ".xyz" || ending == ".txt" || ending == ".asc" || ending == ".csv" ||
    ending == ".pts" || ending == ".ptx";
}

int CountPieces(const std::string& path)
{
  std::error_code ignored;
  return 1 + static_cast<int>(static_cast<double>(fs::file_size(path, ignored)) / PieceBytes);
}

/// Counts the pieces of a .pvtp.
int CountListedPieces(const std::string& path)
{
  std::ifstream file(path);
  int count = 0;
  for (std::string line; std::getline(file, line);)
  {
    count += line.find("<Piece ") != std::string::npos;
  }
  return std::max(1, count);
}

/// Returns the leg in a file name (leg012_points.xyz), or -1.
int GetLeg(const std::string& path)
{
  const std::string name = fs::path(path).filename().string();
  const int leg = RunFiles::GetNumber(name);
  return leg >= 0 && RunFiles::GetStem(name) == RunFiles::GetLegStem(leg) ? leg : -1;
}

int GetKind(const std::string& path)
{
  return RunFiles::GetKind(fs::path(path).filename().string());
}

/// Returns legNNN_trajectory.txt beside legNNN_points.xyz.
std::string GetTrajectoryName(const std::string& path)
{
  const fs::path points(path);
  const std::string name =
    RunFiles::GetBeside(points.filename().string(), RunFiles::TRAJECTORY, "xyz");
  return name.empty() ? name : (points.parent_path() / name).string();
}

/// Stores the first error of a reader.
void StoreFirst(vtkObject*, unsigned long, void* first, void* text)
{
  auto* error = static_cast<std::string*>(first);
  if (error->empty() && text)
  {
    *error = StripOrigin(static_cast<const char*>(text));
  }
}

/// Reports errors of a reader and of its executive in a text, the first one only.
void ObserveErrors(vtkAlgorithm* reader, std::string& error)
{
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(StoreFirst);
  observer->SetClientData(&error);
  reader->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
}

std::string WithPath(const std::string& path, const std::string& message)
{
  return message.find(path) != std::string::npos ? message : path + ": " + message;
}

void AddLeg(vtkPolyData* block, int leg)
{
  if (leg >= 0 && !block->GetPointData()->GetArray(names::LegIds))
  {
    vtkNew<vtkIntArray> legs;
    legs->SetName(names::LegIds);
    legs->SetNumberOfValues(block->GetNumberOfPoints());
    legs->FillValue(leg);
    block->GetPointData()->AddArray(legs);
  }
}

/// Converts the coordinates of a block to metres; an error if they are degrees.
Status ConvertToMetres(vtkPolyData* block)
{
  const std::string text = GetCRS(block);
  CoordinateSystem system;
  if (text.empty() || block->GetNumberOfPoints() == 0 || !system.Set(text).IsOk() ||
    system.IsMetric())
  {
    return {};
  }
  double first[3];
  block->GetPoint(0, first);
  if (system.IsGeographic())
  {
    const std::string zone = FindMetric(system, first);
    return Status::Error(system.GetName() +
      " has degrees, and lengths are shown in metres; convert it: " + "vtkhelios convert --crs " +
      (zone.empty() ? "EPSG:n" : zone));
  }
  const double units[3] = { system.GetUnit(), system.GetUnit(), system.GetHeightUnit() };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(block->GetNumberOfPoints());
  for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i)
  {
    double place[3];
    block->GetPoint(i, place);
    points->SetPoint(i, units[0] * place[0], units[1] * place[1], units[2] * place[2]);
  }
  block->SetPoints(points);
  return {};
}

/// Gets the files listed by a summary; returns an error if it is not valid.
Status GetFiles(const fs::path& summary, std::vector<std::string>& files)
{
  if (const Status status = CheckInputFile(summary.string()); !status.IsOk())
  {
    return Status::Error(summary.string() + ": " + status.Message());
  }
  std::ifstream text(summary);
  Json::Value root;
  std::string fault;
  if (!ReadJson(text, root, fault) || !root.isObject() || !root["legs"].isArray())
  {
    return Status::Error(summary.string() + " is not the summary of a run; run the survey again");
  }
  for (const Json::Value& leg : root["legs"])
  {
    const Json::Value& entries = leg.isObject() ? leg["files"] : Json::Value::nullSingleton();
    for (const Json::Value& entry : entries)
    {
      if (entry.isObject() && entry["name"].isString())
      {
        files.push_back(entry["name"].asString());
      }
    }
  }
  return {};
}

} // namespace

//------------------------------------------------------------------------------
Status CloudReader::Read(const std::string& path, Cloud& cloud)
{
  return this->Read(path,
    [&cloud](vtkPolyData* block, double)
    {
      cloud.Append(block);
      return true;
    });
}

//------------------------------------------------------------------------------
Status CloudReader::Read(const std::string& path, const BlockFunction& onBlock)
{
  std::error_code ignored;
  if (!fs::exists(path, ignored))
  {
    return Status::Error(path + ": no such file or folder; check the name");
  }
  vtkIdType points = 0;
  this->Stopped = false;
  this->Problem.clear();
  this->OnBlock = [&](vtkPolyData* block, double share)
  {
    this->Problem = ConvertToMetres(block).Message();
    this->Stopped = this->Stopped || !this->Problem.empty();
    points += block->GetNumberOfPoints();
    const double all = this->FirstShare + this->ShareOfFile * share;
    this->Stopped = this->Stopped || (block->GetNumberOfPoints() > 0 && !onBlock(block, all));
    return !this->Stopped;
  };
  this->FirstShare = 0.0;
  this->ShareOfFile = 1.0;
  const bool isFolder = fs::is_directory(path, ignored);
  Status status = isFolder ? this->ReadRun(path) : this->ReadCloud(path);
  if (status.IsOk() && !isFolder && fs::exists(GetTrajectoryName(path), ignored))
  {
    status = this->ReadTrajectory(GetTrajectoryName(path));
  }
  status = this->Problem.empty() ? status : Status::Error(path + ": " + this->Problem);
  const bool isEmpty = status.IsOk() && !this->Stopped && points == 0;
  return isEmpty ? Status::Error(path + ": contains no points; nothing can be shown") : status;
}

//------------------------------------------------------------------------------
Status CloudReader::ReadRun(const std::string& folder)
{
  const fs::path summary = fs::path(folder) / RunFiles::GetSummaryName();
  if (!fs::exists(summary))
  {
    return Status::Error(folder + ": no " + RunFiles::GetSummaryName() +
      " in this folder; give the folder of a finished run " +
      "(vtkhelios run --resume finishes one), or a file");
  }
  std::vector<std::string> files;
  Status status = GetFiles(summary, files);
  const auto isPoints = [](const std::string& name) { return GetKind(name) == RunFiles::POINTS; };
  const auto count = static_cast<double>(std::count_if(files.begin(), files.end(), isPoints));
  this->ShareOfFile = count > 0.0 ? 1.0 / count : 1.0;
  for (const std::string& name : files)
  {
    const std::string path = (fs::path(folder) / name).string();
    if (!status.IsOk() || this->Stopped)
    {
      break;
    }
    if (isPoints(name))
    {
      status = fs::exists(path) ? this->ReadCloud(path)
                                : Status::Error(path + ": missing, though " +
                                    RunFiles::GetSummaryName() + " lists it; run the survey again");
      this->FirstShare += this->ShareOfFile;
    }
    else if (GetKind(name) == RunFiles::TRAJECTORY && fs::path(name).extension() == ".txt")
    {
      status = this->ReadTrajectory(path);
    }
  }
  return status;
}

//------------------------------------------------------------------------------
bool CloudReader::IsRun(const std::string& folder)
{
  std::error_code error;
  return fs::exists(fs::path(folder) / "run_summary.json", error);
}

//------------------------------------------------------------------------------
bool CloudReader::CanRead(const std::string& fileName)
{
  const std::string ending = GetEnding(fileName);
  return std::any_of(std::begin(Endings), std::end(Endings),
    [&ending](const char* known) { return ending == known; });
}

//------------------------------------------------------------------------------
Status CloudReader::ReadCloud(const std::string& path)
{
  if (const Status status = CheckInputFile(path); !status.IsOk())
  {
    return Status::Error(path + ": " + status.Message());
  }
  this->Files.push_back(path);
  const std::string ending = GetEnding(path);
  if (IsText(ending))
  {
    return this->ReadText(path);
  }
  const char* name = path.c_str();
  if (ending == ".las" || ending == ".laz")
  {
    vtkNew<vtkHeliosLASReader> reader;
    reader->SetFileName(name);
    return this->ReadPieces(reader, path, CountPieces(path), GetLeg(path));
  }
  if (ending == ".vtp" || ending == ".pvtp")
  {
    vtkNew<vtkHeliosPointXMLReader> reader;
    reader->SetFileName(name);
    return this->ReadPieces(
      reader, path, ending == ".vtp" ? 1 : CountListedPieces(path), GetLeg(path));
  }
  if (ending == ".ply")
  {
    vtkNew<vtkHeliosPLYPointReader> reader;
    reader->SetFileName(name);
    return this->ReadPieces(reader, path, CountPieces(path));
  }
  return Status::Error(path + ": not a supported cloud format; give " + ListEndings() +
    " or the folder of a finished run");
}

//------------------------------------------------------------------------------
Status CloudReader::ReadText(const std::string& path)
{
  std::error_code ignored;
  if (fs::file_size(path, ignored) == 0)
  {
    return {}; // reported as an empty cloud
  }
  vtkNew<vtkHeliosPointTextReader> reader;
  std::string error;
  ObserveErrors(reader, error);
  vtkNew<vtkStringArray> known;
  for (const std::string& name : this->PartNames)
  {
    known->InsertNextValue(name);
  }
  reader->SetPartNames(known);
  reader->SetFileName(path.c_str());
  reader->SetMaximumNumberOfPoints(BlockSize);
  do
  {
    reader->SetBegin(reader->GetEnd());
    reader->Update();
    vtkPolyData* block = reader->GetOutput();
    if (error.empty())
    {
      AddLeg(block, GetLeg(path));
      this->OnBlock(
        block, static_cast<double>(reader->GetEnd()) / static_cast<double>(reader->GetFileSize()));
    }
  } while (error.empty() && !this->Stopped && reader->GetEnd() < reader->GetFileSize());
  const auto parts = vtkStringArray::SafeDownCast(
    reader->GetOutput()->GetFieldData()->GetAbstractArray(names::PartName));
  for (vtkIdType part = known->GetNumberOfValues(); parts && part < parts->GetNumberOfValues();
       ++part)
  {
    this->PartNames.push_back(parts->GetValue(part));
  }
  return error.empty() ? Status() : Status::Error(WithPath(path, error));
}

//------------------------------------------------------------------------------
Status CloudReader::ReadPieces(vtkAlgorithm* reader, const std::string& path, int pieces, int leg)
{
  std::string error;
  ObserveErrors(reader, error);
  for (int piece = 0; piece < pieces && error.empty() && !this->Stopped; ++piece)
  {
    const bool isRead = reader->UpdatePiece(piece, pieces, 0) != 0;
    if (!isRead && error.empty())
    {
      error = "it cannot be read";
    }
    if (error.empty())
    {
      auto* block = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
      AddLeg(block, leg);
      this->OnBlock(block, (piece + 1.0) / pieces);
    }
  }
  return error.empty() ? Status() : Status::Error(WithPath(path, error));
}

//------------------------------------------------------------------------------
Status CloudReader::ReadTrajectory(const std::string& path)
{
  vtkNew<vtkHeliosTrajectoryReader> reader;
  std::string error;
  ObserveErrors(reader, error);
  reader->UseWriterFormat();
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!error.empty())
  {
    return Status::Error(WithPath(path, error));
  }
  auto trajectory = vtkSmartPointer<vtkPolyData>::New();
  trajectory->ShallowCopy(reader->GetOutput());
  AddLeg(trajectory, GetLeg(path));
  this->Trajectories.push_back(trajectory);
  return {};
}

} // namespace helios::viewer
