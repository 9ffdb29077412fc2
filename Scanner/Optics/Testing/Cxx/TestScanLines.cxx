// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Scan direction and edge of flight line, against the mirror laws in whole numbers.
#include "vtkHeliosConicMirror.h"
#include "vtkHeliosFiberArray.h"
#include "vtkHeliosOscillatingMirror.h"
#include "vtkHeliosPalmerMirror.h"
#include "vtkHeliosRisleyPrisms.h"
#include "vtkHeliosRotatingMirror.h"
#include "vtkHeliosSpinningChannels.h"

#include <catch2/catch.hpp>
#include <vtkNew.h>

namespace
{

/// The half period of an oscillation in which a pulse is, in whole numbers; frequencies in Hz.
vtkIdType GetHalfPeriod(vtkIdType pulse, vtkIdType scanFrequency, vtkIdType pulseFrequency)
{
  return 2 * pulse * scanFrequency / pulseFrequency;
}

/// A pulse and what comes after it.
struct Shot
{
  bool IsFired = false;
  double Angle = 0.0;
};

Shot GetShot(vtkHeliosBeamDeflector* deflector, vtkIdType pulse)
{
  double direction[3];
  return { deflector->GetDirection(pulse, direction), deflector->GetScanAngle(pulse) };
}

/// Whether the next pulse that is fired has a smaller angle: another facet.
bool StartsAnew(vtkHeliosBeamDeflector* deflector, vtkIdType pulse)
{
  const double angle = GetShot(deflector, pulse).Angle;
  Shot next;
  for (vtkIdType i = pulse + 1; !next.IsFired; ++i)
  {
    next = GetShot(deflector, i);
  }
  return next.Angle <= angle;
}

} // namespace

TEST_CASE(
  "ScanLines: an oscillating mirror has a direction and an edge per half period", "[ScanLines]")
{
  vtkNew<vtkHeliosOscillatingMirror> mirror;
  mirror->SetPulseFrequency(100000.0);
  mirror->SetScanAngle(15.0);
  const int pattern =
    GENERATE(vtkHeliosOscillatingMirror::TRIANGULAR, vtkHeliosOscillatingMirror::SINUSOIDAL);
  mirror->SetPattern(pattern);
  const vtkIdType frequency = GENERATE(50, 65, 71);
  mirror->SetScanFrequency(static_cast<double>(frequency));
  vtkNew<vtkHeliosOscillatingMirror> dense; // a thousand pulses for each
  dense->SetPulseFrequency(1e8);
  dense->SetScanAngle(15.0);
  dense->SetPattern(pattern);
  dense->SetScanFrequency(static_cast<double>(frequency));
  vtkIdType edges = 0;
  const vtkIdType count = 10000;
  for (vtkIdType i = 0; i < count; ++i)
  {
    INFO(i);
    const vtkIdType half = GetHalfPeriod(i, frequency, 100000);
    const bool isLast = GetHalfPeriod(i + 1, frequency, 100000) != half;
    REQUIRE(mirror->GetScanDirectionFlag(i) == (half % 2 == 0 ? 1 : 0));
    REQUIRE(mirror->IsEdgeOfFlightLine(i) == isLast);
    const double after = dense->GetScanAngle(1000 * i + 1);
    REQUIRE((after > mirror->GetScanAngle(i)) == (mirror->GetScanDirectionFlag(i) == 1));
    edges += isLast ? 1 : 0;
  }
  CHECK(edges == GetHalfPeriod(count, frequency, 100000));
}

TEST_CASE(
  "ScanLines: a polygon has one direction, and an edge in the window of each facet", "[ScanLines]")
{
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetPulseFrequency(30000.0);
  mirror->SetScanFrequency(GENERATE(70.0, 100.0, 333.3));
  mirror->SetMirrorAngle(45.0);
  const double most = GENERATE(20.0, 45.0, 60.0);
  mirror->SetVerticalAngleMin(-most);
  mirror->SetVerticalAngleMax(most - 3.0);
  int edges = 0;
  for (vtkIdType i = 0; i < 6000; ++i)
  {
    INFO(i);
    const bool isFired = GetShot(mirror, i).IsFired;
    REQUIRE(mirror->GetScanDirectionFlag(i) == 1);
    REQUIRE(mirror->IsEdgeOfFlightLine(i) == (isFired && StartsAnew(mirror, i)));
    edges += mirror->IsEdgeOfFlightLine(i) ? 1 : 0;
  }
  CHECK(edges == Approx(0.2 * mirror->GetScanFrequency()).margin(1.0)); // 0.2 s
}

TEST_CASE("ScanLines: a row of fibres ends at the last one", "[ScanLines]")
{
  vtkNew<vtkHeliosFiberArray> array;
  array->SetNumberOfFibers(127);
  array->SetWarmUpTime(3e-5); // three pulses
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    REQUIRE(array->GetScanDirectionFlag(i) == 1);
    REQUIRE(array->IsEdgeOfFlightLine(i) == (array->GetScanAngle(i) == array->GetScanAngle()));
  }
  array->SetNumberOfFibers(1);
  CHECK(array->GetScanDirectionFlag(5) == 0);
  CHECK_FALSE(array->IsEdgeOfFlightLine(5));
}

TEST_CASE("ScanLines: optics without lines have no flags", "[ScanLines]")
{
  vtkNew<vtkHeliosConicMirror> conic;
  vtkNew<vtkHeliosPalmerMirror> palmer;
  vtkNew<vtkHeliosRisleyPrisms> prisms;
  vtkNew<vtkHeliosSpinningChannels> channels;
  vtkNew<vtkHeliosOscillatingMirror> still;
  still->SetScanFrequency(0.0);
  vtkNew<vtkHeliosRotatingMirror> fixed;
  fixed->SetScanFrequency(0.0);
  vtkHeliosBeamDeflector* const all[] = { conic, palmer, prisms, channels, still, fixed };
  for (vtkHeliosBeamDeflector* optics : all)
  {
    INFO(optics->GetClassName());
    for (vtkIdType i = 0; i < 5000; ++i)
    {
      REQUIRE(optics->GetScanDirectionFlag(i) == 0);
      REQUIRE_FALSE(optics->IsEdgeOfFlightLine(i));
    }
  }
}

TEST_CASE("ScanLines: every pulse is an edge where lines are skipped", "[ScanLines]")
{
  vtkNew<vtkHeliosOscillatingMirror> mirror;
  mirror->SetPulseFrequency(100.0);
  mirror->SetScanFrequency(GENERATE(50.0, 100.0, 1000.0));
  vtkNew<vtkHeliosRotatingMirror> polygon;
  polygon->SetPulseFrequency(100.0);
  polygon->SetScanFrequency(200.0);
  for (vtkIdType i = 0; i < 20; ++i)
  {
    CHECK(mirror->IsEdgeOfFlightLine(i));
    CHECK(polygon->IsEdgeOfFlightLine(i));
  }
}
