// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPulseTable.h"

#include "heliosPulseShape.h"
#include "heliosTextFile.h"

#include <vtkDataArray.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace helios
{
namespace
{

/// Samples that are checked one by one.
struct Table
{
  std::vector<double> Times;
  std::vector<double> Powers;

  Status Add(const std::string& place, double time, double power)
  {
    if (!std::isfinite(time) || !std::isfinite(power))
    {
      return Status::Error(place + "times and powers must be finite");
    }
    if (!this->Times.empty() && !(time > this->Times.back()))
    {
      return Status::Error(place + "its time is not after that of the previous one; sort them");
    }
    this->Times.push_back(time);
    this->Powers.push_back(power);
    return {};
  }

  double Integrate() const
  {
    double sum = 0.0;
    for (std::size_t i = 1; i < this->Times.size(); ++i)
    {
      sum += 0.5 * (this->Times[i] - this->Times[i - 1]) * (this->Powers[i] + this->Powers[i - 1]);
    }
    return sum;
  }

  Status Finish(const std::string& name, PulseShape& shape) const
  {
    const std::string what = "; it has " + std::to_string(this->Times.size());
    if (this->Times.size() < 3 ||
      !(*std::max_element(this->Powers.begin(), this->Powers.end()) > 0.0))
    {
      return Status::Error(
        name + ": a pulse needs at least three samples, and one above zero" + what);
    }
    const double sum = this->Integrate();
    if (!(sum > 0.0))
    {
      return Status::Error(name + ": the energy of the pulse is not positive: the integral is " +
        std::to_string(sum) + "; subtract the zero level of the digitizer, not more");
    }
    shape = PulseShape::MakeSampled(this->Times, this->Powers);
    return {};
  }
};

/// Returns a line with blanks in place of its first separator.
std::string Unseparate(std::string_view line)
{
  std::string text(line);
  const std::size_t at = text.find_first_of(",;");
  if (at < text.find('#'))
  {
    text[at] = ' ';
  }
  return text;
}

Status ReadLine(std::string_view line, const std::string& place, Table& table)
{
  const std::string text = Unseparate(line);
  TextWords words(text);
  if (!words.HasMore())
  {
    return {};
  }
  using Number = TextWords::Number;
  double time, power;
  if (words.Next(time) != Number::Good || words.Next(power) != Number::Good || words.HasMore())
  {
    return Status::Error(place + "expected two numbers per line, a time [ns] and a power");
  }
  return table.Add(place, time, power);
}

} // namespace

//------------------------------------------------------------------------------
Status ReadPulse(const std::string& fileName, PulseShape& shape)
{
  TextFile file;
  Status status = file.Open(fileName);
  Table table;
  std::string_view line;
  while (status.IsOk() && file.NextLine(line))
  {
    status = ReadLine(line, file.GetPlace(), table);
  }
  if (status.IsOk() && !file.GetError().empty())
  {
    status = Status::Error(file.GetError());
  }
  return status.IsOk() ? table.Finish(fileName, shape) : status;
}

//------------------------------------------------------------------------------
Status ReadPulse(vtkDataArray* samples, PulseShape& shape)
{
  if (samples->GetNumberOfComponents() != 2)
  {
    return Status::Error("PulseSamples has " + std::to_string(samples->GetNumberOfComponents()) +
      " numbers per row; give two, a time [ns] and a power");
  }
  Table table;
  Status status;
  for (vtkIdType i = 0; status.IsOk() && i < samples->GetNumberOfTuples(); ++i)
  {
    status = table.Add("PulseSamples, row " + std::to_string(i) + ": ", samples->GetComponent(i, 0),
      samples->GetComponent(i, 1));
  }
  return status.IsOk() ? table.Finish("PulseSamples", shape) : status;
}

} // namespace helios
