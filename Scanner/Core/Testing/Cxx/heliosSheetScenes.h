// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Random sheets closely above the ground, in a beam from above.

#ifndef heliosSheetScenes_h
#define heliosSheetScenes_h

#include "heliosPose.h"
#include "heliosRandom.h"
#include "heliosTestRasters.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace helios
{
namespace testing
{

/// Kind of sheet that ends in the beam. Lengths are in footprint radii (1/e2), along and across a
/// random direction.
enum class SheetKind
{
  HalfPlane,
  Strip,
  Leaf,
  Slit,
  Corner,
  Step,     // joined to the ground by its riser
  Flap,     // joined to the ground by an edge of both
  Crossing, // a strip through the ground
  Board     // a box without a bottom
};
constexpr std::array<const char*, 9> SheetNames = { "half plane", "strip", "leaf", "slit", "corner",
  "step", "flap", "crossing", "board" };

enum class GroundKind
{
  Triangle,
  Mesh,
  Raster,
  Instance
};
constexpr std::array<const char*, 4> GroundNames = { "one triangle", "many triangles",
  "height field", "instance" };

/// Random numbers of a scene.
class SheetDice
{
public:
  explicit SheetDice(std::uint64_t seed)
    : Seed(seed)
  {
  }
  double operator()(double low, double high)
  {
    return low + (high - low) * Uniform4(this->Seed, RandomStream::Scene, this->Index++, 5)[0];
  }

private:
  std::uint64_t Seed;
  std::uint64_t Index = 0;
};

/// A mesh under construction; z is up, the beam comes down at the origin.
class SheetScene
{
public:
  /// Makes a scene for a footprint radius [m], a gap between sheet and ground [m], and the steepest
  /// ground.
  SheetScene(std::uint64_t seed, double radius, double gap, double slope = 0.2)
    : Dice(seed)
    , Radius(radius)
    , Gap(gap)
    , Turn(Dice(0.0, 2.0 * vtkMath::Pi()))
    , Slope{ Dice(-slope, slope), Dice(-slope, slope) }
    , Tilt{ Dice(-0.02, 0.02), Dice(-0.02, 0.02) }
  {
    this->Points->SetDataTypeToDouble();
    this->Materials->SetName(vtkHeliosArrayNames::MaterialIds);
  }

  /// The sheet has material 0, a ground in the mesh material 1.
  vtkSmartPointer<vtkHeliosScene> Make(SheetKind sheet, GroundKind ground)
  {
    this->AddSheet(sheet);
    this->SetMaterial(0);
    auto scene = vtkSmartPointer<vtkHeliosScene>::New();
    this->AddGround(ground, *scene);
    this->SetMaterial(1);
    scene->SetPoints(this->Points);
    scene->SetPolys(this->Polys);
    scene->GetCellData()->AddArray(this->Materials);
    return scene;
  }

private:
  double GetGround(double x, double y) const { return this->Slope[0] * x + this->Slope[1] * y; }

  /// A point at a height above the ground, in radii; the tilt of a sheet is small.
  Vec3 GetPoint(double along, double across, double height) const
  {
    const double u = this->Radius * along;
    const double v = this->Radius * across;
    const double x = u * std::cos(this->Turn) - v * std::sin(this->Turn);
    const double y = u * std::sin(this->Turn) + v * std::cos(this->Turn);
    const double tilt = height * (this->Tilt[0] * along + this->Tilt[1] * across);
    return { x, y, this->GetGround(x, y) + height + tilt };
  }

  /// Sets the material of the triangles that were added since the last call.
  void SetMaterial(int material)
  {
    while (this->Materials->GetNumberOfTuples() < this->Polys->GetNumberOfCells())
    {
      this->Materials->InsertNextValue(material);
    }
  }

  void AddTriangle(const Vec3& a, const Vec3& b, const Vec3& c)
  {
    const vtkIdType first = this->Points->InsertNextPoint(a.GetData());
    this->Points->InsertNextPoint(b.GetData());
    this->Points->InsertNextPoint(c.GetData());
    this->Polys->InsertNextCell({ first, first + 1, first + 2 });
  }

  void AddQuad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
  {
    this->AddTriangle(a, b, c);
    this->AddTriangle(a, c, d);
  }

  /// A rectangle above the ground, between two places along and two across.
  void AddRectangle(double left, double right, double low, double high)
  {
    const double h = this->Gap;
    this->AddQuad(this->GetPoint(left, low, h), this->GetPoint(right, low, h),
      this->GetPoint(right, high, h), this->GetPoint(left, high, h));
  }

  void AddSheet(SheetKind kind)
  {
    constexpr double far = 20.0;
    const double edge = this->Dice(-1.3, 1.3);
    const double width = this->Dice(0.05, 1.0);
    const double other = this->Dice(-1.3, 1.3);
    const double height = this->Dice(0.1, 1.0);
    switch (kind)
    {
      case SheetKind::HalfPlane:
        this->AddRectangle(edge, far, -far, far);
        break;
      case SheetKind::Strip:
        this->AddRectangle(edge, edge + width, -far, far);
        break;
      case SheetKind::Leaf:
        this->AddRectangle(edge, edge + width, other, other + height);
        break;
      case SheetKind::Slit:
        this->AddRectangle(-far, edge, -far, far);
        this->AddRectangle(edge + width, far, -far, far);
        break;
      case SheetKind::Corner:
        this->AddRectangle(edge, far, other, far);
        break;
      case SheetKind::Step:
        this->AddRectangle(edge, far, -far, far);
        this->AddQuad(this->GetPoint(edge, -far, 0.0), this->GetPoint(edge, far, 0.0),
          this->GetPoint(edge, far, this->Gap), this->GetPoint(edge, -far, this->Gap));
        break;
      case SheetKind::Flap:
        this->AddQuad(this->GetPoint(edge, -far, 0.0), this->GetPoint(edge, far, 0.0),
          this->GetPoint(edge + 1.5, far, this->Gap), this->GetPoint(edge + 1.5, -far, this->Gap));
        break;
      case SheetKind::Crossing:
        this->AddQuad(this->GetPoint(edge, -far, -this->Gap), this->GetPoint(edge, far, -this->Gap),
          this->GetPoint(edge + width, far, this->Gap),
          this->GetPoint(edge + width, -far, this->Gap));
        break;
      case SheetKind::Board:
        this->AddRectangle(edge, edge + width, other, other + height);
        for (const double side : { edge, edge + width })
        {
          this->AddQuad(this->GetPoint(side, other, 0.0), this->GetPoint(side, other + height, 0.0),
            this->GetPoint(side, other + height, this->Gap),
            this->GetPoint(side, other, this->Gap));
        }
        break;
    }
  }

  /// A grid whose vertices are in the plane of the ground.
  void AddGrid(vtkPoints* points, vtkCellArray* polys, double size, int count) const
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (int i = 0; i <= count; ++i)
    {
      for (int k = 0; k <= count; ++k)
      {
        const double x = size * (i - 0.5 * count + 0.31);
        const double y = size * (k - 0.5 * count + 0.17);
        points->InsertNextPoint(x, y, this->GetGround(x, y));
      }
    }
    for (int i = 0; i < count; ++i)
    {
      for (int k = 0; k < count; ++k)
      {
        const vtkIdType a = first + i * (count + 1) + k;
        polys->InsertNextCell({ a, a + 1, a + count + 2 });
        polys->InsertNextCell({ a, a + count + 2, a + count + 1 });
      }
    }
  }

  vtkSmartPointer<vtkDataSet> MakeRaster(double size, int count) const
  {
    const double corner = -size * (0.5 * count + 0.27);
    HeightRaster raster(count, count, { corner, size, 0, -corner, 0, -size });
    for (int row = 0; row < count; ++row)
    {
      for (int column = 0; column < count; ++column)
      {
        const double x = corner + size * (column + 0.5);
        const double y = -corner - size * (row + 0.5);
        raster.At(column, row) = this->GetGround(x, y);
      }
    }
    return raster.MakeImage<vtkDoubleArray>();
  }

  static vtkSmartPointer<vtkPolyData> MakeInstance()
  {
    auto places = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->InsertNextPoint(0, 0, 0);
    places->SetPoints(points);
    vtkNew<vtkIntArray> ids;
    ids->SetName(vtkHeliosArrayNames::PrototypeIds);
    ids->InsertNextValue(0);
    places->GetPointData()->AddArray(ids);
    return places;
  }

  void AddGround(GroundKind kind, vtkHeliosScene& scene)
  {
    const double size = this->Radius * std::pow(10.0, this->Dice(-0.5, 1.0));
    constexpr int count = 30;
    const double far = 200.0 * this->Radius;
    switch (kind)
    {
      case GroundKind::Triangle:
        this->AddTriangle({ -far, -far, this->GetGround(-far, -far) },
          { far, -far, this->GetGround(far, -far) }, { 0, far, this->GetGround(0, far) });
        break;
      case GroundKind::Mesh:
        this->AddGrid(this->Points, this->Polys, size, count);
        break;
      case GroundKind::Raster:
        scene.AddPrototype(this->MakeRaster(size, count));
        scene.SetInstances(MakeInstance());
        break;
      case GroundKind::Instance:
      {
        vtkNew<vtkPolyData> grid;
        vtkNew<vtkPoints> points;
        points->SetDataTypeToDouble();
        vtkNew<vtkCellArray> polys;
        this->AddGrid(points, polys, size, count);
        grid->SetPoints(points);
        grid->SetPolys(polys);
        scene.AddPrototype(grid);
        scene.SetInstances(MakeInstance());
        break;
      }
    }
  }

  SheetDice Dice;
  double Radius;
  double Gap;
  double Turn;
  double Slope[2];
  double Tilt[2];
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Polys;
  vtkNew<vtkIntArray> Materials;
};

} // namespace testing
} // namespace helios

#endif
