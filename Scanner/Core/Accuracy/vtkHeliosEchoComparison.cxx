// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosEchoComparison.h"

#include "heliosEchoComparison.h"

#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <string>

vtkStandardNewMacro(vtkHeliosEchoComparison);

namespace
{

/// A table of names and estimates.
class MeasureTable
{
public:
  MeasureTable()
  {
    this->Names->SetName("Name");
    const char* const titles[] = { "Value", "Lower", "Upper" };
    for (int i = 0; i < 3; ++i)
    {
      this->Columns[i]->SetName(titles[i]);
    }
  }

  void Add(const char* name, const helios::Estimate& estimate)
  {
    this->Names->InsertNextValue(name);
    this->Columns[0]->InsertNextValue(estimate.Value);
    this->Columns[1]->InsertNextValue(estimate.Lower);
    this->Columns[2]->InsertNextValue(estimate.Upper);
  }

  void AddCount(const char* name, vtkIdType count)
  {
    const auto value = static_cast<double>(count);
    this->Add(name, { value, value, value });
  }

  void AddColumns(vtkTable* table) const
  {
    table->AddColumn(this->Names);
    for (const auto& column : this->Columns)
    {
      table->AddColumn(column);
    }
  }

private:
  vtkNew<vtkStringArray> Names;
  vtkNew<vtkDoubleArray> Columns[3];
};

} // namespace

//------------------------------------------------------------------------------
vtkHeliosEchoComparison::vtkHeliosEchoComparison()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkHeliosEchoComparison::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosEchoComparison::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  helios::EchoMatching matching;
  matching.Distance = this->MatchingDistance;
  matching.FullAmplitude = this->FullAmplitude;
  matching.Extinction = this->Extinction;
  matching.LeastShare = this->LeastShare;
  matching.LeastAmplitude = this->LeastAmplitude;
  helios::EchoComparison comparison;
  const helios::Status status =
    comparison.Add(vtkPolyData::GetData(inputs[0]), vtkPolyData::GetData(inputs[1]), matching);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  const helios::EchoErrors errors = comparison.GetErrors();
  MeasureTable table;
  for (const helios::EchoMeasure& measure : helios::EchoMeasures)
  {
    table.Add(measure.Name, errors.*measure.Measure);
  }
  table.AddCount("echoes", errors.Echoes);
  table.AddCount("matched", errors.Matched);
  table.AddColumns(vtkTable::GetData(outputs));
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosEchoComparison::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MatchingDistance: " << this->MatchingDistance << " m\n"
     << indent << "FullAmplitude: " << this->FullAmplitude << " W\n"
     << indent << "Extinction: " << this->Extinction << " 1/m\n"
     << indent << "LeastShare: " << this->LeastShare << "\n"
     << indent << "LeastAmplitude: " << this->LeastAmplitude << " W\n";
}
