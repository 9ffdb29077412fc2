// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSyntheticTree.h"

#include "heliosMeshBuilder.h"
#include "heliosRandom.h"
#include "heliosSyntheticMaterials.h"
#include "heliosSyntheticTerrain.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace helios
{

namespace
{

constexpr double TwoPi = 6.283185307179586;

Vec3 AnyPerpendicular(const Vec3& v)
{
  Vec3 p = std::abs(v[2]) < 0.9 * v.Norm() ? v.Cross({ 0, 0, 1 }) : v.Cross({ 1, 0, 0 });
  p.Normalize();
  return p;
}

} // namespace

//------------------------------------------------------------------------------
void AddTube(
  MeshBuilder& mesh, const std::vector<Vec3>& path, const std::vector<double>& radii, int sides)
{
  std::vector<vtkTypeInt32> last;
  Vec3 normal = AnyPerpendicular(path[1] - path[0]);
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    Vec3 tangent = path[i + 1] - path[i > 0 ? i - 1 : 0];
    tangent.Normalize();
    normal = normal - tangent * tangent.Dot(normal); // transported without twist
    normal.Normalize();
    const Vec3 binormal = tangent.Cross(normal);
    std::vector<vtkTypeInt32> ring;
    for (int k = 0; k < sides; ++k)
    {
      const double angle = TwoPi * k / sides;
      ring.push_back(mesh.AddPoint(
        path[i] + (normal * std::cos(angle) + binormal * std::sin(angle)) * radii[i]));
    }
    for (int k = 0; k < sides && i > 0; ++k)
    {
      const int next = (k + 1) % sides;
      mesh.AddQuad(last[k], last[next], ring[next], ring[k]);
    }
    if (i == 0)
    {
      mesh.AddPolygon({ ring.rbegin(), ring.rend() });
    }
    last = std::move(ring);
  }
  const vtkTypeInt32 tip = mesh.AddPoint(path.back());
  for (int k = 0; k < sides; ++k)
  {
    mesh.AddTriangle(last[k], last[(k + 1) % sides], tip);
  }
}

namespace
{

constexpr double GoldenAngle = 2.399963229728653; // no two branches above one another

/// The random numbers of one tree. Branches, leaves and twigs draw from separate elements.
struct TreeRandom
{
  std::uint64_t Seed;
  std::uint64_t Tree;

  std::array<double, 4> Uniform(int element, std::uint32_t draw) const
  {
    return Uniform4(this->Seed, RandomStream::Scene, this->GetItem(element), draw);
  }
  Vec3 Normal(int element, std::uint32_t draw) const
  {
    const auto a = NormalPair(this->Seed, RandomStream::Scene, this->GetItem(element), draw);
    const auto b = NormalPair(this->Seed, RandomStream::Scene, this->GetItem(element), draw + 1);
    return { a[0], a[1], b[0] };
  }

private:
  std::uint64_t GetItem(int element) const
  {
    return ((this->Tree + 1) << 32) | static_cast<std::uint32_t>(element);
  }
};

enum Draw : std::uint32_t
{
  BranchDraw = 10,
  TwigDraw = 20, // and one per twig of a branch after it
  LeafDraw = 40  // to 45
};

/// Adds a diamond of two triangles; the normal and the length's direction need not be
/// perpendicular.
void AddLeaf(MeshBuilder& mesh, const Vec3& centre, Vec3 normal, const Vec3& along, double length,
  double width)
{
  normal.Normalize();
  Vec3 u = along - normal * normal.Dot(along);
  u.Normalize();
  const Vec3 v = normal.Cross(u) * (0.5 * width);
  u = u * (0.5 * length);
  const vtkTypeInt32 a = mesh.AddPoint(centre - u);
  mesh.AddPoint(centre - v);
  mesh.AddPoint(centre + u);
  mesh.AddPoint(centre + v);
  mesh.AddQuad(a, a + 1, a + 2, a + 3);
}

/// Returns the length of diamonds of this slenderness (width to length) with a total area of index
/// times the crown.
double GetLeafLength(const TreeShape& shape, double areaIndex, double slenderness)
{
  const double ground = 0.125 * TwoPi * shape.CrownDiameter * shape.CrownDiameter;
  const double leaf = areaIndex * ground / std::max(1, shape.NumberOfLeaves);
  return std::min(std::sqrt(leaf / (0.5 * slenderness)), 0.25 * shape.CrownDiameter);
}

/// A tree or shrub whose crown is an ellipsoid.
class RoundCrown
{
public:
  RoundCrown(MeshBuilder& mesh, const TreeShape& shape, const TreeRandom& random)
    : Mesh(mesh)
    , Shape(shape)
    , Random(random)
    , IsShrub(shape.Kind == Species::Shrub)
    , Centre(0, 0, (this->IsShrub ? 0.52 : 0.6) * shape.Height)
    , Axes(0.5 * shape.CrownDiameter, 0.5 * shape.CrownDiameter, shape.Height - this->Centre[2])
    , StemRadius(shape.Height / (this->IsShrub ? 80.0 : 50.0))
  {
  }

  void Add()
  {
    this->Mesh.SetMaterial(this->IsShrub ? synthetic::Stem() : synthetic::Bark());
    if (!this->IsShrub)
    {
      this->AddStem();
    }
    for (int i = 0; i < NumberOfBranches; ++i)
    {
      this->AddBranch(i);
    }
    this->Mesh.SetMaterial(this->IsShrub ? synthetic::ShrubLeaf() : synthetic::Leaf());
    const double length = GetLeafLength(this->Shape, 3.0, 0.6);
    for (int i = 0; i < this->Shape.NumberOfLeaves; ++i)
    {
      this->AddOneLeaf(i, length);
    }
  }

private:
  static constexpr int NumberOfBranches = 20;
  static constexpr int TwigsPerBranch = 5;

  /// Returns the position of the stem at a share of its length, slightly crooked.
  Vec3 GetStem(double share) const
  {
    const double bend = 0.02 * this->Shape.Height * share * share;
    const auto u = this->Random.Uniform(0, BranchDraw);
    return { bend * std::cos(TwoPi * u[0] + 5.0 * share),
      bend * std::sin(TwoPi * u[0] + 5.0 * share), 0.85 * this->Shape.Height * share };
  }

  void AddStem()
  {
    std::vector<Vec3> path{ { 0, 0, 0 }, { 0, 0, 0.03 * this->Shape.Height } };
    std::vector<double> radii{ 1.5 * this->StemRadius, this->StemRadius };
    for (const double share : { 0.2, 0.4, 0.6, 0.8, 1.0 })
    {
      path.push_back(this->GetStem(share));
      radii.push_back(this->StemRadius * (1.0 - 0.8 * share));
    }
    AddTube(this->Mesh, path, radii, 8);
  }

  void AddBranch(int branch)
  {
    const auto u = this->Random.Uniform(branch, BranchDraw);
    const double level = (branch + 0.5) / NumberOfBranches; // from the lowest to the highest
    const double azimuth = GoldenAngle * branch + TwoPi * this->Random.Uniform(0, BranchDraw)[1];
    const double sinTilt = -0.5 + 1.4 * level + 0.1 * (u[0] - 0.5);
    const double cosTilt = std::sqrt(1.0 - sinTilt * sinTilt);
    const Vec3 direction(cosTilt * std::cos(azimuth), cosTilt * std::sin(azimuth), sinTilt);
    const Vec3 start = this->IsShrub ? direction * Vec3(1, 1, 0) * (0.03 * this->Shape.Height)
                                     : this->GetStem(0.3 + 0.55 * level);
    const Vec3 end = this->Centre + direction * this->Axes * (0.62 + 0.3 * u[1]);
    // A quadratic curve, steep at the stem.
    const Vec3 middle = start + (end - start) * 0.4 + Vec3(0, 0, 0.12 * (end - start).Norm());
    std::vector<Vec3> path;
    for (const double t : { 0.0, 0.3, 0.65, 1.0 })
    {
      path.push_back(start * ((1 - t) * (1 - t)) + middle * (2 * t * (1 - t)) + end * (t * t));
    }
    const double radius = this->StemRadius * (this->IsShrub ? 1.0 : 0.45 - 0.25 * level);
    AddTube(this->Mesh, path, { radius, 0.75 * radius, 0.45 * radius }, 5);
    this->Anchors.push_back(end);
    for (int twig = 0; twig < TwigsPerBranch; ++twig)
    {
      this->AddTwig(branch, twig, path[1] + (path[3] - path[1]) * ((twig + 0.5) / TwigsPerBranch),
        0.3 * radius);
    }
  }

  void AddTwig(int branch, int twig, const Vec3& start, double radius)
  {
    const auto u = this->Random.Uniform(branch, TwigDraw + static_cast<std::uint32_t>(twig));
    const double z = 1.6 * u[0] - 0.6;
    const double azimuth = TwoPi * u[1];
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    const double length = (0.2 + 0.25 * u[2]) * this->Axes[0];
    const Vec3 end =
      this->MoveInside(start + Vec3(r * std::cos(azimuth), r * std::sin(azimuth), z) * length);
    AddTube(this->Mesh, { start, end }, { radius }, 3);
    this->Anchors.push_back(end);
  }

  void AddOneLeaf(int leaf, double length)
  {
    const auto u = this->Random.Uniform(leaf, LeafDraw);
    const auto anchor = static_cast<std::size_t>(u[0] * static_cast<double>(this->Anchors.size()));
    const Vec3 offset = this->Random.Normal(leaf, LeafDraw + 1) * (0.1 * this->Axes[0]);
    const Vec3 centre = this->MoveInside(this->Anchors[anchor] + offset);
    AddLeaf(this->Mesh, centre, this->Random.Normal(leaf, LeafDraw + 3),
      { u[1] - 0.5, u[2] - 0.5, u[3] - 0.5 }, length, 0.6 * length);
  }

  /// Returns the point itself, or if it is not inside the crown, the nearest one in the crown's
  /// metric.
  Vec3 MoveInside(const Vec3& point) const
  {
    const Vec3 p = (point - this->Centre) / this->Axes;
    const double norm = p.Norm();
    return norm < 0.97 ? point : this->Centre + p * this->Axes * (0.97 / norm);
  }

  MeshBuilder& Mesh;
  const TreeShape& Shape;
  const TreeRandom& Random;
  bool IsShrub;
  Vec3 Centre; // centre of the crown
  Vec3 Axes;
  double StemRadius;
  std::vector<Vec3> Anchors; // ends of branches and twigs, around which leaves are placed
};

/// A tree of whorls of branches, its crown a cone.
class ConicCrown
{
public:
  ConicCrown(MeshBuilder& mesh, const TreeShape& shape, const TreeRandom& random)
    : Mesh(mesh)
    , Shape(shape)
    , Random(random)
  {
  }

  void Add()
  {
    const double height = this->Shape.Height;
    const double radius = height / 60.0;
    this->Mesh.SetMaterial(synthetic::Bark());
    AddTube(this->Mesh, { { 0, 0, 0 }, { 0, 0, 0.03 * height }, { 0, 0, height } },
      { 1.5 * radius, radius }, 8);
    for (int i = 0; i < Whorls * BranchesPerWhorl; ++i)
    {
      this->AddBranch(i);
    }
    this->Mesh.SetMaterial(synthetic::Needle());
    const double length = GetLeafLength(this->Shape, 4.0, 0.4);
    for (int i = 0; i < this->Shape.NumberOfLeaves; ++i)
    {
      this->AddSpray(i, length);
    }
  }

private:
  static constexpr int Whorls = 24;
  static constexpr int BranchesPerWhorl = 6;

  struct Branch
  {
    Vec3 Start;
    Vec3 Direction; // horizontal
    double Length;
    double Room; // for sprays on this branch and all below

    /// Returns a point of a drooping branch with a rising end.
    Vec3 GetPoint(double share) const
    {
      const double drop = this->Length * (0.5 * share - 0.3 * share * share);
      return this->Start + this->Direction * (this->Length * share) - Vec3(0, 0, drop);
    }
  };

  void AddBranch(int index)
  {
    const auto u = this->Random.Uniform(index, BranchDraw);
    const int whorl = index / BranchesPerWhorl;
    const double level = (whorl + 0.6 * u[0]) / Whorls; // 0 below, 1 above
    const double azimuth = GoldenAngle * index + 0.5 * u[1];
    Branch branch;
    branch.Start = Vec3(0, 0, this->Shape.Height * (0.12 + 0.86 * level));
    branch.Direction = Vec3(std::cos(azimuth), std::sin(azimuth), 0);
    branch.Length = 0.5 * this->Shape.CrownDiameter * (1.0 - 0.95 * level) * (0.8 + 0.2 * u[2]);
    branch.Room = std::pow(branch.Length, 1.5);
    branch.Room += this->Branches.empty() ? 0.0 : this->Branches.back().Room;
    const double radius = 0.015 * branch.Length + 0.004;
    AddTube(this->Mesh, { branch.GetPoint(0), branch.GetPoint(0.5), branch.GetPoint(1) },
      { radius, 0.6 * radius }, 3);
    this->Branches.push_back(branch);
  }

  void AddSpray(int leaf, double length)
  {
    const auto u = this->Random.Uniform(leaf, LeafDraw);
    const Branch& branch = *std::upper_bound(this->Branches.begin(), this->Branches.end() - 1,
      u[0] * this->Branches.back().Room,
      [](double room, const Branch& candidate) { return room < candidate.Room; });
    const double share = 0.1 + 0.9 * std::sqrt(u[1]);
    const double side = (u[2] - 0.5) * 0.6 * branch.Length * (1.05 - share);
    const Vec3 across(-branch.Direction[1], branch.Direction[0], 0);
    const Vec3 centre = branch.GetPoint(share) + across * side -
      Vec3(0, 0, 0.15 * std::abs(side) + 0.3 * length * u[3]);
    const Vec3 tilt = this->Random.Normal(leaf, LeafDraw + 1) * 0.6;
    const Vec3 along = branch.Direction + across * (side > 0 ? 0.8 : -0.8);
    AddLeaf(this->Mesh, centre, Vec3(0, 0, 1) + tilt, along, length, 0.4 * length);
  }

  MeshBuilder& Mesh;
  const TreeShape& Shape;
  const TreeRandom& Random;
  std::vector<Branch> Branches;
};

} // namespace

//------------------------------------------------------------------------------
void AddTree(MeshBuilder& mesh, const TreeShape& shape, vtkIdType seed, vtkIdType number)
{
  const TreeRandom random{ static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(number) };
  if (shape.Kind == Species::Conifer)
  {
    ConicCrown(mesh, shape, random).Add();
  }
  else
  {
    RoundCrown(mesh, shape, random).Add();
  }
}

//------------------------------------------------------------------------------
void AddForest(MeshBuilder& mesh, const Terrain& terrain, double side, const TreeShape& shape,
  int numberOfTrees, vtkIdType seed)
{
  const int columns = static_cast<int>(std::ceil(std::sqrt(numberOfTrees)));
  const int rows = columns > 0 ? (numberOfTrees + columns - 1) / columns : 0;
  for (int i = 0; i < numberOfTrees; ++i)
  {
    const auto key = static_cast<std::uint64_t>(seed);
    const auto u = Uniform4(key, RandomStream::Scene, static_cast<std::uint64_t>(i), 2);
    const auto v = Uniform4(key, RandomStream::Scene, static_cast<std::uint64_t>(i), 3);
    const double x = side * ((i % columns + 0.2 + 0.6 * u[0]) / columns - 0.5);
    const int row = i / columns;
    const double y = side * ((row + 0.2 + 0.6 * u[1]) / rows - 0.5);
    const double scale = 0.7 + 0.3 * u[2];
    TreeShape tree = shape;
    tree.Kind = v[0] < 0.7 ? Species::Broadleaf : Species::Conifer;
    tree.Height *= scale;
    tree.CrownDiameter *= tree.Kind == Species::Conifer ? 0.75 * scale : scale;
    // Slightly below the ground, to avoid gaps on slopes.
    const double z = terrain.GetHeight(x, y) - 0.01 * tree.Height;
    mesh.SetFrame({ { x, y, z }, AxisAngle({ 0, 0, 1 }, 360.0 * u[3]) });
    AddTree(mesh, tree, seed, i);
  }
  mesh.SetFrame(Pose());
}

} // namespace helios
