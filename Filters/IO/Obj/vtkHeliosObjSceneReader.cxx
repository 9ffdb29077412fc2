// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosObjSceneReader.h"

#include "heliosObjMemory.h"
#include "heliosObjParser.h"
#include "heliosObjScene.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <new>

vtkStandardNewMacro(vtkHeliosObjSceneReader);

vtkHeliosObjSceneReader::vtkHeliosObjSceneReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkHeliosObjSceneReader::~vtkHeliosObjSceneReader()
{
  this->SetFileName(nullptr);
}

// Parsing takes nearly all of the time; the later steps share the last tenth.
bool vtkHeliosObjSceneReader::ReportBlock(double progress)
{
  this->UpdateProgress(0.9 * progress);
  return !this->AbortExecute;
}

int vtkHeliosObjSceneReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->NumberOfDroppedTriangles = 0;
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro(<< "FileName is not set; give the OBJ file with SetFileName");
    return 0;
  }
  helios::TextReport report;
  helios::ObjParser parser(report);
  helios::ObjScene scene(parser, report);
  parser.File.OnBlock = [this](double progress) { return this->ReportBlock(progress); };
  bool isRead = false;
  try
  {
    report.Error = helios::CheckObjMemory(this->FileName, parser.File.OnBlock).Message();
    isRead = report.Error.empty() && parser.Read(this->FileName) && scene.ReadMaterials();
    if (isRead)
    {
      scene.DropFlatTriangles();
      scene.CheckExtent();
      scene.DropUnusedPoints();
      if (this->UpAxis == UP_AXIS_Y)
      {
        scene.TurnUp();
      }
      scene.MoveTo(vtkPolyData::GetData(outputVector));
    }
  }
  catch (const std::bad_alloc&)
  {
    report.Error =
      parser.File.GetPlace() + "not enough memory to continue; free some, or split the file";
    isRead = false;
  }

  for (const std::string& warning : report.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  if (parser.File.IsStopped())
  {
    report.Error = parser.File.GetPlace() + "reading was aborted here; update again to read it";
  }
  if (!isRead)
  {
    vtkErrorMacro(<< report.Error);
    return 0;
  }
  this->NumberOfDroppedTriangles = scene.GetNumberOfDroppedTriangles();
  return 1;
}

void vtkHeliosObjSceneReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "UpAxis: " << (this->UpAxis == UP_AXIS_Y ? "y" : "z") << "\n";
  os << indent << "NumberOfDroppedTriangles: " << this->NumberOfDroppedTriangles << "\n";
}
