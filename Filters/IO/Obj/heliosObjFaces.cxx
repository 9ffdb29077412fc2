// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosObjFaces.h"

#include "heliosLineFile.h"

#include <algorithm>

namespace helios
{

//------------------------------------------------------------------------------
void ObjFaces::Add(const Face& face, const std::string& path)
{
  this->LargestCount += static_cast<std::int64_t>(face.Vertices.size()) - 2;
  if (this->Mesh.KeepsAll)
  {
    this->Mesh.Faces.Add(face.Vertices);
  }
  const vtkIdType known = this->Mesh.GetNumberOfPoints();
  const auto isKnown = [known](vtkTypeInt32 vertex) { return vertex < known; };
  if (this->Waiting.empty() && std::all_of(face.Vertices.begin(), face.Vertices.end(), isKnown))
  {
    this->AddTriangles(face, path);
  }
  else
  {
    this->Path = path;
    this->Waiting.push_back(face);
  }
}

//------------------------------------------------------------------------------
void ObjFaces::Finish()
{
  for (const Face& face : this->Waiting)
  {
    this->AddTriangles(face, this->Path);
  }
  this->Waiting.clear();
}

//------------------------------------------------------------------------------
/// Adds the triangles of a face. A face without area becomes a fan, whose triangles are counted as
/// dropped.
void ObjFaces::AddTriangles(const Face& face, const std::string& path)
{
  const vtkIdType count = this->Mesh.GetNumberOfTriangles();
  if (face.Vertices.size() > 3)
  {
    this->Rings.front() = face.Vertices;
    this->Polygons.Add(this->Rings, face.Material, [&] { return Place(path, face.Line); });
  }
  if (this->Mesh.GetNumberOfTriangles() == count)
  {
    this->AddFan(face);
    return;
  }
  const std::vector<int>& places = this->Polygons.GetPlaces();
  for (std::size_t i = 0; i < places.size(); i += 3)
  {
    this->AddTextures(face, { places[i], places[i + 1], places[i + 2] });
  }
}

//------------------------------------------------------------------------------
void ObjFaces::AddFan(const Face& face)
{
  const std::vector<vtkTypeInt32>& v = face.Vertices;
  for (std::size_t i = 2; i < v.size(); ++i)
  {
    this->Mesh.AddTriangle(v[0], v[i - 1], v[i], face.Material);
    this->AddTextures(face, { 0, static_cast<int>(i) - 1, static_cast<int>(i) });
  }
}

//------------------------------------------------------------------------------
void ObjFaces::AddTextures(const Face& face, const std::array<int, 3>& corners)
{
  if (!face.Textures.empty())
  {
    this->Textures.push_back({ face.Textures[static_cast<std::size_t>(corners[0])],
      face.Textures[static_cast<std::size_t>(corners[1])],
      face.Textures[static_cast<std::size_t>(corners[2])] });
  }
}

} // namespace helios
