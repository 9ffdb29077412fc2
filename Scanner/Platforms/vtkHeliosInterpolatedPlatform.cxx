// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosInterpolatedPlatform.h"

#include "heliosPathCell.h"
#include "heliosRecordTimes.h"
#include "heliosSampledPath.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkAppendPolyData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkHeliosInterpolatedPlatform);

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr int NoLeg = -1;

/// Trajectories further apart are of two clocks [s].
constexpr double LongestBreak = 7.0 * 86400.0;

/// Returns a time from navigation software, which may have many digits.
std::string Seconds(double time)
{
  std::ostringstream text;
  text << std::setprecision(15) << time << " s";
  return text.str();
}

/// An input, and the times that it covers.
struct Input
{
  int Number;
  double Start;
  double End;
  double Offset = 0.0; // added to its times
};

/// Continues the times of inputs, in order of time, that are after the end of a week or day; returns
/// the input that is the first one then, or the first of all without such an end.
std::size_t ContinueInputs(std::vector<Input>& order)
{
  const double period =
    order.empty() ? 0.0 : helios::FindEndedPeriod(order.back().End, order.front().Start);
  for (std::size_t i = 1; period > 0.0 && i < order.size(); ++i)
  {
    if (order[i].Start - order[i - 1].End > 0.5 * period)
    {
      std::for_each(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(i),
        [period](Input& input) { input.Offset = period; });
      std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(i), order.end());
      return order.size() - i;
    }
  }
  return 0;
}

/// Returns an input with an offset added to its times.
vtkSmartPointer<vtkPolyData> Shift(vtkPolyData* data, double offset)
{
  auto shifted = vtkSmartPointer<vtkPolyData>::New();
  shifted->ShallowCopy(data);
  vtkDataArray* times = data->GetPointData()->GetArray(names::GpsTime);
  vtkNew<vtkDoubleArray> later;
  later->SetName(names::GpsTime);
  later->SetNumberOfValues(times->GetNumberOfTuples());
  for (vtkIdType i = 0; i < times->GetNumberOfTuples(); ++i)
  {
    later->SetValue(i, times->GetComponent(i, 0) + offset);
  }
  shifted->GetPointData()->AddArray(later);
  return shifted;
}

/// The arrays of the output trajectory.
class PathWriter
{
public:
  PathWriter(vtkPolyData* output, vtkIdType count, bool isCubic)
    : Output(output)
    , IsCubic(isCubic)
  {
    this->Points->SetDataTypeToDouble();
    this->Points->Allocate(count);
    this->Add(this->Times, names::GpsTime, 1, count);
    this->Add(this->Orientations, names::Orientation, 4, count);
    if (isCubic)
    {
      this->Add(this->Velocities, names::Velocity, 3, count);
    }
    this->LegIds->SetName(names::LegIds);
    this->LegIds->Allocate(count);
    output->GetPointData()->AddArray(this->LegIds);
  }

  void Append(const helios::SampledPath::State& state, double time, int leg)
  {
    this->Points->InsertNextPoint(state.Position.GetData());
    this->Times->InsertNextValue(time);
    this->Orientations->InsertNextTypedTuple(state.Orientation.GetData());
    if (this->IsCubic)
    {
      this->Velocities->InsertNextTypedTuple(state.Velocity.GetData());
    }
    this->LegIds->InsertNextValue(leg);
  }

  void Finish()
  {
    this->Output->SetPoints(this->Points);
    helios::AddPathCell(this->Output);
  }

private:
  void Add(vtkDoubleArray* array, const char* name, int components, vtkIdType count)
  {
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->Allocate(count * components);
    this->Output->GetPointData()->AddArray(array);
  }

  vtkPolyData* Output;
  bool IsCubic;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Times;
  vtkNew<vtkDoubleArray> Orientations;
  vtkNew<vtkDoubleArray> Velocities;
  vtkNew<vtkIntArray> LegIds;
};

} // namespace

/// Part of the recorded times, and its time of flight. A waiting one stays at its start.
struct vtkHeliosInterpolatedPlatform::Span
{
  int LegId;
  double Start;
  double End;
  double Clock; // GpsTime of the start
  bool Waits;
};

//------------------------------------------------------------------------------
void vtkHeliosInterpolatedPlatform::AddLeg(double start, double end, bool teleportToStart)
{
  this->Legs.push_back({ start, end, teleportToStart });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHeliosInterpolatedPlatform::RemoveAllLegs()
{
  this->Legs.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkHeliosInterpolatedPlatform::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkHeliosInterpolatedPlatform::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkSmartPointer<vtkPolyData> input = this->JoinInputs(inputVector[0]);
  helios::SampledPath path;
  std::vector<Leg> legs;
  if (!input || !path.Set(input, this->Interpolation == CUBIC).IsOk() ||
    !this->FindLegs(path, legs))
  {
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->Fill(path, this->PlanSpans(legs), output);
  output->GetFieldData()->PassData(input->GetFieldData());
  return 1;
}

//------------------------------------------------------------------------------
// The inputs, each checked, concatenated; null after an error.
vtkSmartPointer<vtkPolyData> vtkHeliosInterpolatedPlatform::JoinInputs(vtkInformationVector* inputs)
{
  std::vector<Input> order;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    helios::SampledPath path;
    const helios::Status status =
      path.Set(vtkPolyData::GetData(inputs, i), this->Interpolation == CUBIC);
    if (!status.IsOk())
    {
      vtkErrorMacro(<< "Trajectory " << i << " " << status.Message() << ".");
      return nullptr;
    }
    order.push_back({ i, path.GetStartTime(), path.GetEndTime() });
  }
  std::sort(
    order.begin(), order.end(), [](const Input& a, const Input& b) { return a.Start < b.Start; });
  vtkNew<vtkAppendPolyData> append;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (i > 0 && order[i].Start < order[i - 1].End)
    {
      vtkErrorMacro(<< "Trajectory " << order[i].Number << " starts at " << Seconds(order[i].Start)
                    << ", before trajectory " << order[i - 1].Number << " ends, at "
                    << Seconds(order[i - 1].End)
                    << "; connect each once, and cut them where they overlap.");
      return nullptr;
    }
    if (i > 0 && order[i].Start - order[i - 1].End >= LongestBreak)
    {
      vtkErrorMacro(
        << "Trajectory " << order[i].Number << " starts at " << Seconds(order[i].Start)
        << ", trajectory " << order[i - 1].Number << " ends at " << Seconds(order[i - 1].End)
        << ": these are times of two clocks, such as seconds of a GPS week and GPS time "
           "since 1980; give all trajectories times of one.");
      return nullptr;
    }
  }
  if (const std::size_t later = ContinueInputs(order))
  {
    vtkWarningMacro(<< "Trajectory " << order[later].Number << " starts at "
                    << Seconds(order[later].Start) << ", after the end of trajectory "
                    << order[later - 1].Number << " at " << Seconds(order[later - 1].End) << ": "
                    << helios::NamePeriod(order[later].Offset)
                    << " ends between them, and its times continue with "
                    << Seconds(order[later].Offset) << " added.");
  }
  for (const Input& input : order)
  {
    vtkPolyData* data = vtkPolyData::GetData(inputs, input.Number);
    append->AddInputData(input.Offset > 0.0 ? Shift(data, input.Offset).Get() : data);
  }
  if (order.size() == 1)
  {
    return vtkPolyData::GetData(inputs, 0);
  }
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  append->Update();
  return append->GetOutput();
}

//------------------------------------------------------------------------------
bool vtkHeliosInterpolatedPlatform::FindLegs(
  const helios::SampledPath& path, std::vector<Leg>& legs)
{
  legs = this->Legs;
  for (std::size_t i = 0; i < legs.size(); ++i)
  {
    legs[i].Start = std::isnan(legs[i].Start) ? path.GetStartTime() : legs[i].Start;
    legs[i].End = std::isnan(legs[i].End) ? path.GetEndTime() : legs[i].End;
    if (!this->CheckLeg(path, legs[i], i))
    {
      return false;
    }
    if (i > 0 && !legs[i].Teleports && !this->KeepFileTimes && legs[i].Start < legs[i - 1].End)
    {
      vtkWarningMacro(<< "Leg " << i << " starts at " << Seconds(legs[i].Start)
                      << " of the recorded times, before leg " << i - 1 << " ends, at "
                      << Seconds(legs[i - 1].End)
                      << ": the platform jumps back to an earlier position.");
    }
  }
  if (legs.empty())
  {
    legs.push_back({ path.GetStartTime(), path.GetEndTime(), false });
  }
  return !this->KeepFileTimes || this->CheckFileTimes(legs);
}

//------------------------------------------------------------------------------
bool vtkHeliosInterpolatedPlatform::CheckLeg(
  const helios::SampledPath& path, const Leg& leg, std::size_t index)
{
  if (!(leg.Start < leg.End))
  {
    vtkErrorMacro(<< "Leg " << index << " starts at " << Seconds(leg.Start) << " and ends at "
                  << Seconds(leg.End) << "; its end must be later.");
    return false;
  }
  if (leg.Start < path.GetStartTime() || leg.End > path.GetEndTime())
  {
    vtkErrorMacro(<< "Leg " << index << " covers " << Seconds(leg.Start) << " to "
                  << Seconds(leg.End) << ", but the recorded times are "
                  << Seconds(path.GetStartTime()) << " to " << Seconds(path.GetEndTime())
                  << "; give times within them.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosInterpolatedPlatform::CheckFileTimes(const std::vector<Leg>& legs)
{
  for (std::size_t i = 0; i < legs.size(); ++i)
  {
    if (legs[i].Start < 0.0 || legs[i].End > 1e12)
    {
      vtkErrorMacro(<< "Leg " << i << " covers " << Seconds(legs[i].Start) << " to "
                    << Seconds(legs[i].End)
                    << "; kept times must lie between 0 and 1e12 s; switch KeepFileTimes off.");
      return false;
    }
    if (i > 0 && legs[i].Start < legs[i - 1].End)
    {
      vtkErrorMacro(<< "Leg " << i << " starts at " << Seconds(legs[i].Start) << ", before leg "
                    << i - 1 << " ends, at " << Seconds(legs[i - 1].End)
                    << "; times must increase; switch KeepFileTimes off or sort the legs.");
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<vtkHeliosInterpolatedPlatform::Span> vtkHeliosInterpolatedPlatform::PlanSpans(
  const std::vector<Leg>& legs) const
{
  std::vector<Span> spans;
  double clock = this->StartTime;
  const auto append = [&spans, &clock](int id, double start, double end, bool waits)
  {
    spans.push_back({ id, start, end, clock, waits });
    clock += end - start;
  };
  for (std::size_t i = 0; i < legs.size(); ++i)
  {
    const double before = i > 0 ? legs[i - 1].End : legs[i].Start;
    const bool hasGap = legs[i].Start > before;
    if (hasGap && (!legs[i].Teleports || this->KeepFileTimes))
    {
      append(NoLeg, before, legs[i].Start, legs[i].Teleports);
    }
    append(this->FirstLegId + static_cast<int>(i), legs[i].Start, legs[i].End, false);
  }
  return spans;
}

//------------------------------------------------------------------------------
void vtkHeliosInterpolatedPlatform::Fill(
  const helios::SampledPath& path, const std::vector<Span>& spans, vtkPolyData* output) const
{
  vtkIdType count = 0;
  for (const Span& span : spans)
  {
    count += 2 + (span.Waits ? 0 : path.CountBefore(span.End) - path.CountUntil(span.Start));
  }
  PathWriter writer(output, count, this->Interpolation == CUBIC);
  for (const Span& span : spans)
  {
    const auto getTime = [this, &span](double time)
    { return this->KeepFileTimes ? time : span.Clock + (time - span.Start); };
    const auto append = [&writer, &span, &getTime](const helios::SampledPath::State& state)
    { writer.Append(state, getTime(state.Time), span.LegId); };
    helios::SampledPath::State start =
      span.Waits ? path.GetArrival(span.Start) : path.GetDeparture(span.Start);
    if (span.Waits)
    {
      start.Velocity = { 0.0, 0.0, 0.0 };
      append(start);
      start.Time = span.End;
      append(start);
      continue;
    }
    append(start);
    const vtkIdType last = path.CountBefore(span.End);
    for (vtkIdType i = path.CountUntil(span.Start); i < last; ++i)
    {
      append(path.GetSample(i));
    }
    if (span.End > span.Start)
    {
      append(path.GetArrival(span.End));
    }
  }
  writer.Finish();
}

//------------------------------------------------------------------------------
void vtkHeliosInterpolatedPlatform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FirstLegId: " << this->FirstLegId << "\n"
     << indent << "KeepFileTimes: " << this->KeepFileTimes << "\n"
     << indent << "Interpolation: " << (this->Interpolation == CUBIC ? "Cubic" : "Linear") << "\n";
  for (const Leg& leg : this->Legs)
  {
    os << indent << "Leg: " << Seconds(leg.Start) << " to " << Seconds(leg.End)
       << (leg.Teleports ? ", teleports" : "") << "\n";
  }
}
