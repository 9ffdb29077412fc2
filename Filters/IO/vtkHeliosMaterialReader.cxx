// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosMaterialReader.h"

#include "heliosMaterialTable.h"
#include "heliosMtlFile.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace names = vtkHeliosArrayNames;

vtkStandardNewMacro(vtkHeliosMaterialReader);

namespace
{

bool HasLowerName(const helios::Material& a, const helios::Material& b)
{
  return a.Name < b.Name;
}

std::string ListNames(const helios::MaterialTable& materials)
{
  std::string list;
  for (const helios::Material& material : materials)
  {
    list += (list.empty() ? "" : ", ") + material.Name;
  }
  return list;
}

/// The material of that name, or the alphabetically first; null where there is none.
const helios::Material* Choose(
  const helios::MaterialTable& materials, const helios::MtlFile& file, const std::string& name)
{
  const int row = name.empty()
    ? static_cast<int>(
        std::min_element(materials.begin(), materials.end(), HasLowerName) - materials.begin())
    : file.Find(name);
  return row >= 0 && row < static_cast<int>(materials.size()) ? &materials[row] : nullptr;
}

void SetOnlyMaterial(vtkPolyData* scene, const helios::Material& material)
{
  helios::SetMaterials(scene, { material });
  vtkNew<vtkIntArray> ids;
  ids->SetName(names::MaterialIds);
  ids->SetNumberOfValues(scene->GetNumberOfCells());
  ids->FillValue(0);
  scene->GetCellData()->AddArray(ids);
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosMaterialReader::~vtkHeliosMaterialReader()
{
  this->SetFileName(nullptr);
  this->SetMaterialName(nullptr);
}

//------------------------------------------------------------------------------
int vtkHeliosMaterialReader::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro(<< "FileName is not set; give the MTL file with SetFileName");
    return 0;
  }
  helios::MaterialTable materials;
  helios::TextReport report;
  helios::MtlFile file(materials, report);
  const bool isRead = file.Read(this->FileName);
  for (const std::string& warning : report.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  if (!isRead)
  {
    vtkErrorMacro(<< report.Error);
    return 0;
  }
  const std::string name = this->MaterialName ? this->MaterialName : "";
  const helios::Material* material = Choose(materials, file, name);
  if (!material)
  {
    vtkErrorMacro(<< this->FileName << ": has no material"
                  << (materials.empty() ? "; begin one with newmtl NAME"
                                        : " " + name + "; it has " + ListNames(materials)));
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(vtkPolyData::GetData(inputVector[0]));
  SetOnlyMaterial(output, *material);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosMaterialReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
  os << indent << "MaterialName: " << (this->MaterialName ? this->MaterialName : "(none)") << '\n';
}
