// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPLYSceneReader.h"

#include "heliosPlyFile.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkHeliosPLYSceneReader);

//------------------------------------------------------------------------------
bool vtkHeliosPLYSceneReader::ReadScene(vtkPolyData* scene, helios::TextReport& report)
{
  helios::SceneMesh mesh;
  mesh.Materials.emplace_back();
  mesh.KeepsAll = this->GetKeepAll();
  helios::PlyFile file(mesh, report);
  file.OnBlock = [this](double progress) { return this->ReportBlock(progress); };
  if (!file.Read(this->GetFileName()))
  {
    return false;
  }
  this->Finish(mesh, scene, report);
  return true;
}
