// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGltfModel.h"

#include "heliosGltfCutout.h"
#include "heliosMemoryCheck.h"

#include <json/json.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace helios
{

namespace
{

constexpr std::size_t MeshesPerBlock = 256;

/// Returns the luminance of a linear colour (Rec. 709).
double GetLuminance(const double* color)
{
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

} // namespace

//------------------------------------------------------------------------------
bool GltfModel::Read()
{
  const Status status = this->ReadDocument();
  return status.IsOk() || this->Report.Fail(status.Message());
}

//------------------------------------------------------------------------------
Status GltfModel::ReadDocument()
{
  GltfNodes nodes(this->Document, this->Animation);
  Status status = nodes.Find(this->Placements);
  for (const GltfPlacement& placement : this->Placements)
  {
    if (status.IsOk() && placement.Skin >= 0 && this->Joints.count(placement.Skin) == 0)
    {
      status = FindGltfJoints(this->Document, placement.Skin, nodes, this->Joints[placement.Skin]);
    }
  }
  status = status.IsOk() ? this->ReadMaterials() : status;
  status = status.IsOk() ? this->ReadMeshes() : status;
  status = status.IsOk() ? this->CheckSize() : status;
  status = status.IsOk() ? this->AddMeshes() : status;
  if (status.IsOk())
  {
    this->WarnOfMotion();
  }
  return status;
}

//------------------------------------------------------------------------------
/// Adds a row per material; a base colour without texture is a reflectance.
Status GltfModel::ReadMaterials()
{
  for (std::int64_t i = 0; i < this->Document.GetCount("materials"); ++i)
  {
    const Json::Value& given = this->Document.GetElement("materials", i);
    const Json::Value& surface = GetMember(given, "pbrMetallicRoughness");
    const Json::Value& color = GetMember(surface, "baseColorFactor");
    Material material;
    const std::string name = GetText(given, "name");
    material.Name = name.empty() ? "material" + std::to_string(i) : name;
    double factors[4] = { 1, 1, 1, 1 };
    const bool isColor = color.isNull() ||
      (ReadNumbers(color, factors, 4) &&
        std::all_of(factors, factors + 4, [](double x) { return x >= 0.0 && x <= 1.0; }));
    if (!isColor)
    {
      return this->Document.Fail(
        ElementPath("materials", i) + ".pbrMetallicRoughness.baseColorFactor",
        "is " + Describe(color) + ", not four numbers from 0 to 1; correct it");
    }
    if (!color.isNull() && GetMember(surface, "baseColorTexture").isNull())
    {
      material.Reflectance = GetLuminance(factors);
    }
    this->Mesh.Materials.push_back(material);
    Cutout cutout;
    this->TextureSets.push_back(FindGltfCutout(this->Document, i, material.Name, cutout));
    if (!cutout.What.empty())
    {
      this->Cutouts.push_back(std::move(cutout));
    }
  }
  return {};
}

//------------------------------------------------------------------------------
Status GltfModel::ReadMeshes()
{
  for (const GltfPlacement& placement : this->Placements)
  {
    const auto [mesh, isNew] = this->Meshes.emplace(GetKey(placement), GltfMesh());
    const Status status = isNew ? ReadGltfMesh(this->Document, placement.Mesh, placement.Weights,
                                    placement.Skin >= 0, this->TextureSets, mesh->second)
                                : Status();
    if (!status.IsOk())
    {
      return status;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
/// Checks the number of all triangles, with copies.
Status GltfModel::CheckSize() const
{
  double triangles = 0.0;
  double points = 0.0;
  for (const GltfPlacement& placement : this->Placements)
  {
    const GltfMesh& mesh = this->Meshes.at(GetKey(placement));
    triangles += static_cast<double>(mesh.Materials.size());
    points += static_cast<double>(mesh.Points.size()) / 3.0;
  }
  if (std::max(3.0 * triangles, points) > static_cast<double>(MaximumCorners))
  {
    return Status::Error(this->Document.GetPath() + ": more than " +
      std::to_string(MaximumCorners / 3) + " triangles or " + std::to_string(MaximumCorners) +
      " vertices at all places; split the file into several scene parts");
  }
  const Status status = CheckMemory("triangles at all places", triangles, BytesPerTriangle);
  return status.IsOk() ? status : Status::Error(this->Document.GetPath() + ": " + status.Message());
}

//------------------------------------------------------------------------------
Status GltfModel::AddMeshes()
{
  for (std::size_t i = 0; i < this->Placements.size(); ++i)
  {
    const Status status = this->AddMesh(this->Placements[i]);
    if (!status.IsOk())
    {
      return status;
    }
    if ((i + 1) % MeshesPerBlock == 0 && this->OnBlock &&
      !this->OnBlock(static_cast<double>(i + 1) / static_cast<double>(this->Placements.size())))
    {
      return Status::Error(this->Document.GetPath() + ": reading was aborted at mesh " +
        std::to_string(i + 1) + " of " + std::to_string(this->Placements.size()) +
        "; update again to read it");
    }
  }
  return {};
}

//------------------------------------------------------------------------------
/// Adds a placed mesh; a mirrored mesh is turned outside again.
Status GltfModel::AddMesh(const GltfPlacement& placement)
{
  const GltfMesh& mesh = this->Meshes.at(GetKey(placement));
  const auto first = static_cast<vtkTypeInt32>(this->Mesh.GetNumberOfPoints());
  const Status status = this->AddPoints(placement, mesh);
  if (!status.IsOk())
  {
    return status;
  }
  const bool isMirrored = !this->Animation && placement.Place.IsMirrored(); // frames are alike
  for (std::size_t i = 0; i < mesh.Materials.size(); ++i)
  {
    const vtkTypeInt32* corners = mesh.Corners.data() + 3 * i;
    this->Mesh.AddTriangle(first + corners[0], first + corners[isMirrored ? 2 : 1],
      first + corners[isMirrored ? 1 : 2], this->FindRow(mesh.Materials[i]));
  }
  this->AddTextures(mesh, isMirrored);
  return {};
}

//------------------------------------------------------------------------------
/// Adds the vertices of a placed mesh; those of a skin are where its joints move them.
Status GltfModel::AddPoints(const GltfPlacement& placement, const GltfMesh& mesh)
{
  const std::vector<GltfTransform>* joints =
    placement.Skin >= 0 ? &this->Joints.at(placement.Skin) : nullptr;
  for (const auto& each : mesh.Weights.Influences)
  {
    if (joints && !(each.Joint < static_cast<std::int64_t>(joints->size())))
    {
      return this->Document.Fail(ElementPath("meshes", placement.Mesh),
        "refers to joint " + std::to_string(each.Joint) + ", but " +
          ElementPath("skins", placement.Skin) + " has " + std::to_string(joints->size()) +
          "; write the file again");
    }
  }
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    const std::array<double, 3> p = joints
      ? mesh.Weights.Apply(i / 3, mesh.Points.data() + i, *joints)
      : placement.Place.Apply(mesh.Points.data() + i);
    if (!std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); }))
    {
      return this->Document.Fail(ElementPath("nodes", placement.Node),
        "moves a vertex of its mesh to infinity; correct its matrix, or its parents'");
    }
    this->Mesh.AddPoint(p[0], p[1], p[2]);
  }
  return {};
}

//------------------------------------------------------------------------------
/// Adds the texture coordinates of a placed mesh; all triangles have them once one has.
void GltfModel::AddTextures(const GltfMesh& mesh, bool isMirrored)
{
  GrowingArray<vtkFloatArray>& all = this->Mesh.TextureCoordinates;
  const vtkIdType missing = 6 * this->Mesh.GetNumberOfTriangles() - all.GetSize();
  const auto own = static_cast<vtkIdType>(mesh.Textures.size());
  if (own == 0 && all.GetSize() == 0)
  {
    return;
  }
  std::fill_n(all.Append(missing - own), missing - own, std::numeric_limits<float>::quiet_NaN());
  float* to = all.Append(own);
  for (std::size_t i = 0; i < mesh.Textures.size(); i += 6)
  {
    for (const std::size_t corner : { 0, isMirrored ? 2 : 1, isMirrored ? 1 : 2 })
    {
      to = std::copy_n(mesh.Textures.data() + i + 2 * corner, 2, to);
    }
  }
}

//------------------------------------------------------------------------------
bool GltfModel::ApplyCutouts()
{
  const bool isCut = helios::ApplyCutouts(this->Mesh, this->Cutouts, this->Report);
  this->Mesh.TextureCoordinates.Truncate(0);
  return isCut;
}

//------------------------------------------------------------------------------
int GltfModel::FindRow(int material)
{
  if (material >= 0)
  {
    return material;
  }
  if (this->DefaultRow < 0)
  {
    this->DefaultRow = static_cast<int>(this->Mesh.Materials.size());
    this->Mesh.Materials.emplace_back();
  }
  return this->DefaultRow;
}

//------------------------------------------------------------------------------
void GltfModel::WarnOfMotion()
{
  if (!this->Animation && this->Document.GetCount("skins") > 0)
  {
    this->Report.Warn(this->Document.GetPath() +
      ": skins[0]: skins are not applied, so meshes are where their nodes are; apply them before "
      "export");
  }
}

} // namespace helios
