// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlanOutput.h"

#include "heliosCoverGreedy.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt64Array.h>

#include <algorithm>
#include <string>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

/// Adds an array of values value(i).
template <typename ArrayT, typename ValueT>
void AddColumn(vtkPolyData* data, const char* name, vtkIdType count, ValueT value)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->SetValue(i, value(static_cast<int>(i)));
  }
  data->GetPointData()->AddArray(array);
}

} // namespace

PlanOutput::PlanOutput(
  const CoverProblem& problem, const Incidence& incidence, const Choice& selected)
  : Problem(problem)
  , Selected(selected)
  , Counts(problem, selected)
  , Best(incidence.GetBest(problem, selected))
{
}

vtkIdType PlanOutput::GetCoveredCount() const
{
  return CountBits(this->Counts.GetCovered().data(), this->Problem.Rows.Length);
}

void PlanOutput::WriteCandidates(
  vtkPolyData* input, const std::vector<double>& meanAngles, vtkPolyData* output) const
{
  const int count = this->Problem.Rows.Rows;
  std::vector<char> isSelected(count);
  for (const int a : this->Selected)
  {
    isSelected[a] = 1;
  }
  output->ShallowCopy(input);
  AddColumn<vtkTypeInt64Array>(
    output, names::ViewshedSize, count, [this](int a) { return this->Problem.Rows.GetSize(a); });
  AddColumn<vtkDoubleArray>(
    output, names::MeanIncidenceAngle, count, [&](int a) { return meanAngles[a]; });
  AddColumn<vtkTypeInt64Array>(output, names::Exclusivity, count,
    [&](int a) { return isSelected[a] ? this->Counts.GetExclusiveCount(a) : 0; });
  AddColumn<vtkIntArray>(output, names::Selected, count, [&](int a) { return isSelected[a]; });
}

void PlanOutput::WriteTestPoints(vtkPolyData* input, vtkPolyData* output) const
{
  const int count = this->Problem.Rows.Columns;
  output->ShallowCopy(input);
  AddColumn<vtkIntArray>(output, names::Coverable, count,
    [this](int v) { return HasBit(this->Problem.Coverable.data(), v) ? 1 : 0; });
  AddColumn<vtkIntArray>(
    output, names::NumberOfScans, count, [this](int v) { return this->Counts.GetCount(v); });
  AddColumn<vtkDoubleArray>(
    output, names::BestIncidenceAngle, count, [this](int v) { return this->Best[v]; });
}

void PlanOutput::WriteSelected(vtkPolyData* candidates, vtkPolyData* output) const
{
  const GreedyChoice order = SortByGain(this->Problem, this->Selected);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (const int a : order.Candidates)
  {
    const vtkIdType id = points->InsertNextPoint(candidates->GetPoint(a));
    vertices->InsertNextCell(1, &id);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  vtkPointData* arrays = candidates->GetPointData();
  for (int k = 0; k < arrays->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* from = arrays->GetAbstractArray(k);
    if (from->GetName() && from->GetName() != std::string(names::Visibility))
    {
      const auto to = vtkSmartPointer<vtkAbstractArray>::Take(from->NewInstance());
      to->SetName(from->GetName());
      to->SetNumberOfComponents(from->GetNumberOfComponents());
      for (const int a : order.Candidates)
      {
        to->InsertNextTuple(a, from);
      }
      output->GetPointData()->AddArray(to);
    }
  }
  AddColumn<vtkTypeInt64Array>(output, names::NewlyCovered, points->GetNumberOfPoints(),
    [&order](int k) { return order.NewlyCovered[k]; });
}

} // namespace helios
