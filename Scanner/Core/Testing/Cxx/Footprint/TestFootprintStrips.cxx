// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The strips of a surface that is deeper than a part may be.
#include "heliosFootprintScene.h"

#include <algorithm>

using helios::FootprintPart;
using namespace helios::testing;

namespace
{

/// The parts of a steep plane, cell 0, behind a bar of two triangles, or of several or none, from a
/// left edge on; without those of next to no energy.
std::vector<FootprintPart> FindPlane(int pieces, double left = -0.02)
{
  constexpr double tilt = 20.0;
  FootprintScene scene;
  scene.Settings.Depth = 0.4;
  scene.AddTriangle({ { -9, 100 - 9 * tilt, -9 }, { 0, 100, 9 }, { 9, 100 + 9 * tilt, -9 } });
  for (int i = 0; i < pieces; ++i)
  {
    const double low = -0.4 + 0.8 * i / pieces;
    const double high = -0.4 + 0.8 * (i + 1) / pieces;
    scene.AddTriangle({ { left, 50, low }, { 0.01, 50, low }, { 0.01, 50, high } });
    scene.AddTriangle({ { left, 50, low }, { 0.01, 50, high }, { left, 50, high } });
  }
  scene.Build();
  std::vector<FootprintPart> parts = scene.FindParts();
  parts.erase(std::remove_if(parts.begin(), parts.end(),
                [](const FootprintPart& part) { return part.Cell != 0 || part.Energy < 1e-5; }),
    parts.end());
  std::sort(parts.begin(), parts.end(),
    [](const FootprintPart& a, const FootprintPart& b) { return a.Range < b.Range; });
  return parts;
}

} // namespace

TEST_CASE("Strips of a surface do not depend on how what hides it is divided")
{
  const std::vector<FootprintPart> parts = FindPlane(1);
  REQUIRE(parts.size() > 10);
  for (const int pieces : { 2, 7, 40 })
  {
    const std::vector<FootprintPart> others = FindPlane(pieces);
    CAPTURE(pieces);
    REQUIRE(others.size() == parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      // Energies are integrated to 1e-6.
      const double energy = parts[i].Energy;
      CHECK(others[i].Energy == Approx(energy).epsilon(0).margin(2e-6));
      CHECK(others[i].Range == Approx(parts[i].Range).epsilon(0).margin(0.4 * 1e-6 / energy));
    }
  }
}

TEST_CASE("A strip is two parts, at most as far from each other as the depth")
{
  const std::vector<FootprintPart> parts = FindPlane(1);
  double sum = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    sum += parts[i].Energy;
    const bool isPair = i + 1 < parts.size() && parts[i].Energy == parts[i + 1].Energy;
    CHECK((!isPair || parts[i + 1].Range - parts[i].Range <= 0.4));
  }
  CHECK(sum > 0.5);
  CHECK(sum < 1.0);
}

TEST_CASE("The strips of a surface that is hidden in part are those of all of it")
{
  const std::vector<FootprintPart> whole = FindPlane(0);
  const std::vector<FootprintPart> right = FindPlane(1, -9.0); // the left side is hidden
  REQUIRE(right.size() > 6);
  REQUIRE(right.size() < whole.size());
  // Two parts a strip; the first one is hidden in part.
  for (std::size_t i = 1; i <= right.size() - 2; ++i)
  {
    const FootprintPart& part = right[right.size() - i];
    const FootprintPart& same = whole[whole.size() - i];
    CHECK(part.Range == Approx(same.Range).epsilon(0).margin(0.4 * 1e-6 / same.Energy));
    CHECK(part.Energy == Approx(same.Energy).epsilon(0).margin(2e-6));
  }
}
