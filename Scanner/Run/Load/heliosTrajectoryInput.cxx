// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTrajectoryInput.h"

#include "heliosMessages.h"
#include "heliosRecordTimes.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

/// The tolerance of the squared length of a quaternion, as in vtkHeliosInterpolatedPlatform.
constexpr double UnitTolerance = 1e-6;

/// Returns a point array with a tuple per point; null after an error.
vtkDataArray* FindArray(vtkPolyData* data, const char* array, int components, const char* meaning,
  const std::string& name, Messages& log)
{
  MessageBuilder text;
  vtkDataArray* found = data->GetPointData()->GetArray(array);
  if (!found)
  {
    text << name << " has no point array " << array << "; add one, " << meaning
         << ", as vtkHeliosTrajectoryReader does";
  }
  else if (found->GetNumberOfComponents() != components)
  {
    text << name << ": point array " << array << " has " << found->GetNumberOfComponents()
         << " components; give " << components << ", " << meaning;
  }
  else if (found->GetNumberOfTuples() != data->GetNumberOfPoints())
  {
    text << name << ": point array " << array << " has " << found->GetNumberOfTuples()
         << " rows for " << data->GetNumberOfPoints() << " points; give one per point";
  }
  if (!text.str().empty())
  {
    log.Error(text.str());
  }
  return text.str().empty() ? found : nullptr;
}

/// Checks the rows of a trajectory, each in turn.
class RowCheck
{
public:
  RowCheck(vtkPolyData* data, vtkDataArray* times, vtkDataArray* orientations)
    : Data(data)
    , Times(times)
    , Orientations(orientations)
  {
  }

  /// Describes the fault of a row in the text, with its cure; unchanged without one.
  void Describe(vtkIdType row, MessageBuilder& text) const
  {
    double p[3];
    double q[4];
    const double time = this->Times->GetComponent(row, 0);
    this->Data->GetPoint(row, p);
    this->Orientations->GetTuple(row, q);
    if (!std::isfinite(time))
    {
      text << names::GpsTime << " is " << time << "; give a finite time [s], or remove the row";
    }
    else if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      text << "Points is (" << p[0] << ", " << p[1] << ", " << p[2]
           << "); give finite coordinates [m], or remove the row";
    }
    else if (!(std::abs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1.0) <
               UnitTolerance))
    {
      text << names::Orientation << " is (" << q[0] << ", " << q[1] << ", " << q[2] << ", " << q[3]
           << "), which is not a unit quaternion w, x, y, z; normalize it";
    }
    else
    {
      this->DescribeOrder(row, time, text);
    }
  }

private:
  void DescribeOrder(vtkIdType row, double time, MessageBuilder& text) const
  {
    const double before = row > 0 ? this->Times->GetComponent(row - 1, 0) : -INFINITY;
    if (time < before)
    {
      const double period = FindEndedPeriod(before, time);
      text << names::GpsTime << " is " << time << ", before that of row " << row - 1 << ", "
           << before << "; ";
      period > 0.0 ? text << NamePeriod(period) << " ends there: add " << period
                          << " s to the rows from this one on"
                   : text << "sort the rows by " << names::GpsTime;
    }
    else if (row > 1 && time == before && time == this->Times->GetComponent(row - 2, 0))
    {
      text << names::GpsTime << " is " << time
           << ", as in the two rows before; two rows at one time are a jump, remove the others";
    }
  }

  vtkPolyData* Data;
  vtkDataArray* Times;
  vtkDataArray* Orientations;
};

/// Returns whether times can be seconds of one clock; warns of missing rows.
bool CheckTimes(vtkPolyData* data, vtkDataArray* times, const std::string& name, Messages& log)
{
  const auto getPosition = [data](std::size_t row)
  {
    Vec3 position;
    data->GetPoint(static_cast<vtkIdType>(row), position.GetData());
    return position;
  };
  const TimeFinding finding =
    CheckRecordTimes({ static_cast<std::size_t>(data->GetNumberOfPoints()),
      [times](std::size_t row) { return times->GetComponent(static_cast<vtkIdType>(row), 0); },
      getPosition });
  const std::string text = name + ", row " + std::to_string(finding.Row) + ": " + finding.Message;
  if (finding.IsError)
  {
    log.Error(text);
  }
  else if (!finding.Message.empty())
  {
    log.Warning(text);
  }
  return !finding.IsError;
}

} // namespace

//------------------------------------------------------------------------------
bool CheckTrajectoryInput(vtkPolyData* data, const std::string& name, Messages& log)
{
  if (data->GetNumberOfPoints() == 0)
  {
    log.Error(name + " has no points; give one per row of the trajectory, [m]");
    return false;
  }
  vtkDataArray* times = FindArray(data, names::GpsTime, 1, "the time [s]", name, log);
  vtkDataArray* orientations =
    FindArray(data, names::Orientation, 4, "the unit quaternion w, x, y, z", name, log);
  if (!times || !orientations)
  {
    return false;
  }
  const RowCheck check(data, times, orientations);
  for (vtkIdType row = 0; row < data->GetNumberOfPoints(); ++row)
  {
    MessageBuilder fault;
    check.Describe(row, fault);
    if (fault.tellp() > 0)
    {
      log.Error(name + ", row " + std::to_string(row) + ": " + fault.str());
      return false;
    }
  }
  return CheckTimes(data, times, name, log);
}

} // namespace helios
