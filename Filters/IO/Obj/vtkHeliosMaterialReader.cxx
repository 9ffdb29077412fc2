// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosMaterialReader.h"

#include "heliosMaterialTable.h"
#include "heliosMtlFile.h"
#include "heliosRandom.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkDemandDrivenPipeline.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

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

/// Returns the material with that name, or the alphabetically first; null if missing.
const helios::Material* Choose(
  const helios::MaterialTable& materials, const helios::MtlFile& file, const std::string& name)
{
  const int row = name.empty()
    ? static_cast<int>(
        std::min_element(materials.begin(), materials.end(), HasLowerName) - materials.begin())
    : file.Find(name);
  return row >= 0 && row < static_cast<int>(materials.size()) ? &materials[row] : nullptr;
}

/// Returns the material and its random variations.
helios::MaterialTable Vary(
  const helios::Material& material, int count, double range, std::uint64_t seed)
{
  helios::MaterialTable table(static_cast<std::size_t>(count), material);
  const bool hasOwn = !std::isnan(material.Reflectance);
  const double first = hasOwn ? material.Reflectance : helios::DefaultReflectance;
  for (std::size_t i = 1; i < table.size(); ++i)
  {
    const double u = helios::Uniform4(seed, helios::RandomStream::RandomMaterial, i, 0)[0];
    table[i].Name += '.' + std::to_string(i);
    if (hasOwn || material.Spectrum.empty())
    {
      table[i].Reflectance = std::min(1.0, std::max(0.0, first + range * (2.0 * u - 1.0)));
    }
  }
  return table;
}

/// Sets the materials; MaterialIds of a mesh are the ids of the input, modulo the number of
/// materials.
void SetMaterials(vtkDataSet* scene, const helios::MaterialTable& materials)
{
  helios::SetMaterials(scene, materials);
  if (!vtkPolyData::SafeDownCast(scene))
  {
    return;
  }
  vtkDataArray* before = scene->GetCellData()->GetArray(names::MaterialIds);
  vtkNew<vtkIntArray> ids;
  ids->SetName(names::MaterialIds);
  ids->SetNumberOfValues(scene->GetNumberOfCells());
  const int count = static_cast<int>(materials.size());
  for (vtkIdType i = 0; i < scene->GetNumberOfCells(); ++i)
  {
    const int id = before && count > 1 ? static_cast<int>(before->GetComponent(i, 0)) : 0;
    ids->SetValue(i, id % count);
  }
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
int vtkHeliosMaterialReader::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosMaterialReader::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataSet");
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkHeliosMaterialReader::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, inputVector, outputVector);
  }
  const bool isRaster = vtkImageData::GetData(inputVector[0]) != nullptr;
  vtkDataSet* output = vtkDataSet::GetData(outputVector);
  if (!output || isRaster != output->IsA("vtkImageData"))
  {
    const auto made = isRaster ? vtkSmartPointer<vtkDataSet>(vtkSmartPointer<vtkImageData>::New())
                               : vtkSmartPointer<vtkDataSet>(vtkSmartPointer<vtkPolyData>::New());
    outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
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
  file.SetReadsColors(this->ReadColors);
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
  vtkDataSet* output = vtkDataSet::GetData(outputVector);
  output->ShallowCopy(vtkDataSet::GetData(inputVector[0]));
  SetMaterials(output,
    Vary(*material, this->NumberOfMaterials, this->RandomRange,
      static_cast<std::uint64_t>(this->Seed)));
  if (this->NumberOfMaterials > 1 && std::isnan(material->Reflectance) &&
    !material->Spectrum.empty())
  {
    vtkWarningMacro(<< this->FileName << ": material " << material->Name
                    << " has its reflectance from a spectrum, which NumberOfMaterials does not "
                       "vary; give it a helios_reflectance");
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosMaterialReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
  os << indent << "MaterialName: " << (this->MaterialName ? this->MaterialName : "(none)") << '\n'
     << indent << "NumberOfMaterials: " << this->NumberOfMaterials << '\n'
     << indent << "RandomRange: " << this->RandomRange << '\n'
     << indent << "Seed: " << this->Seed << '\n'
     << indent << "ReadColors: " << this->ReadColors << '\n';
}
