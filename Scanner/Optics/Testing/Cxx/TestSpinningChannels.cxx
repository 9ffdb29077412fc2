// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosExactPhase.h"
#include "vtkHeliosSpinningChannels.h"

#include <catch2/catch.hpp>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <limits>

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// 16 channels from -15 to 15 degrees, 20 revolutions/s.
void SetUp(vtkHeliosSpinningChannels* head)
{
  head->SetPulseFrequency(320000.0);
  head->SetScanFrequency(20.0);
  head->SetNumberOfChannels(16);
  for (int c = 0; c < 16; ++c)
  {
    head->SetElevation(c, 2.0 * c - 15.0);
  }
}

/// Elevation and azimuth of a pulse [deg], the latter in (-180, 180].
void GetAngles(vtkHeliosSpinningChannels* head, vtkIdType pulse, double& elevation, double& azimuth)
{
  double d[3];
  REQUIRE(head->GetDirection(pulse, d));
  REQUIRE(vtkMath::Norm(d) == Approx(1.0).epsilon(1e-15));
  elevation = vtkMath::DegreesFromRadians(std::atan2(d[2], std::hypot(d[0], d[1])));
  azimuth = vtkMath::DegreesFromRadians(std::atan2(-d[0], d[1]));
}

} // namespace

TEST_CASE("SpinningChannels: pulse i is channel i mod n at its own azimuth", "[SpinningChannels]")
{
  vtkNew<vtkHeliosSpinningChannels> head;
  SetUp(head);
  for (vtkIdType i = 0; i < 16000; ++i) // one revolution
  {
    double elevation;
    double azimuth;
    GetAngles(head, i, elevation, azimuth);
    const double expected = 360.0 * static_cast<double>(i) / 16000.0;
    REQUIRE(head->GetChannel(i) == i % 16);
    REQUIRE(head->GetDelay(i) == 0.0);
    REQUIRE(elevation == Approx(2.0 * static_cast<double>(i % 16) - 15.0).margin(1e-13));
    REQUIRE(azimuth == Approx(expected > 180.0 ? expected - 360.0 : expected).margin(1e-12));
    REQUIRE(head->GetScanAngle(i) == Approx(expected).margin(1e-12));
  }
}

TEST_CASE(
  "SpinningChannels: azimuths of channels, and heads that rotate clockwise", "[SpinningChannels]")
{
  vtkNew<vtkHeliosSpinningChannels> head;
  SetUp(head);
  head->SetAzimuth(3, -4.2);
  CHECK(head->GetScanAngle(3) == Approx(360.0 + 360.0 * 3.0 / 16000.0 - 4.2).epsilon(1e-14));
  head->SetScanFrequency(-20.0);
  double elevation;
  double azimuth;
  GetAngles(head, 4000, elevation, azimuth);
  CHECK(azimuth == Approx(-90.0).epsilon(1e-14)); // to the right
  CHECK(elevation == Approx(-15.0).epsilon(1e-14));
}

TEST_CASE("SpinningChannels: firing times", "[SpinningChannels]")
{
  // A VLP-16: 16 lasers 2.304 us apart, then 18.432 us to recharge; 18.08 kHz cycles.
  vtkNew<vtkHeliosSpinningChannels> head;
  SetUp(head);
  const double cycle = 55.296e-6;
  head->SetPulseFrequency(16.0 / cycle);
  for (int c = 0; c < 16; ++c)
  {
    head->SetFiringTime(c, 2.304e-6 * c);
  }
  for (vtkIdType i = 0; i < 100000; ++i)
  {
    const double time =
      cycle * static_cast<double>(i / 16) + 2.304e-6 * static_cast<double>(i % 16);
    const double turns = 20.0 * time;
    REQUIRE(head->GetScanAngle(i) == Approx(360.0 * (turns - std::floor(turns))).margin(1e-9));
    REQUIRE(static_cast<double>(i) / head->GetPulseFrequency() + head->GetDelay(i) ==
      Approx(time).margin(1e-15));
  }
  head->SetFiringTime(5, 0.0); // with the first
  CHECK(head->GetScanAngle(5) == head->GetScanAngle(0));
  CHECK(head->GetDelay(5) == Approx(-5.0 / head->GetPulseFrequency()).epsilon(1e-15));
}

TEST_CASE("SpinningChannels: no drift after a day", "[SpinningChannels]")
{
  vtkNew<vtkHeliosSpinningChannels> head;
  SetUp(head);
  head->SetPulseFrequency(1e6);
  head->SetScanFrequency(-19.7);
  head->SetFiringTime(7, 0.0);
  for (const vtkIdType pulse : { 86400000000LL, 86399999999LL, 77777777777LL, 86400000007LL })
  {
    const vtkIdType fired = pulse % 16 == 7 ? pulse - 7 : pulse;
    const double azimuth = 2.0 * Pi * helios::ExactPhase(fired, -19.7, 1000000);
    const double elevation =
      vtkMath::RadiansFromDegrees(2.0 * static_cast<double>(pulse % 16) - 15.0);
    double d[3];
    REQUIRE(head->GetDirection(pulse, d));
    CHECK(head->GetChannel(pulse) == pulse % 16);
    CHECK(d[0] == Approx(-std::sin(azimuth) * std::cos(elevation)).margin(3e-15));
    CHECK(d[1] == Approx(std::cos(azimuth) * std::cos(elevation)).margin(3e-15));
    CHECK(d[2] == Approx(std::sin(elevation)).margin(1e-15));
  }
}

TEST_CASE("SpinningChannels: values out of range", "[SpinningChannels]")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkHeliosSpinningChannels> head;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(head);
  CHECK(head->GetNumberOfChannels() == 1);
  head->SetElevation(0, 100.0);
  CHECK(head->GetElevation(0) == 90.0);
  head->SetElevation(0, nan);
  CHECK(head->GetElevation(0) == 0.0);
  head->SetAzimuth(0, nan);
  CHECK(head->GetAzimuth(0) == 0.0);
  head->SetFiringTime(0, nan);
  CHECK(head->GetFiringTime(0) == -1.0);
  head->SetNumberOfChannels(0);
  CHECK(head->GetNumberOfChannels() == 1);
  CHECK(log->Errors.empty());
  head->SetElevation(1, 5.0);
  CHECK(log->HasError("there is no channel 1; give one from 0 to 0, or set NumberOfChannels"));
  head->SetAzimuth(-1, 5.0);
  CHECK(log->HasError("there is no channel -1"));
  double d[3];
  for (const double frequency : { 0.0, -1e6, 1e6, nan })
  {
    head->SetScanFrequency(frequency);
    REQUIRE(head->GetDirection(9007199254740991LL, d));
    CHECK(vtkMath::Norm(d) == Approx(1.0).epsilon(1e-15));
  }
}
