// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLasBlock.h"

#include "heliosLasNames.h"
#include "heliosLasWaves.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace helios
{

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double LargestNumber = 2147483647.0;
constexpr double AngleUnit = 0.006;         // [deg]
constexpr double SmallestAmplitude = 1e-15; // [W], intensity 0
constexpr double IntensityPerDecade = 1000.0;
constexpr int LargestReturn = 15;
constexpr std::size_t LongestName = 32;

/// Returns whether an array is fully stored in the standard LAS fields; intensities are if they
/// have 16 bits.
bool IsField(const std::string& name, int type)
{
  if (name == names::Intensity)
  {
    return type == VTK_UNSIGNED_SHORT || type == VTK_UNSIGNED_CHAR;
  }
  const char* const fields[] = { names::ReturnNumber, names::NumberOfReturns,
    names::ClassificationFlags, names::ScanDirectionFlag, names::EdgeOfFlightLine,
    names::ClassificationIds, names::UserData, names::ScanAngle, names::LegIds, names::GpsTime,
    names::RGB, names::NearInfrared };
  return std::any_of(
    std::begin(fields), std::end(fields), [&name](const char* field) { return name == field; });
}

/// Returns the Extra Bytes type; 0: not storable.
int GetExtraType(vtkDataArray* array)
{
  switch (array->GetDataType())
  {
    case VTK_FLOAT:
      return 9;
    case VTK_DOUBLE:
      return 10;
    case VTK_BIT:
      return 0;
    default:
      break;
  }
  const int sign = array->GetDataTypeMin() < 0 ? 1 : 0;
  switch (array->GetDataTypeSize())
  {
    case 1:
      return 1 + sign;
    case 2:
      return 3 + sign;
    case 4:
      return 5 + sign;
    default:
      return 7 + sign;
  }
}

template <std::size_t Size>
void CopyColumn(const char* values, int stride, vtkIdType count, char* place, int length)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    std::memcpy(place + i * length, values + i * stride, Size);
  }
}

void CopyColumn(const char* values, int stride, int size, vtkIdType count, char* place, int length)
{
  switch (size)
  {
    case 1:
      return CopyColumn<1>(values, stride, count, place, length);
    case 2:
      return CopyColumn<2>(values, stride, count, place, length);
    case 4:
      return CopyColumn<4>(values, stride, count, place, length);
    default:
      return CopyColumn<8>(values, stride, count, place, length);
  }
}

/// Value of a field, or a default if the array is missing.
vtkTypeInt64 GetInteger(const Column& column, vtkIdType row, vtkTypeInt64 otherwise)
{
  return column.IsSet() ? column.GetInteger(row) : otherwise;
}

int GetReturn(const Column& column, vtkIdType row)
{
  return static_cast<int>(std::clamp<vtkTypeInt64>(GetInteger(column, row, 1), 0, LargestReturn));
}

std::int16_t GetAngle(double degrees)
{
  const double angle = std::isfinite(degrees) ? std::remainder(degrees, 360.0) : 0.0;
  return static_cast<std::int16_t>(std::lrint(angle / AngleUnit)); // 180 degrees: 30000
}

std::uint16_t GetColor(double value)
{
  return static_cast<std::uint16_t>(std::lrint(65535.0 * std::clamp(value, 0.0, 1.0)));
}

std::string Show(double value)
{
  std::ostringstream text;
  text.precision(12);
  text << value;
  return text.str();
}

} // namespace

Status LasBlock::ReadColumn(vtkPolyData* echoes, const char* name, bool isInteger, Column& column)
{
  vtkDataArray* array = echoes->GetPointData()->GetArray(name);
  if (!array)
  {
    return {};
  }
  const int components = &column == &this->Color ? 3 : 1;
  if (array->GetNumberOfTuples() != this->NumberOfPoints ||
    array->GetNumberOfComponents() != components)
  {
    return Status::Error(std::string("the array ") + name + " of a block has " +
      std::to_string(array->GetNumberOfTuples()) + " x " +
      std::to_string(array->GetNumberOfComponents()) + " values, not " +
      std::to_string(this->NumberOfPoints) + " x " + std::to_string(components));
  }
  column = Column(array);
  if (isInteger && !column.HasIntegers())
  {
    return Status::Error(std::string("the array ") + name + " of a block holds " +
      array->GetDataTypeAsString() + "; it must hold integers");
  }
  return {};
}

Status LasBlock::ReadFields(vtkPolyData* echoes)
{
  const struct
  {
    const char* Name;
    bool IsInteger;
    Column& Values;
  } fields[] = { { names::Amplitude, false, this->Amplitude },
    { names::Intensity, false, this->Intensity }, { names::ReturnNumber, true, this->ReturnNumber },
    { names::NumberOfReturns, true, this->NumberOfReturns },
    { names::ClassificationFlags, true, this->Flags }, { names::ChannelIds, true, this->Channel },
    { names::ScanDirectionFlag, true, this->Direction },
    { names::EdgeOfFlightLine, true, this->Edge }, { names::ClassificationIds, true, this->Class },
    { names::UserData, true, this->UserData }, { names::ScanAngle, false, this->ScanAngle },
    { names::LegIds, true, this->Leg }, { names::GpsTime, false, this->Time },
    { names::RGB, false, this->Color }, { names::NearInfrared, true, this->Infrared },
    { names::WaveformIds, true, this->WaveformIds } };
  for (const auto& field : fields)
  {
    Status status = this->ReadColumn(echoes, field.Name, field.IsInteger, field.Values);
    if (!status.IsOk())
    {
      return status;
    }
  }
  return {};
}

Status LasBlock::AddExtra(vtkDataArray* array, bool hasDecibels)
{
  const auto [name, description] = GetLasName(array->GetName(), hasDecibels);
  const int components = array->GetNumberOfComponents();
  const int type = GetExtraType(array);
  if (array->GetNumberOfTuples() != this->NumberOfPoints || type == 0 ||
    (components != 1 && components != 3) || name.size() + (components == 3 ? 1 : 0) > LongestName)
  {
    return Status::Error(std::string("the array ") + array->GetName() +
      " of a block cannot be Extra Bytes, which have 1 or 3 numbers per point and a name of at "
      "most 32 characters; change it, or switch WriteExtraBytes off");
  }
  if (!array->HasStandardMemoryLayout())
  {
    const auto copy =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array->GetDataType()));
    copy->DeepCopy(array);
    this->Copies.push_back(copy);
    array = copy;
  }
  const int size = array->GetDataTypeSize();
  const auto* values = static_cast<const char*>(array->GetVoidPointer(0));
  for (int k = 0; k < components; ++k)
  {
    LasExtra extra;
    extra.Name = components == 3 ? name + "XYZ"[k] : name;
    extra.Description = description;
    extra.Type = type;
    extra.Size = size;
    this->Extras.push_back(extra);
    this->ExtraValues.push_back({ values + k * size, components * size, size, this->Length });
    this->Length += size;
  }
  return {};
}

Status LasBlock::ReadExtras(vtkPolyData* echoes)
{
  vtkPointData* data = echoes->GetPointData();
  const bool hasDecibels = data->HasArray(names::RelativeAmplitude) != 0;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const char* name = data->GetArrayName(i);
    if (!array || !name || !*name)
    {
      return Status::Error(std::string("the array ") + (name ? name : "without a name") +
        " of a block is not numeric or has no name");
    }
    Status status =
      IsField(name, array->GetDataType()) ? Status() : this->AddExtra(array, hasDecibels);
    if (!status.IsOk())
    {
      return status;
    }
  }
  const int limit = std::numeric_limits<std::uint16_t>::max();
  return static_cast<int>(this->Extras.size()) * 192 > limit || this->Length > limit
    ? Status::Error("a block has more arrays than Extra Bytes can hold, 341 numbers; switch "
                    "WriteExtraBytes off")
    : Status();
}

Status LasBlock::Set(vtkPolyData* echoes, bool hasExtras)
{
  this->NumberOfPoints = echoes->GetNumberOfPoints();
  this->Points = Column(echoes->GetPoints()->GetData());
  Status status = this->ReadFields(echoes);
  if (this->Color.HasIntegers() && this->Color.IsSet())
  {
    this->FullColor = echoes->GetPointData()->GetArray(names::RGB)->GetDataTypeMax();
  }
  const LasPointForm form = GetLasPointForm(this->GetFormat());
  this->Length = form.Length;
  this->WavePlace = form.Wave;
  this->InfraredPlace = form.Infrared;
  this->HasColors = form.Color >= 0;
  return status.IsOk() && hasExtras ? this->ReadExtras(echoes) : status;
}

std::uint16_t LasBlock::GetIntensity(const LasScaling& scaling, vtkIdType row) const
{
  double value = 0.0;
  if (this->Intensity.IsSet())
  {
    value = this->Intensity.GetNumber(row);
  }
  else if (this->Amplitude.IsSet())
  {
    const double amplitude = this->Amplitude.GetNumber(row);
    value = scaling.FullIntensity > 0.0
      ? 65535.0 * amplitude / scaling.FullIntensity
      : (amplitude > 0.0 ? IntensityPerDecade * std::log10(amplitude / SmallestAmplitude) : 0.0);
  }
  return static_cast<std::uint16_t>(
    std::isnan(value) ? 0 : std::lrint(std::clamp(value, 0.0, 65535.0)));
}

void LasBlock::EncodeColor(vtkIdType row, char* record) const
{
  for (int k = 0; k < 3; ++k)
  {
    const double color =
      this->Color.IsSet() ? this->Color.GetNumber(row, k) / this->FullColor : 0.0;
    StoreLas(record + 30 + 2 * k, GetColor(color));
  }
  if (this->InfraredPlace >= 0)
  {
    const vtkTypeInt64 value = GetInteger(this->Infrared, row, 0);
    StoreLas(record + this->InfraredPlace,
      static_cast<std::uint16_t>(std::clamp<vtkTypeInt64>(value, 0, 65535)));
  }
}

bool LasBlock::EncodeFields(const LasScaling& scaling, vtkIdType row, char* record)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double number = std::nearbyint(
      (this->Points.GetNumber(row, axis) - scaling.Offset[axis]) / scaling.Scale[axis]);
    if (!(std::abs(number) <= LargestNumber))
    {
      return false;
    }
    StoreLas(record + 4 * axis, static_cast<std::int32_t>(number));
  }
  const double time = this->Time.IsSet() ? this->Time.GetNumber(row) + scaling.TimeShift : 0.0;
  const vtkTypeInt64 source = GetInteger(this->Leg, row, -1) + 1;
  if (!std::isfinite(time) || source < 0 || source > 65535)
  {
    return false;
  }
  const vtkTypeInt64 label = GetInteger(this->Class, row, 1);
  const bool isLate = GetInteger(this->ReturnNumber, row, 1) > LargestReturn ||
    GetInteger(this->NumberOfReturns, row, 1) > LargestReturn;
  const bool isOdd = label < 0 || label > 255;
  if (isLate)
  {
    ++this->LateReturns;
  }
  if (isOdd)
  {
    ++this->OddClasses;
  }
  StoreLas(record + 12, this->GetIntensity(scaling, row));
  record[14] = static_cast<char>(
    GetReturn(this->ReturnNumber, row) | GetReturn(this->NumberOfReturns, row) << 4);
  record[15] = static_cast<char>((GetInteger(this->Flags, row, 0) & 15) |
    (GetInteger(this->Channel, row, 0) & 3) << 4 | (GetInteger(this->Direction, row, 0) & 1) << 6 |
    (GetInteger(this->Edge, row, 0) & 1) << 7);
  record[16] = static_cast<char>(isOdd ? 1 : label);
  record[17] = static_cast<char>(GetInteger(this->UserData, row, 0));
  StoreLas(record + 18, GetAngle(this->ScanAngle.IsSet() ? this->ScanAngle.GetNumber(row) : 0.0));
  StoreLas(record + 20, static_cast<std::uint16_t>(source));
  StoreLas(record + 22, time);
  return true;
}

bool LasBlock::Encode(const LasScaling& scaling, vtkIdType begin, vtkIdType end, char* records)
{
  for (vtkIdType row = begin; row < end; ++row)
  {
    char* record = records + (row - begin) * this->Length;
    if (!this->EncodeFields(scaling, row, record))
    {
      return false;
    }
    if (this->HasColors)
    {
      this->EncodeColor(row, record);
    }
    if (this->Waves)
    {
      const double point[3] = { this->Points.GetNumber(row, 0), this->Points.GetNumber(row, 1),
        this->Points.GetNumber(row, 2) };
      this->Waves->EncodePoint(row, point, record + this->WavePlace);
    }
  }
  for (const Extra& extra : this->ExtraValues)
  {
    CopyColumn(extra.Values + begin * extra.Size, extra.Size, extra.Number, end - begin,
      records + extra.Place, this->Length);
  }
  return true;
}

std::string LasBlock::ExplainRow(const LasScaling& scaling, vtkIdType row) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double value = this->Points.GetNumber(row, axis);
    const double offset = scaling.Offset[axis];
    const double scale = scaling.Scale[axis];
    const std::string name(1, "xyz"[axis]);
    if (!std::isfinite(value))
    {
      return "has the coordinate " + name + " = " + Show(value) +
        ", which is not a number; remove such points";
    }
    if (std::abs(std::nearbyint((value - offset) / scale)) > LargestNumber)
    {
      return "has the coordinate " + name + " = " + Show(value) + ", more than " +
        Show(LargestNumber * scale) + " from " + Show(offset) +
        ", the limit of 32 bits with Scale " + Show(scale) + "; set a larger Scale";
    }
  }
  const double time = this->Time.IsSet() ? this->Time.GetNumber(row) + scaling.TimeShift : 0.0;
  if (!std::isfinite(time))
  {
    return std::string("has ") + names::GpsTime + " = " + Show(time) +
      ", which is not a number; remove such points";
  }
  const vtkTypeInt64 leg = GetInteger(this->Leg, row, -1);
  return leg < -1 || leg > 65534 ? std::string("has ") + names::LegIds + " = " +
      std::to_string(leg) + ", outside the range -1 to 65534 of a point source id; split the cloud"
                                 : std::string();
}

Status LasBlock::CheckRange(const LasScaling& scaling, vtkIdType begin, vtkIdType end) const
{
  for (vtkIdType row = begin; row < end; ++row)
  {
    const std::string problem = this->ExplainRow(scaling, row);
    if (!problem.empty())
    {
      return Status::Error("point " + std::to_string(row) + " of a block " + problem);
    }
  }
  return {};
}

} // namespace helios
