// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "vtkHeliosRisleyPrisms.h"

#include <catch2/catch.hpp>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <limits>

namespace
{

struct Reference
{
  int Case;
  vtkIdType Pulse;
  double Direction[3];
};

// Printed by ../Python/make_risley_reference.py: 40 digits, phases in integers.
// clang-format off
const Reference References[] = {
  { 0, 0LL, { 0.0, 0.94686385302356113043, -0.32163464340362346223 } },
  { 0, 1LL, { 0.00046832309963303159580, 0.94686585254225063774, -0.32162841597550304387 } },
  { 0, 777LL, { 0.047621709614977368462, 0.99869833227832174734, -0.018270574097318844822 } },
  { 0, 12345678LL, { 0.31261159855373023509, 0.94972981039093568293, 0.016949209553214111441 } },
  { 0, 86399999999LL, { -0.063704632920071874800, 0.99491454662195717076, 0.078017720195762616283 } },
  { 0, 86400000000LL, { -0.064924205482396970215, 0.99471434261582469822, 0.079550135995152213636 } },
  { 1, 0LL, { 0.0, 0.81724784035643838238, -0.57628635888136151828 } },
  { 1, 1LL, { -0.000038525477134111637138, 0.81724790399632291188, -0.57628626734410788031 } },
  { 1, 777LL, { -0.030980457219564654100, 0.85361367666002735689, -0.51998452120175364996 } },
  { 1, 12345678LL, { 0.0069988328445983661780, 0.99988244893774190913, 0.013642017632202169215 } },
  { 1, 86399999999LL, { -0.087001089537830544073, 0.96343076542224658276, -0.25344027039350804594 } },
  { 1, 86400000000LL, { -0.086936735641667311719, 0.96352571181566961285, -0.25310117871333203953 } },
  { 2, 0LL, { -0.062347968638854966076, 0.90037093939503203949, -0.43063314119969435977 } },
  { 2, 1LL, { -0.062291828430993793573, 0.90037375042215854295, -0.43063538830600091813 } },
  { 2, 777LL, { -0.019517583093714958739, 0.92886573251542780914, -0.36990203420467648099 } },
  { 2, 12345678LL, { 0.23496100633753517750, 0.93636948997928206388, 0.26077864892815121093 } },
  { 2, 86399999999LL, { -0.062404104151464932784, 0.90036822921323030737, -0.43063067657621082169 } },
  { 2, 86400000000LL, { -0.062347968175056357506, 0.90037093943255776072, -0.43063314118838504003 } },
};
// clang-format on

void SetPrism(vtkHeliosRisleyPrisms* prisms, int k, double wedge, double index, double rotor)
{
  prisms->SetWedgeAngle(k, wedge);
  prisms->SetRefractiveIndex(k, index);
  prisms->SetRotorFrequency(k, rotor);
}

/// The cases of make_risley_reference.py.
void SetUp(vtkHeliosRisleyPrisms* prisms, int which)
{
  prisms->SetPulseFrequency(which == 0 ? 100000.0 : 1e6);
  if (which == 0)
  {
    SetPrism(prisms, 0, 18.0, 1.51, -121.5666);
    SetPrism(prisms, 1, 18.0, 1.51, 77.7333);
  }
  else if (which == 1)
  {
    SetPrism(prisms, 0, -29.7, 1.5095, -77.7333);
    SetPrism(prisms, 1, 29.7, 1.5095, 121.5666);
  }
  else
  {
    prisms->SetAirRefractiveIndex(1.00027);
    prisms->SetIncidentBeam(-0.0625, 1.0, 0.03125);
    SetPrism(prisms, 0, 20.5, 1.51, -131.5);
    SetPrism(prisms, 1, -19.5, 1.62, 40.8);
    SetPrism(prisms, 2, 3.25, 1.45, 213.1);
  }
}

double Radians(double degrees)
{
  return vtkMath::RadiansFromDegrees(degrees);
}

} // namespace

TEST_CASE(
  "RisleyPrisms: two and three prisms to 40 digits, also after a day at 1 MHz", "[RisleyPrisms]")
{
  for (const Reference& reference : References)
  {
    vtkNew<vtkHeliosRisleyPrisms> prisms;
    SetUp(prisms, reference.Case);
    INFO("case " << reference.Case << ", pulse " << reference.Pulse);
    double d[3];
    REQUIRE(prisms->GetDirection(reference.Pulse, d));
    CHECK(vtkMath::Norm(d) == Approx(1.0).epsilon(4e-16));
    for (int k = 0; k < 3; ++k)
    {
      CHECK(d[k] == Approx(reference.Direction[k]).margin(4e-15));
    }
  }
}

TEST_CASE("RisleyPrisms: one prism, in either orientation", "[RisleyPrisms]")
{
  vtkNew<vtkHeliosRisleyPrisms> prisms;
  const double n = 1.51;
  const double a = Radians(18.0);
  SetPrism(prisms, 0, 18.0, n, 0.0);
  const double first = std::asin(n * std::sin(a - std::asin(std::sin(a) / n)));
  CHECK(prisms->GetScanAngle(0) == Approx(vtkMath::DegreesFromRadians(first)).epsilon(1e-14));
  prisms->SetWedgeAngle(0, -18.0);
  const double second = std::asin(n * std::sin(a)) - a;
  CHECK(prisms->GetScanAngle(0) == Approx(vtkMath::DegreesFromRadians(second)).epsilon(1e-14));
  // It refracts a beam to its thick side: at angle 0 that is -z if the second face is inclined.
  double d[3];
  REQUIRE(prisms->GetDirection(0, d));
  CHECK(d[0] == 0.0);
  CHECK(d[2] == Approx(-std::sin(second)).epsilon(1e-14));
  prisms->SetWedgeAngle(0, 1e-4); // thin: (n - 1) a
  CHECK(prisms->GetScanAngle(0) == Approx(0.51e-4).epsilon(1e-9));
}

TEST_CASE("RisleyPrisms: the sign of a rotor frequency is its direction", "[RisleyPrisms]")
{
  vtkNew<vtkHeliosRisleyPrisms> prisms;
  prisms->SetPulseFrequency(400.0);
  SetPrism(prisms, 0, -10.0, 1.5, 100.0);
  double d[3];
  double e[3];
  REQUIRE(prisms->GetDirection(1, d)); // a quarter revolution
  prisms->SetRotorFrequency(0, -100.0);
  REQUIRE(prisms->GetDirection(1, e));
  CHECK(d[0] < -0.08);
  CHECK(e[0] == Approx(-d[0]).epsilon(1e-14));
  CHECK(d[2] == Approx(0.0).margin(1e-16));
}

TEST_CASE("RisleyPrisms: a phase is an angle at pulse 0", "[RisleyPrisms]")
{
  vtkNew<vtkHeliosRisleyPrisms> ahead;
  vtkNew<vtkHeliosRisleyPrisms> prisms;
  for (vtkHeliosRisleyPrisms* p : { ahead.Get(), prisms.Get() })
  {
    p->SetPulseFrequency(400.0);
    SetPrism(p, 0, -10.0, 1.5, 100.0);
    SetPrism(p, 1, 12.0, 1.6, -50.0);
  }
  ahead->SetRotorPhase(0, 90.0); // one pulse
  ahead->SetRotorPhase(1, -45.0);
  CHECK(ahead->GetRotorPhase(1) == -45.0);
  for (const vtkIdType pulse : { 0, 1, 2, 777 })
  {
    double d[3];
    double e[3];
    REQUIRE(ahead->GetDirection(pulse, d));
    REQUIRE(prisms->GetDirection(pulse + 1, e));
    for (int k = 0; k < 3; ++k)
    {
      CHECK(d[k] == Approx(e[k]).margin(1e-15));
    }
  }
}

TEST_CASE("RisleyPrisms: opposite prisms cancel", "[RisleyPrisms]")
{
  vtkNew<vtkHeliosRisleyPrisms> prisms;
  prisms->SetPulseFrequency(100.0);
  SetPrism(prisms, 0, -25.0, 1.6, 0.0);
  SetPrism(prisms, 2, 25.0, 1.6, 50.0); // half a revolution per pulse
  double d[3];
  REQUIRE(prisms->GetDirection(1, d));
  CHECK(d[0] == Approx(0.0).margin(1e-15));
  CHECK(d[1] == Approx(1.0).epsilon(1e-15));
  CHECK(d[2] == Approx(0.0).margin(1e-15));
  REQUIRE(prisms->GetDirection(0, d));
  CHECK(d[2] < -0.5); // and add up half a revolution later
}

TEST_CASE("RisleyPrisms: no prism, no deflection", "[RisleyPrisms]")
{
  vtkNew<vtkHeliosRisleyPrisms> prisms;
  double d[3];
  REQUIRE(prisms->GetDirection(0, d));
  CHECK(d[1] == 1.0);
  prisms->SetIncidentBeam(0.0, 4.0, 3.0);
  SetPrism(prisms, 1, 30.0, 1.33, 12.0);
  prisms->SetAirRefractiveIndex(1.33); // under water, prisms of water
  for (vtkIdType i = 0; i < 100000; i += 1001)
  {
    REQUIRE(prisms->GetDirection(i, d));
    REQUIRE(d[0] == Approx(0.0).margin(1e-16));
    REQUIRE(d[1] == Approx(0.8).epsilon(1e-15));
    REQUIRE(d[2] == Approx(0.6).epsilon(1e-15));
  }
}

TEST_CASE("RisleyPrisms: total reflection suppresses the pulse", "[RisleyPrisms]")
{
  vtkNew<vtkHeliosRisleyPrisms> prisms;
  const double critical = vtkMath::DegreesFromRadians(std::asin(1.0 / 1.51));
  SetPrism(prisms, 0, -(critical - 1e-9), 1.51, 0.0);
  double d[3] = { 7.0, 8.0, 9.0 };
  CHECK(prisms->GetDirection(0, d));
  CHECK(d[0] == 0.0);
  d[0] = 7.0;
  prisms->SetWedgeAngle(0, -(critical + 1e-9));
  CHECK_FALSE(prisms->GetDirection(0, d));
  CHECK(d[0] == 7.0); // not set
  CHECK(prisms->GetScanAngle(0) == 0.0);
  // A beam that misses a face, from behind it.
  SetPrism(prisms, 0, 60.0, 1.51, 0.0);
  prisms->SetIncidentBeam(0.0, 1.0, 2.0);
  CHECK_FALSE(prisms->GetDirection(0, d));
}

TEST_CASE("RisleyPrisms: values out of range", "[RisleyPrisms]")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkHeliosRisleyPrisms> prisms;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(prisms);
  SetPrism(prisms, 0, 95.0, 0.5, 1e9);
  CHECK(prisms->GetWedgeAngle(0) == 89.0);
  CHECK(prisms->GetRefractiveIndex(0) == 1.0);
  CHECK(prisms->GetRotorFrequency(0) == 1e6);
  SetPrism(prisms, 0, nan, nan, nan);
  CHECK(prisms->GetWedgeAngle(0) == 0.0);
  CHECK(prisms->GetRefractiveIndex(0) == 1.0);
  CHECK(prisms->GetRotorFrequency(0) == 0.0);
  prisms->SetRotorPhase(0, -400.0);
  CHECK(prisms->GetRotorPhase(0) == -360.0);
  prisms->SetRotorPhase(0, nan);
  CHECK(prisms->GetRotorPhase(0) == 0.0);
  prisms->SetAirRefractiveIndex(nan);
  CHECK(prisms->GetAirRefractiveIndex() == 1.0);
  CHECK(log->Errors.empty());

  prisms->SetWedgeAngle(3, 10.0);
  CHECK(log->HasError("there is no prism 3; give 0, 1 or 2"));
  prisms->SetRotorPhase(4, 10.0);
  CHECK(log->HasError("there is no prism 4"));
  prisms->SetRefractiveIndex(-1, 1.5);
  CHECK(log->HasError("there is no prism -1"));
  const double infinity = std::numeric_limits<double>::infinity();
  const double bad[5][3] = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, -1.0, 0.0 },
    { 0.0, nan, 0.0 }, { infinity, 1.0, 0.0 } };
  for (const auto& beam : bad)
  {
    log->Errors.clear();
    prisms->SetIncidentBeam(beam);
    CHECK(log->HasError("does not point at the prisms; give a direction with y > 0"));
    CHECK(prisms->GetIncidentBeam()[1] == 1.0);
  }
}
