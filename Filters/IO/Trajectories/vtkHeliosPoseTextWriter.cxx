// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPoseTextWriter.h"

#include "heliosColumn.h"
#include "heliosPose.h"
#include "heliosTextFormat.h"
#include "vtkHeliosArrayNames.h"

#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>

vtkStandardNewMacro(vtkHeliosPoseTextWriter);

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr vtkIdType TypicalRowSize = 110;
constexpr double NanosecondsPerSecond = 1e9;
constexpr double LastTime = 9.2e9; // in whole nanoseconds of 64 bits [s]
const char* const EurocHeader =
  "#timestamp [ns],p_x [m],p_y [m],p_z [m],q_w [],q_x [],q_y [],q_z []\n";

void AppendPosition(
  const helios::Column& points, vtkIdType row, char separator, helios::TextBuffer& text)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    text.Append(separator);
    text.AppendFixed<6>(points.GetNumber(row, axis));
  }
}

/// Appends the components from first on, in a circle: 0 for w x y z, 1 for x y z w.
void AppendQuaternion(const helios::Column& orientations, vtkIdType row, int first, char separator,
  helios::TextBuffer& text)
{
  double q[4];
  for (int i = 0; i < 4; ++i)
  {
    q[i] = orientations.GetNumber(row, i);
  }
  const double length = helios::Quaternion(q).Norm();
  for (int i = 0; i < 4; ++i)
  {
    text.Append(separator);
    text.AppendFixed<9>(q[(first + i) % 4] / length); // not finite if the length is 0: dropped
  }
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosPoseTextWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileFormat: " << (this->FileFormat == EUROC ? "EuRoC" : "TUM") << "\n";
}

//------------------------------------------------------------------------------
const char* vtkHeliosPoseTextWriter::GetBlockSource() const
{
  return "the samples of a vtkHeliosPlatform or a vtkHeliosTrajectoryReader";
}

//------------------------------------------------------------------------------
bool vtkHeliosPoseTextWriter::Open()
{
  return this->Superclass::Open() && (this->FileFormat == TUM || this->WriteText(EurocHeader));
}

//------------------------------------------------------------------------------
bool vtkHeliosPoseTextWriter::Write(vtkDataObject* block)
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
  const bool isTum = this->FileFormat == TUM;
  for (vtkIdType row = 0; !isTum && row < count; ++row)
  {
    if (std::abs(times.GetNumber(row)) > LastTime)
    {
      vtkErrorMacro(<< this->GetOpenName() << ": " << names::GpsTime << " is "
                    << times.GetNumber(row) << " s in row " << row
                    << " of a block; EuRoC files have "
                    << "times up to 9.2e9 s: subtract an epoch, or write TUM");
      return false;
    }
  }
  return this->WriteRows(count, TypicalRowSize,
    [&points, &times, &orientations, isTum](vtkIdType row, helios::TextBuffer& text)
    {
      const char separator = isTum ? ' ' : ',';
      const double time = times.GetNumber(row);
      if (isTum || !std::isfinite(time))
      {
        text.AppendFixed<9>(time);
      }
      else
      {
        text.AppendInteger(std::llround(NanosecondsPerSecond * time));
      }
      AppendPosition(points, row, separator, text);
      AppendQuaternion(orientations, row, isTum ? 1 : 0, separator, text);
      text.Append('\n');
    });
}
