// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Densities on planes against closed forms of the scanners.
#include "vtkHeliosPulseDensity.h"

#include "heliosPlanningTest.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFlightArrayNames.h"
#include "vtkHeliosSurvey.h"
#include "vtkHeliosSwath.h"

#include <vtkDoubleArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>

#include <cmath>

namespace
{

constexpr double Frequency = 100000.0;
constexpr double Speed = 50.0;
constexpr double Height = 400.0;
const double Half = vtkMath::RadiansFromDegrees(20.0);

/// A scanner that looks down from a platform, its lines across.
vtkSmartPointer<vtkHeliosSurvey> MakeSurvey(const std::string& optics)
{
  auto survey = vtkSmartPointer<vtkHeliosSurvey>::New();
  survey->AddScanner("s");
  const std::vector<std::array<std::string, 2>> scanner = { { "optics", optics },
    { "pulseFreqs_Hz", "100000" }, { "scanAngleMax_deg", "20" },
    { "scanAngleEffectiveMax_deg", "20" }, { "scanFreqMin_Hz", "10" }, { "scanFreqMax_Hz", "200" },
    { "numFibers", "100" }, { "rangeMax_m", "2000" } };
  for (const auto& [name, value] : scanner)
  {
    REQUIRE(survey->SetScannerAttribute(0, name, value));
  }
  survey->AddPlatform("p");
  REQUIRE(survey->SetPlatformAttribute(0, "type", "linearpath"));
  const std::vector<std::array<std::string, 2>> mount = { { "[0]/axis", "x" },
    { "[0]/angle_deg", "-90" }, { "[1]/axis", "z" }, { "[1]/angle_deg", "-90" } };
  for (const auto& [name, value] : mount)
  {
    REQUIRE(survey->SetPlatformAttribute(0, "scannerMount/rot" + name, value));
  }
  for (int leg = 0; leg < 2; ++leg)
  {
    survey->AddLeg();
    REQUIRE(survey->SetLegAttribute(leg, "x", std::to_string(leg)));
    REQUIRE(survey->SetLegAttribute(leg, "pulseFreq_hz", "100000"));
    REQUIRE(survey->SetLegAttribute(leg, "scanFreq_hz", "100"));
  }
  REQUIRE(survey->Check());
  return survey;
}

/// A line along y, from -1000 to 1000 m.
vtkSmartPointer<vtkPolyData> MakeLine(double speed = Speed)
{
  auto line = helios::MakePoints({ { 0, -1000, Height }, { 0, 1000, Height } });
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1 });
  line->SetLines(cells);
  vtkNew<vtkDoubleArray> speeds;
  speeds->SetName(vtkHeliosArrayNames::Speed);
  speeds->InsertNextValue(speed);
  speeds->InsertNextValue(speed);
  line->GetPointData()->AddArray(speeds);
  return line;
}

struct Prediction
{
  vtkNew<vtkHeliosSwath> Swath;
  vtkNew<vtkHeliosPulseDensity> Filter;
  vtkNew<helios::ErrorObserver> Log;

  explicit Prediction(const std::string& optics)
  {
    REQUIRE(this->Swath->Build(MakeSurvey(optics), 0));
    this->Filter->SetSwath(this->Swath);
    this->Filter->SetInputData(1, MakeLine());
    this->Log->Watch(this->Filter);
  }

  /// The density at x, with the slope of z in x and in y.
  double Compute(double x, double slopeX = 0.0, double slopeY = 0.0)
  {
    auto places = helios::MakePoints({ { x, 0, 0 } });
    vtkNew<vtkDoubleArray> normals;
    normals->SetName(vtkHeliosArrayNames::Normal);
    normals->SetNumberOfComponents(3);
    normals->InsertNextTuple3(-slopeX, -slopeY, 1.0);
    places->GetPointData()->AddArray(normals);
    this->Filter->SetInputData(0, places);
    this->Filter->Update();
    INFO(this->Log->Errors);
    vtkDataArray* density =
      this->Filter->GetOutput()->GetPointData()->GetArray(vtkHeliosFlightArrayNames::PulseDensity);
    REQUIRE(density);
    return density->GetTuple1(0);
  }
};

} // namespace

TEST_CASE("PulseDensity: equal angles, on planes", "[PulseDensity]")
{
  // Rate per angle f / (2 Half), x = Height tan(angle).
  const std::string optics = GENERATE("rotating", "oscillating");
  Prediction prediction(optics);
  const auto wanted = [](double x)
  {
    const double a = x / Height;
    return Frequency / (2.0 * Half * (1.0 + a * a)) / (Speed * Height);
  };
  for (const double x : { 0.0, -60.0, 130.0 })
  {
    CHECK(prediction.Compute(x) == Approx(wanted(x)).epsilon(0.004));
    CHECK(prediction.Compute(x, 0.3, 0.8) ==
      Approx(wanted(x) * (1.0 + 0.3 * x / Height)).epsilon(0.004));
  }
  CHECK(prediction.Compute(Height * std::tan(Half) + 1.0) == 0.0);
  CHECK(prediction.Swath->GetPulseRate() == Approx(Frequency).epsilon(0.001));
  CHECK(prediction.Swath->GetRightTangent() == Approx(std::tan(Half)).epsilon(0.002));
  CHECK(prediction.Swath->GetLeftTangent() == Approx(-std::tan(Half)).epsilon(0.002));
}

TEST_CASE("PulseDensity: a row of fibres", "[PulseDensity]")
{
  Prediction prediction("line");
  const double step = 2.0 * Half / 99.0;
  const double wanted = Frequency / 100.0 / step / (Speed * Height);
  CHECK(prediction.Compute(0.0) == Approx(wanted).epsilon(0.03));
}

TEST_CASE("PulseDensity: a cone", "[PulseDensity]")
{
  // Azimuths are equally probable: the rate per a is f / (pi sqrt(t^2 - a^2)), t = tan(Half).
  Prediction prediction("conic");
  const double t = std::tan(Half);
  for (const double x : { 0.0, 40.0, -90.0 })
  {
    const double a = x / Height;
    const double wanted = Frequency / (vtkMath::Pi() * std::sqrt(t * t - a * a)) / (Speed * Height);
    CHECK(prediction.Compute(x) == Approx(wanted).epsilon(0.01));
    CHECK(prediction.Compute(x, 0.2, 0.5) == Approx(wanted * (1.0 + 0.2 * a)).epsilon(0.01));
    // b = +- sqrt(t^2 - a^2): a slope that hides one of them.
    const double steep = 1.5 / std::sqrt(t * t - a * a);
    CHECK(prediction.Compute(x, 0.0, steep) == Approx(wanted * 2.5 / 2.0).epsilon(0.01));
  }
}

TEST_CASE("PulseDensity: strips add up, and their heights", "[PulseDensity]")
{
  Prediction prediction("rotating");
  const double one = prediction.Compute(50.0);
  auto lines = helios::MakePoints(
    { { 0, -100, Height }, { 0, 100, Height }, { 100, 100, Height }, { 100, -100, Height } });
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1 });
  cells->InsertNextCell({ 2, 3 });
  lines->SetLines(cells);
  vtkNew<vtkDoubleArray> speeds;
  speeds->SetName(vtkHeliosArrayNames::Speed);
  speeds->SetNumberOfTuples(4);
  speeds->Fill(Speed);
  lines->GetPointData()->AddArray(speeds);
  prediction.Filter->SetInputData(1, lines);
  CHECK(prediction.Compute(50.0) == Approx(2.0 * one).epsilon(0.002));
  vtkPointData* data = prediction.Filter->GetOutput()->GetPointData();
  CHECK(data->GetArray(vtkHeliosFlightArrayNames::NumberOfStrips)->GetTuple1(0) == 2.0);
  CHECK(data->GetArray(vtkHeliosFlightArrayNames::FlyingHeight)->GetTuple1(0) == Height);
  CHECK(data->GetArray(vtkHeliosFlightArrayNames::StripDensity)->GetTuple1(0) ==
    Approx(one).epsilon(0.002));
}

TEST_CASE("PulseDensity: errors", "[PulseDensity]")
{
  Prediction prediction("rotating");
  prediction.Filter->SetInputData(0, helios::MakePoints({ { 0, 0, 0 } }));
  std::string wanted;
  SECTION("no swath")
  {
    prediction.Filter->SetSwath(nullptr);
    wanted = "Swath is not set, or not built";
  }
  SECTION("no speed")
  {
    auto line = MakeLine();
    line->GetPointData()->RemoveArray(vtkHeliosArrayNames::Speed);
    prediction.Filter->SetInputData(1, line);
    wanted = "the flight lines have no point array Speed";
  }
  SECTION("a speed that is not positive")
  {
    prediction.Filter->SetInputData(1, MakeLine(0.0));
    wanted = "Speed of flight line 0 is 0 m/s";
  }
  SECTION("a place that is not finite")
  {
    prediction.Filter->SetInputData(0, helios::MakePoints({ { std::nan(""), 0, 0 } }));
    wanted = "place 0 on port 0 is (nan, 0, 0)";
  }
  prediction.Filter->Update();
  CHECK_THAT(prediction.Log->Errors, Catch::Contains(wanted));
}

TEST_CASE("Swath: errors", "[Swath]")
{
  vtkNew<vtkHeliosSwath> swath;
  vtkNew<helios::ErrorObserver> log;
  log->Watch(swath);
  const auto survey = MakeSurvey("rotating");
  CHECK_FALSE(swath->Build(survey, 7));
  CHECK_THAT(log->Errors, Catch::Contains("the survey has no leg 7"));
  CHECK(swath->GetRate(0.0) == 0.0);
  REQUIRE(survey->SetPlatformAttribute(0, "scannerMount/rot[0]/angle_deg", "90"));
  REQUIRE(survey->Check());
  CHECK_FALSE(swath->Build(survey, 0));
  CHECK_THAT(log->Errors, Catch::Contains("points down within 75 deg of nadir"));
}
