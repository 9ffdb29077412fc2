// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCutouts.h"

#include "heliosMemoryCheck.h"
#include "heliosPose.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>

namespace helios
{

namespace
{

constexpr vtkIdType TrianglesPerCheck = 65536; // between checks of the memory

/// The corners of a triangle in space.
using Corners3 = std::array<Vec3, 3>;

double ComputeArea(const Corners3& corners)
{
  return 0.5 * (corners[1] - corners[0]).Cross(corners[2] - corners[0]).Norm();
}

/// The triangles of a material that is cut: counts, and the way it is done.
struct CutMaterial
{
  const Cutout* Source = nullptr;
  std::string Fault; // why triangles stay opaque
  std::unique_ptr<CutoutShape> Shape;
  std::vector<CutoutClipper> Clippers; // one per band
  std::vector<int> Rows;               // materials of the bands
  vtkIdType Triangles = 0;
  vtkIdType Pieces = 0;
  vtkIdType Opaque = 0;
  double Area = 0.0; // [m2]
  double AreaLeft = 0.0;
  double AreaOpaque = 0.0;
};

std::string Format(const char* format, double a, double b)
{
  char text[96];
  std::snprintf(text, sizeof(text), format, a, b);
  return text;
}

/// Cuts the triangles of a mesh.
class CutoutWork
{
public:
  CutoutWork(SceneMesh& mesh, TextReport& report)
    : Mesh(mesh)
    , Report(report)
  {
  }

  bool Apply(const std::vector<Cutout>& cutouts);

private:
  void Find(const std::vector<Cutout>& cutouts);
  void Prepare(CutMaterial& material);
  int AddRow(const CutMaterial& material, double opacity);
  Corners3 GetCorners(vtkIdType triangle);
  std::array<std::array<double, 2>, 3> GetTexture(vtkIdType triangle, bool isTopDown);
  bool Cut(vtkIdType triangle, CutMaterial& material);
  void AddPieces(vtkIdType triangle, int row, CutMaterial& material);
  void Move(vtkIdType from, vtkIdType to);
  bool Grow();
  bool CheckSize();
  void Truncate(vtkIdType kept);
  void AddNotes();
  void WarnOfOpaque();

  SceneMesh& Mesh;
  TextReport& Report;
  std::map<int, CutMaterial> Materials; // by row
  CutoutPieces Pieces;
  vtkIdType Checked = 0; // triangles at the last check

  // The new triangles.
  std::vector<vtkTypeInt32> Corners;
  std::vector<int> Rows;
  std::vector<int> Parts;
  std::vector<float> Textures;
};

//------------------------------------------------------------------------------
bool CutoutWork::Apply(const std::vector<Cutout>& cutouts)
{
  this->Find(cutouts);
  if (this->Materials.empty())
  {
    return true;
  }
  const vtkIdType count = this->Mesh.GetNumberOfTriangles();
  vtkIdType kept = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto found = this->Materials.find(this->Mesh.MaterialIds.GetValues()[i]);
    if (found == this->Materials.end() || !this->Cut(i, found->second))
    {
      this->Move(i, kept++);
    }
    if (!this->CheckSize())
    {
      return false;
    }
  }
  this->Truncate(kept);
  this->AddNotes();
  this->WarnOfOpaque();
  return true;
}

//------------------------------------------------------------------------------
/// Finds the materials that triangles have; of two cutouts of a material, the last one.
void CutoutWork::Find(const std::vector<Cutout>& cutouts)
{
  std::map<int, const Cutout*> sources;
  for (const Cutout& each : cutouts)
  {
    sources[each.Row] = &each;
  }
  const vtkIdType count = sources.empty() ? 0 : this->Mesh.GetNumberOfTriangles();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const int row = this->Mesh.MaterialIds.GetValues()[i];
    const auto found = sources.find(row);
    if (found != sources.end())
    {
      this->Materials[row].Source = found->second;
      sources.erase(found);
    }
  }
  for (auto& [row, material] : this->Materials)
  {
    this->Prepare(material);
  }
}

//------------------------------------------------------------------------------
void CutoutWork::Prepare(CutMaterial& material)
{
  const Cutout& source = *material.Source;
  material.Fault = source.Fault;
  MaskImage mask;
  if (material.Fault.empty())
  {
    material.Fault = ReadMask(source, mask).Message();
  }
  if (!material.Fault.empty())
  {
    return;
  }
  const Material& base = this->Mesh.Materials[static_cast<std::size_t>(source.Row)];
  const bool isPlain =
    base.Optics.Kind == OpticsKind::Opaque || base.Optics.Kind == OpticsKind::Leaf;
  const bool isBlended = source.IsBlended && isPlain && base.Spectrum.empty();
  if (source.IsBlended && !isBlended)
  {
    this->Report.Warn(source.Place + source.What + ": its opacity is cut at " +
      Format("%g", source.Threshold, 0.0) + ", as the material has " +
      (isPlain ? "a spectrum" : "optics of its own") + "; give it a reflectance to blend it");
  }
  material.Shape = std::make_unique<CutoutShape>(
    isBlended ? CutoutShape::Blend(mask) : CutoutShape::Cut(mask, source.Threshold));
  for (const CutoutBand& band : material.Shape->GetBands())
  {
    material.Clippers.emplace_back(band, source.Wrap);
    material.Rows.push_back(this->AddRow(material, band.Opacity));
  }
}

//------------------------------------------------------------------------------
/// Returns the row of a material of an opacity: a leaf that scatters and transmits accordingly.
int CutoutWork::AddRow(const CutMaterial& material, double opacity)
{
  const int row = material.Source->Row;
  if (opacity == 1.0)
  {
    return row;
  }
  Material made = this->Mesh.Materials[static_cast<std::size_t>(row)];
  made.Name += Format(" (opacity %.3g)", opacity, 0.0);
  made.Reflectance =
    opacity * (std::isnan(made.Reflectance) ? DefaultReflectance : made.Reflectance);
  const double before = made.Optics.Kind == OpticsKind::Leaf ? made.Optics.Transmittance : 0.0;
  made.Optics.Kind = OpticsKind::Leaf;
  made.Optics.Transmittance = 1.0 - opacity * (1.0 - before);
  this->Mesh.Materials.push_back(made);
  return static_cast<int>(this->Mesh.Materials.size()) - 1;
}

//------------------------------------------------------------------------------
Corners3 CutoutWork::GetCorners(vtkIdType triangle)
{
  const vtkTypeInt32* ids = this->Mesh.Corners.GetValues() + 3 * triangle;
  const auto get = [&](int corner)
  { return Vec3(this->Mesh.Points.GetValues() + 3 * static_cast<vtkIdType>(ids[corner])); };
  return { get(0), get(1), get(2) };
}

//------------------------------------------------------------------------------
std::array<std::array<double, 2>, 3> CutoutWork::GetTexture(vtkIdType triangle, bool isTopDown)
{
  const float* values = this->Mesh.TextureCoordinates.GetValues() + 6 * triangle;
  std::array<std::array<double, 2>, 3> corners{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double v = values[2 * i + 1];
    corners[i] = { values[2 * i], isTopDown ? 1.0 - v : v };
  }
  return corners;
}

//------------------------------------------------------------------------------
/// Adds what is left of a triangle; false if it stays as it is.
bool CutoutWork::Cut(vtkIdType triangle, CutMaterial& material)
{
  const double area = ComputeArea(this->GetCorners(triangle));
  const auto leave = [&](const char* fault)
  {
    material.Fault = material.Fault.empty() ? fault : material.Fault;
    material.Opaque += 1;
    material.AreaOpaque += area;
    return false;
  };
  if (!material.Shape)
  {
    return leave("");
  }
  const auto count = [&]()
  {
    material.Area += area;
    material.Triangles += 1;
  };
  if (material.Shape->IsWhole())
  {
    count();
    this->Mesh.MaterialIds.GetValues()[triangle] = material.Rows[0];
    material.AreaLeft += area;
    material.Pieces += 1;
    return false;
  }
  if (material.Clippers.empty())
  {
    count();
    return true; // nothing is left
  }
  const bool hasTexture = this->Mesh.TextureCoordinates.GetSize() > 0;
  const auto corners = hasTexture ? this->GetTexture(triangle, material.Source->IsTopDown)
                                  : std::array<std::array<double, 2>, 3>{};
  if (!hasTexture || !std::isfinite(corners[0][0] + corners[1][0] + corners[2][0]))
  {
    return leave("they have no texture coordinates; give them (vt)");
  }
  for (std::size_t band = 0; band < material.Clippers.size(); ++band)
  {
    if (!material.Clippers[band].Clip(corners, this->Pieces))
    {
      return leave("the texture repeats more than 4096 times over a triangle, or ends within it; "
                   "correct the texture coordinates");
    }
    this->AddPieces(triangle, material.Rows[band], material);
  }
  count();
  return true;
}

//------------------------------------------------------------------------------
void CutoutWork::AddPieces(vtkIdType triangle, int row, CutMaterial& material)
{
  const Corners3 corners = this->GetCorners(triangle);
  const Vec3 right = corners[1] - corners[0];
  const Vec3 up = corners[2] - corners[0];
  const auto first = static_cast<vtkTypeInt32>(this->Mesh.GetNumberOfPoints());
  for (const auto& point : this->Pieces.Points)
  {
    const Vec3 place = corners[0] + point[0] * right + point[1] * up;
    this->Mesh.AddPoint(place[0], place[1], place[2]);
  }
  const bool hasTextures = this->Mesh.TextureCoordinates.GetSize() > 0;
  const auto texture = this->GetTexture(triangle, false);
  const std::size_t count = this->Pieces.Corners.size() / 3;
  double area = 0.0; // share of the triangle
  for (std::size_t i = 0; i < this->Pieces.Corners.size(); ++i)
  {
    const int id = this->Pieces.Corners[i];
    const auto& point = this->Pieces.Points[static_cast<std::size_t>(id)];
    this->Corners.push_back(first + id);
    for (std::size_t axis = 0; hasTextures && axis < 2; ++axis)
    {
      this->Textures.push_back(
        static_cast<float>(texture[0][axis] + point[0] * (texture[1][axis] - texture[0][axis]) +
          point[1] * (texture[2][axis] - texture[0][axis])));
    }
    const auto& next =
      this->Pieces
        .Points[static_cast<std::size_t>(this->Pieces.Corners[i % 3 == 2 ? i - 2 : i + 1])];
    area += point[0] * next[1] - next[0] * point[1];
  }
  this->Rows.insert(this->Rows.end(), count, row);
  if (this->Mesh.PartIds.GetSize() > 0)
  {
    this->Parts.insert(this->Parts.end(), count, this->Mesh.PartIds.GetValues()[triangle]);
  }
  material.Pieces += static_cast<vtkIdType>(count);
  material.AreaLeft += area * ComputeArea(corners);
}

//------------------------------------------------------------------------------
void CutoutWork::Move(vtkIdType from, vtkIdType to)
{
  if (from == to)
  {
    return;
  }
  const auto move = [from, to](auto& array, int size)
  {
    if (array.GetSize() > 0)
    {
      std::copy_n(array.GetValues() + size * from, size, array.GetValues() + size * to);
    }
  };
  move(this->Mesh.Corners, 3);
  move(this->Mesh.MaterialIds, 1);
  move(this->Mesh.PartIds, 1);
  move(this->Mesh.TextureCoordinates, 6);
}

//------------------------------------------------------------------------------
bool CutoutWork::CheckSize()
{
  const auto count = static_cast<vtkIdType>(this->Rows.size());
  if (count < this->Checked + TrianglesPerCheck)
  {
    return true;
  }
  this->Checked = count;
  const Cutout& source = *this->Materials.begin()->second.Source;
  const std::string cure = "place trees as instances, or simplify the image";
  if (std::max<std::int64_t>(3 * count, this->Mesh.GetNumberOfPoints()) > MaximumCorners)
  {
    return this->Report.Fail(source.Place + source.What + ": it cuts more than " +
      std::to_string(MaximumCorners / 3) + " triangles; " + cure);
  }
  const Status status =
    CheckMemory("triangles cut by images", static_cast<double>(count), BytesPerTriangle);
  return status.IsOk() ||
    this->Report.Fail(source.Place + source.What + ": " + status.Message() + "; or " + cure);
}

//------------------------------------------------------------------------------
/// Puts the new triangles behind those that are left.
void CutoutWork::Truncate(vtkIdType kept)
{
  const auto finish = [kept](auto& array, int size, const auto& values)
  {
    array.Truncate(std::min(array.GetSize(), size * kept));
    if (!values.empty())
    {
      std::copy(values.begin(), values.end(), array.Append(static_cast<vtkIdType>(values.size())));
    }
  };
  finish(this->Mesh.Corners, 3, this->Corners);
  finish(this->Mesh.MaterialIds, 1, this->Rows);
  finish(this->Mesh.PartIds, 1, this->Parts);
  finish(this->Mesh.TextureCoordinates, 6, this->Textures);
}

//------------------------------------------------------------------------------
void CutoutWork::AddNotes()
{
  for (const auto& [row, material] : this->Materials)
  {
    if (material.Triangles > 0)
    {
      const double share = material.Area > 0.0 ? material.AreaLeft / material.Area : 0.0;
      this->Mesh.Notes.push_back(material.Source->What + " leaves " +
        Format("%.3g %% of %.4g m2", 100.0 * share, material.Area) + ": " +
        std::to_string(material.Triangles) + " -> " + std::to_string(material.Pieces) +
        " triangles");
    }
  }
}

//------------------------------------------------------------------------------
/// Warns once of the triangles that are scanned as opaque, if there are any.
void CutoutWork::WarnOfOpaque()
{
  const CutMaterial* first = nullptr;
  vtkIdType triangles = 0;
  double area = 0.0;
  std::size_t materials = 0;
  for (const auto& [row, material] : this->Materials)
  {
    if (material.Opaque > 0)
    {
      first = first ? first : &material;
      triangles += material.Opaque;
      area += material.AreaOpaque;
      ++materials;
    }
  }
  if (first)
  {
    this->Report.Warn(first->Source->Place + first->Source->What +
      " is not applied: " + std::to_string(triangles) + " triangle" + (triangles == 1 ? "" : "s") +
      Format(", %.3g m2", area, 0.0) + ", of " + std::to_string(materials) + " material" +
      (materials == 1 ? " is" : "s are") + " scanned as opaque: " + first->Fault);
  }
}

} // namespace

//------------------------------------------------------------------------------
bool ApplyCutouts(SceneMesh& mesh, const std::vector<Cutout>& cutouts, TextReport& report)
{
  return CutoutWork(mesh, report).Apply(cutouts);
}

//------------------------------------------------------------------------------
bool HasCutouts(SceneMesh& mesh, const std::vector<Cutout>& cutouts)
{
  const int* ids = mesh.MaterialIds.GetValues();
  return std::any_of(cutouts.begin(), cutouts.end(),
    [&](const Cutout& each)
    {
      return std::find(ids, ids + mesh.GetNumberOfTriangles(), each.Row) !=
        ids + mesh.GetNumberOfTriangles();
    });
}

} // namespace helios
