// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSBETWriter.h"

#include "heliosColumn.h"
#include "heliosSbetEncoder.h"
#include "heliosSceneCrs.h"
#include "vtkHeliosArrayNames.h"

#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <vector>

vtkStandardNewMacro(vtkHeliosSBETWriter);

namespace names = vtkHeliosArrayNames;

//------------------------------------------------------------------------------
vtkHeliosSBETWriter::vtkHeliosSBETWriter()
  : Encoder(std::make_unique<helios::SbetEncoder>())
{
}

//------------------------------------------------------------------------------
vtkHeliosSBETWriter::~vtkHeliosSBETWriter() = default;

//------------------------------------------------------------------------------
void vtkHeliosSBETWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CRS: " << this->CRS << "\n" << indent << "FileCRS: " << this->FileCRS << "\n";
}

//------------------------------------------------------------------------------
const char* vtkHeliosSBETWriter::GetBlockSource() const
{
  return "the samples of a vtkHeliosPlatform or a vtkHeliosTrajectoryReader";
}

//------------------------------------------------------------------------------
bool vtkHeliosSBETWriter::Refuse(const std::string& problem)
{
  vtkErrorMacro(<< this->GetOpenName() << ": " << problem);
  return false;
}

//------------------------------------------------------------------------------
bool vtkHeliosSBETWriter::Open()
{
  this->Encoder = std::make_unique<helios::SbetEncoder>();
  return this->Superclass::Open();
}

//------------------------------------------------------------------------------
bool vtkHeliosSBETWriter::Write(vtkDataObject* block)
{
  vtkPolyData* data = this->CheckOpen() ? this->GetPoints(block) : nullptr;
  if (!data)
  {
    return false;
  }
  helios::SbetSamples samples;
  samples.Count = data->GetNumberOfPoints();
  if (samples.Count == 0)
  {
    return true;
  }
  samples.Points = helios::Column(data->GetPoints()->GetData());
  vtkPointData* arrays = data->GetPointData();
  if (!this->GetNumbers(arrays, names::GpsTime, samples.Count, 1, samples.Times) ||
    !this->GetNumbers(arrays, names::Orientation, samples.Count, 4, samples.Orientations) ||
    (arrays->HasArray(names::Velocity) &&
      !this->GetNumbers(arrays, names::Velocity, samples.Count, 3, samples.Velocities)))
  {
    return false;
  }
  const std::string crs = this->CRS.empty() ? helios::GetCRS(data) : this->CRS;
  std::vector<helios::SbetRecord> records;
  helios::Status status = this->Encoder->SetSystems(crs, this->FileCRS);
  status = status.IsOk() ? this->Encoder->Encode(samples, records) : status;
  if (!status.IsOk())
  {
    return this->Refuse(status.Message());
  }
  const vtkIdType start = this->GetFileSize();
  if (!this->WriteBytes(reinterpret_cast<const char*>(records.data()),
        records.size() * sizeof(helios::SbetRecord), start))
  {
    return false;
  }
  this->NumberOfRecords += samples.Count;
  this->NumberOfBytes += this->GetFileSize() - start;
  return true;
}
