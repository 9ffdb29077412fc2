// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosWaveformPolylines.h"

#include "heliosConstants.h"
#include "heliosPose.h"
#include "heliosStatus.h"
#include "heliosWaveformTable.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkHeliosWaveformPolylines);

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double MetresPerNanosecond = 0.5 * helios::SpeedOfLight; // two-way

helios::Vec3 GetVector(const helios::Column& column, vtkIdType row)
{
  return { column.GetNumber(row, 0), column.GetNumber(row, 1), column.GetNumber(row, 2) };
}

/// Returns the unit vector perpendicular to a beam nearest to a unit vector; for a parallel beam: x
/// or y.
helios::Vec3 FindAcross(const helios::Vec3& beam, const helios::Vec3& wanted)
{
  constexpr double parallel = 1e-6;
  const helios::Vec3 choices[] = { wanted, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } };
  helios::Vec3 across;
  for (const helios::Vec3& choice : choices)
  {
    across = choice - beam.Dot(choice) * beam;
    if (across.Normalize() > parallel)
    {
      break;
    }
  }
  return across;
}

/// Builds the polylines.
class Curves
{
public:
  Curves(const helios::WaveformTable& waveforms, const helios::Vec3& side, double scale)
    : Waveforms(waveforms)
    , Side(side)
    , Scale(scale)
  {
    this->Points->SetDataTypeToDouble();
    this->Amplitude->SetName(names::Amplitude);
    this->Range->SetName(names::Range);
  }

  void Append(vtkIdType row)
  {
    const helios::WaveformTable& table = this->Waveforms;
    const helios::Vec3 origin = GetVector(table.Origin, row);
    const helios::Vec3 beam = GetVector(table.Direction, row);
    const helios::Vec3 across = FindAcross(beam, this->Side);
    const vtkIdType first = table.Offset.GetInteger(row);
    const vtkIdType count = table.Count.GetInteger(row);
    this->Lines->InsertNextCell(static_cast<int>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double time =
        table.StartTime.GetNumber(row) + static_cast<double>(i) * table.BinSize.GetNumber(row);
      const double range = MetresPerNanosecond * time;
      const double amplitude = table.Samples.GetNumber(first + i);
      const helios::Vec3 point = origin + range * beam + this->Scale * amplitude * across;
      this->Lines->InsertCellPoint(this->Points->InsertNextPoint(point.GetData()));
      this->Amplitude->InsertNextValue(static_cast<float>(amplitude));
      this->Range->InsertNextValue(range);
    }
  }

  void MoveTo(vtkPolyData* output)
  {
    output->SetPoints(this->Points);
    output->SetLines(this->Lines);
    output->GetPointData()->AddArray(this->Amplitude);
    output->GetPointData()->AddArray(this->Range);
    output->GetPointData()->SetActiveScalars(names::Amplitude);
  }

private:
  const helios::WaveformTable& Waveforms;
  helios::Vec3 Side;
  double Scale; // [m/W]
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkFloatArray> Amplitude;
  vtkNew<vtkDoubleArray> Range;
};

/// Copies the columns that apply to a curve.
void CopyColumns(vtkDataSetAttributes* from, const std::vector<vtkIdType>& rows, vtkCellData* to)
{
  vtkNew<vtkDataSetAttributes> columns;
  columns->ShallowCopy(from);
  for (const char* name : { names::Origin, names::Direction, names::Offset, names::Count })
  {
    columns->RemoveArray(name);
  }
  to->CopyAllOn();
  to->CopyAllocate(columns, static_cast<vtkIdType>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    to->CopyData(columns, rows[i], static_cast<vtkIdType>(i));
  }
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosWaveformPolylines::AddPulseId(vtkIdType id)
{
  if (this->PulseIds.insert(id).second)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHeliosWaveformPolylines::RemoveAllPulseIds()
{
  if (!this->PulseIds.empty())
  {
    this->PulseIds.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHeliosWaveformPolylines::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
bool vtkHeliosWaveformPolylines::CheckDirection()
{
  const double* d = this->DisplacementDirection;
  const double length = std::hypot(d[0], d[1], d[2]);
  if (!std::isfinite(length) || length == 0.0)
  {
    vtkErrorMacro(<< "DisplacementDirection is " << d[0] << ' ' << d[1] << ' ' << d[2]
                  << "; set a vector that is not zero, such as 0 0 1");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
double vtkHeliosWaveformPolylines::FindScale(const helios::WaveformTable& waveforms) const
{
  if (this->Scale > 0.0)
  {
    return this->Scale;
  }
  double largest = 0.0;
  for (vtkIdType i = 0; i < waveforms.NumberOfSamples; ++i)
  {
    largest = std::max(largest, std::abs(waveforms.Samples.GetNumber(i)));
  }
  return largest > 0.0 ? this->Height / largest : 0.0;
}

//------------------------------------------------------------------------------
int vtkHeliosWaveformPolylines::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkTable* table = vtkTable::GetData(inputVector[0]);
  helios::WaveformTable waveforms;
  const helios::Status status = waveforms.Set(table);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< "the input " << status.Message()
                  << "; connect the waveforms of vtkHeliosScanner (output port 1), or of a reader");
    return 0;
  }
  if (!this->CheckDirection())
  {
    return 0;
  }
  helios::Vec3 side(this->DisplacementDirection);
  side.Normalize();
  Curves curves(waveforms, side, waveforms.NumberOfRows > 0 ? this->FindScale(waveforms) : 0.0);
  std::vector<vtkIdType> shown;
  vtkIdType selected = 0;
  for (vtkIdType row = 0; row < waveforms.NumberOfRows; ++row)
  {
    const bool isSelected =
      this->PulseIds.empty() || this->PulseIds.count(waveforms.PulseIds.GetInteger(row)) > 0;
    if (isSelected && selected++ % this->EveryNth == 0)
    {
      shown.push_back(row);
      curves.Append(row);
    }
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  curves.MoveTo(output);
  CopyColumns(table->GetRowData(), shown, output->GetCellData());
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosWaveformPolylines::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const double* d = this->DisplacementDirection;
  os << indent << "Scale: " << this->Scale << "\n"
     << indent << "Height: " << this->Height << "\n"
     << indent << "DisplacementDirection: " << d[0] << ' ' << d[1] << ' ' << d[2] << "\n"
     << indent << "EveryNth: " << this->EveryNth << "\n"
     << indent << "NumberOfPulseIds: " << this->PulseIds.size() << "\n";
}
