// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosWaterWaves.h"

#include "heliosMaterialTable.h"
#include "heliosWaveSpectrum.h"

#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHeliosWaterWaves);

namespace
{

helios::WaveField MakeField(vtkHeliosWaterWaves* self)
{
  return { { self->GetWindSpeed(), self->GetWindDirection(), self->GetFetch() },
    self->GetShortestWave(), static_cast<std::uint64_t>(self->GetSeed()) };
}

/// Returns the points with the heights of waves added.
vtkSmartPointer<vtkPoints> Raise(vtkPoints* rest, const helios::WaveField& field, double time)
{
  auto raised = vtkSmartPointer<vtkPoints>::New();
  raised->SetDataTypeToDouble();
  raised->SetNumberOfPoints(rest->GetNumberOfPoints());
  vtkSMPTools::For(0, rest->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        double p[3];
        rest->GetPoint(i, p);
        raised->SetPoint(i, p[0], p[1], p[2] + field.GetHeight(p[0], p[1], time));
      }
    });
  return raised;
}

/// Sets the slopes of the wind that the mesh does not contain.
void SetSlopes(vtkPolyData* water, double slopes)
{
  helios::MaterialTable materials = helios::GetMaterials(water);
  bool hasWater = false;
  for (helios::Material& material : materials)
  {
    const bool isWater = material.Optics.Kind == helios::OpticsKind::Water;
    material.Optics.MeanSquareSlope = isWater ? slopes : material.Optics.MeanSquareSlope;
    hasWater = hasWater || isWater;
  }
  if (hasWater)
  {
    helios::SetMaterials(water, materials);
  }
}

} // namespace

//------------------------------------------------------------------------------
int vtkHeliosWaterWaves::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!std::isfinite(this->WindDirection) || !std::isfinite(this->Time))
  {
    vtkErrorMacro(<< "WindDirection is " << this->WindDirection << " and Time is " << this->Time
                  << "; give finite numbers");
    return 0;
  }
  output->ShallowCopy(input);
  if (!input->GetPoints() || !(this->WindSpeed > 0.0))
  {
    return 1;
  }
  const helios::WaveField field = MakeField(this);
  output->SetPoints(Raise(input->GetPoints(), field, this->Time));
  vtkNew<vtkFieldData> fields; // replaces the input's field data
  fields->ShallowCopy(input->GetFieldData());
  output->SetFieldData(fields);
  const double all = 0.003 + 0.00512 * this->WindSpeed; // Cox and Munk 1954
  SetSlopes(output, std::max(0.0, all - field.GetMeanSquareSlope()));
  return 1;
}

//------------------------------------------------------------------------------
double vtkHeliosWaterWaves::GetHeight(double x, double y)
{
  return MakeField(this).GetHeight(x, y, this->Time);
}

//------------------------------------------------------------------------------
double vtkHeliosWaterWaves::GetSignificantHeight()
{
  return 4.0 * std::sqrt(MakeField(this).GetVariance());
}

//------------------------------------------------------------------------------
void vtkHeliosWaterWaves::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WindSpeed: " << this->WindSpeed << "\n"
     << indent << "WindDirection: " << this->WindDirection << "\n"
     << indent << "Fetch: " << this->Fetch << "\n"
     << indent << "ShortestWave: " << this->ShortestWave << "\n"
     << indent << "Time: " << this->Time << "\n"
     << indent << "Seed: " << this->Seed << "\n";
}
