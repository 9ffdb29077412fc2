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
  const auto onBlock = [this](double progress) { return this->ReportBlock(progress); };
  report.Error = helios::CheckObjMemory(this->GetFileName(), onBlock).Message();
  bool hasTextures = this->ReadColors;
  bool isRead = report.Error.empty() && this->ReadOnce(scene, report, hasTextures);
  if (!isRead && report.Error.empty() && hasTextures)
  {
    report = helios::TextReport();
    isRead = this->ReadOnce(scene, report, hasTextures);
  }
  return isRead;
}

//------------------------------------------------------------------------------
/// Reads the file, with texture coordinates or without. False without an error if images cut its
/// triangles: they need texture coordinates.
bool vtkHeliosObjSceneReader::ReadOnce(
  vtkPolyData* scene, helios::TextReport& report, bool& hasTextures)
{
  const std::string path = this->GetFileName();
  helios::ObjParser parser(report);
  parser.SetReadsTextures(hasTextures);
  parser.Mesh.KeepsAll = this->GetKeepAll();
  helios::ObjScene names(parser, report);
  parser.File.OnBlock = [this](double progress) { return this->ReportBlock(progress); };
  bool isRead = false;
  try
  {
    isRead = parser.Read(path) && names.ReadMaterials(this->ReadColors);
    if (isRead && !hasTextures && !this->GetKeepAll() && names.HasCutouts())
    {
      hasTextures = true;
      return false;
    }
    isRead = isRead && (this->GetKeepAll() || names.ApplyCutouts());
    if (isRead)
    {
      parser.Mesh.TextureCoordinates.Truncate(
        this->ReadColors ? parser.Mesh.TextureCoordinates.GetSize() : 0);
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
