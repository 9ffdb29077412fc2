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

TEST_CASE("SpinningChannels: beams that fire at once have equal times", "[SpinningChannels]")
{
  vtkNew<vtkHeliosSpinningChannels> head;
  SetUp(head);
  head->SetPulseFrequency(1310720.0 / 3.0);
  for (int c = 0; c < 16; ++c)
  {
    CHECK(head->GetElapsedTime(c) == c / head->GetPulseFrequency());
    head->SetFiringTime(c, c < 8 ? 0.0 : 1e-6);
  }
  for (vtkIdType i = 0; i < 1600000; i += 16)
  {
    const double first = head->GetElapsedTime(i);
    for (vtkIdType c = 1; c < 16; ++c)
    {
      REQUIRE(head->GetElapsedTime(i + c) == (c < 8 ? first : first + 1e-6));
    }
  }
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

TEST_CASE("SpinningChannels: origins on a circle that the head turns", "[SpinningChannels]")
{
  // Ouster: columns of beams that start 15.806 mm from the axis; column m of 1024 at the encoder
  // angle 2 pi (1 - m / 1024), clockwise from 180 degrees.
  vtkNew<vtkHeliosSpinningChannels> head;
  head->SetPulseFrequency(2.0 * 10240.0);
  head->SetScanFrequency(-10.0);
  head->SetStartAngle(180.0);
  head->SetNumberOfChannels(2);
  for (int c = 0; c < 2; ++c)
  {
    head->SetFiringTime(c, 0.0);
    head->SetOriginOffset(c, 0.015806);
    head->SetElevation(c, c == 0 ? 20.95 : -21.82);
    head->SetAzimuth(c, c == 0 ? -4.21 : 4.2);
  }
  head->SetOriginHeight(1, -0.0112);
  for (const vtkIdType pulse : { 0, 1, 514, 515, 2046, 2047, 2048, 4097 })
  {
    INFO("pulse " << pulse);
    const auto column = static_cast<double>(pulse / 2 % 1024);
    const double turn = 2.0 * Pi * (1.0 - column / 1024.0) + Pi;
    double origin[3];
    REQUIRE(head->GetOrigin(pulse, origin));
    CHECK(origin[0] == Approx(-0.015806 * std::sin(turn)).margin(1e-15));
    CHECK(origin[1] == Approx(0.015806 * std::cos(turn)).margin(1e-15));
    CHECK(origin[2] == (pulse % 2 == 0 ? 0.0 : -0.0112));
    const double own = turn + (pulse % 2 == 0 ? -4.21 : 4.2) * Pi / 180.0;
    double d[3];
    REQUIRE(head->GetDirection(pulse, d));
    CHECK(std::atan2(-d[0], d[1]) == Approx(std::remainder(own, 2.0 * Pi)).margin(1e-13));
    CHECK(head->GetColumn(pulse) == pulse / 2 % 1024);
  }
  CHECK(head->GetOriginOffset(1) == 0.015806);
  CHECK(head->GetOriginHeight(1) == -0.0112);
}

TEST_CASE("SpinningChannels: without an offset beams start at the origin", "[SpinningChannels]")
{
  vtkNew<vtkHeliosSpinningChannels> head;
  SetUp(head);
  double origin[3] = { 7.0, 8.0, 9.0 };
  CHECK_FALSE(head->GetOrigin(5, origin));
  CHECK(origin[0] == 7.0);
  head->SetOriginHeight(3, 0.01);
  CHECK(head->GetOrigin(3, origin));
  CHECK(origin[2] == 0.01);
  CHECK_FALSE(head->GetOrigin(4, origin));
}

TEST_CASE("SpinningChannels: columns count the cycles of a revolution", "[SpinningChannels]")
{
  vtkNew<vtkHeliosSpinningChannels> head;
  SetUp(head);
  for (vtkIdType i = 0; i < 40000; ++i) // 1000 columns a revolution
  {
    REQUIRE(head->GetColumn(i) == i / 16 % 1000);
  }
  CHECK(head->GetColumn(16000LL * 1728000) == 0); // after a day
  CHECK(head->GetColumn(16000LL * 1728000 - 1) == 999);
  CHECK(head->GetColumn(16000LL * 1728000 + 16 * 357) == 357);
  // 1808.4 columns: the first of each revolution is the first that starts in it.
  head->SetPulseFrequency(16.0 / 55.296e-6);
  head->SetScanFrequency(-10.0);
  vtkIdType revolution = 0;
  vtkIdType first = 0;
  for (vtkIdType cycle = 0; cycle < 20000; ++cycle)
  {
    if (static_cast<double>(cycle) * 55.296e-5 >= static_cast<double>(revolution + 1))
    {
      ++revolution;
      first = cycle;
    }
    REQUIRE(head->GetColumn(16 * cycle + 7) == cycle - first);
  }
  // 1000 columns, but 7.1 is not a double: revolutions begin a rounding error late.
  head->SetPulseFrequency(16.0 * 7100.0);
  head->SetScanFrequency(7.1);
  for (const vtkIdType turn : { 1, 2, 3, 500, 100000 })
  {
    CHECK(head->GetColumn(16000 * turn) == 0);
    CHECK(head->GetColumn(16000 * turn - 1) == 999);
  }
  head->SetScanFrequency(0.0);
  CHECK(head->GetColumn(12345) == 0);
}

TEST_CASE("SpinningChannels: origins out of range", "[SpinningChannels]")
{
  vtkNew<vtkHeliosSpinningChannels> head;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(head);
  head->SetOriginOffset(0, 11.0);
  head->SetOriginHeight(0, -11.0);
  head->SetStartAngle(400.0);
  CHECK(head->GetOriginOffset(0) == 10.0);
  CHECK(head->GetOriginHeight(0) == -10.0);
  CHECK(head->GetStartAngle() == 360.0);
  head->SetOriginOffset(0, std::numeric_limits<double>::quiet_NaN());
  CHECK(head->GetOriginOffset(0) == 0.0);
  head->SetOriginOffset(1, 0.1);
  CHECK(log->HasError("there is no channel 1"));
}
