// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPoseText.h"

#include <cmath>
#include <sstream>
#include <string>

namespace helios
{

namespace
{

constexpr int LastColumn = 7;
/// Largest deviation of a quaternion from unit length: files have as few as four decimals.
constexpr double LengthTolerance = 1e-3;

std::string Print(const Quaternion& q)
{
  std::ostringstream text;
  text << "w " << q.GetW() << ", x " << q.GetX() << ", y " << q.GetY() << ", z " << q.GetZ();
  return text.str();
}

} // namespace

PoseTextParser::PoseTextParser(const PoseColumns& columns, TextReport& report)
  : Columns(columns)
  , Report(report)
  , Row(columns.Separators)
{
  for (int column = 0; column <= LastColumn; ++column)
  {
    this->Row.Need(column);
  }
}

bool PoseTextParser::Fail(const std::string& message)
{
  return this->Report.Fail(this->File->GetPlace() + message);
}

bool PoseTextParser::Read(LineFile& file, RecordedPath& path)
{
  this->File = &file;
  file.SetRange(0, file.GetSize());
  std::string_view line;
  while (file.NextLine(line))
  {
    if (!TextRow::IsEmpty(line) && !this->ReadRow(line, path))
    {
      return false;
    }
  }
  if (!file.GetError().empty())
  {
    return this->Report.Fail(file.GetError());
  }
  if (file.IsStopped())
  {
    return this->Fail("reading was aborted here; update again to read it");
  }
  if (path.Rows.empty())
  {
    return this->Report.Fail(file.GetPath() + ": has no rows; give a " + this->Columns.Name +
      " file with rows " + this->Columns.Order);
  }
  const auto getPlace = [&](std::size_t i)
  {
    std::string_view ignored;
    file.SetRange(path.Rows[i].LineStart, path.Rows[i].LineStart + 1);
    file.NextLine(ignored);
    return file.GetPlace();
  };
  return CheckRowTimes(path.Rows, getPlace, this->Report);
}

bool PoseTextParser::ReadRow(std::string_view line, RecordedPath& path)
{
  switch (this->Row.Read(line))
  {
    case TextRow::Good:
      return this->AddPose(path);
    case TextRow::Short:
      return this->Fail("the row has " + std::to_string(this->Row.GetColumn()) +
        " columns; a row of a " + this->Columns.Name + " file is " + this->Columns.Order);
    default:
      return this->Fail(this->Row.DescribeFault("row"));
  }
}

bool PoseTextParser::AddPose(RecordedPath& path)
{
  const auto get = [this](int column) { return this->Row.GetValue(column); };
  const int v = this->Columns.FirstOfVector;
  const Quaternion q(get(this->Columns.W), get(v), get(v + 1), get(v + 2));
  const double length = q.Norm();
  if (!(std::abs(length - 1.0) <= LengthTolerance))
  {
    return this->Fail("the quaternion (" + Print(q) + ") has length " + std::to_string(length) +
      "; give unit quaternions, and rows " + this->Columns.Order);
  }
  TrajectoryRow row{};
  row.Time = this->Clock.Continue(get(0) * this->Columns.TimeUnit);
  if (this->Clock.IsFirstContinued())
  {
    this->Report.Warn(this->File->GetPlace() + this->Clock.DescribeEnd());
  }
  row.Position = { get(1), get(2), get(3) };
  row.LineStart = this->File->GetLineStart();
  if (!path.Rows.empty() && !(row.Time > path.Rows.back().Time))
  {
    return this->Fail("time is " + PrintExactly(row.Time) +
      " s, not after that of the row before, " + PrintExactly(path.Rows.back().Time) +
      " s; sort the rows by time, one per time");
  }
  path.Rows.push_back(row);
  path.Attitudes.push_back(q * (1.0 / length));
  return true;
}

} // namespace helios
