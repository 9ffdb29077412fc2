// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosInstanceParts.h"

#include "vtkHeliosArrayNames.h"

#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <numeric>
#include <sstream>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

std::string ToText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

} // namespace

//------------------------------------------------------------------------------
Status InstanceParts::Set(
  const PartList& parts, const std::vector<int>& ids, vtkPolyData* instances)
{
  *this = InstanceParts();
  this->All = this->Parts = parts;
  this->Instances = instances;
  const Status status = this->FindPrototypes(parts);
  return status.IsOk() ? this->SetIds(ids) : status;
}

//------------------------------------------------------------------------------
Status InstanceParts::FindPrototypes(const PartList& parts)
{
  this->Numbers.assign(parts.size(), -1);
  vtkDataArray* ids = this->Instances->GetPointData()->GetArray(names::PrototypeIds);
  for (vtkIdType i = 0; i < this->Instances->GetNumberOfPoints(); ++i)
  {
    const double id = ids ? ids->GetComponent(i, 0) : 0.0;
    if (!(id >= 0.0 && id < static_cast<double>(parts.size())) ||
      !parts[static_cast<std::size_t>(id)])
    {
      return Status::Error(std::string(names::PrototypeIds) + " " + ToText(id) + " of instance " +
        std::to_string(i) +
        " is not valid: expected a connection of input 0 with triangles, 0 to " +
        std::to_string(parts.size() - 1));
    }
    const auto connection = static_cast<std::size_t>(id);
    if (this->Numbers[connection] < 0)
    {
      this->Numbers[connection] = static_cast<int>(this->Prototypes.size());
      this->Prototypes.push_back(connection);
      this->Parts[connection] = nullptr;
    }
    this->Uses.push_back(connection);
  }
  return {};
}

//------------------------------------------------------------------------------
Status InstanceParts::SetIds(const std::vector<int>& ids)
{
  int next = 0;
  this->Ids.assign(this->Parts.size(), -1);
  std::vector<int> all;
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    if (!this->IsPrototype(i))
    {
      const int given = i < ids.size() ? ids[i] : -1;
      this->Ids[i] = given >= 0 ? given : next;
      next = std::max(next, this->Ids[i] + 1);
      all.push_back(this->Ids[i]);
    }
  }
  const bool areSorted = std::is_sorted(all.begin(), all.end());
  vtkDataArray* given = this->Instances->GetPointData()->GetArray(names::PartIds);
  for (vtkIdType i = 0; i < this->Instances->GetNumberOfPoints(); ++i)
  {
    this->InstanceIds.push_back(
      given ? static_cast<int>(given->GetComponent(i, 0)) : next + static_cast<int>(i));
  }
  all.insert(all.end(), this->InstanceIds.begin(), this->InstanceIds.end());
  const bool areAscending =
    areSorted && std::is_sorted(this->InstanceIds.begin(), this->InstanceIds.end());
  std::sort(all.begin(), all.end());
  const auto twice = std::adjacent_find(all.begin(), all.end());
  if (twice != all.end() || !areAscending)
  {
    return Status::Error(twice != all.end()
        ? "Part id " + std::to_string(*twice) + " is given twice, by SetPartId or " +
          names::PartIds + " of the instances"
        : std::string("Part ids must ascend: those of SetPartId over the connections, and ") +
          names::PartIds + " over the instances");
  }
  this->NumberOfParts = all.empty() ? 0 : all.back() + 1;
  return {};
}

//------------------------------------------------------------------------------
std::vector<std::size_t> InstanceParts::GetOrder() const
{
  std::vector<int> first(this->Ids);
  for (std::size_t i = this->Uses.size(); i-- > 0;)
  {
    first[this->Uses[i]] = this->InstanceIds[i];
  }
  std::vector<std::size_t> order(first.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [&first](std::size_t a, std::size_t b) { return first[a] < first[b]; });
  return order;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> InstanceParts::MakeInstances() const
{
  vtkNew<vtkIntArray> prototypes, parts;
  vtkNew<vtkIdTypeArray> cells;
  prototypes->SetName(names::PrototypeIds);
  parts->SetName(names::PartIds);
  cells->SetName(names::FirstCellIds);
  std::size_t connection = 0;
  vtkIdType cell = 0;
  for (std::size_t i = 0; i < this->Uses.size(); ++i)
  {
    for (; connection < this->Parts.size() &&
         (this->IsPrototype(connection) || this->Ids[connection] < this->InstanceIds[i]);
         ++connection)
    {
      cell += this->Parts[connection] ? this->Parts[connection]->GetNumberOfPolys() : 0;
    }
    prototypes->InsertNextValue(this->Numbers[this->Uses[i]]);
    parts->InsertNextValue(this->InstanceIds[i]);
    cells->InsertNextValue(cell);
    cell += this->All[this->Uses[i]]->GetNumberOfPolys();
  }
  auto made = vtkSmartPointer<vtkPolyData>::New();
  made->ShallowCopy(this->Instances);
  made->GetPointData()->AddArray(prototypes);
  made->GetPointData()->AddArray(parts);
  made->GetPointData()->AddArray(cells);
  return made;
}

} // namespace helios
