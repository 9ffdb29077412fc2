// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosTrajectoryTextWriter.h"

#include "heliosColumn.h"
#include "heliosPose.h"
#include "heliosTextFormat.h"
#include "vtkHeliosArrayNames.h"

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

constexpr vtkIdType TypicalRowSize = 80;
constexpr double LockedCosine = 1e-9; // cosine of the pitch at gimbal lock
constexpr double HalfUnit = 5e-5;     // half the last decimal [deg]

/// Computes roll, pitch and yaw [deg] of A = Rx(roll) Ry(pitch) Rz(yaw); NaN for an invalid
/// rotation.
void GetAngles(const helios::Quaternion& orientation, double angles[3])
{
  if (orientation.SquaredNorm() == 0.0)
  {
    std::fill_n(angles, 3, vtkMath::Nan());
    return;
  }
  const helios::Rotation attitude(orientation);
  const auto& m = attitude.M;
  const double cosPitch = std::hypot(m[1][2], m[2][2]);
  const bool isLocked = cosPitch < LockedCosine;
  const double roll = isLocked ? 0.0 : std::atan2(-m[1][2], m[2][2]);
  const double pitch = std::atan2(m[0][2], cosPitch);
  const double yaw = isLocked ? std::atan2(m[1][0], m[1][1]) : std::atan2(-m[0][1], m[0][0]);
  angles[0] = vtkMath::DegreesFromRadians(roll);
  angles[1] = vtkMath::DegreesFromRadians(pitch);
  angles[2] = vtkMath::DegreesFromRadians(yaw);
  if (angles[2] < -HalfUnit) // smaller negative angles are printed as 0, not as 360
  {
    angles[2] += 360.0;
  }
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosTrajectoryTextWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
const char* vtkHeliosTrajectoryTextWriter::GetBlockSource() const
{
  return "the samples of a vtkHeliosPlatform";
}

//------------------------------------------------------------------------------
bool vtkHeliosTrajectoryTextWriter::Write(vtkDataObject* block)
{
  vtkPolyData* samples = this->CheckOpen() ? this->GetPoints(block) : nullptr;
  if (!samples)
  {
    return false;
  }
  const vtkIdType count = samples->GetNumberOfPoints();
  if (count == 0)
  {
    return true;
  }
  const helios::Column points(samples->GetPoints()->GetData());
  helios::Column times, orientations;
  vtkPointData* data = samples->GetPointData();
  if (!this->GetNumbers(data, names::GpsTime, count, 1, times) ||
    !this->GetNumbers(data, names::Orientation, count, 4, orientations))
  {
    return false;
  }
  return this->WriteRows(count, TypicalRowSize,
    [&points, &times, &orientations](vtkIdType row, helios::TextBuffer& text)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        text.AppendFixed<4>(points.GetNumber(row, axis));
        text.Append(' ');
      }
      text.AppendFixed<9>(times.GetNumber(row));
      double q[4], angles[3];
      for (int i = 0; i < 4; ++i)
      {
        q[i] = orientations.GetNumber(row, i);
      }
      GetAngles(helios::Quaternion(q), angles);
      for (const double angle : angles)
      {
        text.Append(' ');
        text.AppendFixed<4>(angle);
      }
      text.Append('\n');
    });
}
