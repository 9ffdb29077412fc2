// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The angles of Data/Assets/scanners.xml, against published rates and steps of data sheets.
#include "vtkHeliosFiberArray.h"
#include "vtkHeliosOscillatingMirror.h"
#include "vtkHeliosRisleyPrisms.h"
#include "vtkHeliosRotatingMirror.h"

#include <catch2/catch.hpp>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

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

TEST_CASE("Catalogue: the field of view of the Mid-40", "[ScannerCatalogue]")
{
  const std::string scanner = ReadScanner("risley_uls");
  REQUIRE(scanner.find("optics=\"risley\"") == 0);
  CHECK(60.0 * Number(scanner, "rotorFreq1_Hz") == Approx(-7294.0));
  CHECK(60.0 * Number(scanner, "rotorFreq2_Hz") == Approx(4664.0));
  vtkNew<vtkHeliosRisleyPrisms> prisms;
  prisms->SetPulseFrequency(Number(scanner, "pulseFreqs_Hz"));
  for (int k = 0; k < 2; ++k)
  {
    const std::string number = std::to_string(k + 1);
    prisms->SetWedgeAngle(k, Number(scanner, "angle" + number + "_deg"));
    prisms->SetRefractiveIndex(k, Number(scanner, "refrIndex" + number));
    prisms->SetRotorFrequency(k, Number(scanner, "rotorFreq" + number + "_Hz"));
  }
  double least = 90.0;
  double most = 0.0;
  for (vtkIdType i = 0; i < 100000; ++i) // 1 s
  {
    least = std::min(least, prisms->GetScanAngle(i));
    most = std::max(most, prisms->GetScanAngle(i));
  }
  CHECK(2.0 * most == Approx(38.4).epsilon(1e-3));
  CHECK(least < 0.5); // the middle is covered, too
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
      kept += std::isspace(static_cast<unsigned char>(c)) ? std::string() : std::string(1, c);
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
