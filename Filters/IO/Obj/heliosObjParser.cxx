// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosObjParser.h"

#include "heliosStatus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace helios
{

namespace
{

// Statements that define no surfaces.
bool IsIgnored(std::string_view keyword)
{
  static constexpr std::array<std::string_view, 10> keywords = { "o", "g", "s", "l", "p", "vp",
    "mg", "lod", "maplib", "usemap" };
  return std::find(keywords.begin(), keywords.end(), keyword) != keywords.end();
}

} // namespace

ObjParser::ObjParser(TextReport& report)
  : Report(report)
{
}

bool ObjParser::Fail(const std::string& message)
{
  return this->Report.Fail(this->File.GetPlace() + message);
}

bool ObjParser::Read(const std::string& path)
{
  const Status status = this->File.Open(path);
  if (!status.IsOk())
  {
    return this->Report.Fail(status.Message());
  }
  std::string_view line;
  while (this->File.NextLine(line))
  {
    if (!this->ReadLine(line))
    {
      return false;
    }
  }
  if (!this->File.GetError().empty())
  {
    return this->Report.Fail(this->File.GetError());
  }
  if (this->UnknownCount > 0)
  {
    this->Report.Warn(this->FirstUnknown + ", ignored (" + std::to_string(this->UnknownCount) +
      " such lines in this file)");
  }
  if (this->File.IsStopped() || !this->CheckIndices())
  {
    return false;
  }
  this->Faces.Finish();
  this->Faces.Warn(this->Report);
  if (this->ReadsTextures)
  {
    this->PlaceTextures();
  }
  return true;
}

bool ObjParser::ReadLine(std::string_view line)
{
  TextWords words(line);
  const std::string_view keyword = words.Next();
  if (keyword.size() == 1 && keyword[0] == 'v')
  {
    return this->ReadVertex(words);
  }
  if (keyword.size() == 1 && keyword[0] == 'f')
  {
    return this->ReadFace(words);
  }
  return keyword.empty() || this->ReadStatement(keyword, words);
}

bool ObjParser::ReadStatement(std::string_view keyword, TextWords& words)
{
  if (keyword == "vn")
  {
    ++this->Elements[2].Count;
    return this->ReadNumbers(keyword, words, 3);
  }
  if (keyword == "vt")
  {
    ++this->Elements[1].Count;
    return this->ReadsTextures ? this->ReadTexturePoint(words)
                               : this->ReadNumbers(keyword, words, 1);
  }
  if (keyword == "usemtl")
  {
    this->Use(words.NextTitle());
  }
  else if (keyword == "mtllib")
  {
    this->AddLibrary(words.Rest());
  }
  else if (!IsIgnored(keyword))
  {
    this->CountUnknown(keyword);
  }
  return true;
}

bool ObjParser::ReadVertex(TextWords& words)
{
  if (this->Mesh.Points.GetSize() / 3 >= this->MaximumNumberOfCorners)
  {
    return this->Fail("more than " + std::to_string(this->MaximumNumberOfCorners) +
      " vertices; split the file into several scene parts");
  }
  double* point = this->Mesh.Points.Append(3);
  for (int i = 0; i < 3; ++i)
  {
    const TextWords::Number status = words.Next(point[i]);
    if (status != TextWords::Number::Good)
    {
      return this->FailNumber("v", status, words);
    }
    if (!std::isfinite(point[i]))
    {
      return this->Fail(std::string("vertex coordinate ") + "xyz"[i] + " is " +
        (std::isnan(point[i]) ? "NaN" : "infinite") + "; correct the vertex, or remove it");
    }
  }
  ++this->Elements[0].Count;
  return !words.HasMore() || this->ReadNumbers("v", words, 0);
}

// Checks numbers that are not used.
bool ObjParser::ReadNumbers(std::string_view keyword, TextWords& words, int minimum)
{
  double unused;
  TextWords::Number status = TextWords::Number::Good;
  for (int count = 0; status == TextWords::Number::Good; ++count)
  {
    status = words.Next(unused);
    if (status == TextWords::Number::None && count >= minimum)
    {
      return true;
    }
  }
  return this->FailNumber(keyword, status, words);
}

// Reads u, v if it is there, and numbers that are not used.
bool ObjParser::ReadTexturePoint(TextWords& words)
{
  double point[2] = { 0.0, 0.0 };
  for (int i = 0; i < 2; ++i)
  {
    const TextWords::Number status = words.Next(point[i]);
    if (status != TextWords::Number::Good && (i == 0 || status != TextWords::Number::None))
    {
      return this->FailNumber("vt", status, words);
    }
  }
  this->TexturePoints.push_back({ static_cast<float>(point[0]), static_cast<float>(point[1]) });
  return !words.HasMore() || this->ReadNumbers("vt", words, 0);
}

bool ObjParser::FailNumber(std::string_view keyword, TextWords::Number status, TextWords& words)
{
  const std::string cure = keyword == "v" ? "v needs three numbers: v x y z"
    : keyword == "vn"                     ? "vn needs three numbers: vn x y z"
                                          : "vt needs one to three numbers: vt u v w";
  switch (status)
  {
    case TextWords::Number::None:
      return this->Fail("too few numbers; " + cure);
    case TextWords::Number::Excessive:
      return this->Fail(
        Quote(words.Next()) + " is beyond the range of double precision; correct it");
    default:
      return this->Fail(Quote(words.Next()) + " is not a number; " + cure);
  }
}

bool ObjParser::ReadFace(TextWords& words)
{
  this->Face.Vertices.clear();
  this->Face.Textures.clear();
  while (words.HasMore())
  {
    if (!this->ReadCorner(words))
    {
      return false;
    }
  }
  if (this->Face.Vertices.size() < 3)
  {
    return this->Fail("face has " + std::to_string(this->Face.Vertices.size()) +
      " corners; it needs three or more: f 1 2 3");
  }
  return this->AddFace();
}

// Reads v, v/t, v//n or v/t/n.
bool ObjParser::ReadCorner(TextWords& words)
{
  TextWords start = words;
  for (Element& element : this->Elements)
  {
    const bool isVertex = &element == this->Elements;
    int index = 0;
    const TextWords::Number status = words.ReadIndex(index);
    if (status == TextWords::Number::Excessive)
    {
      return this->Fail(
        "face refers to " + Quote(start.Next()) + ", 2^31 or more; correct the index");
    }
    const bool isGiven = status == TextWords::Number::Good;
    if (isVertex && !isGiven)
    {
      break;
    }
    const bool isKnown = index > 0 && index <= element.Count;
    if (isGiven && !isKnown && !this->Resolve(element, index))
    {
      return false;
    }
    if (isVertex)
    {
      this->Face.Vertices.push_back(index - 1);
    }
    if (this->ReadsTextures && isVertex)
    {
      this->Face.Textures.push_back(0);
    }
    if (this->ReadsTextures && &element == this->Elements + 1 && isGiven)
    {
      this->Face.Textures.back() = index;
    }
    if (words.IsAtWordEnd())
    {
      return true;
    }
    if (!words.ReadSlash())
    {
      break;
    }
  }
  return this->Fail(Quote(start.Next()) +
    " is not the corner of a face; write it v, v/t, v//n or v/t/n, such as 1//3");
}

// Converts an index to one that counts from the first element, from 1. Of texture coordinates and
// normals, 0 stands for those that are not there.
bool ObjParser::Resolve(Element& element, int& index)
{
  if (index > element.Count && index > element.Largest)
  {
    element.Largest = index; // may be defined later in the file
    element.LargestLine = this->File.GetLine();
  }
  if (index > 0)
  {
    return true;
  }
  const int given = index;
  const bool isKnown = index < 0 && -static_cast<std::int64_t>(index) <= element.Count;
  index = isKnown ? static_cast<int>(element.Count + index + 1) : 0;
  if (!isKnown && &element != this->Elements)
  {
    element.Absent = element.AbsentLine == 0 ? given : element.Absent;
    element.AbsentLine = element.AbsentLine == 0 ? this->File.GetLine() : element.AbsentLine;
    return true;
  }
  if (given == 0)
  {
    return this->Fail("face refers to vertex 0; indices count from 1, or backwards from -1");
  }
  return isKnown ||
    this->Fail("face refers to vertex " + std::to_string(given) + ", but only " +
      std::to_string(element.Count) + " come before it; correct the index");
}

bool ObjParser::CheckIndices()
{
  const Element& vertices = this->Elements[0];
  if (vertices.Largest > vertices.Count)
  {
    return this->Report.Fail(Place(this->File.GetPath(), vertices.LargestLine) +
      "face refers to vertex " + std::to_string(vertices.Largest) + ", but the file has " +
      std::to_string(vertices.Count) + "; correct the index");
  }
  this->WarnOfAbsent();
  return true;
}

// Warns once about texture coordinates and normals.
void ObjParser::WarnOfAbsent()
{
  std::string text;
  std::int64_t line = 0;
  for (const Element& element : { this->Elements[1], this->Elements[2] })
  {
    const bool isBeyond = element.Largest > element.Count;
    if (element.AbsentLine > 0 || isBeyond)
    {
      line = line > 0 ? line : element.AbsentLine > 0 ? element.AbsentLine : element.LargestLine;
      text += (text.empty() ? "" : " and ") + std::string(element.Name) + ' ' +
        std::to_string(element.AbsentLine > 0 ? element.Absent : element.Largest) +
        " (the file has " + std::to_string(element.Count) + ')';
    }
  }
  if (!text.empty())
  {
    this->Report.Warn(Place(this->File.GetPath(), line) + "faces refer to " + text +
      ": they are read without; correct these indices, or leave them out");
  }
}

bool ObjParser::AddFace()
{
  const auto count = static_cast<std::int64_t>(this->Face.Vertices.size()) - 2;
  if (3 * (this->Faces.GetLargestCount() + count) > this->MaximumNumberOfCorners)
  {
    return this->Fail("more than " + std::to_string(this->MaximumNumberOfCorners / 3) +
      " triangles; split the file into several scene parts");
  }
  if (this->CurrentUse < 0)
  {
    this->CurrentUse = this->AddUse({}, 0);
  }
  this->Face.Material = this->CurrentUse;
  this->Face.Line = this->File.GetLine();
  this->Faces.Add(this->Face, this->File.GetPath());
  return true;
}

// Sets the texture coordinates of all triangles, if one of them has any: they may follow the faces.
void ObjParser::PlaceTextures()
{
  if (this->TexturePoints.empty())
  {
    return;
  }
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  for (const std::array<int, 3>& triangle : this->Faces.GetTextures())
  {
    float* to = this->Mesh.TextureCoordinates.Append(6);
    for (const int index : triangle)
    {
      const bool isKnown =
        index > 0 && static_cast<std::size_t>(index) <= this->TexturePoints.size();
      const std::array<float, 2> point = isKnown
        ? this->TexturePoints[static_cast<std::size_t>(index) - 1]
        : std::array<float, 2>{ none, none };
      to = std::copy(point.begin(), point.end(), to);
    }
  }
}

void ObjParser::AddLibrary(std::string_view names)
{
  const auto isSame = [names](const Statement& known) { return known.Text == names; };
  if (names.empty())
  {
    this->Report.Warn(this->File.GetPlace() + "mtllib has no name; give that of a material file");
  }
  else if (std::none_of(this->Libraries.begin(), this->Libraries.end(), isSame))
  {
    this->Libraries.push_back({ std::string(names), this->File.GetLine() });
  }
}

void ObjParser::Use(std::string_view name)
{
  const std::size_t known = this->Uses.size();
  this->CurrentUse = this->AddUse(name, this->File.GetLine());
  if (name.empty() && this->Uses.size() > known)
  {
    this->Report.Warn(this->File.GetPlace() +
      "usemtl has no name, the default material is used; give that of a material");
  }
}

int ObjParser::AddUse(std::string_view name, std::int64_t line)
{
  const auto [place, isNew] =
    this->UseRows.emplace(std::string(name), static_cast<int>(this->Uses.size()));
  if (isNew)
  {
    this->Uses.push_back({ std::string(name), line });
  }
  return place->second;
}

void ObjParser::CountUnknown(std::string_view keyword)
{
  if (this->UnknownCount++ == 0)
  {
    this->FirstUnknown = this->File.GetPlace() + "unknown keyword " + Quote(keyword);
  }
}

} // namespace helios
