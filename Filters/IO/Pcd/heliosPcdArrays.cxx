// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPcdArrays.h"

#include "heliosSceneCrs.h"
#include "heliosStatus.h"
#include "heliosTextFile.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

int GetVtkType(const PcdField& field)
{
  if (field.Type == 'F')
  {
    return field.Size == 4 ? VTK_FLOAT : VTK_DOUBLE;
  }
  const bool isSigned = field.Type == 'I';
  switch (field.Size)
  {
    case 1:
      return isSigned ? VTK_SIGNED_CHAR : VTK_UNSIGNED_CHAR;
    case 2:
      return isSigned ? VTK_SHORT : VTK_UNSIGNED_SHORT;
    case 4:
      return isSigned ? VTK_INT : VTK_UNSIGNED_INT;
    default:
      return isSigned ? VTK_TYPE_INT64 : VTK_TYPE_UINT64;
  }
}

template <typename T>
bool WriteNumber(std::string_view word, char* to)
{
  T value = 0;
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  std::memcpy(to, &value, sizeof(T));
  return result.ec == std::errc() && result.ptr == end;
}

/// Stores a word as a number of a field; false if it is not a number or out of range.
bool WriteNumber(const PcdField& field, std::string_view word, char* to)
{
  switch (GetVtkType(field))
  {
    vtkTemplateMacro(return WriteNumber<VTK_TT>(word, to));
  }
  return false;
}

double ReadReal(const char* from, int size)
{
  if (size == 8)
  {
    double value = 0.0;
    std::memcpy(&value, from, sizeof(value));
    return value;
  }
  float value = 0.0F;
  std::memcpy(&value, from, sizeof(value));
  return static_cast<double>(value);
}

} // namespace

PcdArrays::PcdArrays(const PcdHeader& header)
  : Header(header)
  , Points(vtkSmartPointer<vtkDoubleArray>::New())
  , Bytes(header.GetRowSize())
{
  this->Points->SetNumberOfComponents(3);
  if (!this->Points->Resize(static_cast<vtkIdType>(header.GetNumberOfPoints())) &&
    header.GetNumberOfPoints() > 0)
  {
    throw std::bad_alloc();
  }
  std::size_t offset = 0;
  for (const PcdField& field : header.Fields)
  {
    Column column = this->MakeColumn(field);
    column.From = offset;
    this->Columns.push_back(column);
    offset += field.GetBytes();
  }
}

PcdArrays::~PcdArrays() = default;

std::string PcdArrays::GetArrayName(const PcdField& field, PcdMeaning meaning) const
{
  switch (meaning)
  {
    case PcdMeaning::Normal:
      return names::Normals;
    case PcdMeaning::Color:
      return names::RGB;
    case PcdMeaning::Label:
      return names::ClassificationIds;
    case PcdMeaning::Curvature:
      return CurvatureName;
    case PcdMeaning::Intensity:
      return this->Header.HasAmplitude ? names::Amplitude : names::Intensity;
    default:
      return field.Name;
  }
}

vtkDataArray* PcdArrays::AddArray(int type, const std::string& name, int components)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  const auto count = static_cast<vtkIdType>(this->Header.GetNumberOfPoints());
  if (!array->Resize(count) && count > 0)
  {
    throw std::bad_alloc();
  }
  this->Arrays.push_back(array);
  return array;
}

PcdArrays::Column PcdArrays::MakeColumn(const PcdField& field)
{
  const PcdRole role = GetPcdRole(this->Header, field);
  const std::string name = this->GetArrayName(field, role.Meaning);
  Column column;
  column.Meaning = role.Meaning;
  column.TupleSize = field.GetBytes();
  switch (role.Meaning)
  {
    case PcdMeaning::Padding:
    case PcdMeaning::ColorCopy:
      return column;
    case PcdMeaning::Coordinate:
      column.Axis = role.Axis;
      return column;
    case PcdMeaning::Normal:
      this->Normals = this->Normals ? this->Normals : this->AddArray(GetVtkType(field), name, 3);
      column.Array = this->Normals;
      column.To = static_cast<std::size_t>(role.Axis) * field.GetBytes();
      column.TupleSize = 3 * field.GetBytes();
      return column;
    case PcdMeaning::Color:
      column.Array = this->AddArray(VTK_FLOAT, name, 3);
      return column;
    case PcdMeaning::Intensity:
      if (this->Header.HasWholeIntensity && !this->Header.HasAmplitude && field.Type == 'F' &&
        field.Count == 1)
      {
        column.Array = this->AddArray(VTK_UNSIGNED_SHORT, name, 1);
        return column;
      }
      column.Meaning = PcdMeaning::Array;
      break;
    case PcdMeaning::Label: // negative classes have the bits of an int
      column.Array = this->AddArray(field.Size == 4 ? VTK_INT : GetVtkType(field), name, 1);
      return column;
    default:
      break;
  }
  column.Array = this->AddArray(GetVtkType(field), name, field.Count);
  return column;
}

/// Stores blue, green, red and alpha, as PCL packs them into the four bytes of a float or integer.
void PcdArrays::StoreColor(const Column& column, const char* from)
{
  unsigned char bytes[4];
  std::memcpy(bytes, from, sizeof(bytes));
  auto* color = static_cast<float*>(column.Array->GetVoidPointer(0)) + 3 * this->Row;
  for (int k = 0; k < 3; ++k)
  {
    color[k] = this->HasNoColor ? std::numeric_limits<float>::quiet_NaN()
                                : static_cast<float>(bytes[2 - k]) / 255.0F;
  }
  this->NumberOfTransparent += !this->HasNoColor && bytes[3] != 0 && bytes[3] != 255;
}

void PcdArrays::StoreWhole(const Column& column, const char* from, int size) const
{
  const double value = std::clamp(std::round(ReadReal(from, size)), 0.0, 65535.0);
  static_cast<unsigned short*>(column.Array->GetVoidPointer(0))[this->Row] =
    std::isfinite(value) ? static_cast<unsigned short>(value) : 0;
}

void PcdArrays::Append(const char* row, const double point[3])
{
  const double* origin = this->Header.Origin;
  const double sum[3] = { origin[0] + point[0], origin[1] + point[1], origin[2] + point[2] };
  if (!std::isfinite(sum[0]) || !std::isfinite(sum[1]) || !std::isfinite(sum[2]))
  {
    ++this->NumberOfDropped;
    return;
  }
  std::copy_n(sum, 3, this->Points->GetPointer(3 * this->Row));
  for (std::size_t i = 0; i < this->Columns.size(); ++i)
  {
    const Column& column = this->Columns[i];
    if (column.Meaning == PcdMeaning::Color)
    {
      this->StoreColor(column, row + column.From);
    }
    else if (column.Meaning == PcdMeaning::Intensity)
    {
      this->StoreWhole(column, row + column.From, this->Header.Fields[i].Size);
    }
    else if (column.Array)
    {
      char* tuples = static_cast<char*>(column.Array->GetVoidPointer(0));
      std::memcpy(tuples + static_cast<std::size_t>(this->Row) * column.TupleSize + column.To,
        row + column.From, this->Header.Fields[i].GetBytes());
    }
  }
  ++this->Row;
}

void PcdArrays::AddRow(const char* row)
{
  double point[3];
  for (std::size_t i = 0; i < this->Columns.size(); ++i)
  {
    if (this->Columns[i].Axis >= 0)
    {
      point[this->Columns[i].Axis] =
        ReadReal(row + this->Columns[i].From, this->Header.Fields[i].Size);
    }
  }
  this->Append(row, point);
}

Status PcdArrays::AddLine(std::string_view line)
{
  double point[3];
  std::int64_t number = 0;
  TextWords words(line);
  this->HasNoColor = false;
  for (std::size_t i = 0; i < this->Columns.size(); ++i)
  {
    const PcdField& field = this->Header.Fields[i];
    const int axis = this->Columns[i].Axis;
    char* to = this->Bytes.data() + this->Columns[i].From;
    for (int k = 0; k < field.Count; ++k, to += field.Size, ++number)
    {
      const std::string_view word = words.NextName();
      if (word.empty())
      {
        return Status::Error("the point has " + std::to_string(number) +
          " numbers, but FIELDS and COUNT make " +
          std::to_string(this->Header.GetNumberOfColumns()) + "; complete the line");
      }
      const bool isGood = axis < 0
        ? WriteNumber(field, word, to)
        : WriteNumber<double>(word, reinterpret_cast<char*>(point + axis));
      if (!isGood)
      {
        return Status::Error(Quote(word) + " is not a number of type " + field.Type + " and size " +
          std::to_string(field.Size) + ", as the field " + Quote(field.Name) + " has; " +
          (word.find(',') == word.npos ? "correct it"
                                       : "write a decimal point, and blanks between numbers"));
      }
      this->HasNoColor = this->HasNoColor ||
        (this->Columns[i].Meaning == PcdMeaning::Color && field.Type == 'F' &&
          std::isnan(ReadReal(to, field.Size)));
    }
  }
  if (!words.NextName().empty())
  {
    return Status::Error("the point has more than the " + std::to_string(number) +
      " numbers that FIELDS and COUNT make; remove the others");
  }
  this->Append(this->Bytes.data(), point);
  return {};
}

void PcdArrays::MoveTo(vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  this->Points->SetNumberOfTuples(this->Row);
  points->SetData(this->Points);
  output->SetPoints(points);
  for (const auto& array : this->Arrays)
  {
    array->SetNumberOfTuples(this->Row);
    output->GetPointData()->AddArray(array);
  }
  if (this->Normals)
  {
    output->GetPointData()->SetNormals(this->Normals);
  }
  SetCRS(output, this->Header.Crs);
  if (this->Header.HasEpoch)
  {
    vtkNew<vtkDoubleArray> epoch;
    epoch->SetName(names::GpsEpoch);
    epoch->InsertNextValue(this->Header.Epoch);
    output->GetFieldData()->AddArray(epoch);
  }
}

} // namespace helios
