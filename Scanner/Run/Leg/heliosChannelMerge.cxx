// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosChannelMerge.h"

#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <utility>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

/// A record: its channel and its row there.
struct Source
{
  std::size_t Channel;
  vtkIdType Row;
};

/// Returns the rows of all channels in pulse order.
std::vector<Source> FindOrder(const std::vector<vtkFieldData*>& columns)
{
  std::vector<std::pair<double, Source>> rows; // a double holds ids up to 2^53
  for (std::size_t channel = 0; channel < columns.size(); ++channel)
  {
    vtkDataArray* ids = columns[channel]->GetArray(names::PulseIds);
    for (vtkIdType row = 0; ids && row < ids->GetNumberOfTuples(); ++row)
    {
      rows.push_back({ ids->GetComponent(row, 0), { channel, row } });
    }
  }
  std::stable_sort(
    rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Source> order;
  order.reserve(rows.size());
  for (const auto& row : rows)
  {
    order.push_back(row.second);
  }
  return order;
}

/// Gathers one array from all channels, in an order.
vtkSmartPointer<vtkAbstractArray> Gather(
  const std::vector<vtkAbstractArray*>& arrays, const std::vector<Source>& order)
{
  auto all = vtkSmartPointer<vtkAbstractArray>::Take(arrays.front()->NewInstance());
  all->SetName(arrays.front()->GetName());
  all->SetNumberOfComponents(arrays.front()->GetNumberOfComponents());
  all->SetNumberOfTuples(static_cast<vtkIdType>(order.size()));
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    all->SetTuple(static_cast<vtkIdType>(i), order[i].Row, arrays[order[i].Channel]);
  }
  return all;
}

/// Gathers every column.
void GatherColumns(
  const std::vector<vtkFieldData*>& from, const std::vector<Source>& order, vtkFieldData* into)
{
  for (int k = 0; k < from.front()->GetNumberOfArrays(); ++k)
  {
    std::vector<vtkAbstractArray*> arrays;
    for (vtkFieldData* columns : from)
    {
      arrays.push_back(columns->GetAbstractArray(from.front()->GetArrayName(k)));
    }
    into->AddArray(Gather(arrays, order));
  }
}

vtkSmartPointer<vtkDataObject> MergePoints(const std::vector<vtkDataObject*>& channels)
{
  std::vector<vtkFieldData*> columns;
  std::vector<vtkAbstractArray*> coordinates;
  for (vtkDataObject* channel : channels)
  {
    auto* data = vtkPolyData::SafeDownCast(channel);
    columns.push_back(data->GetPointData());
    coordinates.push_back(data->GetPoints()->GetData());
  }
  const std::vector<Source> order = FindOrder(columns);
  auto merged = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetData(vtkDataArray::SafeDownCast(Gather(coordinates, order)));
  merged->SetPoints(points);
  GatherColumns(columns, order, merged->GetPointData());
  merged->GetFieldData()->PassData(channels.front()->GetFieldData());
  return merged;
}

/// Concatenates the samples of all channels, and shifts the offsets of the rows accordingly.
void JoinSamples(
  const std::vector<vtkDataObject*>& channels, const std::vector<Source>& order, vtkTable* merged)
{
  vtkDataArray* first = channels.front()->GetFieldData()->GetArray(names::Samples);
  auto samples = vtkSmartPointer<vtkDataArray>::Take(first->NewInstance());
  samples->SetName(names::Samples);
  std::vector<vtkIdType> begins;
  for (vtkDataObject* channel : channels)
  {
    vtkDataArray* own = channel->GetFieldData()->GetArray(names::Samples);
    begins.push_back(samples->GetNumberOfTuples());
    samples->InsertTuples(begins.back(), own->GetNumberOfTuples(), 0, own);
  }
  vtkDataArray* offsets =
    vtkDataArray::SafeDownCast(merged->GetRowData()->GetAbstractArray(names::Offset));
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const auto row = static_cast<vtkIdType>(i);
    offsets->SetComponent(
      row, 0, offsets->GetComponent(row, 0) + static_cast<double>(begins[order[i].Channel]));
  }
  merged->GetFieldData()->AddArray(samples);
}

vtkSmartPointer<vtkDataObject> MergeRows(const std::vector<vtkDataObject*>& channels)
{
  std::vector<vtkFieldData*> columns;
  for (vtkDataObject* channel : channels)
  {
    columns.push_back(vtkTable::SafeDownCast(channel)->GetRowData());
  }
  const std::vector<Source> order = FindOrder(columns);
  auto merged = vtkSmartPointer<vtkTable>::New();
  GatherColumns(columns, order, merged->GetRowData());
  merged->GetFieldData()->PassData(channels.front()->GetFieldData());
  JoinSamples(channels, order, merged);
  return merged;
}

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> MergeChannels(const std::vector<vtkDataObject*>& channels)
{
  if (channels.size() == 1)
  {
    return channels.front();
  }
  return vtkTable::SafeDownCast(channels.front()) ? MergeRows(channels) : MergePoints(channels);
}

} // namespace helios
