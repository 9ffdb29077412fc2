// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLasArrays.h"

#include "heliosLasNames.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>

#include <limits>
#include <new>
#include <sstream>

namespace helios
{

namespace names = vtkHeliosArrayNames;

namespace
{

/// VTK types of the Extra Bytes types.
constexpr int ArrayTypes[] = { VTK_VOID, VTK_TYPE_UINT8, VTK_TYPE_INT8, VTK_TYPE_UINT16,
  VTK_TYPE_INT16, VTK_TYPE_UINT32, VTK_TYPE_INT32, VTK_TYPE_UINT64, VTK_TYPE_INT64,
  VTK_TYPE_FLOAT32, VTK_TYPE_FLOAT64 };

///@{
/// Types of Extra Bytes.
constexpr int FirstLongType = 7;
constexpr int FloatType = 9;
constexpr int DoubleType = 10;
///@}

bool IsFloat(int type)
{
  return type == FloatType || type == DoubleType;
}

/// Returns whether double does not hold all numbers of a type.
bool IsLong(int type)
{
  return type >= FirstLongType && type < FloatType;
}

/// Replaces the values that stand for none by NaN, in an array that is filled before.
template <typename T>
auto MakeNoDataFill(T* values, const LasExtra& extra)
{
  return [values, extra](const char*, vtkIdType first, vtkIdType count)
  {
    for (vtkIdType i = first * extra.Components; i < (first + count) * extra.Components; ++i)
    {
      if (values[i] == static_cast<T>(extra.NoData[i % extra.Components]))
      {
        values[i] = std::numeric_limits<T>::quiet_NaN();
      }
    }
  };
}

/// Reads one number of Extra Bytes.
double GetExtra(const char* bytes, int type)
{
  switch (type)
  {
    case 1:
      return LoadLas<std::uint8_t>(bytes);
    case 2:
      return LoadLas<std::int8_t>(bytes);
    case 3:
      return LoadLas<std::uint16_t>(bytes);
    case 4:
      return LoadLas<std::int16_t>(bytes);
    case 5:
      return LoadLas<std::uint32_t>(bytes);
    case 6:
      return LoadLas<std::int32_t>(bytes);
    case 7:
      return static_cast<double>(LoadLas<std::uint64_t>(bytes));
    case 8:
      return static_cast<double>(LoadLas<std::int64_t>(bytes));
    case 9:
      return static_cast<double>(LoadLas<float>(bytes));
    default:
      return LoadLas<double>(bytes);
  }
}

/// Returns whether three fields are x, y and z of one array.
bool IsVector(const std::vector<LasExtra>& extras, std::size_t at)
{
  if (at + 3 > extras.size() || extras[at].Name.size() < 2)
  {
    return false;
  }
  const std::string stem = extras[at].Name.substr(0, extras[at].Name.size() - 1);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const LasExtra& extra = extras[at + k];
    if (extra.Name != stem + "XYZ"[k] || extra.Type == 0 || extra.Type != extras[at].Type ||
      extra.Components != 1 || extra.IsScaled || extra.HasNoData)
    {
      return false;
    }
  }
  return true;
}

vtkSmartPointer<vtkDataArray> MakeArray(int type, const char* name, int components, vtkIdType count)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(type == VTK_TYPE_INT64
      ? vtkTypeInt64Array::New() // like other ids
      : vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfComponents(components);
  if (!array->Allocate(count * components) && count > 0)
  {
    throw std::bad_alloc();
  }
  array->SetNumberOfTuples(count);
  return array;
}

} // namespace

template <typename ArrayT>
typename ArrayT::ValueType* LasArrays::Add(const char* name, int components)
{
  const auto array = vtkSmartPointer<ArrayT>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  if (!array->Allocate(this->Count * components) && this->Count > 0)
  {
    throw std::bad_alloc();
  }
  array->SetNumberOfTuples(this->Count);
  this->Arrays.push_back(array);
  return array->GetPointer(0);
}

template <typename ArrayT, typename GetT>
void LasArrays::AddField(const char* name, GetT get)
{
  auto* values = this->Add<ArrayT>(name);
  this->Fills.push_back(
    [values, get, length = this->Header.PointLength](
      const char* records, vtkIdType first, vtkIdType count)
    {
      for (vtkIdType i = 0; i < count; ++i)
      {
        values[first + i] = static_cast<typename ArrayT::ValueType>(get(records + i * length));
      }
    });
}

LasArrays::LasArrays(const LasHeader& header, const std::vector<LasExtra>& extras,
  const LasColorBits& colors, vtkIdType count)
  : Header(header)
  , Form(GetLasPointForm(header.Format))
  , Colors(colors)
  , Count(count)
{
  this->AddPoints();
  this->AddFields();
  this->AddExtras(extras);
}

void LasArrays::AddPoints()
{
  double* points = this->Add<vtkDoubleArray>("Points", 3);
  this->Points = this->Arrays.back();
  this->Arrays.pop_back();
  this->Fills.push_back(
    [points, header = this->Header](const char* records, vtkIdType first, vtkIdType count)
    {
      for (vtkIdType i = 0; i < count; ++i)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          const auto number = LoadLas<std::int32_t>(records + i * header.PointLength + 4 * axis);
          points[3 * (first + i) + axis] = header.GetCoordinate(number, axis);
        }
      }
    });
}

void LasArrays::AddFields()
{
  if (this->Form.Time >= 0)
  {
    this->AddField<vtkDoubleArray>(names::GpsTime,
      [place = this->Form.Time](const char* record) { return LoadLas<double>(record + place); });
  }
  this->AddField<vtkUnsignedShortArray>(
    names::Intensity, [](const char* record) { return LoadLas<std::uint16_t>(record + 12); });
  if (this->Form.IsLong)
  {
    this->AddLongFields();
  }
  else
  {
    this->AddShortFields();
  }
  if (this->Form.Color >= 0)
  {
    this->AddColors(this->Form.Color);
  }
  if (this->Form.Infrared >= 0)
  {
    this->AddField<vtkUnsignedShortArray>(names::NearInfrared,
      [place = this->Form.Infrared, scale = this->Colors.GetInfraredScale()](const char* record)
      { return scale * LoadLas<std::uint16_t>(record + place); });
  }
}

/// Formats 6 to 10.
void LasArrays::AddLongFields()
{
  using Bytes = vtkUnsignedCharArray;
  this->AddField<Bytes>(names::ReturnNumber, [](const char* r) { return r[14] & 15; });
  this->AddField<Bytes>(names::NumberOfReturns, [](const char* r) { return r[14] >> 4 & 15; });
  this->AddField<Bytes>(names::ClassificationFlags, [](const char* r) { return r[15] & 15; });
  this->AddField<vtkIntArray>(names::ChannelIds, [](const char* r) { return r[15] >> 4 & 3; });
  this->AddField<Bytes>(names::ScanDirectionFlag, [](const char* r) { return r[15] >> 6 & 1; });
  this->AddField<Bytes>(names::EdgeOfFlightLine, [](const char* r) { return r[15] >> 7 & 1; });
  this->AddField<vtkIntArray>(
    names::ClassificationIds, [](const char* r) { return LoadLas<std::uint8_t>(r + 16); });
  this->AddField<Bytes>(names::UserData, [](const char* r) { return r[17]; });
  this->AddField<vtkDoubleArray>(
    names::ScanAngle, [](const char* r) { return LoadLas<std::int16_t>(r + 18) * 3.0 / 500.0; });
  this->AddField<vtkIntArray>(
    names::LegIds, [](const char* r) { return LoadLas<std::uint16_t>(r + 20) - 1; });
}

/// Formats 0 to 5.
void LasArrays::AddShortFields()
{
  using Bytes = vtkUnsignedCharArray;
  this->AddField<Bytes>(names::ReturnNumber, [](const char* r) { return r[14] & 7; });
  this->AddField<Bytes>(names::NumberOfReturns, [](const char* r) { return r[14] >> 3 & 7; });
  this->AddField<Bytes>(names::ScanDirectionFlag, [](const char* r) { return r[14] >> 6 & 1; });
  this->AddField<Bytes>(names::EdgeOfFlightLine, [](const char* r) { return r[14] >> 7 & 1; });
  this->AddField<vtkIntArray>(names::ClassificationIds, [](const char* r) { return r[15] & 31; });
  this->AddField<Bytes>(names::ClassificationFlags, [](const char* r) { return r[15] >> 5 & 7; });
  this->AddField<vtkDoubleArray>(
    names::ScanAngle, [](const char* r) { return LoadLas<std::int8_t>(r + 16); });
  this->AddField<Bytes>(names::UserData, [](const char* r) { return r[17]; });
  this->AddField<vtkIntArray>(
    names::LegIds, [](const char* r) { return LoadLas<std::uint16_t>(r + 18) - 1; });
}

void LasArrays::AddColors(int place)
{
  float* values = this->Add<vtkFloatArray>(names::RGB, 3);
  if (this->Colors.AreColors8)
  {
    this->Notes.emplace_back(
      "its colours have 8 bits: they are scaled by 257 to the 16 bits of LAS");
  }
  this->Fills.push_back(
    [values, place, length = this->Header.PointLength,
      full = 65535.0F / static_cast<float>(this->Colors.GetColorScale())](
      const char* records, vtkIdType first, vtkIdType count)
    {
      for (vtkIdType i = 0; i < 3 * count; ++i)
      {
        const char* bytes = records + i / 3 * length + place + 2 * (i % 3);
        values[3 * first + i] = static_cast<float>(LoadLas<std::uint16_t>(bytes)) / full;
      }
    });
}

/// Adds arrays for Extra Bytes; undocumented bytes are counted.
void LasArrays::AddExtras(const std::vector<LasExtra>& extras)
{
  int place = this->Form.Length;
  int unknown = this->Header.PointLength - place;
  for (std::size_t i = 0; i < extras.size();)
  {
    const std::size_t fields = IsVector(extras, i) ? 3 : 1;
    LasExtra extra = extras[i];
    if (fields == 3)
    {
      extra.Name.pop_back();
      extra.Components = 3;
      extra.Size *= 3;
    }
    if (extra.Type != 0 && !extra.Name.empty())
    {
      this->AddExtra(extra, place);
      unknown -= extra.Size;
    }
    place += extra.Size;
    i += fields;
  }
  if (unknown > 0)
  {
    this->Notes.push_back("its points have " + std::to_string(unknown) +
      " bytes that no Extra Bytes record describes by type and name; they are not read");
  }
}

void LasArrays::AddExtra(const LasExtra& extra, int place)
{
  const bool isLong = IsLong(extra.Type);
  const bool isDouble = extra.IsScaled || (extra.HasNoData && !isLong && !IsFloat(extra.Type));
  const int type = isDouble ? VTK_DOUBLE : ArrayTypes[extra.Type];
  const auto array = MakeArray(
    type, GetLasArray(extra.Name, extra.Description).c_str(), extra.Components, this->Count);
  this->Arrays.push_back(array);
  if (isDouble)
  {
    this->AddNumbers(extra, place, static_cast<double*>(array->GetVoidPointer(0)));
    return;
  }
  this->AddBytes(extra, place, array);
  if (extra.HasNoData && isLong)
  {
    std::ostringstream number;
    number.precision(19);
    number << extra.NoData[0];
    this->Notes.push_back("Extra Bytes \"" + extra.Name + "\" have " + number.str() +
      " where there is no value; it is read as a number, since these integers have 64 bits");
  }
}

/// Numbers with their scale; NaN where there is no value.
void LasArrays::AddNumbers(const LasExtra& extra, int place, double* values)
{
  this->Fills.push_back(
    [values, length = this->Header.PointLength, place, extra](
      const char* records, vtkIdType first, vtkIdType count)
    {
      const int size = extra.Size / extra.Components;
      for (vtkIdType i = 0; i < count; ++i)
      {
        for (int k = 0; k < extra.Components; ++k)
        {
          const double number = GetExtra(records + i * length + place + k * size, extra.Type);
          values[(first + i) * extra.Components + k] = extra.HasNoData && number == extra.NoData[k]
            ? std::numeric_limits<double>::quiet_NaN()
            : number * extra.Scale[k] + extra.Offset[k];
        }
      }
    });
}

/// Numbers as they are.
void LasArrays::AddBytes(const LasExtra& extra, int place, vtkDataArray* array)
{
  auto* values = static_cast<char*>(array->GetVoidPointer(0));
  this->Fills.push_back(
    [values, length = this->Header.PointLength, place, size = static_cast<std::size_t>(extra.Size)](
      const char* records, vtkIdType first, vtkIdType count)
    {
      char* to = values + first * static_cast<vtkIdType>(size);
      for (vtkIdType i = 0; i < count; ++i, to += size)
      {
        std::memcpy(to, records + i * length + place, size);
      }
    });
  if (extra.HasNoData && extra.Type == FloatType)
  {
    this->Fills.push_back(MakeNoDataFill(static_cast<float*>(array->GetVoidPointer(0)), extra));
  }
  else if (extra.HasNoData && extra.Type == DoubleType)
  {
    this->Fills.push_back(MakeNoDataFill(static_cast<double*>(array->GetVoidPointer(0)), extra));
  }
}

void LasArrays::Decode(const char* records, vtkIdType first, vtkIdType count)
{
  for (const Fill& fill : this->Fills)
  {
    fill(records, first, count);
  }
}

void LasArrays::MoveTo(vtkPolyData* cloud)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(this->Points);
  cloud->SetPoints(points);
  for (const auto& array : this->Arrays)
  {
    cloud->GetPointData()->AddArray(array); // Extra Bytes replace a field of the same name
  }
}

} // namespace helios
