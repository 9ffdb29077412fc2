// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTrajectoryFile.h"

#include "vtkHeliosTrajectoryReader.h"

namespace helios
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHeliosTrajectoryReader> MakeTrajectoryReader(
  const TrajectoryFileData& file, AngleConvention convention, const std::string& crs)
{
  auto reader = vtkSmartPointer<vtkHeliosTrajectoryReader>::New();
  reader->SetFileName(file.File.c_str());
  reader->SetFileFormat(static_cast<int>(file.Format));
  reader->SetFileCRS(file.Crs.empty() ? reader->GetFileCRS() : file.Crs);
  reader->SetTargetCRS(crs);
  reader->SetBodyFrame(static_cast<int>(file.Body));
  reader->SetSeparators(file.Separator);
  reader->SetTimeColumn(file.Columns[0]);
  reader->SetRollColumn(file.Columns[1]);
  reader->SetPitchColumn(file.Columns[2]);
  reader->SetYawColumn(file.Columns[3]);
  reader->SetXColumn(file.Columns[4]);
  reader->SetYColumn(file.Columns[5]);
  reader->SetZColumn(file.Columns[6]);
  reader->SetDomain(file.HasAttitude ? vtkHeliosTrajectoryReader::POSITION_AND_ATTITUDE
                                     : vtkHeliosTrajectoryReader::POSITION);
  reader->SetAngleUnit(
    file.IsInRadians ? vtkHeliosTrajectoryReader::RADIANS : vtkHeliosTrajectoryReader::DEGREES);
  reader->SetAngleConvention(static_cast<int>(convention));
  reader->SetSlopeFilterThreshold(file.SlopeThreshold);
  return reader;
}

} // namespace helios
