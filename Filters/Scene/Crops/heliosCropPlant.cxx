// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCropPlant.h"

#include "heliosMeshBuilder.h"
#include "heliosRandom.h"
#include "heliosSyntheticMaterials.h"
#include "heliosSyntheticTree.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace helios
{

namespace
{

constexpr double TwoPi = 6.283185307179586;
constexpr double GoldenAngle = 2.399963229728653;
constexpr double Clearance = 1e-3; // [m] between leaves and the soil
constexpr double Root = 0.02;      // [m] of a stem below the soil
constexpr int EarSides = 6;
constexpr int PetioleSides = 3;

enum Draw : std::uint32_t
{
  PlantDraw = 110,
  StemDraw = 1000,    // and one per stem after it
  LeafDraw = 1u << 20 // two per leaf
};

/// The curve of a leaf, before triangulation.
struct LeafCurve
{
  Vec3 Base;
  Vec3 Outward; // horizontal, unit
  Vec3 Across;  // horizontal, unit
  double Angle; // [rad]
  double Droop;
  double Length;
  double Width;
};

class PlantMaker
{
public:
  PlantMaker(
    MeshBuilder& mesh, const CropShape& shape, const CropPlant& plant, const CropGround& ground)
    : Mesh(mesh)
    , Shape(shape)
    , Plant(plant)
    , Ground(ground)
    , Scale(plant.Height / shape.Height)
    , Azimuth(TwoPi * this->Uniform(PlantDraw)[0])
  {
  }

  double Add()
  {
    this->AddStems();
    double area = 0.0;
    for (int i = 0; i < this->Shape.Leaves; ++i)
    {
      area += this->AddLeaf(i);
    }
    return area;
  }

private:
  std::array<double, 4> Uniform(std::uint32_t draw) const
  {
    return Uniform4(this->Plant.Seed, RandomStream::Scene, this->Plant.Site, draw);
  }

  double GetStemHeight(int stem) const
  {
    const double share =
      stem == 0 ? 1.0 : 0.82 + 0.16 * this->Uniform(StemDraw + static_cast<std::uint32_t>(stem))[0];
    return share * this->Plant.Height;
  }

  /// Returns the lean of a stem increases with height.
  Vec3 GetStem(int stem, double share) const
  {
    const auto u = this->Uniform(StemDraw + static_cast<std::uint32_t>(stem));
    const double height = this->GetStemHeight(stem);
    const double azimuth = this->Azimuth + GoldenAngle * stem + u[1];
    const double away = (stem > 0 ? 1.5 * this->Shape.StemRadius * this->Scale : 0.0) +
      this->Shape.Lean * height * u[2] * share * share;
    return this->Plant.Position +
      Vec3(away * std::cos(azimuth), away * std::sin(azimuth), height * share);
  }

  void AddStems()
  {
    const double radius = this->Shape.StemRadius * this->Scale;
    this->Mesh.SetMaterial(synthetic::CropStem());
    for (int stem = 0; stem < this->Shape.Stems; ++stem)
    {
      const Vec3 foot = this->GetStem(stem, 0.0);
      AddTube(this->Mesh,
        { foot - Vec3(0, 0, Root), foot, this->GetStem(stem, 0.5), this->GetStem(stem, 1.0) },
        { radius, radius, 0.75 * radius }, this->Shape.StemSides);
    }
    if (this->Shape.EarLength > 0.0)
    {
      this->Mesh.SetMaterial(synthetic::CropEar());
      for (int stem = 0; stem < this->Shape.Stems; ++stem)
      {
        this->AddEar(stem);
      }
    }
  }

  void AddEar(int stem)
  {
    const double share =
      std::min(0.5, this->Shape.EarLength * this->Scale / this->GetStemHeight(stem));
    const double radius = 3.0 * this->Shape.StemRadius * this->Scale;
    AddTube(this->Mesh,
      { this->GetStem(stem, 1.0 - share), this->GetStem(stem, 1.0 - 0.75 * share),
        this->GetStem(stem, 1.0 - 0.3 * share), this->GetStem(stem, 1.0) },
      { 0.5 * radius, radius, 0.8 * radius }, EarSides);
  }

  double AddLeaf(int leaf)
  {
    const std::uint32_t draw = LeafDraw + 2 * static_cast<std::uint32_t>(leaf);
    LeafCurve curve = this->PlaceLeaf(leaf, draw);
    if (this->Shape.PetioleShare > 0.0)
    {
      const Vec3 end =
        curve.Base + GetDirection(curve, 0.0) * (this->Shape.PetioleShare * curve.Length);
      this->Mesh.SetMaterial(synthetic::CropStem());
      const double radius = 0.3 * this->Shape.StemRadius * this->Scale;
      AddTube(this->Mesh, { curve.Base, end }, { radius }, PetioleSides);
      curve.Base = end;
    }
    this->RaiseAboveGround(curve);
    this->Mesh.SetMaterial(synthetic::CropLeaf());
    return this->AddStrip(curve);
  }

  LeafCurve PlaceLeaf(int leaf, std::uint32_t draw) const
  {
    const auto u = this->Uniform(draw);
    const auto v = this->Uniform(draw + 1);
    const int stem = leaf % this->Shape.Stems;
    const int rank = leaf / this->Shape.Stems;
    const int ranks = (this->Shape.Leaves + this->Shape.Stems - 1) / this->Shape.Stems;
    const double level = (rank + 0.5) / ranks;
    const auto vary = [this](double uniform)
    { return 1.0 + this->Shape.LeafVariation * (2.0 * uniform - 1.0); };
    const double turn = this->Shape.IsAlternate ? 0.5 * TwoPi : GoldenAngle;
    const double azimuth = this->Azimuth + GoldenAngle * stem + turn * rank + 0.6 * (v[0] - 0.5);
    // The largest leaves are in the middle.
    const double size = this->Scale * (1.0 - 0.45 * (2.0 * level - 1.0) * (2.0 * level - 1.0));

    LeafCurve curve;
    curve.Outward = Vec3(std::cos(azimuth), std::sin(azimuth), 0.0);
    curve.Across = Vec3(-curve.Outward[1], curve.Outward[0], 0.0);
    curve.Base = this->GetStem(
      stem, this->Shape.LeavesFrom + (this->Shape.LeavesTo - this->Shape.LeavesFrom) * level);
    curve.Length = size * this->Shape.LeafLength * vary(u[0]);
    curve.Width = size * this->Shape.LeafWidth * vary(u[1]);
    curve.Angle = std::min(0.25 * TwoPi, this->Shape.LeafAngle * vary(u[2]));
    curve.Droop = std::min(0.5 * TwoPi - curve.Angle, this->Shape.LeafDroop * vary(u[3]));
    return curve;
  }

  static Vec3 GetDirection(const LeafCurve& curve, double share)
  {
    const double angle = curve.Angle + curve.Droop * share;
    return curve.Outward * std::sin(angle) + Vec3(0, 0, std::cos(angle));
  }

  /// Returns the vector from a point of the curve to the next: a chord of a circle.
  Vec3 GetStep(const LeafCurve& curve, int segment) const
  {
    const int n = this->Shape.LeafSegments;
    const double half = 0.5 * curve.Droop / n;
    const double chord = curve.Length / n * (half > 1e-9 ? std::sin(half) / half : 1.0);
    return GetDirection(curve, (segment + 0.5) / n) * chord;
  }

  /// Raises a leaf that would reach into the soil until it does not.
  void RaiseAboveGround(LeafCurve& curve) const
  {
    for (int i = 0; i < 40 && !this->IsAboveGround(curve); ++i)
    {
      const bool isLast = i == 39;
      curve.Angle *= isLast ? 0.0 : 0.85;
      curve.Droop *= isLast ? 0.0 : 0.85;
    }
    if (!this->IsAboveGround(curve)) // its base is in a clod
    {
      curve.Base[2] = this->Ground.GetHighest() + Clearance;
    }
  }

  bool IsAboveGround(const LeafCurve& curve) const
  {
    // Its lowest point is one of its ends: the angle from the vertical never exceeds pi.
    Vec3 point = curve.Base;
    for (int i = 0; i < this->Shape.LeafSegments; ++i)
    {
      point = point + this->GetStep(curve, i);
    }
    if (std::min(curve.Base[2], point[2]) >= this->Ground.GetHighest() + Clearance)
    {
      return true;
    }
    point = curve.Base;
    for (int i = 0; i <= this->Shape.LeafSegments; ++i)
    {
      const Vec3 half = curve.Across * this->GetHalfWidth(curve, i);
      for (const Vec3& p : { point - half, point, point + half })
      {
        if (p[2] < this->Ground.GetHeight(p[0], p[1]) + Clearance)
        {
          return false;
        }
      }
      point = point + (i < this->Shape.LeafSegments ? this->GetStep(curve, i) : Vec3(0, 0, 0));
    }
    return true;
  }

  double GetHalfWidth(const LeafCurve& curve, int ring) const
  {
    const double share = static_cast<double>(ring) / this->Shape.LeafSegments;
    return 0.5 * curve.Width * GetLeafWidth(share, this->Shape.WidestAt);
  }

  /// Adds flat trapezoids, a triangle at the tip, and one at the base if the leaf has zero width
  /// there.
  double AddStrip(const LeafCurve& curve)
  {
    const int n = this->Shape.LeafSegments;
    const bool isPointed = this->GetHalfWidth(curve, 0) <= 0.0;
    Vec3 point = curve.Base;
    vtkTypeInt32 left = this->AddRing(point, curve.Across * this->GetHalfWidth(curve, 0));
    double area = 0.0;
    for (int i = 0; i < n; ++i)
    {
      const Vec3 step = this->GetStep(curve, i);
      point = point + step;
      const double half = this->GetHalfWidth(curve, i + 1);
      const vtkTypeInt32 next = this->AddRing(point, curve.Across * half);
      const bool startsAtPoint = i == 0 && isPointed;
      const vtkTypeInt32 right = startsAtPoint ? left : left + 1;
      if (i + 1 == n)
      {
        this->Mesh.AddTriangle(left, right, next);
      }
      else if (startsAtPoint)
      {
        this->Mesh.AddTriangle(left, next + 1, next);
      }
      else
      {
        this->Mesh.AddQuad(left, right, next + 1, next);
      }
      area += step.Norm() * (this->GetHalfWidth(curve, i) + half);
      left = next;
    }
    return area;
  }

  /// Two points, or one at zero width. Returns the first.
  vtkTypeInt32 AddRing(const Vec3& centre, const Vec3& half)
  {
    const vtkTypeInt32 first = this->Mesh.AddPoint(centre - half);
    if (half.SquaredNorm() > 0.0)
    {
      this->Mesh.AddPoint(centre + half);
    }
    return first;
  }

  MeshBuilder& Mesh;
  const CropShape& Shape;
  const CropPlant& Plant;
  const CropGround& Ground;
  double Scale;
  double Azimuth;
};

/// Triangles of a tube with this many sides and rings: a cap, walls and a point.
vtkIdType CountTubeTriangles(int sides, int rings)
{
  return sides - 2 + 2 * sides * (rings - 1) + sides;
}

} // namespace

//------------------------------------------------------------------------------
double GetLeafWidth(double share, double widestAt)
{
  if (share >= 1.0)
  {
    return 0.0;
  }
  const double x = (share - widestAt) / (1.0 - widestAt);
  return 1.0 - x * x;
}

//------------------------------------------------------------------------------
vtkIdType CountTriangles(const CropShape& shape)
{
  const vtkIdType ear = shape.EarLength > 0.0 ? CountTubeTriangles(EarSides, 3) : 0;
  const vtkIdType petiole = shape.PetioleShare > 0.0 ? CountTubeTriangles(PetioleSides, 1) : 0;
  const vtkIdType ends = GetLeafWidth(0.0, shape.WidestAt) > 0.0 ? 1 : 2;
  return shape.Stems * (CountTubeTriangles(shape.StemSides, 3) + ear) +
    shape.Leaves * (petiole + 2 * vtkIdType{ shape.LeafSegments } - ends);
}

//------------------------------------------------------------------------------
vtkIdType CountPoints(const CropShape& shape)
{
  return shape.Stems * (3 * shape.StemSides + 3 * EarSides + vtkIdType{ 2 }) +
    shape.Leaves * (2 * vtkIdType{ shape.LeafSegments } + 1 + PetioleSides + 1);
}

//------------------------------------------------------------------------------
double AddCropPlant(
  MeshBuilder& mesh, const CropShape& shape, const CropPlant& plant, const CropGround& ground)
{
  return PlantMaker(mesh, shape, plant, ground).Add();
}

} // namespace helios
