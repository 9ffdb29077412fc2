// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosGLTFSceneReader.h"

#include "heliosGltfModel.h"
#include "heliosMtlFile.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkHeliosGLTFSceneReader);

//------------------------------------------------------------------------------
vtkHeliosGLTFSceneReader::vtkHeliosGLTFSceneReader()
{
  this->SetUpAxisToY();
}

//------------------------------------------------------------------------------
vtkHeliosGLTFSceneReader::~vtkHeliosGLTFSceneReader()
{
  this->SetMaterialFileName(nullptr);
}

//------------------------------------------------------------------------------
bool vtkHeliosGLTFSceneReader::ReadScene(vtkPolyData* scene, helios::TextReport& report)
{
  helios::SceneMesh mesh;
  helios::GltfModel model(mesh, report);
  model.OnBlock = [this](double progress) { return this->ReportBlock(progress); };
  const std::string materials = this->MaterialFileName ? this->MaterialFileName : "";
  if (!model.Read(this->GetFileName()) ||
    (!materials.empty() && !helios::ReplaceMaterials(materials, mesh.Materials, report)) ||
    !model.ApplyCutouts())
  {
    return false;
  }
  this->Finish(mesh, scene, report);
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosGLTFSceneReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "MaterialFileName: " << (this->MaterialFileName ? this->MaterialFileName : "(none)")
     << "\n";
}
