// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlyHeader.h"

#include "heliosAsciiText.h"
#include "heliosLineFile.h"
#include "heliosTextFile.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <string_view>

namespace helios
{

namespace
{

constexpr struct
{
  const char* Name;
  const char* OtherName;
} Types[] = { { "char", "int8" }, { "uchar", "uint8" }, { "short", "int16" },
  { "ushort", "uint16" }, { "int", "int32" }, { "uint", "uint32" }, { "float", "float32" },
  { "double", "float64" } };

constexpr const char* Formats[] = { "ascii", "binary_little_endian", "binary_big_endian" };

constexpr std::int64_t MaximumRows = std::int64_t(1) << 40;

/// Text of a header as UTF-8: characters beyond ASCII may be escaped, or Latin-1.
std::string ToUtf8(std::string_view text)
{
  return UnescapeText(EscapeText(UnescapeText(std::string(text))));
}

/// Returns the index of the property x, y or z of a vertex: in lower case, else in upper case, else -1.
int FindAxis(const PlyElement& vertex, char axis)
{
  const int lower = vertex.Find(std::string(1, axis));
  const char upper = static_cast<char>(std::toupper(static_cast<unsigned char>(axis)));
  return lower >= 0 ? lower : vertex.Find(std::string(1, upper));
}

/// Parses the header lines one by one.
class HeaderParser
{
public:
  HeaderParser(PlyHeader& header, PlyContent content)
    : Header(header)
    , Content(content)
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
    if (key == "comment" && words.NextName() == "vtkhelios")
    {
      const std::string mark = ToUtf8(words.NextName());
      this->Header.Marks[mark] = ToUtf8(words.Rest());
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
    const auto* found = std::find(std::begin(Formats), std::end(Formats), name);
    this->HasFormat = true;
    this->Header.Storage = static_cast<PlyStorage>(found - std::begin(Formats));
    return found != std::end(Formats) && words.NextName() == "1.0"
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
      element.Count > MaximumRows)
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
    property.Name = ToUtf8(words.NextName());
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

  Status Finish()
  {
    const PlyElement* vertex = this->Header.Find("vertex");
    if (!this->HasFormat || !vertex)
    {
      return Status::Error(std::string("the header has no ") +
        (this->HasFormat ? "element vertex" : "format") + "; write it again");
    }
    for (int k = 0; k < 3; ++k)
    {
      const int index = this->Header.Axes[k] = FindAxis(*vertex, "xyz"[k]);
      if (index < 0 || vertex->Properties[static_cast<std::size_t>(index)].IsList)
      {
        return Status::Error(
          std::string("element vertex has no number ") + "xyz"[k] + "; vertices need x, y and z");
      }
    }
    for (const PlyElement& element : this->Header.Elements)
    {
      if (element.Properties.empty() && element.Count > 0)
      {
        return Status::Error("element " + Quote(element.Name) + " has no property; remove it");
      }
    }
    return this->Content == PlyContent::Mesh ? this->CheckFaces() : this->CheckPoints(*vertex);
  }

  Status CheckPoints(const PlyElement& vertex) const
  {
    for (const PlyElement* each = this->Header.Elements.data(); each != &vertex; ++each)
    {
      if (each->Count > 0)
      {
        return Status::Error("element " + Quote(each->Name) +
          " comes before element vertex; write the vertices first");
      }
    }
    const auto list = std::find_if(vertex.Properties.begin(), vertex.Properties.end(),
      [](const PlyProperty& property) { return property.IsList; });
    return list == vertex.Properties.end()
      ? Status()
      : Status::Error("property " + Quote(list->Name) +
          " of element vertex is a list; points have plain numbers only: remove it");
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
  PlyContent Content;
  bool HasMark = false;
  bool HasFormat = false;
  bool AtEnd = false;
};

} // namespace

//------------------------------------------------------------------------------
const char* GetName(PlyType type)
{
  return Types[static_cast<std::size_t>(type)].Name;
}

//------------------------------------------------------------------------------
const char* GetName(PlyStorage storage)
{
  return Formats[static_cast<std::size_t>(storage)];
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
Status PlyHeader::Read(const std::string& path, PlyContent content)
{
  LineFile file;
  if (const Status status = file.Open(path); !status.IsOk())
  {
    return status;
  }
  file.SetRange(0, file.GetSize());
  HeaderParser parser(*this, content);
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
  if (!parser.IsAtEnd())
  {
    return Status::Error(
      Place(path, number) + "the file ends before end_header; it is not a PLY file, or is cut off");
  }
  const double expected = this->GetSmallestSize();
  const auto present = static_cast<double>(file.GetSize() - this->DataBegin);
  char text[128];
  std::snprintf(text, sizeof(text),
    ": the elements of its header need %.0f bytes or more, and %.0f", expected, present);
  return present + 1.0 >= expected // the last line of text may have no end
    ? Status()
    : Status::Error(path + text + " follow, so it is cut off; copy or write it again");
}

} // namespace helios
