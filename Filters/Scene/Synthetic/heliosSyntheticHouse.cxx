// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSyntheticHouse.h"

#include "heliosMeshBuilder.h"
#include "heliosSyntheticMaterials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace helios
{

namespace
{

constexpr double RecessDepth = 0.15;
constexpr double RoofThickness = 0.2;
constexpr double Overhang = 0.5;
constexpr double WindowWidth = 1.1;
constexpr double DoorTop = 2.1;

/// A recessed rectangle of a wall: a window or a door.
struct Opening
{
  double Left;
  double Right;
  double Bottom;
  double Top;
  bool IsDoor;

  bool Contains(double along, double up) const
  {
    return along > this->Left && along < this->Right && up > this->Bottom && up < this->Top;
  }
};

/// A wall from corner to corner, left to right as seen from outside.
struct Wall
{
  Vec3 From;
  Vec3 To;
  double Length;
  std::vector<Opening> Openings;

  Wall(const Vec3& from, const Vec3& to)
    : From(from)
    , To(to)
    , Length((to - from).Norm())
  {
  }

  Vec3 GetPoint(double along, double up, double depth) const
  {
    const Vec3 direction = (this->To - this->From) * (1.0 / this->Length);
    const Vec3 base = along == this->Length
      ? this->To
      : this->From + direction * along; // meets the next wall exactly
    return { base[0] - direction[1] * depth, base[1] + direction[0] * depth, up };
  }
};

std::vector<double> SortedUnique(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// The body of the house: walls, floor and top, with shared points.
class Body
{
public:
  Body(MeshBuilder& mesh, double length, double width, double eaves, double ridge)
    : Mesh(mesh)
    , Eaves(eaves)
    , Ridge(ridge)
    , HalfLength(0.5 * length)
  {
    const double x = 0.5 * width;
    const double y = 0.5 * length;
    const Vec3 corners[4] = { { x, -y, 0 }, { x, y, 0 }, { -x, y, 0 }, { -x, -y, 0 } };
    for (int i = 0; i < 4; ++i)
    {
      this->Walls.emplace_back(corners[i], corners[(i + 1) % 4]);
    }
  }

  void Add()
  {
    this->PlaceOpenings();
    std::vector<double> levels{ 0.0, this->Eaves };
    for (const Wall& wall : this->Walls)
    {
      for (const Opening& opening : wall.Openings)
      {
        levels.insert(levels.end(), { opening.Bottom, opening.Top });
      }
    }
    levels = SortedUnique(levels); // all walls share the points of their edges
    for (const Wall& wall : this->Walls)
    {
      this->AddWall(wall, levels);
    }
    this->AddTopAndFloor();
  }

private:
  void PlaceOpenings()
  {
    for (std::size_t i = 0; i < this->Walls.size(); ++i)
    {
      Wall& wall = this->Walls[i];
      const int columns = static_cast<int>((wall.Length - 1.0) / 2.4);
      for (int column = 0; column < columns; ++column)
      {
        const double centre = wall.Length * (column + 0.5) / columns;
        const double left = centre - 0.5 * WindowWidth;
        const double right = centre + 0.5 * WindowWidth;
        const bool isDoor = i == 0 && column == columns / 2;
        const Opening low{ left, right, isDoor ? 0.0 : 0.9, DoorTop, isDoor };
        for (double floor = 0.0; floor + DoorTop + 0.2 < this->Eaves; floor += 2.7)
        {
          wall.Openings.push_back(
            floor == 0.0 ? low : Opening{ left, right, floor + 0.9, floor + DoorTop, false });
        }
      }
    }
  }

  /// Adds the cells between the cuts of all openings; cells of an opening are recessed, with
  /// reveals at its rim.
  void AddWall(const Wall& wall, const std::vector<double>& ups)
  {
    std::vector<double> alongs{ 0.0, wall.Length };
    for (const Opening& opening : wall.Openings)
    {
      alongs.insert(alongs.end(), { opening.Left, opening.Right });
    }
    alongs = SortedUnique(alongs);
    for (std::size_t i = 0; i + 1 < alongs.size(); ++i)
    {
      for (std::size_t k = 0; k + 1 < ups.size(); ++k)
      {
        const std::array<double, 4> cell{ alongs[i], alongs[i + 1], ups[k], ups[k + 1] };
        const auto opening = std::find_if(wall.Openings.begin(), wall.Openings.end(),
          [&cell](const Opening& o)
          { return o.Contains(0.5 * (cell[0] + cell[1]), 0.5 * (cell[2] + cell[3])); });
        this->AddCell(wall, cell, opening == wall.Openings.end() ? nullptr : &*opening);
      }
    }
    this->AddRim(wall, alongs, 0.0, this->Floor);
    this->AddRim(wall, alongs, this->Eaves, this->Top);
  }

  void AddCell(const Wall& wall, const std::array<double, 4>& cell, const Opening* opening)
  {
    // Around the cell from its lower left, counter-clockwise as seen from outside.
    const std::array<vtkVector2d, 4> corners{ vtkVector2d(cell[0], cell[2]),
      vtkVector2d(cell[1], cell[2]), vtkVector2d(cell[1], cell[3]), vtkVector2d(cell[0], cell[3]) };
    std::array<vtkTypeInt32, 4> outer;
    std::array<vtkTypeInt32, 4> inner;
    const double depth = opening ? RecessDepth : 0.0;
    for (std::size_t i = 0; i < 4; ++i)
    {
      outer[i] = this->GetPoint(wall.GetPoint(corners[i][0], corners[i][1], 0.0));
      inner[i] = this->GetPoint(wall.GetPoint(corners[i][0], corners[i][1], depth));
    }
    this->Mesh.SetMaterial(!opening ? synthetic::Plaster()
        : opening->IsDoor           ? synthetic::Wood()
                                    : synthetic::Window());
    this->Mesh.AddQuad(inner[0], inner[1], inner[2], inner[3]);
    if (opening)
    {
      this->Mesh.SetMaterial(synthetic::Plaster());
      const bool isRim[4] = { cell[2] == opening->Bottom, cell[1] == opening->Right,
        cell[3] == opening->Top, cell[0] == opening->Left };
      for (std::size_t i = 0; i < 4; ++i)
      {
        const std::size_t next = (i + 1) % 4;
        if (isRim[i])
        {
          this->Mesh.AddQuad(outer[i], outer[next], inner[next], inner[i]);
        }
      }
    }
  }

  /// Collects the points of a wall's lower or upper edge except the last, the first of the next
  /// wall.
  void AddRim(
    const Wall& wall, const std::vector<double>& alongs, double up, std::vector<vtkTypeInt32>& rim)
  {
    this->CornerOnRim.push_back(rim.size());
    for (std::size_t i = 0; i + 1 < alongs.size(); ++i)
    {
      rim.push_back(this->GetPoint(wall.GetPoint(alongs[i], up, 0.0)));
    }
  }

  void AddTopAndFloor()
  {
    this->Mesh.SetMaterial(synthetic::Plaster());
    const vtkTypeInt32 centre = this->Mesh.AddPoint({ 0, 0, 0 });
    this->AddFan(centre, this->Floor, 0, this->Floor.size(), true);

    const vtkTypeInt32 front = this->Mesh.AddPoint({ 0, -this->HalfLength, this->Ridge });
    const vtkTypeInt32 back = this->Mesh.AddPoint({ 0, this->HalfLength, this->Ridge });
    const vtkTypeInt32 apexes[5] = { front, back, back, front, front };
    for (std::size_t i = 0; i < 4; ++i)
    {
      // Order of rims: floor, top of each wall; wall 0 and 2 carry the slopes, 1 and 3 the gables.
      const std::size_t first = this->CornerOnRim[2 * i + 1];
      const std::size_t last = i < 3 ? this->CornerOnRim[2 * i + 3] : this->Top.size();
      this->AddFan(apexes[i], this->Top, first, last, false);
      if (apexes[i] != apexes[i + 1])
      {
        this->Mesh.AddTriangle(apexes[i], this->Top[last % this->Top.size()], apexes[i + 1]);
      }
    }
  }

  /// Triangles from an apex to the edges of a rim from first to last.
  void AddFan(vtkTypeInt32 apex, const std::vector<vtkTypeInt32>& rim, std::size_t first,
    std::size_t last, bool looksDown)
  {
    for (std::size_t i = first; i < last; ++i)
    {
      const vtkTypeInt32 a = rim[i];
      const vtkTypeInt32 b = rim[(i + 1) % rim.size()];
      this->Mesh.AddTriangle(apex, looksDown ? b : a, looksDown ? a : b);
    }
  }

  vtkTypeInt32 GetPoint(const Vec3& point)
  {
    const std::array<double, 3> key{ point[0], point[1], point[2] };
    const auto known = this->Points.find(key);
    return known != this->Points.end() ? known->second
                                       : this->Points[key] = this->Mesh.AddPoint(point);
  }

  MeshBuilder& Mesh;
  double Eaves;
  double Ridge;
  double HalfLength;
  std::vector<Wall> Walls;
  std::vector<vtkTypeInt32> Floor;
  std::vector<vtkTypeInt32> Top;
  std::vector<std::size_t> CornerOnRim;
  std::map<std::array<double, 3>, vtkTypeInt32> Points;
};

} // namespace

//------------------------------------------------------------------------------
void AddHouse(MeshBuilder& mesh, double length, double height)
{
  const double width = 0.65 * length;
  const double slope = std::min(0.84, height / width); // about 40 degrees, less for a low house
  const double thickness = std::min(RoofThickness, 0.1 * height);
  const double bodyRidge = height - 0.5 * thickness; // within the roof
  const double eaves = bodyRidge - 0.5 * slope * width;
  Body(mesh, length, width, eaves, bodyRidge).Add();

  const double reach = 0.5 * width + Overhang;
  const double low = height - thickness - slope * reach;
  mesh.SetMaterial(synthetic::Roof());
  for (const double side : { -1.0, 1.0 })
  {
    std::vector<vtkVector2d> slab{ { side * reach, low }, { 0.0, height - thickness },
      { 0.0, height }, { side * reach, low + thickness } };
    if (side > 0)
    {
      std::reverse(slab.begin(), slab.end());
    }
    mesh.AddPrism(slab, -0.5 * length - Overhang, 0.5 * length + Overhang);
  }

  mesh.SetMaterial(synthetic::Brick());
  const double x = 0.2 * width;
  const double y = 0.2 * length;
  mesh.AddBox({ x - 0.3, y - 0.3, 0.5 * eaves }, { x + 0.3, y + 0.3, height + 0.7 });
}

} // namespace helios
