// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosStlFile.h"

#include "heliosLineFile.h"
#include "heliosMemoryCheck.h"
#include "heliosStatus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace helios
{

namespace
{

constexpr std::int64_t HeadSize = 84; // [bytes], with the number of triangles
constexpr std::int64_t RecordSize = 50;
constexpr std::size_t RecordsPerBlock = 20000;

std::uint32_t ReadUnsigned(const unsigned char* bytes)
{
  return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8 |
    static_cast<std::uint32_t>(bytes[2]) << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
}

float ReadFloat(const unsigned char* bytes)
{
  const std::uint32_t bits = ReadUnsigned(bytes);
  float value = 0.0f;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

std::string ToLower(std::string_view word)
{
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

/// Returns whether a file begins as text; binary files may, too.
bool StartsAsText(const unsigned char* head, std::size_t size)
{
  std::string_view text(reinterpret_cast<const char*>(head), size);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return ToLower(text.substr(0, 5)) == "solid";
}

} // namespace

//------------------------------------------------------------------------------
std::size_t StlFile::PointHash::operator()(vtkTypeInt32 id) const
{
  const double* p = this->Mesh->Points.GetValues() + 3 * static_cast<vtkIdType>(id);
  std::size_t hash = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    hash = (hash ^ std::hash<double>()(p[axis])) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 29;
  }
  return hash;
}

//------------------------------------------------------------------------------
bool StlFile::PointEqual::operator()(vtkTypeInt32 a, vtkTypeInt32 b) const
{
  const double* points = this->Mesh->Points.GetValues();
  const double* p = points + 3 * static_cast<vtkIdType>(a);
  return std::equal(p, p + 3, points + 3 * static_cast<vtkIdType>(b));
}

//------------------------------------------------------------------------------
StlFile::StlFile(SceneMesh& mesh, TextReport& report)
  : Mesh(mesh)
  , Report(report)
  , Known(0, PointHash{ &mesh }, PointEqual{ &mesh })
{
}

//------------------------------------------------------------------------------
bool StlFile::Read(const std::string& path)
{
  this->Path = path;
  InputFile file;
  std::int64_t size = 0;
  if (const Status status = OpenInput(path, file, size); !status.IsOk())
  {
    return this->Report.Fail(status.Message());
  }
  std::array<unsigned char, HeadSize> head{};
  const std::size_t read = std::fread(head.data(), 1, head.size(), file.get());
  const std::uint32_t count = ReadUnsigned(head.data() + 80);
  const std::int64_t expected = HeadSize + RecordSize * static_cast<std::int64_t>(count);
  const bool isText = StartsAsText(head.data(), read);
  if (read < head.size() || size < expected || (isText && size != expected))
  {
    return isText ? this->ReadText() : this->FailSize(size, count);
  }
  if (size > expected)
  {
    this->Report.Warn(path + ": " + std::to_string(size - expected) +
      " bytes after the last triangle are not read");
  }
  return this->ReadBinary(file.get(), count);
}

//------------------------------------------------------------------------------
bool StlFile::FailSize(std::int64_t size, std::uint32_t count)
{
  return this->Report.Fail(this->Path + ": is not an STL file, or is cut off: it has " +
    std::to_string(size) + " bytes, and " +
    (size < HeadSize ? "a header alone needs 84"
                     : "its header tells of " + std::to_string(count) + " triangles, which need " +
          std::to_string(HeadSize + RecordSize * static_cast<std::int64_t>(count))) +
    "; copy or write the file again");
}

//------------------------------------------------------------------------------
bool StlFile::ReadBinary(std::FILE* file, std::uint32_t count)
{
  if (3 * static_cast<std::int64_t>(count) > MaximumCorners)
  {
    return this->Report.Fail(this->Path + ": more than " + std::to_string(MaximumCorners / 3) +
      " triangles; split the file into several scene parts");
  }
  if (const Status status = CheckMemory("triangles", count, BytesPerTriangle); !status.IsOk())
  {
    return this->Report.Fail(this->Path + ": " + status.Message());
  }
  std::vector<unsigned char> block(RecordsPerBlock * RecordSize);
  for (std::int64_t done = 0; done < count;)
  {
    const std::size_t wanted = std::min(RecordsPerBlock, static_cast<std::size_t>(count - done));
    if (std::fread(block.data(), RecordSize, wanted, file) != wanted)
    {
      return this->Report.Fail(this->Path + ": cannot be read any further; check the disk");
    }
    for (std::size_t i = 0; i < wanted; ++i, ++done)
    {
      this->Triangle = done + 1;
      if (!this->AddBinary(block.data() + i * RecordSize))
      {
        return false;
      }
    }
    if (this->OnBlock && !this->OnBlock(static_cast<double>(done) / count))
    {
      return this->Report.Fail(this->Path + ": reading was aborted at triangle " +
        std::to_string(done) + "; update again to read it");
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// Adds a record: the normal, which is not read, three vertices, and two bytes of attributes.
bool StlFile::AddBinary(const unsigned char* record)
{
  for (int corner = 0; corner < 3; ++corner)
  {
    const unsigned char* bytes = record + 12 * (corner + 1);
    const double point[3] = { ReadFloat(bytes), ReadFloat(bytes + 4), ReadFloat(bytes + 8) };
    if (!this->AddVertex(point))
    {
      return false;
    }
  }
  this->EndLoop();
  return true;
}

//------------------------------------------------------------------------------
bool StlFile::AddVertex(const double* point)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!std::isfinite(point[axis]))
    {
      return this->FailHere(std::string("vertex coordinate ") + "xyz"[axis] + " is " +
        (std::isnan(point[axis]) ? "NaN" : "infinite") + "; correct the vertex, or remove it");
    }
  }
  const auto next = static_cast<vtkTypeInt32>(this->Mesh.GetNumberOfPoints());
  this->Mesh.AddPoint(point[0] + 0.0, point[1] + 0.0, point[2] + 0.0); // -0 becomes 0
  const auto [found, isNew] = this->Known.insert(next);
  if (!isNew)
  {
    this->Mesh.Points.Truncate(3 * static_cast<vtkIdType>(next));
  }
  this->Corners[this->NumberOfCorners++] = *found;
  return true;
}

//------------------------------------------------------------------------------
void StlFile::EndLoop()
{
  this->Mesh.AddTriangle(this->Corners[0], this->Corners[1], this->Corners[2], 0);
  this->NumberOfCorners = 0;
}

//------------------------------------------------------------------------------
bool StlFile::ReadText()
{
  this->Text.OnBlock = this->OnBlock;
  const Status status = this->Text.Open(this->Path);
  if (!status.IsOk())
  {
    return this->Report.Fail(status.Message());
  }
  std::string_view line;
  while (this->Text.NextLine(line))
  {
    if (!this->ReadLine(line))
    {
      return false;
    }
  }
  if (this->Text.IsStopped())
  {
    return this->FailHere("reading was aborted here; update again to read it");
  }
  if (!this->Text.GetError().empty())
  {
    return this->Report.Fail(this->Text.GetError());
  }
  return !this->IsInSolid ||
    this->FailHere("the file ends before endsolid, so it is cut off; copy or write it again");
}

//------------------------------------------------------------------------------
bool StlFile::ReadLine(std::string_view line)
{
  TextWords words(line);
  const std::string key = ToLower(words.NextName());
  if (key == "vertex")
  {
    return this->ReadVertex(words);
  }
  if (key == "endloop")
  {
    return this->ReadEndLoop();
  }
  if (key == "solid" || key == "endsolid")
  {
    this->IsInSolid = key == "solid";
    return true;
  }
  return key.empty() || key == "facet" || key == "outer" || key == "endfacet" ||
    this->FailHere(Quote(key) +
      " is no keyword of STL; expected one of solid, facet, outer loop, "
      "vertex, endloop, endfacet, endsolid");
}

//------------------------------------------------------------------------------
bool StlFile::ReadEndLoop()
{
  if (this->NumberOfCorners != 3)
  {
    return this->FailHere("the loop has " + std::to_string(this->NumberOfCorners) +
      " vertices; a facet of STL has three");
  }
  this->EndLoop();
  return true;
}

//------------------------------------------------------------------------------
bool StlFile::ReadVertex(TextWords& words)
{
  double point[3];
  if (this->NumberOfCorners == 3)
  {
    return this->FailHere("the loop has a fourth vertex; a facet of STL has three");
  }
  if (3 * (this->Mesh.GetNumberOfTriangles() + 1) > MaximumCorners)
  {
    return this->FailHere("more than " + std::to_string(MaximumCorners / 3) +
      " triangles; split the file into several scene parts");
  }
  for (double& coordinate : point)
  {
    TextWords ahead = words;
    if (words.Next(coordinate) != TextWords::Number::Good)
    {
      return this->FailHere(ahead.HasMore()
          ? Quote(ahead.Next()) + " is not a number; vertex needs three numbers: vertex x y z"
          : "too few numbers; vertex needs three numbers: vertex x y z");
    }
  }
  return words.HasMore()
    ? this->FailHere(Quote(words.Next()) + " comes after vertex x y z; remove it")
    : this->AddVertex(point);
}

//------------------------------------------------------------------------------
bool StlFile::FailHere(const std::string& message)
{
  const std::string place = this->Triangle > 0
    ? this->Path + ": triangle " + std::to_string(this->Triangle) + ": "
    : this->Text.GetPlace();
  return this->Report.Fail(place + message);
}

} // namespace helios
