// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosCityJSONReader.h"

#include "heliosCityModel.h"
#include "heliosMtlFile.h"
#include "heliosSceneCrs.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkHeliosCityJSONReader);

//------------------------------------------------------------------------------
vtkHeliosCityJSONReader::~vtkHeliosCityJSONReader()
{
  this->SetLevelOfDetail(nullptr);
  this->SetMaterialFileName(nullptr);
}

//------------------------------------------------------------------------------
bool vtkHeliosCityJSONReader::ReadScene(vtkPolyData* scene, helios::TextReport& report)
{
  helios::SceneMesh mesh;
  helios::CityModel model(mesh, report);
  model.LevelOfDetail = this->LevelOfDetail ? this->LevelOfDetail : "";
  model.OnBlock = [this](double progress) { return this->ReportBlock(progress); };
  const std::string materials = this->MaterialFileName ? this->MaterialFileName : "";
  if (!model.Read(this->GetFileName()) ||
    (!materials.empty() && !helios::ReplaceMaterials(materials, mesh.Materials, report)))
  {
    return false;
  }
  this->Finish(mesh, scene, report);
  helios::SetCRS(scene, model.GetCrs());
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosCityJSONReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LevelOfDetail: " << (this->LevelOfDetail ? this->LevelOfDetail : "(highest)")
     << "\n";
  os << indent
     << "MaterialFileName: " << (this->MaterialFileName ? this->MaterialFileName : "(none)")
     << "\n";
}
