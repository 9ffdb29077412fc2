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

bool vtkHeliosObjSceneReader::ReadScene(vtkPolyData* scene, helios::TextReport& report)
{
  const std::string path = this->GetFileName();
  helios::ObjParser parser(report);
  parser.SetReadsTextures(this->ReadColors);
  helios::ObjScene names(parser, report);
  parser.File.OnBlock = [this](double progress) { return this->ReportBlock(progress); };
  bool isRead = false;
  try
  {
    report.Error = helios::CheckObjMemory(path, parser.File.OnBlock).Message();
    isRead = report.Error.empty() && parser.Read(path) && names.ReadMaterials(this->ReadColors);
    if (isRead)
    {
      this->Finish(parser.Mesh, scene, report,
        [&names](vtkIdType vertex) { return names.FindVertexPlace(vertex); });
    }
  }
  catch (const std::bad_alloc&)
  {
    isRead = report.Fail(
      parser.File.GetPlace() + "not enough memory to continue; free some, or split the file");
  }
  if (parser.File.IsStopped())
  {
    isRead =
      report.Fail(parser.File.GetPlace() + "reading was aborted here; update again to read it");
  }
  return isRead;
}

//------------------------------------------------------------------------------
void vtkHeliosObjSceneReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReadColors: " << this->ReadColors << "\n";
}
