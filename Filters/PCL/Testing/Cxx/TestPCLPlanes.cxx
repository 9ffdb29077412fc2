// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPclTesting.h"
#include "vtkHeliosPCLPlanes.h"

#include <vtkMath.h>

#include <catch2/catch.hpp>

namespace names = vtkHeliosPCLArrayNames;

namespace
{

constexpr double Noise = 0.01; // [m], along the normal

struct Patch
{
  helios::Triple Centre;
  helios::Triple U; // unit vectors in the plane
  helios::Triple V;
  double Size;
  int Count;

  helios::Triple GetNormal() const
  {
    helios::Triple n;
    vtkMath::Cross(this->U.data(), this->V.data(), n.data());
    return n;
  }
};

/// Two slopes of a roof and a wall.
std::vector<Patch> MakePatches()
{
  return { { { 0.0, -4.0, 5.0 }, { 1, 0, 0 }, { 0, 0.8, 0.6 }, 10.0, 20000 },
    { { 0.0, 4.0, 5.0 }, { 1, 0, 0 }, { 0, 0.8, -0.6 }, 10.0, 15000 },
    { { 30.0, 0.0, 2.0 }, { 0, 1, 0 }, { 0, 0, 1 }, 4.0, 4000 } };
}

helios::Triples MakePoints(const std::vector<Patch>& patches)
{
  helios::Uniform uniform(31);
  helios::Triples points;
  for (const Patch& patch : patches)
  {
    const helios::Triple n = patch.GetNormal();
    for (int i = 0; i < patch.Count; ++i)
    {
      const double u = uniform(-0.5, 0.5) * patch.Size;
      const double v = uniform(-0.5, 0.5) * patch.Size;
      const double w = Noise * uniform.Normal();
      helios::Triple p = helios::Utm + patch.Centre;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        p[axis] += u * patch.U[axis] + v * patch.V[axis] + w * n[axis];
      }
      points.push_back(p);
    }
  }
  for (int i = 0; i < 500; ++i) // clutter
  {
    points.push_back(
      helios::Utm + helios::Triple{ uniform(-10, 40), uniform(-10, 10), uniform(8, 20) });
  }
  return points;
}

} // namespace

TEST_CASE("PCLPlanes: planes are accurate within the noise", "[PCLPlanes]")
{
  const auto patches = MakePatches();
  helios::Filtering<vtkHeliosPCLPlanes> run(MakePoints(patches));
  run.Filter->SetDistanceThreshold(4.0 * Noise);
  run.Filter->SetMinimumNumberOfPoints(1000);
  REQUIRE(run.Run());
  CHECK(run.CountMoved() == 0);
  REQUIRE(run.Filter->GetNumberOfPlanes() == 3);
  vtkIdType first = 0;
  for (int plane = 0; plane < 3; ++plane)
  {
    const Patch& patch = patches[static_cast<std::size_t>(plane)];
    const double root = std::sqrt(static_cast<double>(patch.Count));
    double row[4];
    double centre[3];
    run.GetField(names::PlaneCoefficients)->GetTuple(plane, row);
    run.GetField(names::PlaneCentre)->GetTuple(plane, centre);
    helios::Triple n = patch.GetNormal();
    const double cosine = std::abs(vtkMath::Dot(n.data(), row));
    // s / (u sqrt(n)) about each of two axes, u = size / sqrt(12); four standard deviations
    const double spread = patch.Size / std::sqrt(12.0);
    helios::Triple cross;
    vtkMath::Cross(n.data(), row, cross.data());
    CHECK(vtkMath::Norm(cross.data()) < 4.0 * std::sqrt(2.0) * Noise / (spread * root));
    CHECK(cosine > 0.999);
    // the true distance from the detected centre
    helios::Triple offset;
    const helios::Triple truth = helios::Utm + patch.Centre;
    vtkMath::Subtract(centre, truth.data(), offset.data());
    CHECK(std::abs(vtkMath::Dot(offset.data(), n.data())) < 4.0 * Noise / root);
    CHECK(std::abs(vtkMath::Dot(row, centre) + row[3]) < 1e-8);
    CHECK(run.GetField(names::PlaneDeviation)->GetTuple1(plane) == Approx(Noise).epsilon(0.03));
    CHECK(row[2] >= 0.0);

    vtkIdType right = 0;
    for (vtkIdType i = first; i < first + patch.Count; ++i)
    {
      right += run.Get(names::PlaneIds)->GetTuple1(i) == plane ? 1 : 0;
    }
    CHECK(static_cast<double>(right) > 0.99 * patch.Count); // not those at the ridge
    first += patch.Count;
  }
  vtkIdType clutter = 0;
  for (vtkIdType i = first; i < run.Count(); ++i)
  {
    clutter += run.Get(names::PlaneIds)->GetTuple1(i) < 0 ? 1 : 0;
  }
  CHECK(clutter > 480);
}

TEST_CASE("PCLPlanes: the requested number of planes, repeatably", "[PCLPlanes]")
{
  helios::Filtering<vtkHeliosPCLPlanes> run(MakePoints(MakePatches()));
  run.Filter->SetMaximumNumberOfPlanes(1);
  REQUIRE(run.Run());
  CHECK(run.Filter->GetNumberOfPlanes() == 1);
  CHECK(run.GetField(names::PlaneCoefficients)->GetNumberOfTuples() == 1);
  const double d = run.GetField(names::PlaneCoefficients)->GetComponent(0, 3);
  REQUIRE(run.Run());
  CHECK(run.GetField(names::PlaneCoefficients)->GetComponent(0, 3) == d);
  run.Filter->SetMinimumNumberOfPoints(50000);
  REQUIRE(run.Run());
  CHECK(run.Filter->GetNumberOfPlanes() == 0);
  CHECK(run.Count() == 39500);
}
