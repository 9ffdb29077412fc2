// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPulseDensity.h"

#include "heliosStatus.h"
#include "heliosStrip.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFlightArrayNames.h"
#include "vtkHeliosSwath.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeliosPulseDensity);

namespace
{

namespace names = vtkHeliosArrayNames;
namespace flight = vtkHeliosFlightArrayNames;

helios::Status ReadStrips(vtkPolyData* lines, std::vector<helios::Strip>& strips)
{
  vtkDataArray* speeds = lines->GetPointData()->GetArray(names::Speed);
  if (!speeds)
  {
    return helios::Status::Error(std::string("the flight lines have no point array ") +
      names::Speed + "; use those of vtkHeliosFlightLines, or add it");
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < lines->GetLines()->GetNumberOfCells(); ++cell)
  {
    lines->GetLines()->GetCellAtId(cell, ids);
    std::vector<helios::Vec3> waypoints;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      waypoints.emplace_back(lines->GetPoint(ids->GetId(i)));
    }
    const double speed = speeds->GetTuple1(ids->GetId(0));
    if (!(speed > 0.0 && std::isfinite(speed)))
    {
      std::ostringstream text;
      text << names::Speed << " of flight line " << cell << " is " << speed
           << " m/s; give a positive speed";
      return helios::Status::Error(text.str());
    }
    if (waypoints.size() >= 2)
    {
      strips.emplace_back(std::move(waypoints), speed);
    }
  }
  return {};
}

helios::GroundPlace GetPlace(vtkPolyData* ground, vtkDataArray* normals, vtkIdType i)
{
  double p[3], n[3] = { 0.0, 0.0, 1.0 };
  ground->GetPoint(i, p);
  if (normals)
  {
    normals->GetTuple(i, n);
  }
  const bool isSteep = !(n[2] > 0.0);
  return { helios::Vec3(p), isSteep ? 0.0 : -n[0] / n[2], isSteep ? 0.0 : -n[1] / n[2] };
}

helios::Status CheckFinite(vtkPolyData* ground)
{
  for (vtkIdType i = 0; i < ground->GetNumberOfPoints(); ++i)
  {
    double p[3];
    ground->GetPoint(i, p);
    if (!std::isfinite(p[0] + p[1] + p[2]))
    {
      std::ostringstream text;
      text << "place " << i << " on port 0 is (" << p[0] << ", " << p[1] << ", " << p[2]
           << "); give finite coordinates";
      return helios::Status::Error(text.str());
    }
  }
  return {};
}

template <typename ArrayT>
ArrayT* AddArray(vtkPolyData* output, const char* name)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfTuples(output->GetNumberOfPoints());
  output->GetPointData()->AddArray(array);
  return array;
}

/// Fills the arrays of the output.
class Filler
{
public:
  Filler(const std::vector<helios::Strip>& strips, const vtkHeliosSwath& swath, vtkPolyData* output)
    : Strips(strips)
    , Swath(swath)
    , Ground(output)
    , Normals(output->GetPointData()->GetArray(names::Normal))
    , Densities(AddArray<vtkDoubleArray>(output, flight::PulseDensity))
    , Densest(AddArray<vtkDoubleArray>(output, flight::StripDensity))
    , Counts(AddArray<vtkIntArray>(output, flight::NumberOfStrips))
    , Heights(AddArray<vtkDoubleArray>(output, flight::FlyingHeight))
  {
  }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      this->Fill(i);
    }
  }

private:
  void Fill(vtkIdType i)
  {
    const helios::GroundPlace place = GetPlace(this->Ground, this->Normals, i);
    double sum = 0.0;
    double largest = 0.0;
    int count = 0;
    double nearest = VTK_DOUBLE_MAX;
    double height = std::nan("");
    for (const helios::Strip& strip : this->Strips)
    {
      const double density = strip.ComputeDensity(place, this->Swath);
      sum += density;
      largest = std::max(largest, density);
      count += density > 0.0;
      const helios::PlaceInStrip at = strip.Find(place.Position);
      if (std::abs(at.Across) < nearest)
      {
        nearest = std::abs(at.Across);
        height = at.Height;
      }
    }
    this->Densities->SetValue(i, sum);
    this->Densest->SetValue(i, largest);
    this->Counts->SetValue(i, count);
    this->Heights->SetValue(i, height);
  }

  const std::vector<helios::Strip>& Strips;
  const vtkHeliosSwath& Swath;
  vtkPolyData* Ground;
  vtkDataArray* Normals;
  vtkDoubleArray* Densities;
  vtkDoubleArray* Densest;
  vtkIntArray* Counts;
  vtkDoubleArray* Heights;
};

} // namespace

//------------------------------------------------------------------------------
vtkHeliosPulseDensity::vtkHeliosPulseDensity()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkHeliosPulseDensity::~vtkHeliosPulseDensity() = default;

//------------------------------------------------------------------------------
void vtkHeliosPulseDensity::SetSwath(vtkHeliosSwath* swath)
{
  if (this->Swath != swath)
  {
    this->Swath = swath;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHeliosSwath* vtkHeliosPulseDensity::GetSwath() const
{
  return this->Swath;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHeliosPulseDensity::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Swath ? std::max(own, this->Swath->GetMTime()) : own;
}

//------------------------------------------------------------------------------
int vtkHeliosPulseDensity::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosPulseDensity::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!this->Swath || !(this->Swath->GetPulseRate() > 0.0))
  {
    vtkErrorMacro(<< "Swath is not set, or not built; call Build() of a vtkHeliosSwath and set it");
    return 0;
  }
  vtkPolyData* ground = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  std::vector<helios::Strip> strips;
  helios::Status status = ReadStrips(vtkPolyData::GetData(inputs[1]), strips);
  status = status.IsOk() ? CheckFinite(ground) : status;
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  output->ShallowCopy(ground);
  Filler filler(strips, *this->Swath, output);
  vtkSMPTools::For(0, output->GetNumberOfPoints(), filler);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosPulseDensity::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Swath: " << this->Swath.Get() << "\n";
}
