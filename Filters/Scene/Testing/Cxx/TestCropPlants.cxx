// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The shapes of single plants, measured on their triangles.

#include "heliosCropTesting.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace
{
namespace names = vtkHeliosArrayNames;
namespace truth = helios::cropFieldNames;
using helios::GetTruth;
using helios::Make;
using helios::Vec3;

/// A leaf, from its first and last triangle.
struct Leaf
{
  Vec3 Left; // middle of its base; both coincide for a pointed leaf
  Vec3 Right;
  Vec3 Tip;
  int Part;

  Vec3 GetMiddle() const { return (this->Left + this->Right) * 0.5; }

  double GetAzimuth() const
  {
    const Vec3 outward = this->Tip - this->GetMiddle();
    return std::atan2(outward[1], outward[0]);
  }
};

/// All leaves in order, with this many triangles each.
std::vector<Leaf> GetLeaves(
  vtkHeliosCropFieldSource* field, const helios::TriangleMesh& mesh, vtkIdType triangles)
{
  vtkIntArray* parts = helios::GetIds(field->GetOutput(), names::PartIds);
  const std::vector<bool> isLeaf = helios::FindMaterial(field, "crop_leaf");
  std::vector<vtkIdType> cells;
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    if (isLeaf[static_cast<std::size_t>(i)])
    {
      cells.push_back(i);
    }
  }
  REQUIRE(static_cast<vtkIdType>(cells.size()) % triangles == 0);
  std::vector<Leaf> leaves;
  for (std::size_t i = 0; i < cells.size(); i += static_cast<std::size_t>(triangles))
  {
    const vtkIdType first = cells[i];
    const vtkIdType last = first + triangles - 1;
    leaves.push_back({ Vec3(mesh.GetCorner(first, 0)), Vec3(mesh.GetCorner(first, 1)),
      Vec3(mesh.GetCorner(last, 2)), parts->GetValue(first) });
  }
  return leaves;
}

/// The corners of a material's triangles of a part; of all parts for 0.
std::vector<Vec3> GetCorners(vtkHeliosCropFieldSource* field, const helios::TriangleMesh& mesh,
  const std::string& material, int part = 0)
{
  vtkIntArray* parts = helios::GetIds(field->GetOutput(), names::PartIds);
  const std::vector<bool> is = helios::FindMaterial(field, material);
  std::vector<Vec3> corners;
  for (vtkIdType i = 0; i < 3 * mesh.GetNumberOfTriangles(); ++i)
  {
    if (is[static_cast<std::size_t>(i / 3)] && (part == 0 || parts->GetValue(i / 3) == part))
    {
      corners.emplace_back(mesh.GetCorner(i / 3, static_cast<int>(i % 3)));
    }
  }
  return corners;
}

bool IsLower(const Vec3& a, const Vec3& b)
{
  return a[2] < b[2];
}

/// An angle in [-pi, pi].
double Wrap(double angle)
{
  return std::remainder(angle, 2.0 * vtkMath::Pi());
}

} // namespace

TEST_CASE("CropPlants: maize has its leaves in one plane, with random headings", "[CropPlants]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  helios::MakeExact(field);
  field->SetNumberOfRows(20);
  field->SetRowLength(3.2); // 21 plants
  const helios::TriangleMesh mesh = Make(field);
  const std::vector<Leaf> leaves = GetLeaves(field, mesh, 15);
  REQUIRE(leaves.size() == 20 * 21 * 12);
  double off = 0.0; // deviation from the opposite side of the stem
  Vec3 sum(0.0, 0.0, 0.0);
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    const double azimuth = leaves[i].GetAzimuth();
    if (i % 12 == 0)
    {
      sum = sum + Vec3(std::cos(azimuth), std::sin(azimuth), 0.0);
      continue;
    }
    off = std::max(off, std::abs(Wrap(azimuth - leaves[i - 1].GetAzimuth() - vtkMath::Pi())));
  }
  CHECK(off < 0.6 + 1e-9);
  CHECK(off > 0.5);
  // maximum of 420 random directions: with p = 1e-4
  CHECK(sum.Norm() / 420 < 3.0 / std::sqrt(420.0));
}

TEST_CASE("CropPlants: leaves are at the golden angle around a stem", "[CropPlants]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  helios::MakeExact(field);
  field->SetSpeciesToBroadleaf();
  field->SetNumberOfRows(1);
  field->SetRowLength(0.0);
  const helios::TriangleMesh mesh = Make(field);
  const std::vector<Leaf> leaves = GetLeaves(field, mesh, 10);
  REQUIRE(leaves.size() == 24);
  const std::vector<Vec3> stalks = GetCorners(field, mesh, "crop_stem");
  const double golden = vtkMath::Pi() * (3.0 - std::sqrt(5.0));
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    // Each is at the end of its stalk.
    const Vec3& base = leaves[i].Left;
    CHECK(std::any_of(stalks.begin(), stalks.end(),
      [&base](const Vec3& corner) { return (corner - base).Norm() < 1e-12; }));
    if (i > 0)
    {
      const Vec3 turn = leaves[i].Tip - base;
      const Vec3 before = leaves[i - 1].Tip - leaves[i - 1].Left;
      const double angle = std::atan2(turn[1], turn[0]) - std::atan2(before[1], before[0]);
      CHECK(std::abs(Wrap(angle - golden)) < 0.6 + 1e-9);
    }
  }
}

TEST_CASE("CropPlants: lengths and widths of leaves vary independently", "[CropPlants]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  helios::MakeExact(field);
  field->SetLeafVariation(0.2);
  field->SetLeafDroop(0.0); // straight
  field->SetNumberOfRows(1);
  field->SetRowLength(3.2);
  const helios::TriangleMesh mesh = Make(field);
  const double base = 0.09 / 0.8 * (1.0 - std::pow(0.4 / 0.6, 2)); // ratio of width to length
  double least = 1e300;
  double most = 0.0;
  for (const Leaf& leaf : GetLeaves(field, mesh, 15))
  {
    const double ratio =
      (leaf.Right - leaf.Left).Norm() / (leaf.Tip - leaf.GetMiddle()).Norm() / base;
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  CHECK(least > 0.8 / 1.2 - 1e-9);
  CHECK(least < 0.75);
  CHECK(most < 1.2 / 0.8 + 1e-9);
  CHECK(most > 1.35);
}

TEST_CASE("CropPlants: stems lean within the limit and start in the soil", "[CropPlants]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  helios::MakeExact(field);
  field->SetNumberOfRows(10);
  field->SetRowLength(3.2);
  field->SetLeavesPerPlant(0);
  const helios::TriangleMesh mesh = Make(field);
  vtkDoubleArray* places = GetTruth(field, truth::PlantPosition);
  double most = 0.0;
  for (int part = 1; part <= 210; ++part)
  {
    const std::vector<Vec3> corners = GetCorners(field, mesh, "crop_stem", part);
    const auto ends = std::minmax_element(corners.begin(), corners.end(), IsLower);
    const double* place = places->GetPointer(3 * (part - 1));
    CHECK((*ends.first)[2] == Approx(-0.02));
    CHECK((*ends.second)[2] == Approx(2.2));
    most =
      std::max(most, std::hypot((*ends.second)[0] - place[0], (*ends.second)[1] - place[1]) / 2.2);
  }
  CHECK(most <= 0.04 + 1e-12);
  CHECK(most > 0.038);
}

TEST_CASE("CropPlants: ears grow with the plant", "[CropPlants]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  helios::MakeExact(field);
  field->SetSpeciesToCereal();
  field->SetNumberOfRows(1);
  field->SetRowLength(0.0);
  field->SetStemsPerPlant(1);
  for (const double height : { 0.9, 1.8 })
  {
    field->SetPlantHeight(height);
    const helios::TriangleMesh mesh = Make(field);
    const std::vector<Vec3> corners = GetCorners(field, mesh, "crop_ear");
    const auto ends = std::minmax_element(corners.begin(), corners.end(), IsLower);
    CHECK((*ends.second)[2] == Approx(height));
    // 0.09 m of 0.9 m; its lowest ring is slightly tilted.
    CHECK((*ends.second)[2] - (*ends.first)[2] == Approx(0.1 * height).epsilon(0.02));
  }
}

TEST_CASE("CropPlants: positions vary independently along and across, to 3 sigma", "[CropPlants]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  helios::MakeExact(field);
  field->SetPositionJitter(0.01);
  field->SetNumberOfRows(100);
  field->SetPlantSpacing(0.2);
  field->SetRowSpacing(0.5);
  field->SetRowLength(19.8); // 100 plants
  field->SetLeavesPerPlant(0);
  field->Update();
  vtkDoubleArray* places = GetTruth(field, truth::PlantPosition);
  REQUIRE(places->GetNumberOfTuples() == 10000);
  double products = 0.0;
  double most[2] = { 0.0, 0.0 };
  for (int i = 0; i < 10000; ++i)
  {
    const double away[2] = { places->GetComponent(i, 0) - 0.5 * (i / 100 - 49.5),
      places->GetComponent(i, 1) - 0.2 * (i % 100 - 49.5) };
    products += away[0] * away[1] / 1e-4;
    for (int k = 0; k < 2; ++k)
    {
      most[k] = std::max(most[k], std::abs(away[k]));
    }
  }
  CHECK(std::abs(products) / 10000 < 4.0 / std::sqrt(10000.0)); // uncorrelated: 4 sigma
  CHECK(most[0] == Approx(0.03));                               // 27 of 10000 are beyond
  CHECK(most[1] == Approx(0.03));
}
