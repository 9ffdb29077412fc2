// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The angles of Data/Assets/scanners.xml, against published rates and steps of data sheets.
#include "vtkHeliosFiberArray.h"
#include "vtkHeliosOscillatingMirror.h"
#include "vtkHeliosRisleyPrisms.h"
#include "vtkHeliosRotatingMirror.h"

#include <catch2/catch.hpp>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace
{

/// The text from <scanner id="..." to its sources or the next scanner, without comments and the name.
std::string ReadScanner(const std::string& id)
{
  const auto root = std::filesystem::path(__FILE__).parent_path() / "../../../..";
  std::ifstream file(root / "Data/Assets/scanners.xml");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::size_t begin = text.find("<scanner id=\"" + id + "\"");
  const std::size_t end = std::min({ text.find("<scanner", begin + 1), text.find("<!--", begin),
    text.find("<sources>", begin), text.find("</document>", begin) });
  return begin < end ? text.substr(text.find("optics=", begin), end - text.find("optics=", begin))
                     : std::string();
}

double Number(const std::string& scanner, const std::string& attribute)
{
  const std::size_t at = scanner.find(attribute + "=\"");
  INFO(attribute);
  REQUIRE(at != std::string::npos);
  return std::stod(scanner.substr(at + attribute.size() + 2));
}

/// The mirror of a scanner of the catalogue, with its maximum window.
vtkSmartPointer<vtkHeliosRotatingMirror> MakeMirror(
  const std::string& id, double pulseFrequency, double scanFrequency)
{
  const std::string scanner = ReadScanner(id);
  REQUIRE(scanner.find("optics=\"rotating\"") == 0);
  REQUIRE(scanFrequency >= Number(scanner, "scanFreqMin_Hz"));
  REQUIRE(scanFrequency <= Number(scanner, "scanFreqMax_Hz"));
  auto mirror = vtkSmartPointer<vtkHeliosRotatingMirror>::New();
  mirror->SetPulseFrequency(pulseFrequency);
  mirror->SetScanFrequency(scanFrequency);
  mirror->SetMirrorAngle(Number(scanner, "scanAngleMax_deg"));
  mirror->SetVerticalAngleMin(-Number(scanner, "scanAngleEffectiveMax_deg"));
  mirror->SetVerticalAngleMax(Number(scanner, "scanAngleEffectiveMax_deg"));
  return mirror;
}

/// The pulses emitted per second.
int MeasurementRate(const std::string& id, int pulseFrequency, double scanFrequency)
{
  auto mirror = MakeMirror(id, pulseFrequency, scanFrequency);
  int count = 0;
  double d[3];
  for (vtkIdType i = 0; i < pulseFrequency; ++i)
  {
    count += mirror->GetDirection(i, d) ? 1 : 0;
  }
  return count;
}

/// The prisms of a scanner of the catalogue.
vtkSmartPointer<vtkHeliosRisleyPrisms> MakePrisms(const std::string& id)
{
  const std::string scanner = ReadScanner(id);
  REQUIRE(scanner.find("optics=\"risley\"") == 0);
  auto prisms = vtkSmartPointer<vtkHeliosRisleyPrisms>::New();
  prisms->SetPulseFrequency(Number(scanner, "pulseFreqs_Hz"));
  for (int k = 0; k < 2; ++k)
  {
    const std::string number = std::to_string(k + 1);
    prisms->SetWedgeAngle(k, Number(scanner, "angle" + number + "_deg"));
    prisms->SetRefractiveIndex(k, Number(scanner, "refrIndex" + number));
    prisms->SetRotorFrequency(k, Number(scanner, "rotorFreq" + number + "_Hz"));
    prisms->SetRotorPhase(k, Number(scanner, "rotorPhase" + number + "_deg"));
  }
  return prisms;
}

/// The rates of the Mid-40 and Mid-70, and that the beams fill a circle.
void CheckRevolutions(vtkHeliosRisleyPrisms* prisms, double halfAngle)
{
  CHECK(60.0 * prisms->GetRotorFrequency(0) == Approx(7294.0).epsilon(1e-14));
  CHECK(60.0 * prisms->GetRotorFrequency(1) == Approx(-4664.0).epsilon(1e-14));
  double least = 90.0;
  double most = 0.0;
  for (vtkIdType i = 0; i < 100000; ++i) // 1 s
  {
    least = std::min(least, prisms->GetScanAngle(i));
    most = std::max(most, prisms->GetScanAngle(i));
  }
  CHECK(most == Approx(vtkMath::DegreesFromRadians(halfAngle)).epsilon(1e-5));
  CHECK(least < 0.5);
}

} // namespace

TEST_CASE("Catalogue: angular steps of the VZ-400 data sheet", "[ScannerCatalogue]")
{
  CHECK(MakeMirror("vz400_class_tls", 100000, 120)->GetScanAngle(1) == Approx(0.288));
  CHECK(MakeMirror("vz400_class_tls", 300000, 3)->GetScanAngle(1) == Approx(0.0024));
}

TEST_CASE("Catalogue: measurement rates of the data sheets", "[ScannerCatalogue]")
{
  CHECK(MeasurementRate("vz400_class_tls", 100000, 100) == Approx(42000).epsilon(0.01));
  CHECK(MeasurementRate("vz400_class_tls", 300000, 100) == Approx(122000).epsilon(0.03));
  CHECK(MeasurementRate("rotating_als", 1000000, 200) == Approx(666000).epsilon(0.002));
  CHECK(MeasurementRate("mobile_mls", 1000000, 250) == 1000000);
  CHECK(MeasurementRate("copter_uls", 550000, 200) == Approx(500000).epsilon(0.01));
}

TEST_CASE("Catalogue: the scan product of the ALTM Gemini", "[ScannerCatalogue]")
{
  const std::string scanner = ReadScanner("oscillating_als");
  REQUIRE(scanner.find("optics=\"oscillating\"") == 0);
  CHECK(Number(scanner, "scanProduct") == 1000.0);
  CHECK(Number(scanner, "scanFreqMax_Hz") == 70.0);
  // 50 degrees in all at 40 Hz and 167 kHz: 80 lines/s of 2087 pulses, 0.024 degrees apart
  vtkNew<vtkHeliosOscillatingMirror> mirror;
  mirror->SetPulseFrequency(167000);
  mirror->SetScanFrequency(Number(scanner, "scanProduct") / 25.0);
  mirror->SetScanAngle(Number(scanner, "scanAngleMax_deg"));
  CHECK(mirror->GetScanAngle(167000 / 40) == Approx(-25.0).epsilon(1e-3));
  CHECK(mirror->GetScanAngle(167000 / 80) == Approx(25.0).epsilon(1e-3));
  CHECK(mirror->GetScanAngle(1) - mirror->GetScanAngle(0) == Approx(50.0 * 80.0 / 167000.0));
}

TEST_CASE("Catalogue: the line rate of the Falcon II", "[ScannerCatalogue]")
{
  const std::string scanner = ReadScanner("fiber_als");
  REQUIRE(scanner.find("optics=\"line\"") == 0);
  const double fibers = Number(scanner, "numFibers");
  CHECK(Number(scanner, "pulseFreqs_Hz") / fibers == Approx(653.0).epsilon(0.001));
  vtkNew<vtkHeliosFiberArray> array;
  array->SetNumberOfFibers(static_cast<int>(fibers));
  array->SetScanAngle(Number(scanner, "scanAngleMax_deg"));
  CHECK(array->GetScanAngle(126) - array->GetScanAngle(0) == Approx(14.3));
}

TEST_CASE("Catalogue: the beam of the Mid-40 starts to the left", "[ScannerCatalogue]")
{
  const auto prisms = MakePrisms("risley_uls");
  const double a = vtkMath::RadiansFromDegrees(18.0);
  const double n = 1.5089;
  // In the plane of both wedges: the second face of the first bends the beam by b, the first face
  // of the second and its second face bend it further.
  const double b = std::asin(n * std::sin(a)) - a;
  const double most = std::asin(n * std::sin(a - std::asin(std::sin(a - b) / n)));
  double d[3];
  REQUIRE(prisms->GetDirection(0, d));
  CHECK(d[0] == Approx(-std::sin(most)).epsilon(1e-14));
  CHECK(d[2] == Approx(0.0).margin(1e-15));
  CHECK(2.0 * vtkMath::DegreesFromRadians(most) == Approx(38.4).epsilon(0.002)); // the manual
  CheckRevolutions(prisms, most);
}

TEST_CASE("Catalogue: the beam of the Mid-70 starts to the right", "[ScannerCatalogue]")
{
  const auto prisms = MakePrisms("livox_mid70");
  const double a = vtkMath::RadiansFromDegrees(18.0);
  const double n = 1.8144;
  const double b = std::asin(n * std::sin(a - std::asin(std::sin(a) / n)));
  const double most = std::asin(n * std::sin(std::asin(std::sin(b) / n) + a)) - a;
  double d[3];
  REQUIRE(prisms->GetDirection(0, d));
  CHECK(d[0] == Approx(std::sin(most)).epsilon(1e-14));
  CHECK(d[2] == Approx(0.0).margin(1e-15));
  CHECK(2.0 * vtkMath::DegreesFromRadians(most) == Approx(70.4).epsilon(0.002)); // the manual
  CheckRevolutions(prisms, most);
}

TEST_CASE("Catalogue: the six beams of the Avia", "[ScannerCatalogue]")
{
  const std::string scanner = ReadScanner("livox_avia");
  const auto prisms = MakePrisms("livox_avia");
  std::vector<double> slopes;
  for (std::size_t at = scanner.find("<channel>"); at != std::string::npos;
       at = scanner.find("<channel>", at + 1))
  {
    const std::string channel = scanner.substr(at, scanner.find("</channel>", at) - at);
    CHECK(Number(channel, "<incidentBeam x") == 0.0);
    slopes.push_back(Number(channel, " z") / Number(channel, " y"));
  }
  REQUIRE(slopes.size() == 6);
  for (std::size_t k = 0; k < 6; ++k)
  {
    CHECK(slopes[k] == Approx((5.0 - 2.0 * static_cast<double>(k)) * 0.047 / 6.0).epsilon(1e-12));
  }
  CHECK(6.0 * Number(scanner, "pulseFreqs_Hz") == 240000.0); // points/s of the manual
  // Between the two middle beams the pattern of the manual is 70.4 degrees wide.
  double d[3];
  REQUIRE(prisms->GetDirection(0, d));
  CHECK(2.0 * vtkMath::DegreesFromRadians(std::asin(d[0])) == Approx(70.4).epsilon(0.002));
}

TEST_CASE(
  "Catalogue: an instrument is identical by class and by product name", "[ScannerCatalogue]")
{
  const std::pair<const char*, const char*> pairs[] = { { "vz400_class_tls", "riegl_vz400" },
    { "rotating_als", "riegl_vq780i" }, { "conic_als", "riegl_vq880g" },
    { "mobile_mls", "riegl_vux1ha" }, { "copter_uls", "riegl_vux1uav" },
    { "oscillating_als", "optech_gemini" }, { "fiber_als", "toposys_falcon2" },
    { "risley_uls", "livox_mid40" } };
  const auto words = [](const std::string& text)
  {
    std::string kept;
    for (const char c : text)
    {
      // An element without sources ends with />.
      const bool isKept = !std::isspace(static_cast<unsigned char>(c)) && c != '/';
      kept += isKept ? std::string(1, c) : std::string();
    }
    return kept;
  };
  for (const auto& [group, product] : pairs)
  {
    INFO(group << " and " << product);
    CHECK_FALSE(ReadScanner(group).empty());
    CHECK(words(ReadScanner(group)) == words(ReadScanner(product)));
  }
}
