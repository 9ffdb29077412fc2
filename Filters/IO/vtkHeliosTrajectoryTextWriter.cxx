// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosTrajectoryTextWriter.h"

#include "heliosPose.h"
#include "heliosTextFormat.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHeliosTrajectoryTextWriter);

namespace names = vtkHeliosArrayNames;

namespace
{

/// Roll, pitch and yaw [deg] of A = Rx(roll) Ry(pitch) Rz(yaw).
void GetAngles(const helios::Rotation& attitude, double angles[3])
{
  const auto& m = attitude.M;
  const double sinPitch = std::max(-1.0, std::min(1.0, m[0][2]));
  const bool isLocked = std::abs(sinPitch) > 1.0 - 1e-12;
  const double roll = isLocked ? 0.0 : std::atan2(-m[1][2], m[2][2]);
  const double yaw = isLocked ? std::atan2(m[1][0], m[1][1]) : std::atan2(-m[0][1], m[0][0]);
  angles[0] = vtkMath::DegreesFromRadians(roll);
  angles[1] = vtkMath::DegreesFromRadians(std::asin(sinPitch));
  const double degrees = vtkMath::DegreesFromRadians(yaw);
  // what would be printed as -0 or 360 is 0
  angles[2] = degrees < -5e-5 ? degrees + 360.0 : std::max(0.0, degrees);
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosTrajectoryTextWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
bool vtkHeliosTrajectoryTextWriter::Write(vtkDataObject* block)
{
  if (!this->CheckOpen())
  {
    return false;
  }
  auto* samples = vtkPolyData::SafeDownCast(block);
  if (!samples)
  {
    vtkErrorMacro(<< this->FileName << ": a block is not vtkPolyData");
    return false;
  }
  vtkDataArray* times = this->GetArray(samples->GetPointData(), names::GpsTime, 1);
  vtkDataArray* orientations = this->GetArray(samples->GetPointData(), names::Orientation, 4);
  if (!times || !orientations)
  {
    return false;
  }
  vtkPoints* points = samples->GetPoints();
  return this->WriteRows(samples->GetNumberOfPoints(),
    [points, times, orientations](vtkIdType row, helios::TextBuffer& text)
    {
      double p[3], q[4], angles[3];
      points->GetPoint(row, p);
      orientations->GetTuple(row, q);
      GetAngles(helios::Rotation(helios::Quaternion(q[0], q[1], q[2], q[3])), angles);
      for (const double coordinate : p)
      {
        text.AppendFixed<4>(coordinate);
        text.Append(' ');
      }
      text.AppendFixed<9>(times->GetComponent(row, 0));
      for (const double angle : angles)
      {
        text.Append(' ');
        text.AppendFixed<4>(angle);
      }
      text.Append('\n');
    });
}
