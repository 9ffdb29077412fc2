// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPcdBlock.h"

#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <type_traits>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

constexpr double OriginStep = 100.0; // [m]

bool IsReal(vtkDataArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

bool IsSigned(vtkDataArray* array)
{
  switch (array->GetDataType())
  {
    case VTK_UNSIGNED_CHAR:
    case VTK_UNSIGNED_SHORT:
    case VTK_UNSIGNED_INT:
    case VTK_UNSIGNED_LONG:
    case VTK_UNSIGNED_LONG_LONG:
      return false;
    default:
      return true;
  }
}

/// Whether PCL or helios::PointEcho defines the field as float.
bool IsFloatField(const std::string& name)
{
  return name == "intensity" || name.substr(0, 7) == "normal_" || name == names::EchoWidth;
}

/// Appends the numbers of points as bytes.
struct ByteSink
{
  std::string& Text;

  template <typename T>
  void Add(T value)
  {
    this->Text.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }
  void EndRow() {}
};

/// Appends them as text.
struct WordSink
{
  std::string& Text;
  bool IsFirst = true;

  template <typename T>
  void Add(T value)
  {
    using Number = std::conditional_t<sizeof(T) == 1, int, T>; // not a character
    char word[32];
    this->Text.append(this->IsFirst ? "" : " ");
    this->Text.append(word, std::to_chars(word, word + sizeof(word), Number(value)).ptr);
    this->IsFirst = false;
  }
  void EndRow()
  {
    this->Text += '\n';
    this->IsFirst = true;
  }
};

/// Calls use(value) with a number of any type.
template <typename UseT>
void Visit(vtkDataArray* array, vtkIdType index, const UseT& use)
{
  switch (array->GetDataType())
  {
    vtkTemplateMacro(use(static_cast<VTK_TT*>(array->GetVoidPointer(0))[index]));
  }
}

} // namespace

void PcdBlock::AddField(
  const std::string& name, vtkDataArray* array, int component, int count, bool isFloat)
{
  PcdField field;
  field.Name = name;
  std::replace_if(
    field.Name.begin(), field.Name.end(), [](unsigned char c) { return c <= ' ' || c == 127; },
    '_');
  field.Type = IsReal(array) ? 'F' : IsSigned(array) ? 'I' : 'U';
  field.Size = isFloat && IsFloatField(name) && IsReal(array) ? 4 : array->GetDataTypeSize();
  field.Count = count;
  this->Fields.push_back(field);
  this->Sources.push_back({ array, component });
}

Status PcdBlock::Set(vtkPolyData* echoes, bool isFloat)
{
  this->Echoes = echoes;
  this->IsFloat = isFloat;
  for (const char* name : { "x", "y", "z" })
  {
    this->Fields.push_back({ name, isFloat ? 4 : 8, 'F', 1 });
    this->Sources.push_back({});
  }
  vtkPointData* data = echoes->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i); // null: strings
    if (!array || array->GetDataType() == VTK_BIT || !array->GetName())
    {
      continue;
    }
    if (array->GetNumberOfTuples() != echoes->GetNumberOfPoints())
    {
      return Status::Error(std::string("the point array ") + array->GetName() + " of a block has " +
        std::to_string(array->GetNumberOfTuples()) + " tuples for " +
        std::to_string(echoes->GetNumberOfPoints()) +
        " points; give it one per point, or remove it");
    }
    const std::string name = array->GetName();
    if (name == names::Normals && array->GetNumberOfComponents() == 3)
    {
      this->AddField("normal_x", array, 0, 1, isFloat);
      this->AddField("normal_y", array, 1, 1, isFloat);
      this->AddField("normal_z", array, 2, 1, isFloat);
      continue;
    }
    const bool isAmplitude = name == names::Amplitude && array->GetNumberOfComponents() == 1;
    this->Amplitude = this->Amplitude || isAmplitude;
    this->AddField(
      isAmplitude ? "intensity" : name, array, 0, array->GetNumberOfComponents(), isFloat);
  }
  for (std::size_t i = 0; i < this->Fields.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if (this->Fields[i].Name == this->Fields[j].Name)
      {
        return Status::Error("two point arrays of a block make the field " + this->Fields[i].Name +
          "; rename one of them");
      }
    }
  }
  return {};
}

void PcdBlock::GetMiddle(double origin[3]) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low[3] = { infinity, infinity, infinity };
  double high[3] = { -infinity, -infinity, -infinity };
  for (vtkIdType i = 0; i < this->Echoes->GetNumberOfPoints(); ++i)
  {
    double p[3];
    this->Echoes->GetPoint(i, p);
    for (int axis = 0; axis < 3 && std::isfinite(p[0] + p[1] + p[2]); ++axis)
    {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double middle = low[axis] + 0.5 * (high[axis] - low[axis]);
    origin[axis] =
      low[axis] <= high[axis] ? std::round(middle / OriginStep) * OriginStep + 0.0 : 0.0;
  }
}

double PcdBlock::RoundCoordinate(double value, double origin)
{
  if (!this->IsFloat)
  {
    return value;
  }
  const auto rounded = static_cast<double>(static_cast<float>(value - origin));
  this->LargestError = std::max(this->LargestError, std::abs(origin + rounded - value));
  return rounded;
}

void PcdBlock::Append(vtkIdType begin, vtkIdType end, const PcdHeader& header, std::string& text)
{
  const bool isText = header.Storage == PcdStorage::Ascii;
  WordSink words{ text };
  ByteSink bytes{ text };
  for (vtkIdType i = begin; i < end; ++i)
  {
    double p[3];
    this->Echoes->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      ++this->NumberOfDropped;
      continue;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = this->RoundCoordinate(p[axis], header.Origin[axis]);
    }
    if (isText)
    {
      this->AppendRow(i, p, words);
    }
    else
    {
      this->AppendRow(i, p, bytes);
    }
    ++this->NumberOfWritten;
  }
}

template <typename SinkT>
void PcdBlock::AppendRow(vtkIdType point, const double place[3], SinkT& sink) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (this->IsFloat)
    {
      sink.Add(static_cast<float>(place[axis]));
    }
    else
    {
      sink.Add(place[axis]);
    }
  }
  for (std::size_t f = 3; f < this->Fields.size(); ++f)
  {
    const Source& source = this->Sources[f];
    const auto size = static_cast<std::size_t>(this->Fields[f].Size);
    const vtkIdType first = point * source.Array->GetNumberOfComponents() + source.Component;
    for (vtkIdType k = first; k < first + this->Fields[f].Count; ++k)
    {
      Visit(source.Array, k,
        [size, &sink](auto value)
        {
          if (size == sizeof(value))
          {
            sink.Add(value);
          }
          else
          {
            sink.Add(static_cast<float>(value));
          }
        });
    }
  }
  sink.EndRow();
}

} // namespace helios
