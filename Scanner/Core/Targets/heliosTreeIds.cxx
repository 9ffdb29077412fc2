// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTreeIds.h"

#include "heliosMaterialTable.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFoliageArrayNames.h"

#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>
#include <vector>

namespace names = vtkHeliosArrayNames;
namespace foliage = vtkHeliosFoliageArrayNames;

namespace helios
{

namespace
{

enum Organ : unsigned char
{
  None,
  Leaf,
  Wood
};
constexpr const char* OrganNames[] = { "none", "leaf", "wood" };

constexpr std::pair<const char*, Organ> OrganWords[] = { { "leaf", Leaf }, { "leaves", Leaf },
  { "foliage", Leaf }, { "needle", Leaf }, { "wood", Wood }, { "bark", Wood }, { "trunk", Wood },
  { "stem", Wood }, { "branch", Wood }, { "twig", Wood } };

Organ FindOrgan(const Material& material)
{
  std::string name = material.Name;
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto* found = std::find_if(std::begin(OrganWords), std::end(OrganWords),
    [&name](const auto& word) { return name.find(word.first) != std::string::npos; });
  const Organ byOptics = material.Optics.Kind == OpticsKind::Leaf ? Leaf : None;
  return found == std::end(OrganWords) ? byOptics : found->second;
}

/// Returns the value of a table in a row; outside of it another one.
template <typename ValueT>
ValueT FindRow(const std::vector<ValueT>& table, int row, ValueT otherwise)
{
  return row >= 0 && static_cast<std::size_t>(row) < table.size()
    ? table[static_cast<std::size_t>(row)]
    : otherwise;
}

vtkSmartPointer<vtkStringArray> MakeNames(const char* name)
{
  auto array = vtkSmartPointer<vtkStringArray>::New();
  array->SetName(name);
  return array;
}

/// Adds an array with the values of a table in the rows that an array of echoes has.
template <typename ArrayT, typename ValueT>
void AddRows(
  const char* name, const std::vector<ValueT>& table, const int* rows, ValueT none, vtkPolyData* to)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfValues(to->GetNumberOfPoints());
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetValue(i, FindRow(table, rows[i], none));
  }
  to->GetPointData()->AddArray(array);
}

/// Returns the row of its species for each part, and the names of all species, in their order.
std::vector<int> NumberSpecies(vtkStringArray* parts, vtkStringArray* species)
{
  std::vector<int> rows;
  for (vtkIdType part = 0; part < parts->GetNumberOfValues(); ++part)
  {
    const std::string name = parts->GetValue(part);
    const vtkIdType known = name.empty() ? -1 : species->LookupValue(name);
    const bool isNew = !name.empty() && known < 0;
    rows.push_back(static_cast<int>(isNew ? species->InsertNextValue(name) : known));
  }
  return rows;
}

} // namespace

//------------------------------------------------------------------------------
void AddTreeIds(vtkPolyData* echoes)
{
  vtkFieldData* fields = echoes->GetFieldData();
  auto* trees = vtkIntArray::SafeDownCast(fields->GetAbstractArray(foliage::PartTree));
  auto* partSpecies = vtkStringArray::SafeDownCast(fields->GetAbstractArray(foliage::PartSpecies));
  auto* parts = vtkIntArray::SafeDownCast(echoes->GetPointData()->GetArray(names::PartIds));
  auto* materials = vtkIntArray::SafeDownCast(echoes->GetPointData()->GetArray(names::MaterialIds));
  if (!trees || !partSpecies || !parts || !materials)
  {
    return;
  }
  const std::vector<int> numbers(
    trees->GetPointer(0), trees->GetPointer(0) + trees->GetNumberOfValues());
  const auto species = MakeNames(foliage::SpeciesName);
  const auto organs = MakeNames(foliage::OrganName);
  for (const char* name : OrganNames)
  {
    organs->InsertNextValue(name);
  }
  std::vector<unsigned char> organOf;
  for (const Material& material : GetMaterials(echoes))
  {
    organOf.push_back(FindOrgan(material));
  }
  AddRows<vtkIntArray>(foliage::TreeIds, numbers, parts->GetPointer(0), -1, echoes);
  AddRows<vtkIntArray>(
    foliage::SpeciesIds, NumberSpecies(partSpecies, species), parts->GetPointer(0), -1, echoes);
  AddRows<vtkUnsignedCharArray>(
    foliage::OrganIds, organOf, materials->GetPointer(0), static_cast<unsigned char>(None), echoes);
  auto* organIds =
    vtkUnsignedCharArray::SafeDownCast(echoes->GetPointData()->GetArray(foliage::OrganIds));
  for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
  {
    const bool isTree = FindRow(numbers, parts->GetValue(i), -1) >= 0;
    organIds->SetValue(i, isTree ? organIds->GetValue(i) : static_cast<unsigned char>(None));
  }
  fields->AddArray(species);
  fields->AddArray(organs);
}

} // namespace helios
