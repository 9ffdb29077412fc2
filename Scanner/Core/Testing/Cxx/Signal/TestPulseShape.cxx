// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPulseShape.h"

#include "heliosConstants.h"

#include <catch2/catch.hpp>

#include <cmath>

using helios::PulseShape;

namespace
{

/// The sum of all bins of a pulse in a window that contains it, times the bin size.
double GetArea(PulseShape& shape, double bin, double shift = 0.0)
{
  shape.SetBinSize(bin);
  const double before = 1.0 - shape.GetStart() + shift;
  std::vector<double> sum(static_cast<std::size_t>((before + shape.GetEnd()) / bin) + 3, 0.0);
  shape.Deposit(before, 1.0, sum.data(), { 0, static_cast<vtkIdType>(sum.size()) });
  double area = 0.0;
  for (const double value : sum)
  {
    area += value;
  }
  return area * bin;
}

} // namespace

TEST_CASE("PulseShape: a Gaussian", "[PulseShape]")
{
  PulseShape shape = PulseShape::MakeGaussian(4);
  const double sigma = 4 / helios::FwhmPerSigma;
  CHECK(sigma == Approx(1.698643601).epsilon(1e-9));
  CHECK(shape(0) == 1.0);
  CHECK(shape(2) == Approx(0.5).epsilon(1e-14));
  CHECK(shape(-2) == Approx(0.5).epsilon(1e-14));
  CHECK(shape.GetSigma() == Approx(sigma).epsilon(1e-15));
  // E2: the sum over bins is the area up to 2 exp(-2 pi^2 sigma^2 / dt^2).
  const double area = sigma * std::sqrt(2 * std::acos(-1.0));
  for (const double ratio : { 0.1, 0.5, 1.0 })
  {
    const double law = 2 * std::exp(-2 * std::pow(std::acos(-1.0) / ratio, 2));
    for (const double shift : { 0.0, 0.3, 0.77 })
    {
      CHECK(std::abs(GetArea(shape, ratio * sigma, shift) / area - 1) <= law + 1e-10);
    }
  }
}

TEST_CASE("PulseShape: the pulse of HELIOS", "[PulseShape]")
{
  const double tau = 1.3;
  PulseShape shape = PulseShape::MakeHelios(3.3946806708465 * tau);
  CHECK(shape(0) == 1.0);
  CHECK(shape(-2 * tau) == 0.0);
  CHECK(shape(-3 * tau) == 0.0);
  CHECK(shape(tau) == Approx(9 * std::exp(-3.0) / (4 * std::exp(-2.0))).epsilon(1e-14));
  // Half maxima, and the area 2 tau over the peak 0.541341132946451.
  CHECK(shape((0.76124022935 - 2) * tau) == Approx(0.5).epsilon(1e-8));
  CHECK(shape((0.76124022935 + 3.3946806708465 - 2) * tau) == Approx(0.5).epsilon(1e-8));
  CHECK(GetArea(shape, 0.01 * tau) == Approx(2 * tau / 0.541341132946451).epsilon(1e-8));
  // Its curvature is discontinuous at its start: the error of the sum falls with the cube of the
  // bin size.
  const double area = 2 * tau / 0.541341132946451;
  for (const double ratio : { 0.25, 0.5, 1.0 })
  {
    CHECK(std::abs(GetArea(shape, ratio * tau) / area - 1) < 8e-3 * std::pow(ratio, 3));
  }
}

TEST_CASE("PulseShape: a sampled pulse", "[PulseShape]")
{
  // A triangle that rises for 1 ns and falls for 3 ns.
  PulseShape shape = PulseShape::MakeSampled({ 10, 11, 14 }, { 0, 5, 0 });
  CHECK_FALSE(shape.IsGaussian());
  CHECK(shape.GetLength() == Approx(2.0).epsilon(1e-15));
  CHECK(shape(0) == 1.0);
  CHECK(shape(-0.5) == 0.5);
  CHECK(shape(1.5) == 0.5);
  CHECK(shape(-1.01) == 0.0);
  CHECK(shape(3.01) == 0.0);
  CHECK(GetArea(shape, 0.01) == Approx(2.0).epsilon(1e-4));
}

TEST_CASE("PulseShape: pulses are added at their exact time, not that of a bin", "[PulseShape]")
{
  const double bin = 0.5;
  for (PulseShape shape : { PulseShape::MakeGaussian(4), PulseShape::MakeHelios(4) })
  {
    shape.SetBinSize(bin);
    std::vector<double> sum(200, 0.0);
    const double time = 30.137;
    shape.Deposit(time, 3.0, sum.data(), { 0, 200 });
    for (int i = 0; i < 200; ++i)
    {
      CHECK(sum[static_cast<std::size_t>(i)] ==
        Approx(3.0 * shape(i * bin - time)).epsilon(1e-12).margin(1e-9));
    }
  }
}
