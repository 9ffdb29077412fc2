// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMaterialTable.h"

#include "vtkHeliosArrayNames.h"

#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

template <typename ArrayT, typename GetT>
void AddColumn(vtkFieldData* fields, const char* name, const MaterialTable& materials, GetT get)
{
  vtkNew<ArrayT> column;
  column->SetName(name);
  column->SetNumberOfValues(static_cast<vtkIdType>(materials.size()));
  for (std::size_t i = 0; i < materials.size(); ++i)
  {
    column->SetValue(static_cast<vtkIdType>(i), get(materials[i]));
  }
  fields->AddArray(column);
}

double Number(vtkFieldData* fields, const char* name, vtkIdType row, double fallback)
{
  vtkDataArray* column = fields->GetArray(name);
  return column && row < column->GetNumberOfTuples() ? column->GetComponent(row, 0) : fallback;
}

std::string Text(vtkFieldData* fields, const char* name, vtkIdType row)
{
  auto* column = vtkStringArray::SafeDownCast(fields->GetAbstractArray(name));
  return column && row < column->GetNumberOfValues() ? std::string(column->GetValue(row)) : "";
}

/// The columns of optics, and the numbers in them.
struct OpticsColumn
{
  const char* Name;
  double MaterialOptics::*Value;
};
constexpr OpticsColumn OpticsColumns[] = {
  { names::MaterialMirrorReflectance, &MaterialOptics::MirrorReflectance },
  { names::MaterialRefractiveIndex, &MaterialOptics::RefractiveIndex },
  { names::MaterialThickness, &MaterialOptics::Thickness },
  { names::MaterialAttenuation, &MaterialOptics::Attenuation },
  { names::MaterialBackscatter, &MaterialOptics::Backscatter },
  { names::MaterialTransmittance, &MaterialOptics::Transmittance },
  { names::MaterialRetroreflection, &MaterialOptics::Retroreflection },
  { names::MaterialMeanSquareSlope, &MaterialOptics::MeanSquareSlope },
};

MaterialOptics GetOptics(vtkFieldData* fields, vtkIdType row)
{
  MaterialOptics optics;
  optics.Kind = static_cast<OpticsKind>(Number(fields, names::MaterialOptics, row, 0));
  optics.Dispersion =
    static_cast<DispersionKind>(Number(fields, names::MaterialDispersion, row, 0));
  optics.RefractiveIndex = optics.Kind == OpticsKind::Water ? WaterIndex : optics.RefractiveIndex;
  for (const OpticsColumn& column : OpticsColumns)
  {
    optics.*column.Value = Number(fields, column.Name, row, optics.*column.Value);
  }
  return optics;
}

void SetOptics(vtkFieldData* fields, const MaterialTable& materials)
{
  const bool hasOptics = std::any_of(materials.begin(), materials.end(),
    [](const Material& m) { return m.Optics.Kind != OpticsKind::Opaque; });
  fields->RemoveArray(names::MaterialOptics);
  fields->RemoveArray(names::MaterialDispersion);
  for (const OpticsColumn& column : OpticsColumns)
  {
    fields->RemoveArray(column.Name);
  }
  if (!hasOptics)
  {
    return;
  }
  AddColumn<vtkIntArray>(fields, names::MaterialOptics, materials,
    [](const Material& m) { return static_cast<int>(m.Optics.Kind); });
  AddColumn<vtkIntArray>(fields, names::MaterialDispersion, materials,
    [](const Material& m) { return static_cast<int>(m.Optics.Dispersion); });
  for (const OpticsColumn& column : OpticsColumns)
  {
    AddColumn<vtkDoubleArray>(fields, column.Name, materials,
      [&column](const Material& m) { return m.Optics.*column.Value; });
  }
}

MaterialColor GetColor(vtkFieldData* fields, vtkIdType row)
{
  MaterialColor color;
  vtkDataArray* base = fields->GetArray(names::MaterialColor);
  if (base && base->GetNumberOfComponents() == 3 && row < base->GetNumberOfTuples())
  {
    base->GetTuple(row, color.Base.data());
    color.Texture = Text(fields, names::MaterialTexture, row);
  }
  return color;
}

void SetColors(vtkFieldData* fields, const MaterialTable& materials)
{
  fields->RemoveArray(names::MaterialColor);
  fields->RemoveArray(names::MaterialTexture);
  if (std::none_of(
        materials.begin(), materials.end(), [](const Material& m) { return m.Color.IsSet(); }))
  {
    return;
  }
  vtkNew<vtkDoubleArray> colors;
  colors->SetName(names::MaterialColor);
  colors->SetNumberOfComponents(3);
  for (const Material& m : materials)
  {
    colors->InsertNextTuple(m.Color.Base.data());
  }
  fields->AddArray(colors);
  AddColumn<vtkStringArray>(
    fields, names::MaterialTexture, materials, [](const Material& m) { return m.Color.Texture; });
}

} // namespace

bool MaterialColor::operator==(const MaterialColor& other) const
{
  return this->IsSet() == other.IsSet() && (!this->IsSet() || this->Base == other.Base) &&
    this->Texture == other.Texture;
}

bool MaterialOptics::operator==(const MaterialOptics& other) const
{
  return this->Kind == other.Kind && this->MirrorReflectance == other.MirrorReflectance &&
    this->RefractiveIndex == other.RefractiveIndex && this->Thickness == other.Thickness &&
    this->Attenuation == other.Attenuation && this->Backscatter == other.Backscatter &&
    this->Transmittance == other.Transmittance && this->Retroreflection == other.Retroreflection &&
    this->MeanSquareSlope == other.MeanSquareSlope && this->Dispersion == other.Dispersion &&
    this->GroupIndex == other.GroupIndex;
}

bool Material::operator==(const Material& other) const
{
  const bool sameReflectance = this->Reflectance == other.Reflectance ||
    (std::isnan(this->Reflectance) && std::isnan(other.Reflectance));
  return sameReflectance && this->Name == other.Name && this->Specularity == other.Specularity &&
    this->SpecularExponent == other.SpecularExponent &&
    this->Classification == other.Classification && this->IsGround == other.IsGround &&
    this->Spectrum == other.Spectrum && this->Optics == other.Optics && this->Color == other.Color;
}

MaterialTable GetMaterials(vtkDataObject* scene)
{
  vtkFieldData* fields = scene->GetFieldData();
  vtkAbstractArray* key = fields->GetAbstractArray(names::MaterialName);
  key = key ? key : fields->GetAbstractArray(names::MaterialReflectance);
  MaterialTable materials(key ? static_cast<std::size_t>(key->GetNumberOfTuples()) : 1);
  if (!key)
  {
    return materials;
  }
  for (std::size_t i = 0; i < materials.size(); ++i)
  {
    const vtkIdType row = static_cast<vtkIdType>(i);
    Material& m = materials[i];
    m.Name = Text(fields, names::MaterialName, row);
    m.Reflectance = Number(fields, names::MaterialReflectance, row, m.Reflectance);
    m.Specularity = Number(fields, names::MaterialSpecularity, row, m.Specularity);
    m.SpecularExponent = Number(fields, names::MaterialSpecularExponent, row, m.SpecularExponent);
    m.Classification = static_cast<int>(Number(fields, names::MaterialClassification, row, 0));
    m.IsGround = Number(fields, names::MaterialIsGround, row, 0) != 0;
    m.Spectrum = Text(fields, names::MaterialSpectrum, row);
    m.Optics = GetOptics(fields, row);
    m.Color = GetColor(fields, row);
  }
  return materials;
}

void SetMaterials(vtkDataObject* scene, const MaterialTable& materials)
{
  vtkFieldData* fields = scene->GetFieldData();
  using M = const Material&;
  AddColumn<vtkStringArray>(fields, names::MaterialName, materials, [](M m) { return m.Name; });
  AddColumn<vtkDoubleArray>(
    fields, names::MaterialReflectance, materials, [](M m) { return m.Reflectance; });
  AddColumn<vtkDoubleArray>(
    fields, names::MaterialSpecularity, materials, [](M m) { return m.Specularity; });
  AddColumn<vtkDoubleArray>(
    fields, names::MaterialSpecularExponent, materials, [](M m) { return m.SpecularExponent; });
  AddColumn<vtkIntArray>(
    fields, names::MaterialClassification, materials, [](M m) { return m.Classification; });
  AddColumn<vtkIntArray>(
    fields, names::MaterialIsGround, materials, [](M m) { return m.IsGround ? 1 : 0; });
  AddColumn<vtkStringArray>(
    fields, names::MaterialSpectrum, materials, [](M m) { return m.Spectrum; });
  SetOptics(fields, materials);
  SetColors(fields, materials);
}

} // namespace helios
