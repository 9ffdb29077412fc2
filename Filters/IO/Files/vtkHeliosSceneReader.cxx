// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSceneReader.h"

#include "heliosSceneMesh.h"
#include "heliosTextFile.h"

#include <vtkPolyData.h>

#include <new>

//------------------------------------------------------------------------------
vtkHeliosSceneReader::vtkHeliosSceneReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHeliosSceneReader::~vtkHeliosSceneReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
// Parsing takes nearly all of the time; the later steps share the last tenth.
bool vtkHeliosSceneReader::ReportBlock(double progress)
{
  this->UpdateProgress(0.9 * progress);
  return !this->AbortExecute;
}

//------------------------------------------------------------------------------
void vtkHeliosSceneReader::Finish(helios::SceneMesh& mesh, vtkPolyData* scene,
  helios::TextReport& report, const std::function<std::string(vtkIdType)>& findPlace)
{
  mesh.DropFlatTriangles(this->FileName, report);
  if (mesh.GetNumberOfTriangles() == 0)
  {
    report.Warn(std::string(this->FileName) + ": no triangles, so the scene is empty; add " +
      this->GetFaceExample());
  }
  mesh.CheckExtent(this->FileName, report, findPlace);
  mesh.DropUnusedPoints();
  if (this->UpAxis == UP_AXIS_Y)
  {
    mesh.TurnUp();
  }
  this->NumberOfDroppedTriangles = mesh.GetNumberOfDroppedTriangles();
  this->NumberOfFaces = mesh.Faces.Count;
  this->FaceHash = mesh.Faces.Hash;
  mesh.MoveTo(scene);
}

//------------------------------------------------------------------------------
bool vtkHeliosSceneReader::ReadFile(vtkPolyData* scene, helios::TextReport& report)
{
  if (!this->FileName || !*this->FileName)
  {
    return report.Fail(std::string("FileName is not set; give the ") + this->GetFormatName() +
      " file with SetFileName");
  }
  try
  {
    return this->ReadScene(scene, report);
  }
  catch (const std::bad_alloc&)
  {
    return report.Fail(std::string(this->FileName) +
      ": not enough memory to continue; free some, or split the file");
  }
}

//------------------------------------------------------------------------------
int vtkHeliosSceneReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->NumberOfDroppedTriangles = 0;
  helios::TextReport report;
  const bool isRead = this->ReadFile(vtkPolyData::GetData(outputVector), report);
  for (const std::string& warning : report.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  if (!isRead)
  {
    vtkErrorMacro(<< report.Error);
    return 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosSceneReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "UpAxis: " << (this->UpAxis == UP_AXIS_Y ? "y" : "z") << "\n";
  os << indent << "KeepAll: " << this->KeepAll << "\n";
  os << indent << "NumberOfFaces: " << this->NumberOfFaces << "\n";
  os << indent << "FaceHash: " << this->FaceHash << "\n";
  os << indent << "NumberOfDroppedTriangles: " << this->NumberOfDroppedTriangles << "\n";
}
