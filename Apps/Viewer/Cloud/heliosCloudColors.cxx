// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCloudColors.h"

#include "heliosCloudCodes.h"
#include "heliosTicks.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace helios::viewer
{

namespace
{

constexpr std::size_t MaximumLegend = 16;
constexpr int MaximumTicks = 6;

// 1, 2, 3, 4, 5 and more returns
constexpr Rgb ReturnColors[] = { { 128, 128, 128 }, { 222, 184, 98 }, { 88, 172, 110 },
  { 86, 140, 210 }, { 190, 98, 180 }, { 214, 84, 76 } };

Rgb GetReturnColor(double number)
{
  return ReturnColors[static_cast<int>(std::min(std::max(number, 0.0), 5.0))];
}

} // namespace

//------------------------------------------------------------------------------
bool CloudColors::IsCategory() const
{
  switch (this->By)
  {
    case ColorBy::ReturnNumber:
    case ColorBy::NumberOfReturns:
    case ColorBy::Class:
    case ColorBy::Part:
    case ColorBy::Material:
    case ColorBy::Leg:
      return true;
    default:
      return false;
  }
}

//------------------------------------------------------------------------------
/// Returns the position of a value on the ramp; outside [0, 1] beyond its ends.
double CloudColors::GetShare(double value) const
{
  double low = this->Low, high = this->High;
  if (this->IsLogarithmic())
  {
    value = std::log(value);
    low = std::log(low);
    high = std::log(high);
  }
  return high > low ? (value - low) / (high - low) : 0.5;
}

//------------------------------------------------------------------------------
Rgb CloudColors::Map(double value) const
{
  if (this->By == ColorBy::One)
  {
    return this->One;
  }
  if (!std::isfinite(value) || (this->By == ColorBy::Own && value == NoColor))
  {
    return Unknown;
  }
  if (this->By == ColorBy::Own)
  {
    const auto packed = static_cast<std::uint32_t>(value);
    return { static_cast<std::uint8_t>(packed >> 16), static_cast<std::uint8_t>(packed >> 8),
      static_cast<std::uint8_t>(packed) };
  }
  if (this->By == ColorBy::Class)
  {
    return GetClassColor(static_cast<int>(value));
  }
  if (this->By == ColorBy::ReturnNumber || this->By == ColorBy::NumberOfReturns)
  {
    return GetReturnColor(value);
  }
  if (this->IsCategory())
  {
    return value < 0.0 ? Unknown : GetDistinctColor(static_cast<std::int64_t>(value));
  }
  const double clamped = std::min(std::max(this->GetShare(value), 0.0), 1.0); // NaN becomes 0
  return this->Colors[static_cast<std::size_t>(std::min(255.0, 256.0 * clamped))];
}

//------------------------------------------------------------------------------
void CloudColors::Map(const Cloud& cloud, const CloudChunk& chunk, vtkIdType begin, vtkIdType end,
  std::uint8_t* rgba) const
{
  constexpr vtkIdType step = 1024;
  double values[step] = {};
  while (begin < end)
  {
    const vtkIdType stop = std::min(end, begin + step);
    if (this->By != ColorBy::One)
    {
      cloud.GetValues(chunk, static_cast<CloudColumn>(this->By), begin, stop, values);
    }
    for (vtkIdType i = 0; i < stop - begin; ++i, rgba += 4)
    {
      const Rgb color = this->Map(values[i]);
      std::copy(color.begin(), color.end(), rgba);
      rgba[3] = 255;
    }
    begin = stop;
  }
}

//------------------------------------------------------------------------------
bool CloudColors::FitRange(std::vector<double> values)
{
  if (this->IsPlain())
  {
    return false;
  }
  values.erase(
    std::remove_if(values.begin(), values.end(),
      [this](double v) { return !std::isfinite(v) || (this->IsLogarithmic() && v <= 0.0); }),
    values.end());
  if (values.empty())
  {
    return false;
  }
  const auto pick = [&values](double share)
  {
    const std::ptrdiff_t at = std::lround(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
  };
  this->Low = pick(0.02);
  this->High = pick(0.98);
  return true;
}

//------------------------------------------------------------------------------
std::string CloudColors::GetName(const Cloud& cloud) const
{
  switch (this->By)
  {
    case ColorBy::Height:
      return "Height";
    case ColorBy::Amplitude:
      return cloud.HasRawAmplitudes() ? "Intensity" : "Amplitude";
    case ColorBy::ReturnNumber:
      return "Return";
    case ColorBy::NumberOfReturns:
      return "Returns";
    case ColorBy::Class:
      return "Class";
    case ColorBy::Time:
      return "GPS time";
    case ColorBy::Part:
      return "Part";
    case ColorBy::Material:
      return "Material";
    case ColorBy::Leg:
      return "Leg";
    case ColorBy::Incidence:
      return "Incidence";
    case ColorBy::Range:
      return "Range";
    case ColorBy::Own:
    case ColorBy::One:
      break;
  }
  return "";
}

//------------------------------------------------------------------------------
std::string CloudColors::GetUnit(const Cloud& cloud) const
{
  switch (this->By)
  {
    case ColorBy::Height:
    case ColorBy::Range:
      return "m";
    case ColorBy::Time:
      return "s";
    case ColorBy::Incidence:
      return "\xC2\xB0"; // degrees
    case ColorBy::Amplitude:
      return cloud.HasRawAmplitudes() ? "" : "W";
    default:
      return "";
  }
}

//------------------------------------------------------------------------------
std::string CloudColors::GetLabel(const Cloud& cloud, int category) const
{
  if (this->By == ColorBy::Class)
  {
    return GetClassName(category);
  }
  const std::string name = this->By == ColorBy::Part ? cloud.GetPartName(category)
    : this->By == ColorBy::Material                  ? cloud.GetMaterialName(category)
                                                     : "";
  const bool isCount = this->By == ColorBy::ReturnNumber || this->By == ColorBy::NumberOfReturns;
  return !name.empty() ? name : isCount && category >= 5 ? "5 and more" : std::to_string(category);
}

//------------------------------------------------------------------------------
Legend CloudColors::MakeLegend(const Cloud& cloud, const std::vector<double>& values) const
{
  Legend legend;
  legend.Title = this->GetName(cloud);
  legend.IsCategory = this->IsCategory();
  if (!this->IsPlain())
  {
    legend.IsCategory ? this->AddCategories(cloud, values, legend) : this->AddTicks(cloud, legend);
  }
  return legend;
}

//------------------------------------------------------------------------------
void CloudColors::AddTicks(const Cloud& cloud, Legend& legend) const
{
  const std::string unit = this->GetUnit(cloud);
  const Ticks ticks = this->IsLogarithmic()
    ? MakeLogTicks(this->Low, this->High, MaximumTicks, unit)
    : MakeTicks(this->Low, this->High, MaximumTicks, unit);
  legend.Title += ticks.Unit.empty() ? "" : " [" + ticks.Unit + "]";
  legend.Colors.assign(this->Colors.begin(), this->Colors.end());
  for (const Tick& tick : ticks.List)
  {
    legend.Marks.push_back({ this->GetShare(tick.Value), tick.Text });
  }
  if (ticks.List.empty())
  {
    legend.Marks.push_back({ 0.5, DescribeValue(this->Low, this->IsLogarithmic() ? unit : "") });
  }
}

//------------------------------------------------------------------------------
void CloudColors::AddCategories(
  const Cloud& cloud, const std::vector<double>& values, Legend& legend) const
{
  const bool isCount = this->By == ColorBy::ReturnNumber || this->By == ColorBy::NumberOfReturns;
  std::set<int> categories;
  for (const double value : values)
  {
    categories.insert(static_cast<int>(isCount ? std::min(value, 5.0) : value));
  }
  while (categories.size() > MaximumLegend)
  {
    categories.erase(std::prev(categories.end()));
  }
  for (const int category : categories)
  {
    legend.Marks.push_back(
      { static_cast<double>(legend.Colors.size()), this->GetLabel(cloud, category) });
    legend.Colors.push_back(this->Map(category));
  }
}

} // namespace helios::viewer
