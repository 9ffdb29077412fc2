// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCloudColors.h"

#include <vtkLookupTable.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace helios::viewer
{

namespace
{

constexpr std::size_t MaximumLegend = 16;

// 1, 2, 3, 4, 5 and more returns
constexpr Rgb ReturnColors[] = { { 128, 128, 128 }, { 222, 184, 98 }, { 88, 172, 110 },
  { 86, 140, 210 }, { 190, 98, 180 }, { 214, 84, 76 } };

Rgb GetReturnColor(double number)
{
  return ReturnColors[static_cast<int>(std::min(std::max(number, 0.0), 5.0))];
}

void SetTableColor(vtkLookupTable* table, vtkIdType i, const Rgb& color)
{
  table->SetTableValue(i, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0, 1.0);
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
Rgb CloudColors::Map(double value) const
{
  if (this->By == ColorBy::One)
  {
    return this->One;
  }
  if (!std::isfinite(value))
  {
    return Unknown;
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
  double low = this->Low, high = this->High;
  if (this->IsLogarithmic())
  {
    value = std::log(value);
    low = std::log(low);
    high = std::log(high);
  }
  const double share = high > low ? (value - low) / (high - low) : 0.5;
  const double clamped = std::min(std::max(share, 0.0), 1.0); // of NaN: 0
  return GetRamp()[static_cast<std::size_t>(std::min(255.0, 256.0 * clamped))];
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
std::string CloudColors::GetTitle(const Cloud& cloud) const
{
  switch (this->By)
  {
    case ColorBy::Height:
      return "Height [m]";
    case ColorBy::Amplitude:
      return cloud.HasRawAmplitudes() ? "Intensity" : "Amplitude [W]";
    case ColorBy::ReturnNumber:
      return "Return";
    case ColorBy::NumberOfReturns:
      return "Returns";
    case ColorBy::Class:
      return "Class";
    case ColorBy::Time:
      return "GPS time [s]";
    case ColorBy::Part:
      return "Part";
    case ColorBy::Material:
      return "Material";
    case ColorBy::Leg:
      return "Leg";
    case ColorBy::Incidence:
      return "Incidence [deg]";
    case ColorBy::Range:
      return "Range [m]";
    case ColorBy::One:
      break;
  }
  return "";
}

//------------------------------------------------------------------------------
std::string CloudColors::GetLabel(int category) const
{
  if (this->By == ColorBy::Class)
  {
    return GetClassName(category);
  }
  const bool isCount = this->By == ColorBy::ReturnNumber || this->By == ColorBy::NumberOfReturns;
  return isCount && category >= 5 ? "5 and more" : std::to_string(category);
}

//------------------------------------------------------------------------------
void CloudColors::FillTable(vtkLookupTable* table, const std::vector<double>& values) const
{
  table->ResetAnnotations();
  table->SetIndexedLookup(this->IsCategory());
  table->SetScale(VTK_SCALE_LINEAR);
  if (!this->IsCategory())
  {
    table->SetNumberOfTableValues(256);
    table->SetRange(this->Low, this->High > this->Low ? this->High : this->Low * 1.001 + 1e-9);
    table->SetScale(this->IsLogarithmic() && this->Low > 0.0 ? VTK_SCALE_LOG10 : VTK_SCALE_LINEAR);
    for (vtkIdType i = 0; i < 256; ++i)
    {
      SetTableColor(table, i, GetRamp()[static_cast<std::size_t>(i)]);
    }
    return;
  }
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
  table->SetNumberOfTableValues(
    static_cast<vtkIdType>(std::max<std::size_t>(1, categories.size())));
  vtkIdType row = 0;
  for (const int category : categories)
  {
    table->SetAnnotation(vtkVariant(category), this->GetLabel(category));
    SetTableColor(table, row++, this->Map(category));
  }
}

} // namespace helios::viewer
