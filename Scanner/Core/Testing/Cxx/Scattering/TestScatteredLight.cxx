// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Light that is scattered more than once, against closed forms and quadratures.
#include "heliosScatteringBench.h"

using namespace helios::testing;
using helios::Vec3;

namespace
{

/// Integrates over [0, end] by Simpson's rule.
double Integrate(const std::function<double(double)>& f, double end, int steps = 20000)
{
  double sum = f(0.0) + f(end);
  for (int i = 1; i < steps; ++i)
  {
    sum += (i % 2 == 0 ? 2.0 : 4.0) * f(end * i / steps);
  }
  return sum * end / (3.0 * steps);
}

/// Chandrasekhar's H(1) of isotropic scattering with an albedo, by iteration.
double GetChandrasekharH(double albedo)
{
  constexpr int count = 400;
  const auto mu = [](int i) { return (i + 0.5) / count; };
  std::vector<double> h(count, 1.0);
  const auto iterate = [&](double m)
  {
    double sum = 0.0;
    for (int j = 0; j < count; ++j)
    {
      sum += mu(j) * h[static_cast<std::size_t>(j)] / (m + mu(j)) / count;
    }
    // 1 / H = sqrt(1 - albedo) + albedo / 2 int mu' H / (mu + mu')
    return 1.0 / (std::sqrt(1.0 - albedo) + 0.5 * albedo * sum);
  };
  for (int k = 0; k < 200; ++k)
  {
    std::vector<double> next(count);
    for (int i = 0; i < count; ++i)
    {
      next[static_cast<std::size_t>(i)] = iterate(mu(i));
    }
    h = next;
  }
  return iterate(1.0);
}

} // namespace

TEST_CASE("ScatteredLight: a Lambertian sphere returns rho / (1 - rho), delayed by its mean chord")
{
  constexpr double radius = 2.0;
  const double rho = GENERATE(0.3, 0.8);
  LightBench bench;
  bench.SetScene(MakeSphere(radius, rho));
  const double first = rho * bench.GetWhite(radius);
  const Vec3 axis = Vec3(0.3, 0.5, 0.7).Normalized();
  for (const int orders : { 2, 3, 64 })
  {
    bench.Settings.Orders = orders;
    const auto result = bench.Run({ 0, 0, 0 }, axis, 100);
    const double truth = first * (rho - std::pow(rho, orders)) / (1.0 - rho);
    CheckTruth(result, truth, 0.02, 2e-3);
    if (orders == 64) // order n is n - 1 chords of 4 R / 3 later
    {
      const double delay = radius * 2.0 / 3.0 / (1.0 - rho);
      CHECK(result.Range == Approx(radius + delay).epsilon(0.02));
    }
  }
}

TEST_CASE("ScatteredLight: a field of view shows its share of a sphere")
{
  LightBench bench;
  bench.SetScene(MakeSphere(1.0, 0.5));
  bench.Settings.Orders = 64;
  const Vec3 axis = Vec3(0.3, 0.5, 0.7).Normalized();
  for (const double half : { 1.0, 0.2 })
  {
    bench.Settings.HalfFieldOfView = half;
    const double share = 0.5 * (1.0 - std::cos(half));
    const auto result = bench.Run({ 0, 0, 0 }, axis, 200);
    CheckTruth(result, share * 0.5 * bench.GetWhite(1.0), 0.02, 3e-3);
  }
}

TEST_CASE(
  "ScatteredLight: two parallel planes return what the Hankel transform of their view gives")
{
  constexpr double apart = 3.0, rho = 0.7, half = 1000.0;
  auto scene = MakeScene({ Wall(0.5 * apart, half), Wall(-0.5 * apart, half) });
  SetMaterial(scene, rho);
  LightBench bench;
  bench.SetScene(scene);
  const auto getOrder = [](int n)
  {
    return std::pow(rho, n) *
      Integrate(
        [n](double q)
        {
          const double view = q > 0.0 ? q * apart * std::cyl_bessel_k(1.0, q * apart) : 1.0;
          return q * std::pow(view, n - 1) * std::exp(-0.5 * q * apart);
        },
        40.0);
  };
  double truth = 0.0;
  for (int orders = 2; orders <= 5; ++orders)
  {
    truth += bench.GetWhite(1.0) * getOrder(orders);
    bench.Settings.Orders = orders;
    CheckTruth(bench.Run({ 0, 0, 0 }, { 0, 1, 0 }, 200), truth, 0.02, 1e-3);
  }
}

TEST_CASE("ScatteredLight: a corner returns the quadrature of its second order")
{
  // The floor and a wall that meet along x; the beam meets the floor 0.2 m before the wall.
  constexpr double floor = 0.6, wall = 0.4, far = 300.0;
  auto scene = MakeScene({ { { -far, -far, 0 }, { 2 * far, 0, 0 }, { 0, far, 0 } },
    { { -far, 0, 0 }, { 2 * far, 0, 0 }, { 0, 0, 2 * far } } });
  helios::Material materials[2];
  materials[0].Reflectance = floor;
  materials[1].Reflectance = wall;
  helios::SetMaterials(scene, { materials[0], materials[1] });
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkHeliosArrayNames::MaterialIds);
  for (const int id : { 0, 0, 1, 1 })
  {
    ids->InsertNextValue(id);
  }
  scene->GetCellData()->AddArray(ids);
  LightBench bench;
  bench.SetScene(scene);
  const Vec3 receiver(1.0, -8.0, 5.0), first(0.0, -0.2, 0.0);
  const Vec3 axis = (first - receiver).Normalized();
  const auto getIrradiance = [&](const Vec3& y) // on the wall, of a beam of 1 W
  {
    const Vec3 apart = y - first;
    const double square = apart.SquaredNorm();
    return floor / Pi * std::max(0.0, apart[2]) * std::max(0.0, apart[1]) / (square * square);
  };
  for (const double half : { 0.5, 0.03 })
  {
    constexpr int rings = 1500, turns = 1500;
    double sum = 0.0;
    const double cap = 1.0 - std::cos(half);
    for (int i = 0; i < rings; ++i)
    {
      const double cosine = 1.0 - cap * (i + 0.5) / rings;
      for (int k = 0; k < turns; ++k)
      {
        const Vec3 d = helios::GetAround(
          axis, cosine, std::sqrt(1.0 - cosine * cosine), 2.0 * Pi * (k + 0.5) / turns);
        const Vec3 y = receiver + (-receiver[1] / d[1]) * d; // on the plane of the wall
        sum += d[1] > 0.0 && y[2] > 0.0 ? getIrradiance(y) : 0.0;
      }
    }
    const double truth = 0.25 * std::pow(bench.Settings.Equation.ReceiverDiameter, 2) * wall * sum *
      2.0 * Pi * cap / (rings * turns);
    bench.Settings.HalfFieldOfView = half;
    CheckTruth(bench.Run(receiver, axis, 400), truth, 0.02, 2e-3);
  }
}

TEST_CASE("ScatteredLight: a semi-infinite isotropic medium returns Chandrasekhar's H squared")
{
  constexpr double distance = 2000.0;
  const double albedo = GENERATE(0.5, 0.9);
  const int cells[3] = { 8, 4, 8 };
  LightBench bench;
  vtkNew<vtkPolyData> nothing;
  bench.SetScene(nothing);
  // 20 free paths in a metre
  bench.AddGrid(MakeBox({ -4.0, 0.0, -4.0 }, 1.0, cells, 40.0, 0.25 * albedo));
  bench.Settings.IsIsotropic = true;
  bench.Settings.Orders = 64;
  bench.Settings.HalfFieldOfView = std::atan(4.0 * std::sqrt(2.0) / distance);
  const double h = GetChandrasekharH(albedo);
  const double truth = bench.GetWhite(distance) * 0.125 * albedo * (h * h - 1.0);
  CheckTruth(bench.Run({ 0, -distance, 0 }, { 0, 1, 0 }, 400), truth, 0.01, 2e-3);
}
