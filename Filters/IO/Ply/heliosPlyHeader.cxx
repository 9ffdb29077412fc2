// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlyHeader.h"

#include "heliosLineFile.h"
#include "heliosTextFile.h"

#include <algorithm>
#include <string_view>

namespace helios
{

namespace
{

constexpr struct
{
  const char* Name;
  const char* OtherName;
  std::size_t Size; // [bytes]
} Types[] = { { "char", "int8", 1 }, { "uchar", "uint8", 1 }, { "short", "int16", 2 },
  { "ushort", "uint16", 2 }, { "int", "int32", 4 }, { "uint", "uint32", 4 },
  { "float", "float32", 4 }, { "double", "float64", 8 } };

constexpr std::int64_t MostRows = std::int64_t(1) << 40;

/// Parses the header lines one by one.
class HeaderParser
{
public:
  explicit HeaderParser(PlyHeader& header)
    : Header(header)
  {
  }

  bool IsAtEnd() const { return this->AtEnd; }

  Status ReadLine(std::string_view line)
  {
    TextWords words(line);
    const std::string_view key = words.NextName();
    if (!this->HasMark)
    {
      this->HasMark = key == "ply" && !words.HasMore();
      return this->HasMark
        ? Status()
        : Status::Error("is not a PLY file: its first line is not ply; check its name");
    }
    if (key.empty() || key == "comment" || key == "obj_info")
    {
      return {};
    }
    if (key == "format")
    {
      return this->ReadFormat(words);
    }
    if (key == "element")
    {
      return this->ReadElement(words);
    }
    if (key == "property")
    {
      return this->ReadProperty(words);
    }
    this->AtEnd = key == "end_header";
    return this->AtEnd ? this->Finish()
                       : Status::Error("unknown entry " + Quote(key) +
                           "; a PLY header has format, comment, obj_info, element, property, "
                           "end_header");
  }

private:
  Status ReadFormat(TextWords& words)
  {
    const std::string_view name = words.NextName();
    this->HasFormat = true;
    this->Header.Storage = name == "ascii" ? PlyStorage::Text
      : name == "binary_big_endian"        ? PlyStorage::BigEndian
                                           : PlyStorage::LittleEndian;
    const bool isKnown =
      name == "binary_little_endian" || this->Header.Storage != PlyStorage::LittleEndian;
    return isKnown && words.NextName() == "1.0"
      ? Status()
      : Status::Error("format " + Quote(name) +
          " is not known; expected one of ascii, "
          "binary_little_endian, binary_big_endian, followed by 1.0");
  }

  Status ReadElement(TextWords& words)
  {
    PlyElement element;
    element.Name = words.NextName();
    TextWords ahead = words;
    if (words.Next(element.Count) != TextWords::Number::Good || element.Count < 0 ||
      element.Count > MostRows)
    {
      return Status::Error("element " + Quote(element.Name) + " has the count " +
        Quote(ahead.Next()) + "; expected a whole number from 0 to 2^40");
    }
    if (this->Header.Find(element.Name))
    {
      return Status::Error("element " + Quote(element.Name) + " is given twice; remove one");
    }
    this->Header.Elements.push_back(element);
    return {};
  }

  Status ReadProperty(TextWords& words)
  {
    if (this->Header.Elements.empty())
    {
      return Status::Error("property comes before any element; write element NAME COUNT above it");
    }
    PlyProperty property;
    std::string_view type = words.NextName();
    property.IsList = type == "list";
    Status status;
    if (property.IsList)
    {
      status = ReadType(words.NextName(), property.CountType);
      type = words.NextName();
      if (status.IsOk() && property.CountType >= PlyType::Float32)
      {
        return Status::Error("a list has a count of floating point; give it an integer type");
      }
    }
    status = status.IsOk() ? ReadType(type, property.Type) : status;
    property.Name = words.NextName();
    PlyElement& element = this->Header.Elements.back();
    if (status.IsOk() && (property.Name.empty() || element.Find(property.Name) >= 0))
    {
      return Status::Error(property.Name.empty() ? "property has no name; give it one"
                                                 : "property " + Quote(property.Name) + " of " +
            Quote(element.Name) + " is given twice; remove one");
    }
    element.Properties.push_back(property);
    return status;
  }

  static Status ReadType(std::string_view name, PlyType& type)
  {
    const auto* found = std::find_if(std::begin(Types), std::end(Types),
      [name](const auto& each) { return name == each.Name || name == each.OtherName; });
    if (found == std::end(Types))
    {
      return Status::Error("type " + Quote(name) +
        " is not known; expected one of char, uchar, short, ushort, int, uint, float, double");
    }
    type = static_cast<PlyType>(found - std::begin(Types));
    return {};
  }

  Status Finish() const
  {
    const PlyElement* vertex = this->Header.Find("vertex");
    if (!this->HasFormat || !vertex)
    {
      return Status::Error(std::string("the header has no ") +
        (this->HasFormat ? "element vertex" : "format") + "; write it again");
    }
    for (const char* name : { "x", "y", "z" })
    {
      const int index = vertex->Find(name);
      if (index < 0 || vertex->Properties[static_cast<std::size_t>(index)].IsList)
      {
        return Status::Error(
          std::string("element vertex has no number ") + name + "; vertices need x, y and z");
      }
    }
    for (const PlyElement& element : this->Header.Elements)
    {
      if (element.Properties.empty() && element.Count > 0)
      {
        return Status::Error("element " + Quote(element.Name) + " has no property; remove it");
      }
    }
    return this->CheckFaces();
  }

  Status CheckFaces() const
  {
    if (const PlyElement* strips = this->Header.Find("tristrips"); strips && strips->Count > 0)
    {
      return Status::Error("element tristrips is not supported; save the triangles as faces");
    }
    const PlyElement* face = this->Header.Find("face");
    if (!face)
    {
      return Status::Error(
        "the header has no element face: the file is a cloud; give a mesh, or use xyzloader");
    }
    const int index = std::max(face->Find("vertex_indices"), face->Find("vertex_index"));
    const auto* list = index < 0 ? nullptr : &face->Properties[static_cast<std::size_t>(index)];
    return list && list->IsList && list->Type < PlyType::Float32
      ? Status()
      : Status::Error("element face has no list vertex_indices of integers; write it again");
  }

  PlyHeader& Header;
  bool HasMark = false;
  bool HasFormat = false;
  bool AtEnd = false;
};

} // namespace

//------------------------------------------------------------------------------
std::size_t GetSize(PlyType type)
{
  return Types[static_cast<std::size_t>(type)].Size;
}

//------------------------------------------------------------------------------
int PlyElement::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Properties.begin(), this->Properties.end(),
    [&name](const PlyProperty& property) { return property.Name == name; });
  return found == this->Properties.end() ? -1 : static_cast<int>(found - this->Properties.begin());
}

//------------------------------------------------------------------------------
const PlyElement* PlyHeader::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Elements.begin(), this->Elements.end(),
    [&name](const PlyElement& element) { return element.Name == name; });
  return found == this->Elements.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
double PlyHeader::GetSmallestSize() const
{
  double size = 0.0;
  for (const PlyElement& element : this->Elements)
  {
    double row = 0.0;
    for (const PlyProperty& property : element.Properties)
    {
      const PlyType type = property.IsList ? property.CountType : property.Type;
      row += this->Storage == PlyStorage::Text ? 2.0 : static_cast<double>(GetSize(type));
    }
    size += row * static_cast<double>(element.Count);
  }
  return size;
}

//------------------------------------------------------------------------------
Status PlyHeader::Read(const std::string& path)
{
  LineFile file;
  if (const Status status = file.Open(path); !status.IsOk())
  {
    return status;
  }
  file.SetRange(0, file.GetSize());
  HeaderParser parser(*this);
  std::int64_t number = 0;
  std::string_view line;
  while (!parser.IsAtEnd() && file.NextLine(line))
  {
    const Status status = parser.ReadLine(line);
    ++number;
    if (!status.IsOk())
    {
      return Status::Error(Place(path, number) + status.Message());
    }
  }
  this->DataBegin = file.GetNextLine();
  this->DataLine = number + 1;
  if (!file.GetError().empty())
  {
    return Status::Error(file.GetError());
  }
  return parser.IsAtEnd()
    ? Status()
    : Status::Error(Place(path, number) +
        "the file ends before end_header; it is not a PLY file, or is cut off");
}

} // namespace helios
