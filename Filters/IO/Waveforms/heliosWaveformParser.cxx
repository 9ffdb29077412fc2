// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosWaveformParser.h"

#include "heliosConstants.h"
#include "vtkHeliosArrayNames.h"

#include <vtkFieldData.h>
#include <vtkTable.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double TimeRounding = 1.0001e-4; // [ns], of the difference of two file times
constexpr double DirectionRounding = 1e-3; // share of the length: a direction has 4 decimals
constexpr int FirstSample = 10;            // column
const char* const ColumnNames[FirstSample] = { "the pulse index", "origin x", "origin y",
  "origin z", "direction x", "direction y", "direction z", "the time of the first sample",
  "the time of the last sample", "the GPS time" };

std::string NameColumn(int column)
{
  return "column " + std::to_string(column) + " from 0 (" +
    (column < FirstSample ? ColumnNames[column] : "a sample") + ")";
}

/// Returns the value with the fewest decimals within the rounding error.
double Shorten(double value, double rounding)
{
  for (double scale = 1.0; scale < 1e9; scale *= 10.0)
  {
    const double shorter = std::round(value * scale) / scale;
    if (std::abs(shorter - value) <= rounding)
    {
      return shorter;
    }
  }
  return value;
}

template <typename ArrayT>
void AddColumn(vtkTable* table, const char* name, GrowingArray<ArrayT>& values, int components = 1)
{
  ArrayT* array = values.Finish(components);
  array->SetName(name);
  table->AddColumn(array);
}

} // namespace

//------------------------------------------------------------------------------
bool WaveformParser::Read(LineFile& file, std::int64_t begin, std::int64_t end)
{
  this->File = &file;
  file.SetRange(begin, end);
  std::string_view line;
  while (file.NextLine(line))
  {
    if (!this->ReadLine(line))
    {
      return false;
    }
  }
  return file.GetError().empty() ? !file.IsStopped() : this->Report.Fail(file.GetError());
}

//------------------------------------------------------------------------------
bool WaveformParser::ReadLine(std::string_view line)
{
  TextWords words(line);
  if (!words.HasMore())
  {
    return true;
  }
  std::int64_t pulse = 0;
  Head head;
  if (this->File->GetLineStart() + static_cast<std::int64_t>(line.size()) >= this->File->GetSize())
  {
    return this->Fail("the line has no end: the file was cut off here; remove the line, or end it "
                      "if it is complete");
  }
  const vtkIdType first = this->Samples.GetSize();
  vtkIdType count = 0;
  double binSize = 0.0;
  if (!this->ReadPulseId(words, pulse) || !this->ReadHead(words, head) ||
    !this->CheckDirection(head) || !this->ReadSamples(words, count) ||
    !this->FindBinSize(head, count, binSize))
  {
    return false;
  }
  *this->PulseIds.Append(1) = pulse;
  std::copy_n(head.Origin, 3, this->Origin.Append(3));
  std::copy_n(head.Direction, 3, this->Direction.Append(3));
  *this->GpsTime.Append(1) = head.GpsTime;
  *this->StartTime.Append(1) = this->Format.TimesPerUnit * head.Start;
  *this->BinSize.Append(1) = binSize;
  *this->Offset.Append(1) = first;
  *this->Count.Append(1) = count;
  return true;
}

//------------------------------------------------------------------------------
bool WaveformParser::ReadPulseId(TextWords& words, std::int64_t& pulse)
{
  const std::string_view word = words.Next();
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), pulse);
  return (error == std::errc() && end == word.data() + word.size()) ||
    this->Fail(Quote(word) + " in " + NameColumn(0) +
      " is not a whole number; give a file with lines of: pulse index, origin x y z, direction x y "
      "z, first and last time, GPS time, samples");
}

//------------------------------------------------------------------------------
bool WaveformParser::ReadNumber(TextWords& words, int column, double& value)
{
  const TextWords::Number kind = words.Next(value);
  if (kind == TextWords::Number::None)
  {
    return this->Fail("the line ends before " + NameColumn(column) +
      "; complete it, or remove it if the run was interrupted");
  }
  if (kind != TextWords::Number::Good)
  {
    return this->Fail(Quote(words.Next()) + " in " + NameColumn(column) +
      " is not a number of double precision; write numbers such as -1.5 or 2e3");
  }
  return std::isfinite(value) ||
    this->Fail(
      "the number in " + NameColumn(column) + " is not finite; correct the line or remove it");
}

//------------------------------------------------------------------------------
bool WaveformParser::ReadHead(TextWords& words, Head& head)
{
  double* const columns[FirstSample] = { nullptr, head.Origin, head.Origin + 1, head.Origin + 2,
    head.Direction, head.Direction + 1, head.Direction + 2, &head.Start, &head.End, &head.GpsTime };
  for (int column = 1; column < FirstSample; ++column)
  {
    if (!this->ReadNumber(words, column, *columns[column]))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool WaveformParser::CheckDirection(Head& head)
{
  double* d = head.Direction;
  const double length = std::hypot(d[0], d[1], d[2]);
  if (!(std::abs(length - 1.0) <= DirectionRounding))
  {
    return this->Fail("the direction in columns 4 5 6 from 0 has the length " +
      std::to_string(length) + "; give a vector of length 1");
  }
  std::transform(d, d + 3, d, [length](double x) { return x / length; });
  return true;
}

//------------------------------------------------------------------------------
bool WaveformParser::ReadSamples(TextWords& words, vtkIdType& count)
{
  double value = 0.0;
  do
  {
    const int column = FirstSample + static_cast<int>(std::min<vtkIdType>(count, 1 << 30));
    if (!this->ReadNumber(words, column, value))
    {
      return false;
    }
    const double power = value / NanowattsPerWatt;
    if (std::abs(power) > std::numeric_limits<float>::max())
    {
      return this->Fail("the sample in " + NameColumn(column) +
        " is beyond single precision; samples are in nanowatts");
    }
    *this->Samples.Append(1) = static_cast<float>(power);
    ++count;
  } while (words.HasMore());
  return true;
}

//------------------------------------------------------------------------------
// Times have 4 decimals: the bin size with the fewest decimals consistent with them is used.
bool WaveformParser::FindBinSize(const Head& head, vtkIdType count, double& binSize)
{
  const double length = head.End - head.Start;
  const double bins = static_cast<double>(count - 1);
  if (length < 0.0 || (length == 0.0) != (count == 1))
  {
    return this->Fail("the " + std::to_string(count) + " samples last from " +
      std::to_string(head.Start) + " to " + std::to_string(head.End) +
      " ns (columns 7 8 from 0); correct the times");
  }
  binSize = this->Format.BinSize;
  if (count == 1)
  {
    return binSize > 0.0 || this->Fail("the waveform has one sample and no bin size; set BinSize");
  }
  const double given = length / bins;
  if (binSize == 0.0)
  {
    binSize = this->Format.TimesPerUnit * Shorten(given, TimeRounding / bins);
  }
  else if (std::abs(binSize - this->Format.TimesPerUnit * given) >
    this->Format.TimesPerUnit * TimeRounding / bins)
  {
    return this->Fail("the bins of " + std::to_string(this->Format.TimesPerUnit * given) +
      " ns (two-way) do not match BinSize, " + std::to_string(binSize) +
      " ns; set BinSize to 0, or OneWayTimes to match the file");
  }
  return true;
}

//------------------------------------------------------------------------------
bool WaveformParser::Fail(const std::string& message)
{
  return this->Report.Fail(this->File->GetPlace() + message);
}

//------------------------------------------------------------------------------
void WaveformParser::MoveTo(vtkTable* table)
{
  AddColumn(table, names::PulseIds, this->PulseIds);
  AddColumn(table, names::Origin, this->Origin, 3);
  AddColumn(table, names::Direction, this->Direction, 3);
  AddColumn(table, names::GpsTime, this->GpsTime);
  AddColumn(table, names::StartTime, this->StartTime);
  AddColumn(table, names::BinSize, this->BinSize);
  AddColumn(table, names::Offset, this->Offset);
  AddColumn(table, names::Count, this->Count);
  vtkFloatArray* samples = this->Samples.Finish(1);
  samples->SetName(names::Samples);
  table->GetFieldData()->AddArray(samples);
}

} // namespace helios
