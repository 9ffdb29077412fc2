// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlyPoints.h"

#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

namespace helios::viewer
{

namespace
{

struct Type
{
  const char* Name;
  const char* OtherName;
  char Kind; // integer, unsigned or floating point
  std::size_t Size;
};

constexpr Type Types[] = { { "char", "int8", 'i', 1 }, { "uchar", "uint8", 'u', 1 },
  { "short", "int16", 'i', 2 }, { "ushort", "uint16", 'u', 2 }, { "int", "int32", 'i', 4 },
  { "uint", "uint32", 'u', 4 }, { "float", "float32", 'f', 4 }, { "double", "float64", 'f', 8 } };

struct Property
{
  std::string Name;
  Type Form;
};

struct Header
{
  std::string Format;
  std::int64_t Count = -1; // of vertices
  std::size_t Size = 0;    // of a vertex [bytes]
  std::vector<Property> Properties;

  Status Read(std::istream& file);

private:
  Status ReadElement(std::istringstream& words);
  Status ReadProperty(std::istringstream& words);

  std::string Element;
};

Status Header::ReadElement(std::istringstream& words)
{
  std::int64_t count = -1;
  words >> this->Element >> count;
  if (!words || count < 0)
  {
    return Status::Error("an element of its header has no count");
  }
  if (this->Element == "vertex" && this->Count >= 0)
  {
    return Status::Error("has vertices twice");
  }
  if (this->Element != "vertex" && this->Count < 0 && count > 0)
  {
    return Status::Error("has " + this->Element + " before its vertices");
  }
  this->Count = this->Element == "vertex" ? count : this->Count;
  return {};
}

Status Header::ReadProperty(std::istringstream& words)
{
  std::string type;
  Property property;
  words >> type >> property.Name;
  const auto* found = std::find_if(std::begin(Types), std::end(Types),
    [&type](const Type& each) { return type == each.Name || type == each.OtherName; });
  if (!words || found == std::end(Types))
  {
    return Status::Error(
      "has vertices with a property " + type + "; only plain numbers are supported");
  }
  const bool isTwice = std::any_of(this->Properties.begin(), this->Properties.end(),
    [&property](const Property& each) { return each.Name == property.Name; });
  if (isTwice)
  {
    return Status::Error("has the property " + property.Name + " twice");
  }
  property.Form = *found;
  this->Size += found->Size;
  this->Properties.push_back(property);
  return {};
}

Status Header::Read(std::istream& file)
{
  std::string line;
  Status status;
  if (!std::getline(file, line) || line.substr(0, 3) != "ply")
  {
    return Status::Error("is not a PLY file");
  }
  while (std::getline(file, line) && status.IsOk())
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "end_header")
    {
      const bool isGood = this->Count >= 0 && !this->Properties.empty();
      return isGood       ? Status()
        : this->Count < 0 ? Status::Error("has no vertices")
                          : Status::Error("has no vertices with x, y and z");
    }
    if (word == "format")
    {
      words >> this->Format;
    }
    else if (word == "element")
    {
      status = this->ReadElement(words);
    }
    else if (word == "property" && this->Element == "vertex")
    {
      status = this->ReadProperty(words);
    }
  }
  return status.IsOk() ? Status::Error("ends within its header") : status;
}

template <typename T>
double Cast(const unsigned char* bytes)
{
  T value;
  std::memcpy(&value, bytes, sizeof(value));
  return static_cast<double>(value);
}

/// A value of a binary file, in host byte order.
double Decode(const unsigned char* bytes, const Type& type)
{
  if (type.Kind == 'f')
  {
    return type.Size == 4 ? Cast<float>(bytes) : Cast<double>(bytes);
  }
  const bool isSigned = type.Kind == 'i';
  switch (type.Size)
  {
    case 1:
      return isSigned ? Cast<std::int8_t>(bytes) : Cast<std::uint8_t>(bytes);
    case 2:
      return isSigned ? Cast<std::int16_t>(bytes) : Cast<std::uint16_t>(bytes);
    default:
      return isSigned ? Cast<std::int32_t>(bytes) : Cast<std::uint32_t>(bytes);
  }
}

bool ReadBinary(std::istream& file, const Header& header, std::vector<double>& values)
{
  std::vector<unsigned char> bytes(header.Size);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  unsigned char* at = bytes.data();
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const Type& type = header.Properties[i].Form;
    if (header.Format == "binary_big_endian")
    {
      std::reverse(at, at + type.Size);
    }
    values[i] = Decode(at, type);
    at += type.Size;
  }
  return static_cast<bool>(file);
}

bool ReadText(std::istream& file, std::vector<double>& values)
{
  std::string word;
  for (double& value : values)
  {
    file >> word;
    const char* end = word.data() + word.size();
    const auto [last, error] = std::from_chars(word.data(), end, value);
    if (!file || error != std::errc() || last != end)
    {
      return false;
    }
  }
  return true;
}

/// A column for each property, and the indices of x, y and z.
class Columns
{
public:
  explicit Columns(const Header& header)
  {
    for (const Property& property : header.Properties)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName(property.Name.c_str());
      array->SetNumberOfValues(header.Count);
      this->Arrays.emplace_back(array);
    }
  }

  void Set(vtkIdType row, const std::vector<double>& values)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      this->Arrays[i]->SetValue(row, values[i]);
    }
  }

  bool MoveTo(vtkPolyData* cloud, vtkIdType count)
  {
    vtkDoubleArray* axes[3] = {};
    for (const auto& array : this->Arrays)
    {
      const std::string name = array->GetName();
      const std::size_t axis = name.size() == 1 ? std::string("xyz").find(name) : 3;
      if (axis < 3)
      {
        axes[axis] = array;
      }
      else
      {
        array->SetName(name == "intensity" ? vtkHeliosArrayNames::Intensity : name.c_str());
        cloud->GetPointData()->AddArray(array);
      }
    }
    if (!axes[0] || !axes[1] || !axes[2])
    {
      return false;
    }
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      points->SetPoint(i, axes[0]->GetValue(i), axes[1]->GetValue(i), axes[2]->GetValue(i));
    }
    cloud->SetPoints(points);
    return true;
  }

private:
  std::vector<vtkSmartPointer<vtkDoubleArray>> Arrays;
};

/// Whether the rest of a file can hold the vertices.
bool HasRoom(std::istream& file, const Header& header)
{
  const std::streampos begin = file.tellg();
  file.seekg(0, std::ios::end);
  const auto room = static_cast<double>(file.tellg() - begin);
  file.seekg(begin);
  const double least = header.Format == "ascii"
    ? 2.0 * static_cast<double>(header.Properties.size())
    : static_cast<double>(header.Size);
  return static_cast<double>(header.Count) * least <= room + 1.0;
}

} // namespace

Status ReadPlyPoints(const std::string& path, vtkPolyData* cloud)
{
  std::ifstream file(path, std::ios::binary);
  Header header;
  const Status status = header.Read(file);
  if (!status.IsOk())
  {
    return status;
  }
  const bool isText = header.Format == "ascii";
  if (!isText && header.Format != "binary_little_endian" && header.Format != "binary_big_endian")
  {
    return Status::Error("has the format \"" + header.Format + "\"; expected ascii or binary");
  }
  if (!HasRoom(file, header))
  {
    return Status::Error(
      "is truncated: its header gives " + std::to_string(header.Count) + " vertices");
  }
  Columns columns(header);
  std::vector<double> values(header.Properties.size());
  for (std::int64_t row = 0; row < header.Count; ++row)
  {
    if (!(isText ? ReadText(file, values) : ReadBinary(file, header, values)))
    {
      return Status::Error("vertex " + std::to_string(row) + " is missing or not numeric");
    }
    columns.Set(row, values);
  }
  return columns.MoveTo(cloud, header.Count) ? Status()
                                             : Status::Error("has no vertices with x, y and z");
}

} // namespace helios::viewer
