// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Floor plans as planning scenes, with lines of sight computed here in 2D.

#ifndef heliosFloorPlans_h
#define heliosFloorPlans_h

#include "vtkHeliosArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeUInt64Array.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace helios
{

using PlanPoint = std::array<double, 2>;
using PlanPolygon = std::vector<PlanPoint>;

/// Known values of a scene.
struct PlanTruth
{
  int Candidates;
  int TestPoints;
  double Coverage; // [%] of all
  int Optimum;
  double Linear; // to two decimals
  int Viewshed;
  int IncidenceAscending;
  int IncidenceDescending;
  int Greedy;
};

/// Rooms (seen from inside) and solids (seen from outside), walls 3 m high, scanner at 1.5 m.
class FloorPlan
{
public:
  std::string Name;
  PlanPolygon Room;
  std::vector<PlanPolygon> Solids;
  PlanTruth Truth;
  std::vector<PlanPoint> Witness; // a choice of Optimum scans that sees all

  /// Candidates with Visibility, and test points with Normal.
  void Build()
  {
    this->PlaceCandidates();
    this->PlaceOnWalls(this->Room, 1.0);
    for (const PlanPolygon& solid : this->Solids)
    {
      this->PlaceOnWalls(solid, -1.0);
    }
    for (const PlanPoint& p : this->Places)
    {
      this->AddTestPoint(p[0] + 0.013, p[1] + 0.017, 0.0, { 0.0, 0.0, 1.0 });
    }
    this->FillVisibility();
  }

  vtkSmartPointer<vtkPolyData> GetCandidates() const { return this->Candidates; }
  vtkSmartPointer<vtkPolyData> GetTestPoints() const { return this->TestPoints; }
  const std::vector<PlanPoint>& GetPlaces() const { return this->Places; }

  /// The candidate at a position.
  int Find(const PlanPoint& place) const
  {
    for (std::size_t c = 0; c < this->Places.size(); ++c)
    {
      if (std::hypot(this->Places[c][0] - place[0], this->Places[c][1] - place[1]) < 1e-9)
      {
        return static_cast<int>(c);
      }
    }
    return -1;
  }

private:
  static double Turn(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  static bool IsInside(const PlanPolygon& polygon, const PlanPoint& p)
  {
    bool isInside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const PlanPoint& a = polygon[i];
      const PlanPoint& b = polygon[(i + 1) % polygon.size()];
      if ((a[1] > p[1]) != (b[1] > p[1]) &&
        p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
      {
        isInside = !isInside;
      }
    }
    return isInside;
  }

  static bool Crosses(const PlanPolygon& polygon, const PlanPoint& p, const PlanPoint& q)
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const PlanPoint& a = polygon[i];
      const PlanPoint& b = polygon[(i + 1) % polygon.size()];
      if ((Turn(p, q, a) > 0.0) != (Turn(p, q, b) > 0.0) &&
        (Turn(a, b, p) > 0.0) != (Turn(a, b, q) > 0.0))
      {
        return true;
      }
    }
    return false;
  }

  bool IsFree(const PlanPoint& p) const
  {
    bool isFree = IsInside(this->Room, p);
    for (const PlanPolygon& solid : this->Solids)
    {
      isFree = isFree && !IsInside(solid, p);
    }
    return isFree;
  }

  bool Sees(const PlanPoint& p, const PlanPoint& v) const
  {
    const double distance = std::hypot(v[0] - p[0], v[1] - p[1]);
    const double share = 1.0 - 0.05 / distance;
    if (share <= 0.0)
    {
      return true;
    }
    const PlanPoint end = { p[0] + share * (v[0] - p[0]), p[1] + share * (v[1] - p[1]) };
    bool isSeen = !Crosses(this->Room, p, end);
    for (std::size_t s = 0; s < this->Solids.size() && isSeen; ++s)
    {
      isSeen = !Crosses(this->Solids[s], p, end);
    }
    return isSeen;
  }

  void PlaceCandidates()
  {
    PlanPoint high = { 0.0, 0.0 };
    for (const PlanPoint& p : this->Room)
    {
      high = { std::max(high[0], p[0]), std::max(high[1], p[1]) };
    }
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (int i = 0; i + 0.37 < high[0]; ++i)
    {
      for (int j = 0; j + 0.41 < high[1]; ++j)
      {
        const PlanPoint p = { i + 0.37, j + 0.41 };
        if (this->IsFree(p))
        {
          this->Places.push_back(p);
          points->InsertNextPoint(p[0], p[1], 1.5);
        }
      }
    }
    this->Candidates->SetPoints(points);
    this->Normals->SetName(vtkHeliosArrayNames::Normal);
    this->Normals->SetNumberOfComponents(3);
    this->Points->SetDataTypeToDouble();
    this->TestPoints->SetPoints(this->Points);
    this->TestPoints->GetPointData()->AddArray(this->Normals);
  }

  void PlaceOnWalls(const PlanPolygon& polygon, double side)
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const PlanPoint& a = polygon[i];
      const PlanPoint& b = polygon[(i + 1) % polygon.size()];
      const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
      const int count = static_cast<int>(std::lround(length / 0.5));
      for (int k = 0; k < count; ++k)
      {
        const double t = (k + 0.5) / count;
        this->AddTestPoint(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), 1.5,
          { -side * (b[1] - a[1]) / length, side * (b[0] - a[0]) / length, 0.0 });
      }
    }
  }

  void AddTestPoint(double x, double y, double z, const std::array<double, 3>& normal)
  {
    this->Points->InsertNextPoint(x, y, z);
    this->Normals->InsertNextTuple(normal.data());
  }

  void FillVisibility()
  {
    const vtkIdType testPoints = this->Points->GetNumberOfPoints();
    vtkNew<vtkTypeUInt64Array> rows;
    rows->SetName(vtkHeliosArrayNames::Visibility);
    rows->SetNumberOfComponents(static_cast<int>((testPoints + 63) / 64));
    rows->SetNumberOfTuples(static_cast<vtkIdType>(this->Places.size()));
    rows->Fill(0.0);
    for (std::size_t c = 0; c < this->Places.size(); ++c)
    {
      auto* row = rows->GetPointer(static_cast<vtkIdType>(c) * rows->GetNumberOfComponents());
      for (vtkIdType v = 0; v < testPoints; ++v)
      {
        double p[3];
        this->Points->GetPoint(v, p);
        if (this->Sees(this->Places[c], { p[0], p[1] }))
        {
          row[v / 64] |= vtkTypeUInt64(1) << (v % 64);
        }
      }
    }
    this->Candidates->GetPointData()->AddArray(rows);
  }

  std::vector<PlanPoint> Places;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Normals;
  vtkNew<vtkPolyData> Candidates;
  vtkNew<vtkPolyData> TestPoints;
};

inline PlanPolygon MakeRectangle(double x0, double y0, double x1, double y1)
{
  return { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } };
}

/// A corridor with dead ends: each needs its own scan.
inline PlanPolygon MakeComb(int teeth)
{
  PlanPolygon comb = { { 0.0, 0.0 }, { 4.0 * teeth, 0.0 }, { 4.0 * teeth, 2.0 } };
  for (int i = teeth - 1; i >= 0; --i)
  {
    comb.push_back({ 4.0 * i + 3.0, 2.0 });
    comb.push_back({ 4.0 * i + 3.0, 14.0 });
    comb.push_back({ 4.0 * i + 1.0, 14.0 });
    comb.push_back({ 4.0 * i + 1.0, 2.0 });
  }
  comb.push_back({ 0.0, 2.0 });
  return comb;
}

inline std::vector<PlanPolygon> MakeColumns(int nx, int ny, double stepY)
{
  std::vector<PlanPolygon> columns;
  for (int i = 0; i < nx; ++i)
  {
    for (int j = 0; j < ny; ++j)
    {
      const double x = 5.0 + 6.0 * i;
      const double y = 5.0 + stepY * j;
      columns.push_back(MakeRectangle(x, y, x + 1.0, y + 1.0));
    }
  }
  return columns;
}

/// Eight scenes with proved optima.
inline std::vector<FloorPlan> MakeFloorPlans()
{
  std::vector<FloorPlan> scenes(8);
  const auto set = [&scenes](int k, const char* name, PlanPolygon room, PlanTruth truth)
  {
    scenes[k].Name = name;
    scenes[k].Room = std::move(room);
    scenes[k].Truth = truth;
  };
  set(0, "S1 room", MakeRectangle(0, 0, 10, 8), { 80, 152, 100, 1, 1.0, 1, 1, 1, 1 });
  set(1, "S2 L", { { 0, 0 }, { 20, 0 }, { 20, 10 }, { 10, 10 }, { 10, 20 }, { 0, 20 } },
    { 300, 460, 100, 1, 1.0, 1, 1, 2, 1 });
  set(2, "S3 comb of 5", MakeComb(5), { 160, 488, 100, 5, 5.0, 5, 5, 6, 5 });
  set(3, "S3b comb of 9", MakeComb(9), { 288, 872, 100, 9, 9.0, 9, 9, 10, 9 });
  set(4, "S4 room with 6 columns", MakeRectangle(0, 0, 24, 18),
    { 426, 642, 100, 3, 2.13, 6, 5, 5, 4 });
  scenes[4].Solids = MakeColumns(3, 2, 7.0);
  scenes[4].Witness = { { 15.37, 14.41 }, { 0.37, 3.41 }, { 18.37, 4.41 } };
  set(5, "S5 room with 16 columns", MakeRectangle(0, 0, 30, 30),
    { 884, 1252, 100, 4, 2.65, 8, 8, 8, 5 });
  scenes[5].Solids = MakeColumns(4, 4, 6.0);
  scenes[5].Witness = { { 1.37, 18.41 }, { 10.37, 28.41 }, { 29.37, 8.41 }, { 20.37, 2.41 } };
  set(6, "S6 cross of streets", MakeRectangle(0, 0, 60, 40),
    { 1056, 2064, 70.54, 1, 1.0, 1, 2, 4, 1 });
  scenes[6].Solids = { MakeRectangle(0, 0, 24, 14), MakeRectangle(36, 0, 60, 14),
    MakeRectangle(0, 26, 24, 40), MakeRectangle(36, 26, 60, 40) };
  set(7, "S8 12 blocks", MakeRectangle(0, 0, 40, 40), { 1395, 2111, 100, 6, 5.11, 10, 14, 17, 9 });
  for (const auto& b : { std::array<double, 4>{ 8, 36, 14, 39 }, { 24, 29, 27, 32 },
         { 2, 13, 7, 20 }, { 14, 14, 19, 18 }, { 21, 18, 23, 20 }, { 28, 10, 35, 13 },
         { 15, 7, 17, 10 }, { 26, 14, 33, 20 }, { 17, 22, 19, 25 }, { 20, 5, 22, 12 },
         { 35, 14, 39, 18 }, { 4, 24, 6, 31 } })
  {
    scenes[7].Solids.push_back(MakeRectangle(b[0], b[1], b[2], b[3]));
  }
  scenes[7].Witness = { { 7.37, 21.41 }, { 33.37, 36.41 }, { 0.37, 39.41 }, { 22.37, 13.41 },
    { 19.37, 1.41 }, { 39.37, 13.41 } };
  for (FloorPlan& scene : scenes)
  {
    scene.Build();
  }
  return scenes;
}

} // namespace helios

#endif
