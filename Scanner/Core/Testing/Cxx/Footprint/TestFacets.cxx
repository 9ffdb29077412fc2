// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFacets.h"
#include "heliosVisibleSurfaces.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <vector>

using helios::ConeView;
using helios::Facet;
using helios::FacetMaker;
using helios::VisibleSurfaces;

namespace
{

using Point = std::array<double, 3>;

/// Triangles before an apex, with ids from 0.
class View
{
public:
  void Add(const Point& a, const Point& b, const Point& c)
  {
    this->All.Triangles.emplace_back();
    helios::ConeTriangle& triangle = this->All.Triangles.back();
    triangle.Cell = this->Next++;
    std::copy_n(a.data(), 3, triangle.Corners[0]);
    std::copy_n(b.data(), 3, triangle.Corners[1]);
    std::copy_n(c.data(), 3, triangle.Corners[2]);
  }

  std::vector<Facet> Make(double tolerance = 1e-6)
  {
    std::vector<Facet> facets;
    FacetMaker([this](vtkIdType a, vtkIdType b)
      { return (a < this->Border) == (b < this->Border); },
      tolerance)
      .Make(this->All, facets);
    return facets;
  }

  ConeView All;
  vtkIdType Border = 1000; ///< cells from which responses differ

private:
  vtkIdType Next = 0;
};

std::vector<int> GetSizes(const std::vector<Facet>& facets)
{
  std::vector<int> sizes;
  for (const Facet& facet : facets)
  {
    sizes.push_back(facet.Size);
  }
  return sizes;
}

const Point A{ 0, 0, 10 }, B{ 1, 0, 10 }, C{ 1, 1, 10 }, D{ 0, 1, 10 };

} // namespace

TEST_CASE("Two triangles of a square are one facet, whatever their orientation", "[Facets]")
{
  View view;
  view.Add(A, B, C);
  const bool isReverse = GENERATE(false, true);
  isReverse ? view.Add(D, C, A) : view.Add(A, C, D);
  const auto facets = view.Make();
  REQUIRE(GetSizes(facets) == std::vector<int>{ 4 });
  CHECK(facets[0].Cell == 0);
  CHECK(facets[0].First == 0);
  CHECK(facets[0].Last == 2);
}

TEST_CASE("A fan about a centre is one facet once it is closed", "[Facets]")
{
  const Point centre{ 0.5, 0.5, 10 };
  View view;
  view.Add(centre, A, B);
  view.Add(centre, B, C);
  view.Add(centre, C, D);
  SECTION("open: two triangles are convex, three are not")
  {
    CHECK(GetSizes(view.Make()) == std::vector<int>{ 4, 3 });
  }
  SECTION("closed")
  {
    view.Add(centre, D, A);
    CHECK(GetSizes(view.Make()) == std::vector<int>{ 4 });
  }
}

TEST_CASE("Triangles are not joined that differ in plane, response, edge or shape", "[Facets]")
{
  const std::vector<int> separate{ 3, 3 };
  View view;
  view.Add(A, B, C);
  SECTION("plane")
  {
    view.Add(A, C, { 0, 1, 10.001 });
    CHECK(GetSizes(view.Make()) == separate);
    CHECK(GetSizes(view.Make(0.01)) == separate); // tilted by 1 mrad
  }
  SECTION("plane, by less than the tolerance")
  {
    view.Add(A, C, { 0, 1, 10.0001 });
    CHECK(GetSizes(view.Make()) == separate);
    CHECK(GetSizes(view.Make(0.01)) == std::vector<int>{ 4 });
  }
  SECTION("response")
  {
    view.Add(A, C, D);
    view.Border = 1;
    CHECK(GetSizes(view.Make()) == separate);
  }
  SECTION("edge")
  {
    view.Add(A, { 0.9, 1, 10 }, D);
    CHECK(GetSizes(view.Make()) == separate);
  }
  SECTION("the same triangle twice")
  {
    view.Add(A, B, C);
    CHECK(GetSizes(view.Make()) == separate);
  }
  SECTION("shape")
  {
    view.Add(A, C, { 1.5, 5, 10 }); // reflex at C
    CHECK(GetSizes(view.Make()) == separate);
  }
  SECTION("behind the apex")
  {
    view.Add(A, C, { -100, 0, -10 });
    CHECK(GetSizes(view.Make(1e9)) == separate);
  }
  SECTION("no responses are known")
  {
    view.Add(A, C, D);
    std::vector<Facet> facets;
    FacetMaker({}, 1.0).Make(view.All, facets);
    CHECK(GetSizes(facets) == separate);
  }
}

TEST_CASE("Facets have no more corners than fit", "[Facets]")
{
  View view;
  const auto at = [](int i) -> Point { return { 0.01 * i, 0.0001 * i * i, 10 }; };
  for (int i = 1; i + 1 < 20; ++i)
  {
    view.Add(at(0), at(i), at(i + 1));
  }
  for (const Facet& facet : view.Make())
  {
    CHECK(facet.Size <= Facet::Capacity);
  }
  CHECK(view.Make().size() == 3); // facets of 6, 6 and 6 triangles
}

TEST_CASE("Facets that share all edges in a beam are one layer", "[VisibleSurfaces]")
{
  // Four triangles about a point near the axis, at depths that differ.
  const Point middle{ 0.03, -0.02, 9 };
  const Point corners[4] = { { -2, -2, 10 }, { 2, -2, 11 }, { 2, 2, 10 }, { -2, 2, 12 } };
  View view;
  const double apexOffset = GENERATE(0.0, 3.0);
  bool isExpected = true;
  for (int i = 0; i < 4; ++i)
  {
    view.Add(middle, corners[i], corners[(i + 1) % 4]);
  }
  SECTION("whole") {}
  SECTION("a hole")
  {
    view.All.Triangles.pop_back();
    isExpected = false;
  }
  SECTION("another triangle before it")
  {
    view.Add({ 0, 0, 5 }, { 0.1, 0, 5 }, { 0, 0.1, 5 });
    isExpected = false;
  }
  SECTION("another one beside the beam")
  {
    view.Add({ 4, 0, 5 }, { 4.1, 0, 5 }, { 4, 0.1, 5 });
  }
  SECTION("one that covers the beam, before it")
  {
    view.Add({ -9, -9, 6 }, { 9, -9, 6 }, { 0, 9, 6 });
    isExpected = false;
  }
  SECTION("a flap that is folded back")
  {
    view.Add(corners[0], middle, { 0.5, -0.5, 9.5 });
    isExpected = false;
  }
  SECTION("a triangle that reaches behind the apex")
  {
    view.Add({ 4, 0, 5 }, { 4.1, 0, 5 }, { 4, 0.1, -5 });
    isExpected = false;
  }
  for (helios::ConeTriangle& triangle : view.All.Triangles)
  {
    for (auto& corner : triangle.Corners)
    {
      corner[2] += apexOffset;
    }
  }
  VisibleSurfaces surfaces;
  surfaces.Project(view.Make(), { 0.1, apexOffset });
  CHECK(surfaces.AreOneLayer() == isExpected);
}
