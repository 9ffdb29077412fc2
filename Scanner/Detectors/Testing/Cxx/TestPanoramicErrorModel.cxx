// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPose.h"
#include "vtkHeliosPanoramicErrorModel.h"

#include <vtkMath.h>
#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using Model = vtkHeliosPanoramicErrorModel;
using helios::Vec3;

constexpr double Offset = 1e-6; // [m]
constexpr double Tilt = 1e-6;   // [rad]

/// Range, azimuth and zenith angle (negative in the back face), or changes of them.
struct Polar
{
  double R, H, V;
};

Vec3 Aim(double zenith)
{
  return { 0.0, std::sin(zenith), std::cos(zenith) };
}

/// True minus reported values of a point at a range, by the geometry of the ray.
Polar ComputeErrors(const Model& model, double range, double zenith)
{
  Vec3 ray = Aim(zenith);
  Vec3 origin(0.0, 0.0, 0.0);
  model.MoveRay(origin.GetData(), ray.GetData());
  const Vec3 point = origin + (range - model.GetRangeError(0.0)) * ray;
  const double side = zenith < 0.0 ? -1.0 : 1.0; // side of the face
  const double across = std::hypot(point[0], point[1]);
  return { point.Norm() - range, std::atan2(side * point[0], side * point[1]),
    std::atan2(side * across, point[2]) - zenith };
}

/// A parameter alone, and its terms of the model for a front face (k = 1) or a back face (-1) and a
/// zenith angle from 0 to pi.
struct Case
{
  std::string Name;
  std::function<void(Model&)> Set;
  std::function<Polar(double k, double range, double zenith)> Terms;
};

std::vector<Case> MakeCases()
{
  constexpr double d = Offset;
  constexpr double a = Tilt;
  const double tilt = vtkMath::DegreesFromRadians(a);
  return {
    { "x1n", [](Model& m) { m.SetHorizontalBeamOffset(d); },
      [](double k, double r, double v) {
        return Polar{ 0.0, d / r, k * d * std::cos(v) / r };
      } },
    { "x1z", [](Model& m) { m.SetVerticalBeamOffset(d); },
      [](double k, double r, double v) {
        return Polar{ 0.0, k * d / (r * std::tan(v)), -d * std::sin(v) / r };
      } },
    { "x2", [](Model& m) { m.SetTransitOffset(d); },
      [](double k, double r, double v) {
        return Polar{ k * d * std::sin(v), 0.0, k * d * std::cos(v) / r };
      } },
    { "x3", [](Model& m) { m.SetMirrorOffset(d); },
      [](double k, double r, double v) {
        return Polar{ 0.0, k * d / (r * std::sin(v)), 0.0 };
      } },
    { "x4", [=](Model& m) { m.SetVerticalIndexOffset(tilt); },
      [](double k, double, double) {
        return Polar{ 0.0, 0.0, k * a };
      } },
    { "x5n", [=](Model& m) { m.SetHorizontalBeamTilt(tilt); },
      [](double k, double, double v) {
        return Polar{ 0.0, a, k * a * std::cos(v) };
      } },
    { "x5z", [=](Model& m) { m.SetVerticalBeamTilt(tilt); },
      [](double k, double, double v) {
        return Polar{ 0.0, k * a / std::tan(v), -a * std::sin(v) };
      } },
    { "x6", [=](Model& m) { m.SetMirrorTilt(tilt); },
      [](double k, double, double v) {
        return Polar{ 0.0, k * 2.0 * a / std::sin(v), 0.0 };
      } },
    { "x7", [=](Model& m) { m.SetTransitTilt(tilt); },
      [](double k, double, double v) {
        return Polar{ 0.0, -k * a / std::tan(v), 0.0 };
      } },
    { "x10", [](Model& m) { m.SetRangeOffset(d); },
      [](double, double, double) {
        return Polar{ d, 0.0, 0.0 };
      } },
  };
}

} // namespace

TEST_CASE("PanoramicErrorModel: each parameter alone has the terms of the NIST model in both faces",
  "[PanoramicErrorModel]")
{
  for (const Case& one : MakeCases())
  {
    vtkNew<vtkHeliosPanoramicErrorModel> model;
    one.Set(*model);
    for (const double range : { 2.0, 50.0 })
    {
      for (const double degrees : { 20.0, 90.0, 145.0 })
      {
        CAPTURE(one.Name, range, degrees);
        const double v = vtkMath::RadiansFromDegrees(degrees);
        const Polar front = ComputeErrors(*model, range, v);
        const Polar back = ComputeErrors(*model, range, -v);
        const Polar ofFront = one.Terms(1.0, range, v);
        const Polar ofBack = one.Terms(-1.0, range, v);
        constexpr double second = 1e-11; // squares of the parameters, over the sine
        CHECK(front.R == Approx(ofFront.R).margin(second));
        CHECK(front.H == Approx(ofFront.H).margin(second));
        CHECK(front.V == Approx(ofFront.V).margin(second));
        CHECK(back.R == Approx(ofBack.R).margin(second));
        CHECK(back.H == Approx(ofBack.H).margin(second));
        // the zenith angle of the model is positive in both faces
        CHECK(-back.V == Approx(ofBack.V).margin(second));
      }
    }
  }
}

TEST_CASE("PanoramicErrorModel: parameters add up to first order", "[PanoramicErrorModel]")
{
  vtkNew<vtkHeliosPanoramicErrorModel> all;
  Polar sum{ 0.0, 0.0, 0.0 };
  const double v = 0.9;
  for (const Case& one : MakeCases())
  {
    one.Set(*all);
    const Polar terms = one.Terms(1.0, 10.0, v);
    sum = { sum.R + terms.R, sum.H + terms.H, sum.V + terms.V };
  }
  const Polar found = ComputeErrors(*all, 10.0, v);
  CHECK(found.R == Approx(sum.R).margin(1e-10));
  CHECK(found.H == Approx(sum.H).margin(1e-10));
  CHECK(found.V == Approx(sum.V).margin(1e-10));
}

TEST_CASE("PanoramicErrorModel: a beam to the zenith is reflected, without a singularity",
  "[PanoramicErrorModel]")
{
  vtkNew<vtkHeliosPanoramicErrorModel> model;
  model->SetMirrorTilt(0.5);
  Vec3 ray(0.0, 0.0, 1.0);
  Vec3 origin(0.0, 0.0, 0.0);
  CHECK(model->MoveRay(origin.GetData(), ray.GetData()));
  const double turned = vtkMath::RadiansFromDegrees(1.0);
  CHECK(ray[0] == Approx(std::sin(turned)).epsilon(1e-12));
  CHECK(ray[1] == Approx(0.0).margin(1e-15));
  CHECK(ray[2] == Approx(std::cos(turned)).epsilon(1e-12));
  CHECK(origin.Norm() == 0.0);
}

TEST_CASE("PanoramicErrorModel: no ray moves without a parameter, or along the shaft",
  "[PanoramicErrorModel]")
{
  vtkNew<vtkHeliosPanoramicErrorModel> model;
  Vec3 ray = Aim(1.0);
  Vec3 origin(0.0, 0.0, 0.0);
  CHECK_FALSE(model->MoveRay(origin.GetData(), ray.GetData()));
  model->SetRangeOffset(0.01); // errors of ranges only
  CHECK_FALSE(model->MoveRay(origin.GetData(), ray.GetData()));
  model->SetTransitOffset(0.1);
  Vec3 shaft(1.0, 0.0, 0.0);
  CHECK_FALSE(model->MoveRay(origin.GetData(), shaft.GetData()));
  CHECK(shaft[0] == 1.0);
  CHECK(origin.Norm() == 0.0);
}

TEST_CASE("PanoramicErrorModel: range offset and expression add up", "[PanoramicErrorModel]")
{
  vtkNew<vtkHeliosPanoramicErrorModel> model;
  model->SetRangeErrorExpression("0.003");
  model->SetRangeOffset(0.001);
  CHECK(model->GetRangeError(0.3) == Approx(0.002));
  std::ostringstream text;
  model->Print(text);
  CHECK(text.str().find("RangeOffset: 0.001 m") != std::string::npos);
}
