// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosBeamDeflector.h"

#include <catch2/catch.hpp>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>

#include <cmath>

namespace
{

/// What a user writes: pulse i leaves at i times 1e-8 rad from the y axis, odd ones not at all.
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

TEST_CASE("BeamDeflector: the scan angle is 0 where no pulse leaves", "[BeamDeflector]")
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
