// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The cone probe against brute force: rays all over the cone, and each triangle clipped to the cone.

#include "heliosConeProbe.h"
#include "heliosRayCastingScenes.h"
#include "vtkHeliosBeamRayCaster.h"
#include "vtkHeliosBvhRayCaster.h"

#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <algorithm>

using helios::ConeProbe;
using helios::Dice;
using helios::Soup;
using helios::Vec3;

namespace
{

struct Cone
{
  Vec3 Apex;
  Vec3 Axis;
  double Tangent;
};

/// A cone's own frame, in long double.
struct ConeFrame
{
  explicit ConeFrame(const Cone& cone)
    : Source(cone)
  {
    this->W = cone.Axis.Normalized();
    const Vec3 side = std::abs(this->W[2]) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    this->U = this->W.Cross(side).Normalized();
    this->V = this->W.Cross(this->U);
  }
  std::array<long double, 3> Get(const Vec3& p) const
  {
    const Vec3 d = p - this->Source.Apex;
    const auto dot = [&d](const Vec3& a)
    {
      return static_cast<long double>(a[0]) * d[0] + static_cast<long double>(a[1]) * d[1] +
        static_cast<long double>(a[2]) * d[2];
    };
    return { dot(this->U), dot(this->V), dot(this->W) };
  }
  /// The direction to a point in the disc of radius 1.
  Vec3 GetDirection(double x, double y) const
  {
    return this->W + this->U * (x * this->Source.Tangent) + this->V * (y * this->Source.Tangent);
  }

  Cone Source;
  Vec3 U, V, W;
};

using Point3 = std::array<long double, 3>;

/// The part of a triangle before the apex, beyond a minimum distance: a polygon.
std::vector<Point3> ClipToFront(const Point3 corners[3])
{
  long double size = 0;
  for (int i = 0; i < 3; ++i)
  {
    size =
      std::max({ size, std::abs(corners[i][0]), std::abs(corners[i][1]), std::abs(corners[i][2]) });
  }
  const long double least = 1e-9L * size;
  std::vector<Point3> polygon;
  for (int i = 0; i < 3; ++i)
  {
    const Point3& p = corners[i];
    const Point3& q = corners[(i + 1) % 3];
    if (p[2] >= least)
    {
      polygon.push_back(p);
    }
    if ((p[2] >= least) != (q[2] >= least))
    {
      const long double s = (least - p[2]) / (q[2] - p[2]);
      polygon.push_back({ p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1]), least });
    }
  }
  return polygon;
}

/// Points of a triangle within the cone of a tangent, if any, including its extremes.
std::vector<Point3> ClipToCone(const Point3 corners[3], long double tangent)
{
  std::vector<Point3> points;
  const auto polygon = ClipToFront(corners);
  const std::size_t n = polygon.size();
  bool left = n > 0, right = n > 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point3& p = polygon[i];
    const Point3& q = polygon[(i + 1) % n];
    const long double turn = p[0] * q[1] - p[1] * q[0];
    left = left && turn >= 0;
    right = right && turn <= 0;
    // x^2 + y^2 = T^2 z^2 along the edge p + s (q - p).
    const long double d[3] = { q[0] - p[0], q[1] - p[1], q[2] - p[2] };
    const long double t = tangent * tangent;
    const long double a = d[0] * d[0] + d[1] * d[1] - t * d[2] * d[2];
    const long double b = p[0] * d[0] + p[1] * d[1] - t * p[2] * d[2];
    const long double c = p[0] * p[0] + p[1] * p[1] - t * p[2] * p[2];
    if (c <= 0)
    {
      points.push_back(p);
    }
    const long double root = b * b - a * c;
    for (int sign = -1; sign <= 1 && root > 0 && a != 0; sign += 2)
    {
      const long double s = (-b + sign * std::sqrt(root)) / a;
      if (s >= 0 && s <= 1)
      {
        points.push_back({ p[0] + s * d[0], p[1] + s * d[1], p[2] + s * d[2] });
      }
    }
  }
  if (left != right) // the axis passes through it
  {
    const Point3 &p = corners[0], &q = corners[1], &r = corners[2];
    const long double e[3] = { q[0] * r[1] - q[1] * r[0], r[0] * p[1] - r[1] * p[0],
      p[0] * q[1] - p[1] * q[0] };
    const long double z = (e[0] * p[2] + e[1] * q[2] + e[2] * r[2]) / (e[0] + e[1] + e[2]);
    points.push_back({ 0, 0, z });
  }
  return points;
}

/// Why a result is not right; empty if it is.
std::string FindFault(const vtkHeliosRayCaster& caster, const Soup& soup, const Cone& cone,
  double tolerance, const vtkHeliosConeHit& found)
{
  const ConeFrame frame(cone);
  const bool isEmpty = found.Kind == vtkHeliosConeHit::Empty;
  std::vector<vtkHeliosRay> rays = { helios::MakeRay(cone.Apex, cone.Axis) };
  for (int i = 0; i < 120; ++i) // a spiral, and the edge
  {
    const double radius = i < 80 ? std::sqrt((i + 0.5) / 80) : 1.0 - 1e-7;
    const double turn = i < 80 ? 2.39996322972865 * i : 2 * vtkMath::Pi() * i / 40;
    rays.push_back(helios::MakeRay(
      cone.Apex, frame.GetDirection(radius * std::cos(turn), radius * std::sin(turn))));
  }
  const auto hits = helios::Cast(&caster, rays);
  if (!isEmpty && (hits[0].CellId != found.CellId || hits[0].Range != found.Range))
  {
    return "it is not what the axis meets";
  }
  const auto getCorners = [&soup, &frame](vtkIdType cell, Point3 corners[3])
  {
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = frame.Get(soup.Points[soup.Triangles[cell][i]]);
    }
  };
  // The plane's depth along a direction (x, y, 1): n . p / n . d.
  Point3 normal = {}, plane[3] = {};
  if (!isEmpty)
  {
    getCorners(found.CellId, plane);
    Point3 a, b;
    for (int i = 0; i < 3; ++i)
    {
      a[i] = plane[1][i] - plane[0][i];
      b[i] = plane[2][i] - plane[0][i];
    }
    normal = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  }
  const auto dot = [](const Point3& a, const Point3& b)
  { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const auto getDepth = [&](const Point3& d) { return dot(normal, plane[0]) / dot(normal, d); };
  // Bounds the error of a hit, which grows with the incidence, like a range's: 8 u R / cos.
  const auto getError = [&](const Point3& d, double rounding)
  { return rounding * std::sqrt(dot(normal, normal) * dot(d, d)) / std::abs(dot(normal, d)); };
  const double rounding = 1e-9 * (isEmpty ? 1.0 : found.Range) +
    1e-15 * std::max({ cone.Apex[0], cone.Apex[1], cone.Apex[2] });
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    if ((hits[i].CellId >= 0) == isEmpty)
    {
      return isEmpty ? "a ray hits" : "a ray misses";
    }
    if (!isEmpty)
    {
      const Vec3 d(rays[i].Direction);
      const Point3 local = frame.Get(cone.Apex + d * hits[i].Range);
      const Point3 along = { local[0] / local[2], local[1] / local[2], 1 };
      if (!(std::abs(local[2] - getDepth(along)) <= tolerance + getError(along, rounding)))
      {
        return "a ray is off the plane";
      }
    }
  }
  for (vtkIdType cell = 0; cell < static_cast<vtkIdType>(soup.Triangles.size()); ++cell)
  {
    const auto& t = soup.Triangles[cell];
    Point3 corners[3];
    getCorners(cell, corners);
    if (!helios::SpansArea(
          soup.Points[t[0]].GetData(), soup.Points[t[1]].GetData(), soup.Points[t[2]].GetData()))
    {
      continue;
    }
    for (const Point3& p : ClipToCone(corners, cone.Tangent * (1 - 1e-6)))
    {
      if (isEmpty)
      {
        return "a triangle touches it";
      }
      if (!(p[2] - getDepth({ p[0] / p[2], p[1] / p[2], 1 }) >= -(tolerance + rounding)))
      {
        return "a triangle is in front";
      }
    }
  }
  return {};
}

/// Results by kind, after each was checked.
struct Counts
{
  int Kinds[3] = { 0, 0, 0 };
  int Faults = 0;
  std::string Fault;
};

Counts Probe(const Soup& soup, const std::vector<Cone>& cones, double tolerance)
{
  const auto scene = soup.GetPolyData();
  vtkNew<vtkHeliosBeamRayCaster> beam;
  vtkNew<vtkHeliosBvhRayCaster> bvh;
  REQUIRE(beam->Build(scene));
  REQUIRE(bvh->Build(scene));
  const ConeProbe* ofBeam = beam->GetConeProbe(); // on the tree of the caster
  const ConeProbe* ofBvh = bvh->GetConeProbe();   // on one of its own
  REQUIRE((ofBeam && ofBvh));
  Counts counts;
  for (const Cone& cone : cones)
  {
    const auto ask = [&cone, tolerance](const ConeProbe& probe)
    { return probe.Probe(cone.Apex.GetData(), cone.Axis.GetData(), cone.Tangent, tolerance); };
    const vtkHeliosConeHit hit = ask(*ofBeam);
    const vtkHeliosConeHit other = ask(*ofBvh);
    ++counts.Kinds[hit.Kind];
    std::string fault;
    if (hit.Kind != other.Kind || hit.CellId != other.CellId || hit.Range != other.Range)
    {
      fault = "another caster says something else";
    }
    else if (hit.Kind != vtkHeliosConeHit::Unresolved)
    {
      fault = FindFault(*bvh, soup, cone, tolerance, hit);
    }
    counts.Faults += fault.empty() ? 0 : 1;
    counts.Fault = fault.empty() ? counts.Fault : fault;
  }
  return counts;
}

/// Cones at random triangles of a soup, from near and far.
std::vector<Cone> MakeCones(const Soup& soup, const Vec3& centre, double size, int count)
{
  Dice dice(21);
  std::vector<Cone> cones;
  for (int i = 0; i < count; ++i)
  {
    const auto pick = [&dice](std::size_t n)
    { return static_cast<std::size_t>(dice() * static_cast<double>(n)); };
    const auto& t = soup.Triangles[pick(soup.Triangles.size())];
    const Vec3 &a = soup.Points[t[0]], &b = soup.Points[t[1]], &c = soup.Points[t[2]];
    const double s = dice();
    const double r = dice();
    const Vec3 targets[4] = { a, a + (b - a) * s,
      a * s + b * ((1 - s) * r) + c * ((1 - s) * (1 - r)), centre + dice.Direction() * (size * s) };
    const Vec3 apex = centre + dice.Direction() * (size * std::pow(10, dice(-0.7, 2.0)));
    const Vec3 aim = targets[i % 4] - apex;
    cones.push_back({ apex, aim.Normalized(), std::pow(10, dice(-5, i % 3 == 0 ? -0.4 : -2)) });
  }
  return cones;
}

Vec3 GetAim(const Vec3& from, const Vec3& to)
{
  return (to - from).Normalized();
}

/// Kind of the hit of a cone from (0.1, 0.2, 5) towards a point, with a tolerance of 1 um.
int ProbeAt(const Soup& soup, const Vec3& place, double tangent, const Vec3& from = { 0.1, 0.2, 5 })
{
  const Counts counts = Probe(soup, { { from, GetAim(from, place), tangent } }, 1e-6);
  CHECK(counts.Fault == "");
  return counts.Kinds[0] > 0 ? 0 : (counts.Kinds[1] > 0 ? 1 : 2);
}

constexpr int Empty = vtkHeliosConeHit::Empty;
constexpr int PlanarFootprint = vtkHeliosConeHit::PlanarFootprint;
constexpr int Unresolved = vtkHeliosConeHit::Unresolved;

/// A wall of six triangles about the origin.
Soup MakeFan(int count = 6)
{
  Soup soup;
  soup.AddPoint({ 0, 0, 0 });
  for (int i = 0; i < 6; ++i)
  {
    soup.AddPoint({ std::cos(vtkMath::Pi() * i / 3), std::sin(vtkMath::Pi() * i / 3), 0 });
  }
  for (int i = 0; i < count; ++i)
  {
    soup.Triangles.push_back({ 0, i + 1, (i + 1) % 6 + 1 });
  }
  return soup;
}

} // namespace

TEST_CASE("ConeProbe: never wrong over random scenes", "[ConeProbe]")
{
  for (const Vec3& offset : helios::Offsets)
  {
    for (double scale : { 0.01, 1000.0 })
    {
      Soup soup = helios::MakeMixture();
      soup.Move(offset, scale);
      for (double tolerance : { 0.0, 1e-3 * scale })
      {
        const Counts counts = Probe(soup, MakeCones(soup, offset, 2 * scale, 800), tolerance);
        INFO("offset " << offset[0] << ", scale " << scale << ", " << counts.Kinds[0] << " empty, "
                       << counts.Kinds[1] << " plane, " << counts.Kinds[2] << " mixed");
        CHECK(counts.Fault == "");
        CHECK(counts.Kinds[Empty] > 20);
        CHECK(counts.Kinds[PlanarFootprint] > 40);
        CHECK(counts.Kinds[Unresolved] > 200);
      }
    }
  }
}

TEST_CASE("ConeProbe: never wrong over a closed mesh and leaves", "[ConeProbe]")
{
  Soup sphere = helios::MakeIcosphere(3);
  const Counts inside = Probe(sphere, MakeCones(sphere, { 0, 0, 0 }, 0.9, 1000), 1e-4);
  CHECK(inside.Fault == "");
  CHECK(inside.Kinds[PlanarFootprint] > 100);
  Soup forest = helios::MakeTerrain(40, 1.0);
  helios::AddLeaves(forest, 1000, 0.05, { 10, 10, 5 }, { 30, 30, 8 });
  const Counts crowns = Probe(forest, MakeCones(forest, { 20, 20, 5 }, 10, 1000), 1e-3);
  CHECK(crowns.Fault == "");
  CHECK(crowns.Kinds[PlanarFootprint] > 100);
}

TEST_CASE("ConeProbe: mostly planar over smooth terrain", "[ConeProbe]")
{
  for (const Vec3& offset : helios::Offsets)
  {
    Soup soup = helios::MakeTerrain(60, 1.0);
    soup.Move(offset);
    Dice dice(22);
    std::vector<Cone> cones;
    for (int i = 0; i < 200; ++i)
    {
      const Vec3 apex = offset + Vec3(dice(20, 40), dice(20, 40), i % 2 == 0 ? 100.0 : 12.0);
      const Vec3 target = offset + Vec3(dice(2, 58), dice(2, 58), 0.0);
      cones.push_back({ apex, GetAim(apex, target), 0.2e-3 });
    }
    INFO("offset " << offset[0]);
    const Counts strict = Probe(soup, cones, 0.0);
    CHECK(strict.Fault == "");
    CHECK(strict.Kinds[PlanarFootprint] >
      160); // 2 r L / A = 0.04 * 3.4 of the cones at 100 m have an edge
    CHECK(strict.Kinds[Unresolved] > 5);
    const Counts tolerant = Probe(soup, cones, 0.01);
    CHECK(tolerant.Fault == "");
    CHECK(tolerant.Kinds[PlanarFootprint] > 185);
  }
}

TEST_CASE("ConeProbe: a wall of triangles is planar, with a hole it is not", "[ConeProbe]")
{
  CHECK(ProbeAt(MakeFan(), { 0, 0, 0 }, 0.01) == PlanarFootprint);
  CHECK(ProbeAt(MakeFan(), { 0.01, 0.01, 0 }, 0.01) == PlanarFootprint);
  CHECK(ProbeAt(MakeFan(), { 0.01, 0.01, 0 }, 0.1) == PlanarFootprint);
  CHECK(ProbeAt(MakeFan(), { 0.01, 0.01, 0 }, 0.2) == Unresolved);
  CHECK(ProbeAt(MakeFan(), { 0.4, 0.3, 0 }, 0.01) == PlanarFootprint);
  CHECK(ProbeAt(MakeFan(), { 3, 0, 0 }, 0.01) == Empty);
  CHECK(ProbeAt(MakeFan(5), { 0, 0, 0 }, 0.01) == Unresolved);
  CHECK(ProbeAt(MakeFan(5), { 0.4, -0.3, 0 }, 0.01) == Empty);
  CHECK(ProbeAt(MakeFan(5), { 0.4, 0.3, 0 }, 0.01) == PlanarFootprint);
  // A leaf before the wall, just within the cone, just outside, behind, and edge-on.
  const Vec3 from(0.4, 0.2, 5);
  const Vec3 to(0.4, 0.2, 0);
  const auto probeLeaf = [&](const Vec3& a, const Vec3& b, const Vec3& c)
  {
    Soup soup = MakeFan();
    soup.AddTriangle(a, b, c);
    return ProbeAt(soup, to, 0.01, from);
  };
  const double rim = 0.01 * 4.0; // at z = 1
  CHECK(
    probeLeaf({ 0.4 + rim * (1 - 1e-7), 0.2, 1 }, { 0.5, 0.2, 1 }, { 0.5, 0.3, 1 }) == Unresolved);
  CHECK(probeLeaf({ 0.4 + rim * (1 + 1e-7), 0.2, 1 }, { 0.5, 0.2, 1 }, { 0.5, 0.3, 1 }) ==
    PlanarFootprint);
  CHECK(probeLeaf({ 0.4, 0.2, 1 }, { 0.4 + 1e-9, 0.2, 1 }, { 0.4, 0.2 + 1e-9, 1 }) == Unresolved);
  CHECK(probeLeaf({ 0.4, 0.2, -1 }, { 0.5, 0.2, -1 }, { 0.5, 0.3, -1 }) == PlanarFootprint);
  CHECK(probeLeaf({ 0.4, 0.2, -1 }, { 0.5, 0.2, 1 }, { 0.5, 0.3, 1 }) == Unresolved);
  CHECK(probeLeaf({ 0.4, 0.2, 1 }, { 0.4, 0.2, 2 }, { 0.4, 0.3, 1 }) == Unresolved);
  CHECK(probeLeaf({ 0.4, 0.2, 6 }, { 0.5, 0.2, 6 }, { 0.5, 0.3, 7 }) == PlanarFootprint);
  // From all sides, closer than the wall, and from below through it.
  CHECK(probeLeaf({ -9, -9, 4.9 }, { 9, -9, 4.9 }, { 0.4, 9, 4.9 }) == PlanarFootprint);
  CHECK(probeLeaf({ -9, -9, 4.9 }, { 9, -9, 4.9 }, { 0.4, 9, 5.1 }) == PlanarFootprint);
}

TEST_CASE("ConeProbe: a fold is planar within the tolerance only", "[ConeProbe]")
{
  for (double slope : { 0.0, 0.01, 0.1 })
  {
    Soup soup;
    soup.AddTriangle({ 0, -9, 0 }, { 0, 9, 0 }, { -9, 0, 0 });
    soup.AddTriangle({ 0, -9, 0 }, { 0, 9, 0 }, { 9, 0, 9 * slope });
    const Cone cone = { { 0, 0, 10 }, { 0, 0, -1 }, 1e-3 };
    const double radius = 0.01 * (1 + 1e-3 * slope);
    const auto getKind = [&](double tolerance)
    {
      const Counts counts = Probe(soup, { cone }, tolerance);
      CHECK(counts.Fault == "");
      return counts.Kinds[PlanarFootprint] == 1 ? PlanarFootprint : Unresolved;
    };
    CHECK(getKind(slope * radius * 1.01 + 1e-9) == PlanarFootprint);
    if (slope > 0)
    {
      CHECK(getKind(slope * radius * 0.99) == Unresolved);
    }
  }
}

TEST_CASE("ConeProbe: unresolved in doubt", "[ConeProbe]")
{
  const Soup soup = MakeFan();
  const double nan = std::nan("");
  vtkNew<vtkHeliosBvhRayCaster> caster;
  const double from[3] = { 0, 0, 5 };
  const double axis[3] = { 0, 0, -1 };
  CHECK(caster->GetConeProbe() == nullptr); // no scene
  REQUIRE(caster->Build(soup.GetPolyData()));
  const ConeProbe* probe = caster->GetConeProbe();
  REQUIRE(probe);
  CHECK(caster->GetConeProbe() == probe); // made once
  CHECK(probe->Probe(from, axis, 0.01, 1e-6).Kind == PlanarFootprint);
  CHECK(probe->Probe(from, axis, 0.0, 1e-6).Kind == PlanarFootprint); // a line
  CHECK(probe->Probe(from, axis, nan, 1e-6).Kind == Unresolved);
  CHECK(probe->Probe(from, axis, 0.01, nan).Kind == Unresolved);
  CHECK(probe->Probe(from, axis, 0.9, 1e-6).Kind == Unresolved);
  CHECK(probe->Probe(from, axis, -0.1, 1e-6).Kind == Unresolved);
  const double nowhere[3] = { 0, 0, 0 };
  CHECK(probe->Probe(from, nowhere, 0.01, 1e-6).Kind == Unresolved);
}

TEST_CASE("ConeProbe: of the scene built last", "[ConeProbe]")
{
  const double from[3] = { 0, 0, 5 };
  const double axis[3] = { 0, 0, -1 };
  vtkNew<vtkHeliosBvhRayCaster> caster;
  REQUIRE(caster->Build(MakeFan().GetPolyData()));
  CHECK(caster->GetConeProbe()->Probe(from, axis, 0.01, 1e-6).Kind == PlanarFootprint);
  Soup away;
  away.AddTriangle({ 50, 0, 0 }, { 51, 0, 0 }, { 50, 1, 0 });
  REQUIRE(caster->Build(away.GetPolyData()));
  CHECK(caster->GetConeProbe()->Probe(from, axis, 0.01, 1e-6).Kind == Empty);
  CHECK_FALSE(caster->Build(nullptr));
  CHECK(caster->GetConeProbe() == nullptr);
}

TEST_CASE("ConeProbe: none after an abort request, then again", "[ConeProbe]")
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  REQUIRE(caster->Build(MakeFan().GetPolyData()));
  caster->SetShouldStop([]() { return true; });
  CHECK(caster->GetConeProbe() == nullptr);
  caster->SetShouldStop(nullptr);
  CHECK(caster->GetConeProbe() != nullptr);
}

TEST_CASE("ConeProbe: distant triangles are included", "[ConeProbe]")
{
  Soup soup = helios::MakeIcosphere(4);
  soup.AddTriangle({ -1e4, -1e4, 50 }, { 1e4, -1e4, 50 }, { 0, 2e4, 50 });
  CHECK(ProbeAt(soup, { 0.1, 0.2, 5 + 45 }, 0.01, { 0.1, 0.2, 5 }) == PlanarFootprint);
  CHECK(ProbeAt(soup, { 0, 0, -9 }, 0.01, { 0, 0, 60 }) == PlanarFootprint);
  CHECK(ProbeAt(soup, { 3, 0, 0 }, 0.01, { 3, 0, 5 }) == Empty);
}

namespace
{

/// The layer in a cone of 10 mm radius, from 10 m above (0.001, 0.002).
helios::ConeLayer FindLayer(const Soup& soup, double distance, double overlap = 0.0)
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  REQUIRE(caster->Build(soup.GetPolyData()));
  helios::PlaneLimits limits(1e-6);
  limits.OfLayer.Distance = distance;
  limits.Overlap = overlap;
  const double from[3] = { 0.001, 0.002, 10 };
  const double axis[3] = { 0, 0, -1 };
  helios::ConeLayer layer;
  const vtkHeliosConeHit hit = caster->GetConeProbe()->Probe(from, axis, 1e-3, limits, &layer);
  CHECK((hit.Kind == Unresolved || layer.Size > 0));
  return layer;
}

/// A fold along y, whose right side rises.
void AddFold(Soup& soup, double z, double slope)
{
  soup.AddTriangle({ 0, -9, z }, { 0, 9, z }, { -9, 0, z });
  soup.AddTriangle({ 0, -9, z }, { 0, 9, z }, { 9, 0, z + 9 * slope });
}

} // namespace

TEST_CASE("ConeProbe: a layer is a surface without gaps, and without others near it", "[ConeProbe]")
{
  Soup fold;
  AddFold(fold, 0, 0.2);
  CHECK(FindLayer(fold, 0.01).Size == 2);
  CHECK(FindLayer(fold, 0.001).Size == 0); // bends by 2 mm
  CHECK(FindLayer(fold, 0.0).Size == 0);

  Soup plate = fold; // its other side
  AddFold(plate, -0.004, 0.2);
  CHECK(FindLayer(plate, 0.001).Size == 0);
  CHECK(FindLayer(plate, 0.01).Size == 0);
  Soup thick = fold;
  AddFold(thick, -0.02, 0.2);
  CHECK(FindLayer(thick, 0.01).Size == 2);

  Soup covered = fold;
  covered.AddTriangle({ 0.002, 0, 0.003 }, { 0.004, 0, 0.003 }, { 0.002, 0.003, 0.003 });
  CHECK(FindLayer(covered, 0.01).Size == 0);

  Soup gap;
  gap.AddTriangle({ 0, -9, 0 }, { 0, 9, 0 }, { -9, 0, 0 });
  gap.AddTriangle({ 1e-9, -9, 0 }, { 1e-9, 9, 0 }, { 9, 0, 1.8 });
  CHECK(FindLayer(gap, 0.01).Size == 0);
}

TEST_CASE("ConeProbe: a layer is what hides all others, but for an overlap", "[ConeProbe]")
{
  const auto findBeside = [](double height, double overlap)
  {
    Soup soup;
    soup.AddTriangle({ -9, -9, 0 }, { 9, -9, 0 }, { 0, 18, 0 });
    soup.AddTriangle({ 0.004, -1, height }, { 1, 0, height }, { 0.004, 1, height });
    return FindLayer(soup, 0.01, overlap).Size;
  };
  CHECK(findBeside(-0.004, 0.0) == 1);
  CHECK(findBeside(0.004, 0.0) == 0);
  CHECK(findBeside(0.004, 0.005) == 1);
  CHECK(findBeside(0.004, 0.003) == 0);

  Soup fold;
  AddFold(fold, 0, 0.2);
  fold.AddTriangle({ 0, -9, 0 }, { 0, 9, 0 }, { 9, 0, 9 * 0.3 }); // a third one at the edge
  CHECK(FindLayer(fold, 0.01).Size == 0);
}

TEST_CASE("ConeProbe: a fold counts as far as it is inside the cone", "[ConeProbe]")
{
  // A surface bends by 1.0 beyond x = 6 mm: by 5 mm at the rim of 11 mm, as a plane by 17 mm at the
  // other side.
  Soup fold;
  fold.AddTriangle({ 0.006, -9, 0 }, { 0.006, 9, 0 }, { -9, 0, 0 });
  fold.AddTriangle({ 0.006, -9, 0 }, { 0.006, 9, 0 }, { 9, 0, 9 });
  CHECK(FindLayer(fold, 0.006).Size == 2);
  CHECK(FindLayer(fold, 0.003).Size == 0);

  // On both sides of one triangle: the sum counts.
  Soup valley;
  valley.AddTriangle({ -0.004, -9, 0 }, { 0.006, -9, 0 }, { 0.001, 9000, 0 });
  valley.AddTriangle({ 0.006, -9, 0 }, { 0.001, 9000, 0 }, { 9, 0, 9 });
  valley.AddTriangle({ -0.004, -9, 0 }, { 0.001, 9000, 0 }, { -9, 0, 9 });
  CHECK(FindLayer(valley, 0.011).Size == 3);
  CHECK(FindLayer(valley, 0.008).Size == 0);

  // A side that bends again inside the cone is no fold.
  Soup crest;
  crest.AddTriangle({ 0.006, -9, 0 }, { 0.006, 9, 0 }, { -9, 0, 0 });
  crest.AddTriangle({ 0.006, -9, 0 }, { 0.006, 9, 0 }, { 0.008, -9, 0.004 });
  crest.AddTriangle({ 0.006, 9, 0 }, { 0.008, 9, 0.004 }, { 0.008, -9, 0.004 });
  crest.AddTriangle({ 0.008, -9, 0.004 }, { 0.008, 9, 0.004 }, { 9, 0, 0 });
  CHECK(FindLayer(crest, 0.008).Size == 0);
  CHECK(FindLayer(crest, 0.1).Size == 4);

  // Nor is one that ends at another surface there, 4 mm above the first.
  Soup ramp;
  ramp.AddTriangle({ 0.006, -9, 0 }, { 0.007, 9000, 0.002 }, { -9, 0, 0 });
  ramp.AddTriangle({ 0.008, -9, 0.004 }, { 0.007, 9000, 0.002 }, { 0.006, -9, 0 });
  ramp.AddTriangle({ 0.008, -9, 0.004 }, { 0.007, 9000, 0.002 }, { 9, 0, 0.004 });
  CHECK(FindLayer(ramp, 0.012).Size == 0);
  CHECK(FindLayer(ramp, 0.1).Size == 3);
}

TEST_CASE("ConeProbe: the pieces of a layer have the depths of their triangles", "[ConeProbe]")
{
  Soup fold;
  AddFold(fold, 0, 0.2);
  const helios::ConeLayer layer = FindLayer(fold, 0.01);
  REQUIRE(layer.Size == 2);
  for (int i = 0; i < layer.Size; ++i)
  {
    const auto& piece = layer.Pieces[i];
    const double x[2] = { piece.Cell == 0 ? -5e-4 : 5e-4, 3e-4 }; // in the world, of a depth of 1
    double local[2] = { 0, 0 };
    for (int axis = 0; axis < 2; ++axis)
    {
      local[axis] = x[0] * layer.Frame[axis][0] + x[1] * layer.Frame[axis][1];
    }
    for (const auto& edge : piece.Edges)
    {
      CHECK(edge[0] * local[0] + edge[1] * local[1] + edge[2] > 0.0);
    }
    const double inverse =
      piece.Inverse[0] * local[0] + piece.Inverse[1] * local[1] + piece.Inverse[2];
    // 10 - 0.2 (0.001 + x h) on the right side.
    const double depth = piece.Cell == 0 ? 10.0 : (10.0 - 0.2 * 0.001) / (1.0 + 0.2 * x[0]);
    CHECK(1.0 / inverse == Approx(depth).epsilon(1e-12));
  }
}
