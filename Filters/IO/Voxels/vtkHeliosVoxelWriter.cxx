// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosVoxelWriter.h"

#include "heliosStatus.h"
#include "heliosTextFileSink.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFoliageArrayNames.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkObjectFactory.h>

#include <cmath>
#include <limits>
#include <string_view>

vtkStandardNewMacro(vtkHeliosVoxelWriter);

namespace names = vtkHeliosArrayNames;
namespace foliage = vtkHeliosFoliageArrayNames;

namespace
{

constexpr std::string_view Title =
  "i j k PadBVTotal angleMean bsEntering bsIntercepted bsPotential ground_distance lMeanTotal "
  "lgTotal nbEchos nbSampling transmittance attenuation attenuationBiasCorrection\n";

constexpr double Cubic = 1e-9; // relative difference of the edges of a cube

/// The arrays of a cell; missing ones are NaN.
class CellColumns
{
public:
  explicit CellColumns(vtkImageData* grid)
    : Data(grid->GetCellData())
    , Pad(this->Data->GetArray(names::PAD))
    , Transmittance(this->Data->GetArray(names::Transmittance))
    , Entering(this->Data->GetArray(foliage::EnteringEnergy))
    , Intercepted(this->Data->GetArray(foliage::InterceptedEnergy))
    , Beams(this->Data->GetArray(foliage::NumberOfBeams))
    , Shadowed(this->Data->GetArray(foliage::NumberOfShadowedBeams))
    , Length(this->Data->GetArray(foliage::PathLength))
    , Ground(this->Data->GetArray(foliage::GroundDistance))
  {
  }

  void AppendRow(vtkIdType cell, helios::TextFileSink& sink) const
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double beams = Get(this->Beams, cell);
    const double length = Get(this->Length, cell);
    const double entering = Get(this->Entering, cell);
    const double intercepted = Get(this->Intercepted, cell);
    const double attenuation = length > 0.0 ? intercepted / length : nan;
    const double mean = entering > 0.0 ? length / entering : nan;
    sink.AppendNumber(Get(this->Pad, cell));
    for (const double value :
      { nan, entering, intercepted, beams + Get(this->Shadowed, cell), Get(this->Ground, cell),
        mean, length, 0.0, beams, Get(this->Transmittance, cell), attenuation, nan })
    {
      sink.AppendNumber(value);
    }
    sink.Append("\n");
  }

private:
  static double Get(vtkDataArray* array, vtkIdType cell)
  {
    return array ? array->GetTuple1(cell) : std::numeric_limits<double>::quiet_NaN();
  }

  vtkCellData* Data;
  vtkDataArray* Pad;
  vtkDataArray* Transmittance;
  vtkDataArray* Entering;
  vtkDataArray* Intercepted;
  vtkDataArray* Beams;
  vtkDataArray* Shadowed;
  vtkDataArray* Length;
  vtkDataArray* Ground;
};

void AppendNumbers(helios::TextFileSink& sink, std::string_view key, const double values[3])
{
  sink.Append(key);
  for (int axis = 0; axis < 3; ++axis)
  {
    sink.AppendNumber(values[axis]);
  }
  sink.Append("\n");
}

/// Returns the largest density of the cells; 0: none is known.
double FindMaximum(vtkDataArray* pad)
{
  double maximum = 0.0;
  for (vtkIdType i = 0; i < pad->GetNumberOfTuples(); ++i)
  {
    const double value = pad->GetTuple1(i);
    maximum = value > maximum ? value : maximum;
  }
  return maximum;
}

void AppendHead(vtkImageData* grid, helios::TextFileSink& sink)
{
  int points[3];
  int extent[6];
  double low[3];
  double high[3];
  grid->GetDimensions(points);
  grid->GetExtent(extent);
  const double size = grid->GetSpacing()[0];
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = grid->GetOrigin()[axis] + size * extent[2 * axis];
    high[axis] = low[axis] + size * (points[axis] - 1);
  }
  sink.Append("VOXEL SPACE\n");
  AppendNumbers(sink, "#min_corner:", low);
  AppendNumbers(sink, "#max_corner:", high);
  sink.Append("#split:");
  for (const int count : points)
  {
    sink.AppendNumber(count - 1);
  }
  sink.Append("\n#res:");
  sink.AppendNumber(size);
  const double maximum = FindMaximum(grid->GetCellData()->GetArray(names::PAD));
  if (maximum > 0.0)
  {
    sink.Append(" #max_pad:");
    sink.AppendNumber(maximum);
  }
  sink.Append("\n");
  sink.Append(Title);
}

bool HasCubes(vtkImageData* grid)
{
  const double* size = grid->GetSpacing();
  return std::abs(size[1] - size[0]) <= Cubic * size[0] &&
    std::abs(size[2] - size[0]) <= Cubic * size[0] && grid->GetDirectionMatrix()->IsIdentity();
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosVoxelWriter::vtkHeliosVoxelWriter()
{
  this->SetNumberOfOutputPorts(0);
}

//------------------------------------------------------------------------------
vtkHeliosVoxelWriter::~vtkHeliosVoxelWriter()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkHeliosVoxelWriter::Write()
{
  this->IsWritten = false;
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro(<< "FileName is not set; give the .vox file with SetFileName");
  }
  else if (this->GetNumberOfInputConnections(0) == 0)
  {
    vtkErrorMacro(<< "no grid to write; give it with SetInputData or SetInputConnection");
  }
  else
  {
    this->Modified(); // write again, even if unchanged
    this->Update();
  }
  return this->IsWritten ? 1 : 0;
}

//------------------------------------------------------------------------------
int vtkHeliosVoxelWriter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosVoxelWriter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  const std::string error = this->WriteGrid(vtkImageData::GetData(inputVector[0]));
  this->IsWritten = error.empty();
  if (!this->IsWritten)
  {
    vtkErrorMacro(<< error);
  }
  return this->IsWritten ? 1 : 0;
}

//------------------------------------------------------------------------------
std::string vtkHeliosVoxelWriter::WriteGrid(vtkImageData* grid)
{
  const std::string notWritten = std::string(this->FileName) + ": not written: ";
  vtkDataArray* pad = grid->GetCellData()->GetArray(names::PAD);
  if (!pad || pad->GetNumberOfComponents() != 1)
  {
    return notWritten + "the image has no cell array " + names::PAD +
      " of one component; give it the plant area density of its cells [m2/m3]";
  }
  if (!HasCubes(grid))
  {
    return notWritten +
      "its cells are not cubes along x, y and z, which .vox files have; write a .vti file";
  }
  helios::TextFileSink sink;
  if (const helios::Status status = sink.Open(this->FileName); !status.IsOk())
  {
    return status.Message();
  }
  AppendHead(grid, sink);
  const CellColumns columns(grid);
  int points[3];
  grid->GetDimensions(points);
  for (int i = 0; i < points[0] - 1; ++i)
  {
    for (int j = 0; j < points[1] - 1; ++j)
    {
      for (int k = 0; k < points[2] - 1; ++k)
      {
        sink.Append(std::to_string(i));
        sink.AppendNumber(j);
        sink.AppendNumber(k);
        const vtkIdType row = static_cast<vtkIdType>(k) * (points[1] - 1) + j;
        columns.AppendRow(row * (points[0] - 1) + i, sink);
      }
    }
  }
  return sink.Close().Message();
}

//------------------------------------------------------------------------------
void vtkHeliosVoxelWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
}
