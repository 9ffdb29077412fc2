// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosBeamDeflector.h"

#include "heliosExactPhase.h"
#include "vtkHeliosConicMirror.h"
#include "vtkHeliosFiberArray.h"
#include "vtkHeliosOscillatingMirror.h"
#include "vtkHeliosPalmerMirror.h"
#include "vtkHeliosRisleyPrisms.h"
#include "vtkHeliosRotatingMirror.h"
#include "vtkHeliosSpinningChannels.h"

#include <catch2/catch.hpp>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <limits>
#include <vector>

namespace
{

/// A user-defined deflector: pulse i is at i times 1e-8 rad from the y axis, odd ones are not
/// emitted.
class TinySteps : public vtkHeliosBeamDeflector
{
public:
  static TinySteps* New();
  vtkTypeMacro(TinySteps, vtkHeliosBeamDeflector);

  bool GetDirection(vtkIdType pulse, double direction[3]) const override
  {
    const double angle = 1e-8 * static_cast<double>(pulse);
    direction[0] = std::sin(angle);
    direction[1] = std::cos(angle);
    direction[2] = 0.0;
    return pulse % 2 == 0;
  }
};
vtkStandardNewMacro(TinySteps);

/// One of each, with nonzero motion.
std::vector<vtkSmartPointer<vtkHeliosBeamDeflector>> MakeAll()
{
  auto prisms = vtkSmartPointer<vtkHeliosRisleyPrisms>::New();
  prisms->SetWedgeAngle(0, 18.0);
  prisms->SetRotorFrequency(0, -121.57);
  prisms->SetWedgeAngle(1, -20.0);
  prisms->SetRotorFrequency(1, 77.73);
  auto channels = vtkSmartPointer<vtkHeliosSpinningChannels>::New();
  channels->SetNumberOfChannels(5);
  channels->SetElevation(3, 20.0);
  channels->SetFiringTime(3, 1e-5);
  return { vtkSmartPointer<vtkHeliosRotatingMirror>::New(),
    vtkSmartPointer<vtkHeliosOscillatingMirror>::New(), vtkSmartPointer<vtkHeliosFiberArray>::New(),
    vtkSmartPointer<vtkHeliosConicMirror>::New(), vtkSmartPointer<vtkHeliosPalmerMirror>::New(),
    prisms, channels };
}

} // namespace

TEST_CASE("BeamDeflector: the scan angle is exact where an arc cosine is not", "[BeamDeflector]")
{
  vtkNew<TinySteps> deflector;
  for (const vtkIdType pulse : { 2, 4, 1000, 100000000 })
  {
    const double expected = vtkMath::DegreesFromRadians(1e-8 * static_cast<double>(pulse));
    CHECK(deflector->GetScanAngle(pulse) == Approx(expected).epsilon(1e-14));
  }
}

TEST_CASE("BeamDeflector: the scan angle is 0 if no pulse is emitted", "[BeamDeflector]")
{
  vtkNew<TinySteps> deflector;
  CHECK(deflector->GetScanAngle(3) == 0.0);
}

TEST_CASE("BeamDeflector: the pulse frequency stays positive", "[BeamDeflector]")
{
  vtkNew<TinySteps> deflector;
  CHECK(deflector->GetPulseFrequency() == 100000.0);
  deflector->SetPulseFrequency(-5.0);
  CHECK(deflector->GetPulseFrequency() == 1e-9);
  deflector->SetPulseFrequency(3e5);
  CHECK(deflector->GetPulseFrequency() == 3e5);
}

TEST_CASE("BeamDeflector: one channel at a constant rate", "[BeamDeflector]")
{
  vtkNew<TinySteps> deflector;
  CHECK(deflector->GetChannel(12345) == 0);
  CHECK(deflector->GetDelay(12345) == 0.0);
}

TEST_CASE("BeamDeflector: a warm-up equals a later start", "[BeamDeflector]")
{
  for (const auto& deflector : MakeAll())
  {
    INFO(deflector->GetClassName());
    deflector->SetPulseFrequency(1048576.0); // for exact times
    bool moves = false;
    for (const vtkIdType pulse : { 0LL, 1LL, 4711LL, 86400000000LL })
    {
      double cold[3];
      double later[3];
      double warm[3];
      deflector->SetWarmUpTime(0.0);
      REQUIRE(deflector->GetDirection(pulse, cold));
      REQUIRE(deflector->GetDirection(pulse + 99999, later));
      const int channel = deflector->GetChannel(pulse + 99999);
      deflector->SetWarmUpTime(99999.0 / 1048576.0);
      REQUIRE(deflector->GetDirection(pulse, warm));
      CHECK(deflector->GetChannel(pulse) == channel);
      for (int k = 0; k < 3; ++k)
      {
        CHECK(warm[k] == Approx(later[k]).margin(6e-15));
        moves = moves || std::abs(cold[k] - later[k]) > 0.01;
      }
    }
    CHECK(moves);
  }
}

TEST_CASE("BeamDeflector: any warm-up time, to the last digits", "[BeamDeflector]")
{
  // 100 000.5 pulses: moving optics are half a pulse further than the pulse before.
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetPulseFrequency(1e6);
  mirror->SetScanFrequency(100.0);
  mirror->SetWarmUpTime(0.1000005);
  CHECK(mirror->GetScanAngle(0) == Approx(360.0 * 5e-5).epsilon(1e-9));
  vtkNew<vtkHeliosFiberArray> array;
  array->SetPulseFrequency(1e6);
  array->SetNumberOfFibers(1000);
  array->SetWarmUpTime(0.1000004); // the nearest whole pulse
  CHECK(array->GetScanAngle(0) == -10.0);
  array->SetWarmUpTime(0.1000006);
  CHECK(array->GetScanAngle(0) == Approx(-10.0 + 20.0 / 999.0).epsilon(1e-14));
  // A day of warm-up, then a day.
  mirror->SetScanFrequency(99.7);
  mirror->SetWarmUpTime(86400.0);
  const double phase = helios::ExactPhase(2 * 86400000000LL, 99.7, 1000000);
  CHECK(mirror->GetScanAngle(86400000000LL) == Approx(360.0 * phase).margin(180.0 * 1e-15));
}

TEST_CASE("BeamDeflector: frequency and warm-up are never NaN", "[BeamDeflector]")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& deflector : MakeAll())
  {
    INFO(deflector->GetClassName());
    deflector->SetWarmUpTime(nan);
    CHECK(deflector->GetWarmUpTime() == 0.0);
    deflector->SetWarmUpTime(-1.0);
    CHECK(deflector->GetWarmUpTime() == 0.0);
    deflector->SetWarmUpTime(1e9);
    CHECK(deflector->GetWarmUpTime() == 1e6);
    deflector->SetPulseFrequency(nan);
    CHECK(deflector->GetPulseFrequency() == 1e-9);
    double d[3];
    REQUIRE(deflector->GetDirection(3, d));
    CHECK(vtkMath::Norm(d) == Approx(1.0).epsilon(1e-15));
  }
}
