// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlyFile.h"

#include "heliosMemoryCheck.h"
#include "heliosStatus.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

constexpr std::int64_t RowsPerBlock = 65536;

} // namespace

//------------------------------------------------------------------------------
bool PlyFile::Read(const std::string& path)
{
  this->Path = path;
  this->Report.Error = this->Header.Read(path, PlyContent::Mesh).Message();
  if (!this->Report.Error.empty() || !this->CheckSize())
  {
    return false;
  }
  this->Source = OpenPlySource(path, this->Header, this->Report.Error);
  if (!this->Report.Error.empty())
  {
    return false;
  }
  for (const PlyElement& element : this->Header.Elements)
  {
    if (!this->ReadElement(element))
    {
      return false;
    }
  }
  this->Polygons.Warn(this->Report);
  this->WarnOfRest();
  return true;
}

//------------------------------------------------------------------------------
/// Compares the counts of the header with the memory and 32-bit cells.
bool PlyFile::CheckSize()
{
  const std::int64_t vertices = this->Header.Find("vertex")->Count;
  const std::int64_t faces = this->Header.Find("face")->Count;
  if (vertices > MaximumCorners || 3 * faces > MaximumCorners)
  {
    return this->Report.Fail(this->Path + ": more than " + std::to_string(MaximumCorners) +
      " vertices or " + std::to_string(MaximumCorners / 3) +
      " triangles; split the file into several scene parts");
  }
  const auto count = static_cast<double>(faces);
  const double further = static_cast<double>(vertices) / std::max(1.0, count) - 0.5;
  const Status status =
    CheckMemory("faces", count, BytesPerTriangle + BytesPerVertex * std::max(0.0, further));
  return status.IsOk() || this->Report.Fail(this->Path + ": " + status.Message());
}

//------------------------------------------------------------------------------
bool PlyFile::ReadElement(const PlyElement& element)
{
  this->Element = element.Name;
  if (element.Name == "face" && element.Count > 0 &&
    this->Mesh.GetNumberOfPoints() < this->Header.Find("vertex")->Count)
  {
    return this->Report.Fail(
      this->Path + ": element face comes before element vertex; write the vertices first");
  }
  for (this->Row = 0; this->Row < element.Count; ++this->Row)
  {
    const bool isRead = this->Source->StartRow() &&
      (element.Name == "vertex"    ? this->ReadVertex(element)
          : element.Name == "face" ? this->ReadFace(element)
                                   : this->SkipRow(element)) &&
      this->Source->EndRow();
    if (!isRead)
    {
      return this->Fail(this->Source->GetError());
    }
    if ((this->Row + 1) % RowsPerBlock == 0 && !this->ReportRow())
    {
      return this->Fail("reading was aborted here; update again to read it");
    }
  }
  this->DoneRows += static_cast<double>(element.Count);
  return true;
}

//------------------------------------------------------------------------------
bool PlyFile::ReportRow()
{
  double rows = 0.0;
  for (const PlyElement& element : this->Header.Elements)
  {
    rows += static_cast<double>(element.Count);
  }
  return !this->OnBlock || this->OnBlock((this->DoneRows + static_cast<double>(this->Row)) / rows);
}

//------------------------------------------------------------------------------
/// Reads the value of a property, or its list.
bool PlyFile::ReadProperty(const PlyProperty& property)
{
  double count = 1.0;
  if (property.IsList && !this->Source->Read(property.CountType, count))
  {
    return false;
  }
  if (count < 0.0)
  {
    return this->Fail("list " + property.Name + " has a count below 0; correct it");
  }
  this->Values.clear();
  for (double i = 0.0; i < count; ++i)
  {
    this->Values.emplace_back();
    if (!this->Source->Read(property.Type, this->Values.back()))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool PlyFile::ReadVertex(const PlyElement& element)
{
  double point[3] = { 0.0, 0.0, 0.0 };
  const int* axes = this->Header.Axes;
  for (std::size_t i = 0; i < element.Properties.size(); ++i)
  {
    if (!this->ReadProperty(element.Properties[i]))
    {
      return false;
    }
    const auto axis = std::find(axes, axes + 3, static_cast<int>(i)) - axes;
    if (axis < 3)
    {
      point[axis] = this->Values.front();
    }
  }
  return this->AddVertex(point);
}

//------------------------------------------------------------------------------
bool PlyFile::AddVertex(const double* point)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!std::isfinite(point[axis]))
    {
      return this->Fail(std::string("vertex coordinate ") + "xyz"[axis] + " is " +
        (std::isnan(point[axis]) ? "NaN" : "infinite") + "; correct the vertex, or remove it");
    }
  }
  this->Mesh.AddPoint(point[0], point[1], point[2]);
  return true;
}

//------------------------------------------------------------------------------
bool PlyFile::ReadFace(const PlyElement& element)
{
  bool isAdded = true;
  for (const PlyProperty& property : element.Properties)
  {
    if (!this->ReadProperty(property))
    {
      return false;
    }
    if (property.IsList && (property.Name == "vertex_indices" || property.Name == "vertex_index"))
    {
      isAdded = this->AddFace();
    }
    if (!isAdded)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool PlyFile::SkipRow(const PlyElement& element)
{
  const std::vector<PlyProperty>& all = element.Properties;
  return std::all_of(
    all.begin(), all.end(), [this](const PlyProperty& each) { return this->ReadProperty(each); });
}

//------------------------------------------------------------------------------
/// Makes a ring of the corners read last.
bool PlyFile::ReadRing()
{
  if (this->Values.size() < 3)
  {
    return this->Fail(
      "face has " + std::to_string(this->Values.size()) + " corners; it needs three or more");
  }
  const auto vertices = static_cast<double>(this->Mesh.GetNumberOfPoints());
  std::vector<vtkTypeInt32>& ring = this->Rings.front();
  ring.clear();
  for (const double id : this->Values)
  {
    if (!(id >= 0.0 && id < vertices))
    {
      return this->Fail("face refers to vertex " + std::to_string(static_cast<std::int64_t>(id)) +
        ", but the file has " + std::to_string(this->Mesh.GetNumberOfPoints()) +
        ", counted from 0; correct the index");
    }
    ring.push_back(static_cast<vtkTypeInt32>(id));
  }
  return this->Mesh.Corners.GetSize() + 3 * static_cast<std::int64_t>(ring.size()) <=
    MaximumCorners ||
    this->Fail("more than " + std::to_string(MaximumCorners / 3) +
      " triangles; split the file into several scene parts");
}

//------------------------------------------------------------------------------
/// Adds the triangles of the corners read last.
bool PlyFile::AddFace()
{
  if (!this->ReadRing())
  {
    return false;
  }
  const std::vector<vtkTypeInt32>& ring = this->Rings.front();
  if (this->Mesh.KeepsAll)
  {
    this->Mesh.Faces.Add(ring);
  }
  if (ring.size() == 3)
  {
    this->Mesh.AddTriangle(ring[0], ring[1], ring[2], 0);
    return true;
  }
  this->Polygons.Add(this->Rings, 0, [this] { return this->GetPlace(); });
  return true;
}

//------------------------------------------------------------------------------
void PlyFile::WarnOfRest()
{
  const std::int64_t rest = this->Source->CountRest();
  if (rest > 0)
  {
    this->Report.Warn(this->Path + ": " + std::to_string(rest) +
      (this->Header.Storage == PlyStorage::Text ? " lines" : " bytes") +
      " after the last element are not read; correct the counts of the header");
  }
}

//------------------------------------------------------------------------------
std::string PlyFile::GetPlace() const
{
  return this->Source->GetPlace(this->Element, this->Row);
}

//------------------------------------------------------------------------------
/// Reports an error. The first one counts: a failing function may have reported it already.
bool PlyFile::Fail(const std::string& message)
{
  return this->Report.Error.empty() ? this->Report.Fail(this->GetPlace() + message) : false;
}

} // namespace helios
