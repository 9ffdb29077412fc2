// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPcdBlock.h"

#include "heliosPcdNames.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
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

/// Returns whether PCL or helios::PointEcho defines the field as float.
bool IsFloatField(const std::string& name)
{
  return name == names::EchoWidth || name == "intensity";
}

bool IsScalar(vtkDataArray* array, const char* name)
{
  return array->GetNumberOfComponents() == 1 && std::string_view(array->GetName()) == name;
}

/// Returns the value of full colour in an array.
double GetFullColor(vtkDataArray* colors)
{
  return IsReal(colors) ? 1.0 : colors->GetDataTypeSize() == 1 ? 255.0 : 65535.0;
}

/// Returns a component of a colour in 8 bits; NaN is 0.
double GetByte(vtkDataArray* colors, vtkIdType point, int component)
{
  const double value = colors->GetComponent(point, component) * (255.0 / GetFullColor(colors));
  return std::isnan(value) ? 0.0 : std::round(std::clamp(value, 0.0, 255.0));
}

/// Packs red, green and blue with full alpha, like PCL.
std::uint32_t PackColor(vtkDataArray* colors, vtkIdType point)
{
  std::uint32_t bits = 0xFF;
  for (int k = 0; k < 3; ++k)
  {
    bits = bits << 8U | static_cast<std::uint32_t>(GetByte(colors, point, k));
  }
  return bits;
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

/// Adds a packed colour as an integer, or as the float of the same bits.
template <typename SinkT>
void AddColor(std::uint32_t bits, char type, SinkT& sink)
{
  if (type == 'U')
  {
    sink.Add(bits);
    return;
  }
  float number = 0.0F;
  std::memcpy(&number, &bits, sizeof(number));
  sink.Add(number);
}

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

void PcdBlock::AddField(const std::string& name, vtkDataArray* array, int component, int count)
{
  PcdField field;
  field.Name = name;
  std::replace_if(
    field.Name.begin(), field.Name.end(), [](unsigned char c) { return c <= ' ' || c == 127; },
    '_');
  const bool isFloat = this->HasFloats && IsFloatField(name) && IsReal(array);
  field.Type = IsReal(array) ? 'F' : IsSigned(array) ? 'I' : 'U';
  field.Size = isFloat ? 4 : array->GetDataTypeSize();
  field.Count = count;
  this->Fields.push_back(field);
  this->Sources.push_back({ array, component, isFloat ? Encoding::Float : Encoding::Plain });
}

void PcdBlock::AddPclField(
  const std::string& name, vtkDataArray* array, int component, Encoding encoding, char type)
{
  const bool isWide = encoding == Encoding::Float && !this->HasFloats && IsReal(array);
  this->Fields.push_back({ name, isWide ? array->GetDataTypeSize() : 4, type, 1 });
  this->Sources.push_back({ array, component, isWide ? Encoding::Plain : encoding });
}

bool PcdBlock::IsFiner(vtkDataArray* colors)
{
  const double full = GetFullColor(colors);
  for (vtkIdType i = 0; full != 255.0 && i < colors->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (std::abs(GetByte(colors, i, k) / 255.0 - colors->GetComponent(i, k) / full) > 1e-6)
      {
        return true;
      }
    }
  }
  return false;
}

void PcdBlock::AddColors(vtkDataArray* array, const Types& types)
{
  this->FineColors = IsFiner(array);
  this->AddPclField("rgb", array, 0, Encoding::Color, types.IsText ? 'U' : 'F');
  if (types.HasFullColors)
  {
    this->AddField(array->GetName(), array, 0, 3);
  }
}

void PcdBlock::AddArray(vtkDataArray* array, const Types& types)
{
  const std::string name = array->GetName();
  if (name == names::Normals && array->GetNumberOfComponents() == 3 && IsReal(array))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->AddPclField(std::string("normal_") + "xyz"[axis], array, axis, Encoding::Float, 'F');
    }
  }
  else if (name == names::RGB && array->GetNumberOfComponents() == 3)
  {
    this->AddColors(array, types);
  }
  else if (IsScalar(array, names::Amplitude) ||
    (IsScalar(array, names::Intensity) && !this->Amplitude))
  {
    this->WholeIntensity = !this->Amplitude && array->GetDataType() == VTK_UNSIGNED_SHORT;
    this->AddPclField("intensity", array, 0, Encoding::Float, 'F');
  }
  else if (IsScalar(array, names::ClassificationIds) && !IsReal(array))
  {
    this->AddPclField("label", array, 0, Encoding::Label, 'U');
  }
  else if (IsScalar(array, CurvatureName) && IsReal(array))
  {
    this->AddPclField("curvature", array, 0, Encoding::Float, 'F');
  }
  else
  {
    this->AddField(name, array, 0, array->GetNumberOfComponents());
  }
}

Status PcdBlock::Set(vtkPolyData* echoes, const Types& types)
{
  *this = PcdBlock();
  this->Echoes = echoes;
  this->HasFloatPoints = types.HasFloatPoints;
  this->HasFloats = types.HasFloats;
  for (const char* name : { "x", "y", "z" })
  {
    this->Fields.push_back({ name, types.HasFloatPoints ? 4 : 8, 'F', 1 });
    this->Sources.push_back({});
  }
  vtkPointData* data = echoes->GetPointData();
  vtkDataArray* amplitude = data->GetArray(names::Amplitude);
  this->Amplitude = amplitude && amplitude->GetNumberOfComponents() == 1;
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
    this->AddArray(array, types);
  }
  return this->CheckNames();
}

Status PcdBlock::CheckNames() const
{
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

double PcdBlock::FindLargestError(const double origin[3]) const
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < this->Echoes->GetNumberOfPoints(); ++i)
  {
    double p[3];
    this->Echoes->GetPoint(i, p);
    for (int axis = 0; axis < 3 && std::isfinite(p[0] + p[1] + p[2]); ++axis)
    {
      const auto rounded = static_cast<double>(static_cast<float>(p[axis] - origin[axis]));
      largest = std::max(largest, std::abs(origin[axis] + rounded - p[axis]));
    }
  }
  return largest;
}

double PcdBlock::RoundCoordinate(double value, double origin)
{
  if (!this->HasFloatPoints)
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
    if (this->HasFloatPoints)
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
    if (source.Stored == Encoding::Color)
    {
      AddColor(PackColor(source.Array, point), this->Fields[f].Type, sink);
      continue;
    }
    const vtkIdType first = point * source.Array->GetNumberOfComponents() + source.Component;
    for (vtkIdType k = first; k < first + this->Fields[f].Count; ++k)
    {
      Visit(source.Array, k,
        [&source, &sink](auto value)
        {
          switch (source.Stored)
          {
            case Encoding::Float:
              return sink.Add(static_cast<float>(value));
            case Encoding::Label:
              return sink.Add(static_cast<std::uint32_t>(static_cast<std::int64_t>(value)));
            default:
              return sink.Add(value);
          }
        });
    }
  }
  sink.EndRow();
}

} // namespace helios
