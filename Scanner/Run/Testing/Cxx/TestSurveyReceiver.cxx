// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Sampling, waveforms, detection and noise in the dialect: read, checked, set up, and run.
#include "heliosReceiverSetup.h"
#include "heliosStatus.h"

#include "heliosSurveyFiles.h"
#include "vtkHeliosBeamSampler.h"
#include "vtkHeliosErrorModel.h"
#include "vtkHeliosPeakDetector.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosScanner.h"
#include "vtkHeliosSurveyPlayer.h"

#include <catch2/catch.hpp>

#include <vtkIndent.h>
#include <vtkNew.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

using namespace helios::test;

namespace
{

namespace fs = std::filesystem;

/// A survey on a tripod with texts inserted into its scanner, into its <survey> and after its leg.
struct Bench
{
  Files Folder;
  helios::test::Reading Reading;

  explicit Bench(const std::string& fwf = "", const std::string& scanner = "",
    const std::string& survey = "", const std::string& inside = "", const std::string& errors = "")
    : Reading(Write(Folder, fwf, scanner, errors), Tripod + (" " + survey), OneLeg + inside)
  {
  }

  const helios::ScannerData& Scanner() const { return this->Reading.Data().Scanners.at(0); }
  const helios::ReceiverData& Receiver() const { return this->Scanner().Receiver; }

  void CheckRefused(const std::vector<std::string>& messages) const
  {
    INFO(this->Reading.Log->Errors);
    CHECK_FALSE(this->Reading.Good);
    for (const std::string& message : messages)
    {
      INFO("missing: " << message);
      CHECK(this->Reading.Log->HasError(message));
    }
  }

  void CheckWarned(const std::string& message) const
  {
    INFO(this->Reading.Log->Errors << this->Reading.Log->Warnings << "missing: " << message);
    CHECK(this->Reading.Good);
    CHECK(this->Reading.Log->HasWarning(message));
  }

  /// No errors or warnings.
  void CheckQuiet() const
  {
    INFO(this->Reading.Log->Errors << this->Reading.Log->Warnings);
    CHECK(this->Reading.Good);
    CHECK(this->Reading.Log->Warnings.empty());
  }

  vtkSmartPointer<vtkHeliosScanner> SetUp(const helios::RunOptions& choice = {}) const
  {
    auto scanner = vtkSmartPointer<vtkHeliosScanner>::New();
    helios::SetUpReceiver(this->Scanner(), choice, scanner);
    return scanner;
  }

private:
  static const Files& Write(const Files& files, const std::string& fwf, const std::string& scanner,
    const std::string& errors)
  {
    files.Write("shot.txt", "# a pulse\n0 0\n2 1\n5 0\n");
    files.Replace("assets.xml", "<FWFSettings beamSampleQuality=\"2\"/>",
      (fwf.empty() ? "" : "<FWFSettings " + fwf + "/>") + errors);
    files.Replace("assets.xml", "optics=\"rotating\"", "optics=\"rotating\" " + scanner);
    return files;
  }
};

std::string Fwf(const std::string& attributes)
{
  return "\n<FWFSettings " + attributes + "/>";
}

} // namespace

TEST_CASE("SurveyReceiver: sampling is adaptive by default", "[SurveyReceiver]")
{
  const Bench bench;
  bench.CheckQuiet();
  CHECK(bench.Receiver().NumberOfCircles == 0);
  const auto scanner = bench.SetUp();
  CHECK(scanner->GetSampling() == vtkHeliosScanner::TOLERANCE);
  CHECK(scanner->GetRangeTolerance() == 0.001);
  CHECK(scanner->GetEnergyTolerance() == 0.01);
  CHECK(scanner->GetBinSize() == 0.25);
  CHECK(scanner->GetMaximumWaveformLength() == 0.0);
  CHECK(scanner->GetNumberOfBins() == 0);
  CHECK(scanner->GetReturnSelection() == vtkHeliosScanner::ALL);
  CHECK(scanner->GetPulseShape() == vtkHeliosScanner::GAUSSIAN);
  CHECK(scanner->GetAtmosphericExtinction() < 0.0);
}

TEST_CASE(
  "SurveyReceiver: beamSampleQuality on any level selects fixed sampling", "[SurveyReceiver]")
{
  const Bench inScanner("beamSampleQuality=\"4\"");
  const Bench inSurvey("", "", "", Fwf("beamSampleQuality=\"4\""));
  for (const Bench* bench : { &inScanner, &inSurvey })
  {
    bench->CheckQuiet();
    const auto scanner = bench->SetUp();
    CHECK(scanner->GetSampling() == vtkHeliosScanner::FIXED);
    CHECK(scanner->GetBeamSampler()->GetPattern() == vtkHeliosBeamSampler::CIRCLES);
    CHECK(scanner->GetBeamSampler()->GetNumberOfSubRays() == 37);
  }
}

TEST_CASE("SurveyReceiver: sampling settings of the survey have precedence", "[SurveyReceiver]")
{
  // the survey's tolerance overrides the scanner's circles
  const Bench tolerant("beamSampleQuality=\"3\"", "", "", Fwf("rangeTolerance_m=\"0.0002\""));
  CHECK(tolerant.Receiver().NumberOfCircles == 0);
  CHECK(tolerant.Receiver().RangeTolerance == 0.0002);
  CHECK(
    Bench("beamSampleQuality=\"3\"", "", "energyTolerance=\"0.05\"").Receiver().NumberOfCircles ==
    0);
  // and vice versa
  const Bench fixed("rangeTolerance_m=\"0.0002\"", "", "", Fwf("beamSampleQuality=\"3\""));
  CHECK(fixed.Receiver().NumberOfCircles == 3);
  fixed.CheckQuiet();
  // the attributes of <survey> override its <FWFSettings>
  CHECK(Bench("", "", "rangeTolerance_m=\"0.003\"", Fwf("rangeTolerance_m=\"0.002\""))
          .Receiver()
          .RangeTolerance == 0.003);
  Bench("beamSampleQuality=\"3\" rangeTolerance_m=\"0.1\"")
    .CheckWarned("assets.xml:8: rangeTolerance_m is not used together with beamSampleQuality");
}

TEST_CASE("SurveyReceiver: options of a run have precedence over the survey", "[SurveyReceiver]")
{
  const Bench bench("beamSampleQuality=\"3\"");
  helios::RunOptions choice;
  choice.EnergyTolerance = 0.02;
  auto scanner = bench.SetUp(choice);
  CHECK(scanner->GetSampling() == vtkHeliosScanner::TOLERANCE);
  CHECK(scanner->GetEnergyTolerance() == 0.02);
  CHECK(scanner->GetRangeTolerance() == 0.001);

  const auto [asked, pattern, got] = GENERATE(std::tuple(1, vtkHeliosBeamSampler::CIRCLES, 1),
    std::tuple(19, vtkHeliosBeamSampler::CIRCLES, 19),
    std::tuple(62, vtkHeliosBeamSampler::CIRCLES, 62),
    std::tuple(64, vtkHeliosBeamSampler::VOGEL, 64),
    std::tuple(250, vtkHeliosBeamSampler::VOGEL, 252));
  choice = {};
  choice.NumberOfSubRays = asked;
  scanner = Bench("rangeTolerance_m=\"0.1\"").SetUp(choice);
  CHECK(scanner->GetSampling() == vtkHeliosScanner::FIXED);
  CHECK(scanner->GetBeamSampler()->GetPattern() == pattern);
  CHECK(scanner->GetBeamSampler()->GetNumberOfSubRays() == got);
}

TEST_CASE(
  "SurveyReceiver: light scattered more than once, by attributes and options", "[SurveyReceiver]")
{
  CHECK(Bench().SetUp()->GetScatteringOrders() == 1);
  const Bench bench("scatteringOrders=\"2\" scatteringPaths=\"64\" scatteringPhase=\"isotropic\"",
    "", "scatteringOrders=\"3\"");
  bench.CheckQuiet();
  helios::RunOptions choice;
  const auto setUp = [&] { return bench.SetUp(choice); };
  CHECK(setUp()->GetScatteringOrders() == 3);
  CHECK(setUp()->GetScatteringPaths() == 64);
  CHECK(setUp()->GetScatteringPhase() == vtkHeliosScanner::ISOTROPIC);
  choice.ScatteringOrders = 4;
  choice.ScatteringPaths = 256;
  CHECK(setUp()->GetScatteringOrders() == 4);
  CHECK(setUp()->GetScatteringPaths() == 256);
  choice.Without = "scattering";
  CHECK(setUp()->GetScatteringOrders() == 1);

  choice.ScatteringOrders = GENERATE(-1, 65);
  CHECK(choice.FindFault().Message() ==
    "ScatteringOrders is " + std::to_string(choice.ScatteringOrders) +
      "; give 1 to 64, or 0 for the survey's value");
  choice.ScatteringOrders = 0;
  choice.ScatteringPaths = GENERATE(7, 65537);
  CHECK(choice.FindFault().Message() ==
    "ScatteringPaths is " + std::to_string(choice.ScatteringPaths) +
      "; give 8 to 65536, or 0 for the survey's value");

  Bench("scatteringOrders=\"65\"")
    .CheckRefused({ "assets.xml:8: scatteringOrders=\"65\" is out of range" });
  Bench("", "", "scatteringPaths=\"1e3\"").CheckRefused({ "scatteringPaths=\"1e3\"", "integer" });
  Bench("scatteringPhase=\"rough\"")
    .CheckRefused({ "assets.xml:8: scatteringPhase=\"rough\"", "isotropic" });
}

TEST_CASE(
  "SurveyReceiver: the accuracy of the instrument is a tenth of its noise", "[SurveyReceiver]")
{
  helios::RunOptions choice;
  choice.Accuracy = helios::InstrumentAccuracy;
  auto scanner = Bench("beamSampleQuality=\"3\"").SetUp(choice); // accuracy_m is 0.005
  CHECK(scanner->GetSampling() == vtkHeliosScanner::TOLERANCE);
  CHECK(scanner->GetRangeTolerance() == Approx(0.0005));
  CHECK(scanner->GetEnergyTolerance() == 0.01);

  helios::ScannerData data = Bench("rangeTolerance_m=\"0.003\"").Scanner();
  const auto setUp = [&data, &choice]
  {
    auto made = vtkSmartPointer<vtkHeliosScanner>::New();
    helios::SetUpReceiver(data, choice, made);
    return made;
  };
  data.Receiver.RangeAccuracyPerMeter = 0.002; // noise grows from the shortest range on
  data.Receiver.RangeMin = 6.0;
  CHECK(setUp()->GetRangeTolerance() == Approx(0.1 * std::hypot(0.005, 0.012)));
  CHECK(setUp()->GetEnergyTolerance() == 0.01);
  data.Receiver.DetectorNoise = 1e-3; // a tenth of the amplitude of a full footprint, or more
  CHECK(setUp()->GetEnergyTolerance() > 0.01);
  choice.RangeTolerance = 0.002; // overrides it
  choice.EnergyTolerance = 0.03;
  CHECK(setUp()->GetRangeTolerance() == 0.002);
  CHECK(setUp()->GetEnergyTolerance() == 0.03);
  choice.RangeTolerance = choice.EnergyTolerance = 0.0;
  data.Receiver.RangeAccuracy = data.Receiver.RangeAccuracyPerMeter = 0.0;
  CHECK(setUp()->GetRangeTolerance() == 0.003);
  CHECK(setUp()->GetEnergyTolerance() == 0.01);
}

TEST_CASE("SurveyReceiver: the pattern of fixed sub-rays", "[SurveyReceiver]")
{
  const Bench bench;
  const auto describe = [&bench](int count, const char* pattern)
  {
    helios::RunOptions choice;
    choice.NumberOfSubRays = count;
    choice.SubRayPattern = pattern;
    vtkHeliosBeamSampler* sampler = bench.SetUp(choice)->GetBeamSampler();
    return std::to_string(sampler->GetNumberOfSubRays()) + " " + sampler->GetPatternAsString();
  };
  CHECK(describe(19, "") == "19 Circles");
  CHECK(describe(18, "") == "20 Vogel");
  CHECK(describe(19, "Circles") == "19 Circles");
  CHECK(describe(19, "Vogel") == "20 Vogel");
  CHECK(describe(64, "GaussLegendre") == "64 GaussLegendre");
  CHECK(vtkHeliosRunOptions::GetSubRayPatternNames() == "GaussLegendre Circles Vogel");
}

TEST_CASE("SurveyReceiver: waveforms, returns and the pulse", "[SurveyReceiver]")
{
  const Bench bench("binSize_ns=\"0.2\" maxFullwaveRange_ns=\"120\" numFullwaveBins=\"500\"", "",
    "", Fwf("returnSelection=\"firstAndLast\" pulseShape=\"helios\""));
  bench.CheckQuiet();
  auto scanner = bench.SetUp();
  CHECK(scanner->GetBinSize() == 0.2);
  CHECK(scanner->GetMaximumWaveformLength() == 120.0);
  CHECK(scanner->GetNumberOfBins() == 500);
  CHECK(scanner->GetReturnSelection() == vtkHeliosScanner::FIRST_AND_LAST);
  CHECK(scanner->GetPulseShape() == vtkHeliosScanner::HELIOS);

  const std::vector<std::pair<std::string, int>> selections = { { "all", vtkHeliosScanner::ALL },
    { "first", vtkHeliosScanner::FIRST }, { "last", vtkHeliosScanner::LAST },
    { "strongest", vtkHeliosScanner::STRONGEST } };
  for (const auto& [name, selection] : selections)
  {
    CHECK(
      Bench("", "", "returnSelection=\"" + name + "\"").SetUp()->GetReturnSelection() == selection);
  }

  const Bench sampled("pulseShape=\"shot.txt\""); // beside the file that names it
  sampled.CheckQuiet();
  scanner = sampled.SetUp();
  CHECK(scanner->GetPulseShape() == vtkHeliosScanner::SAMPLED);
  CHECK(std::string(scanner->GetPulseFileName()) == sampled.Folder / "shot.txt");
}

TEST_CASE("SurveyReceiver: saturation, dead time and photons", "[SurveyReceiver]")
{
  const Bench bench("echoDetector=\"photonCounting\"",
    "saturation_nW=\"3\" deadTime_ns=\"40\" photonEfficiency=\"0.1\" darkCountRate_Hz=\"5e4\" "
    "timeJitter_ns=\"0.2\" wavelength_nm=\"532\"");
  bench.CheckQuiet();
  for (const bool hasNoise : { true, false })
  {
    helios::RunOptions options;
    options.Noise = hasNoise;
    const auto scanner = bench.SetUp(options);
    CHECK(scanner->GetSaturationPower() == Approx(3e-9));
    CHECK(scanner->GetEchoDetector()->GetDeadTime() == 40.0);
    std::ostringstream text;
    scanner->GetEchoDetector()->Print(text);
    for (const char* line : { "DetectionEfficiency: 0.1\n", "Wavelength: 532 nm\n",
           hasNoise ? "DarkCountRate: 50000 Hz\n" : "DarkCountRate: 0 Hz\n",
           hasNoise ? "TimeJitter: 0.2 ns\n" : "TimeJitter: 0 ns\n" })
    {
      INFO(text.str() << "missing: " << line);
      CHECK(text.str().find(line) != std::string::npos);
    }
  }
  CHECK(Bench("", "deadTime_ns=\"7\"").SetUp()->GetEchoDetector()->GetDeadTime() == 7.0);
  CHECK(Bench("").SetUp()->GetSaturationPower() == 0.0);
}

TEST_CASE("SurveyReceiver: detectors", "[SurveyReceiver]")
{
  const std::vector<std::pair<std::string, std::string>> detectors = { { "",
                                                                         "vtkHeliosPeakDetector" },
    { "peak", "vtkHeliosPeakDetector" }, { "gaussian", "vtkHeliosGaussianDecomposition" },
    { "cfd", "vtkHeliosConstantFractionDetector" },
    { "leadingEdge", "vtkHeliosLeadingEdgeDetector" },
    { "photonCounting", "vtkHeliosPhotonCountingDetector" } };
  for (const auto& [name, type] : detectors)
  {
    const std::string given = name.empty() ? "" : "echoDetector=\"" + name + "\"";
    CHECK(Bench(given).SetUp()->GetEchoDetector()->GetClassName() == type);
    helios::RunOptions choice;
    choice.EchoDetector = name;
    const auto scanner = Bench(name.empty() ? "" : "echoDetector=\"cfd\"").SetUp(choice);
    CHECK(scanner->GetEchoDetector()->GetClassName() == type);
    CHECK(scanner->GetEchoDetector()->GetDetectionThreshold() == Approx(0.002e-9));
  }
  const auto scanner = Bench("winSize_ns=\"1.5\"").SetUp();
  auto* peak = vtkHeliosPeakDetector::SafeDownCast(scanner->GetEchoDetector());
  REQUIRE(peak);
  CHECK(peak->GetMinimumSeparation() == 1.5);
}

TEST_CASE("SurveyReceiver: noise, atmosphere and sunlight", "[SurveyReceiver]")
{
  const Bench bench("",
    "accuracyPerMeter=\"0.00002\" accuracyAtThreshold_m=\"0.05\" angleAccuracy_rad=\"0.0001\" "
    "detectorNoise_nW=\"2.5\" solarIrradiance_W_m2_nm=\"0.6\" filterBandwidth_nm=\"2\" "
    "fieldOfView_rad=\"0.002\" atmosphericExtinction_1_m=\"0.0003\" beamQualityFactor=\"1.5\"");
  bench.CheckQuiet();
  auto scanner = bench.SetUp();
  CHECK(scanner->GetRangeAccuracy() == 0.005);
  CHECK(scanner->GetRangeAccuracyPerMeter() == 0.00002);
  CHECK(scanner->GetRangeAccuracyAtThreshold() == 0.05);
  CHECK(scanner->GetAngleAccuracy() == 0.0001);
  CHECK(scanner->GetDetectorNoise() == Approx(2.5e-9));
  CHECK(scanner->GetSolarIrradiance() == 0.6);
  CHECK(scanner->GetFilterBandwidth() == 2.0);
  CHECK(scanner->GetFieldOfView() == 0.002);
  CHECK(scanner->GetAtmosphericExtinction() == 0.0003);
  CHECK(scanner->GetBeamSampler()->GetBeamQualityFactor() == 1.5);
  CHECK(scanner->GetBeamSampler()->GetWavelength() == 1064.0);
  CHECK(scanner->GetEchoDetector()->GetDetectionThreshold() == Approx(0.002e-9));

  helios::RunOptions quiet;
  quiet.Noise = false;
  scanner = bench.SetUp(quiet);
  CHECK(scanner->GetRangeAccuracy() == 0.0);
  CHECK(scanner->GetRangeAccuracyPerMeter() == 0.0);
  CHECK(scanner->GetRangeAccuracyAtThreshold() == 0.0);
  CHECK(scanner->GetAngleAccuracy() == 0.0);
  CHECK(scanner->GetDetectorNoise() == 0.0);
  CHECK(scanner->GetSolarIrradiance() == 0.6); // light, not noise
}

TEST_CASE("SurveyReceiver: a scanner without attributes is a new instrument", "[SurveyReceiver]")
{
  vtkNew<vtkHeliosScanner> fresh;
  const auto scanner = Bench().SetUp();
  scanner->SetPulseLength(fresh->GetPulseLength()); // the scanner of the bench gives some values
  scanner->SetRangeAccuracy(fresh->GetRangeAccuracy());
  scanner->SetRangeMin(fresh->GetRangeMin());
  const auto describe = [](vtkHeliosScanner* each)
  {
    std::ostringstream text;
    each->vtkHeliosInstrument::PrintSelf(text, vtkIndent());
    return text.str().substr(text.str().find("PulseLength"));
  };
  CHECK(describe(scanner) == describe(fresh));
  CHECK(scanner->GetEchoDetector()->GetDeadTime() == fresh->GetEchoDetector()->GetDeadTime());
}

TEST_CASE("SurveyReceiver: attribute names of the Java version", "[SurveyReceiver]")
{
  const Bench bench(
    "binSize_ns=\"0.5\" winSize=\"10\" pulseLength_ns=\"6\" beamDivergence_rad=\"0.001\" "
    "scannerEfficiency=\"0.9\" atmosphericVisibility=\"5\" scannerWaveLength=\"1550\" "
    "apartureDiameter=\"0.15\"");
  bench.CheckQuiet();
  CHECK(bench.Receiver().PeakWindow == 5.0);
  CHECK(bench.Scanner().Receiver.PulseLength == 6.0);
  CHECK(bench.Reading.Data().Legs.at(0).Scans.at(0).BeamDivergence == 0.001);
  CHECK(bench.Scanner().Receiver.OpticalEfficiency == 0.9);
  CHECK(bench.Scanner().Receiver.AtmosphericVisibility == 5.0);
  CHECK(bench.Scanner().Receiver.Wavelength == 1550.0);
  Bench("apartureDiameter=\"0.2\"")
    .CheckWarned("assets.xml:8: apartureDiameter=\"0.2\" has no effect; the receiver has "
                 "receiverDiameter_m=\"0.15\" of scanner tls");
  Bench("apertureDiameter_m=\"0.1\"").CheckWarned("apertureDiameter_m=\"0.1\" has no effect");
  Bench("minEchoWidth=\"2.5\"").CheckWarned("attribute minEchoWidth of <FWFSettings> is not used");
}

TEST_CASE("SurveyReceiver: error expressions", "[SurveyReceiver]")
{
  const Bench bench("", "", "", "<detectorSettings distanceMeasurementError=\"1 + t / 100\"/>",
    "<rangeError expr=\"0.001*THETA\"/><deflectionError expr=\"0.0001*sin(THETA)\"/>"
    "<headError expr=\"0.0002\" zeroSinThreshold_deg=\"2\"/>");
  bench.CheckQuiet();
  const helios::ErrorExpressions& errors = bench.Receiver().Errors;
  CHECK(errors.Range == "0.001*THETA");
  CHECK(errors.Deflection == "0.0001*sin(THETA)");
  CHECK(errors.Head == "0.0002");
  CHECK(errors.HeadZeroSinThreshold == 2.0);
  CHECK(errors.RangeNoiseFactor == "1 + t / 100");
  CHECK(Bench().Receiver().Errors.IsEmpty());
  CHECK(Bench().SetUp()->GetErrorModel() == nullptr);
  const vtkHeliosErrorModel* model = nullptr;
  const auto scanner = bench.SetUp();
  model = scanner->GetErrorModel();
  REQUIRE(model);
  CHECK(model->GetRangeError(0.5) == Approx(0.0005));
  CHECK(model->GetDeflectionError(0.5) == Approx(0.0001 * std::sin(0.5)));
  CHECK(model->GetHeadError(0.5) == Approx(0.0002));
  CHECK(model->GetRangeNoiseFactor(50.0) == Approx(1.5));
  Bench("", "", "", "", "<rangeError expr=\"0.001 * sinn(THETA)\"/>")
    .CheckRefused({ "assets.xml:8: expr=\"0.001 * sinn(THETA)\": ", "is not known; use t or" });
  Bench("", "", "", "<detectorSettings distanceMeasurementError=\"1 +\"/>")
    .CheckRefused({ "distanceMeasurementError=\"1 +\": " });
  Bench("", "", "", "", "<rangeError/>").CheckRefused({ "assets.xml:8: <rangeError> has no expr" });
  Bench("", "", "", "", "<headError expr=\"\"/>")
    .CheckRefused({ "<headError> has no expr; add one" });
}

TEST_CASE("SurveyReceiver: misalignments of a panoramic scanner", "[SurveyReceiver]")
{
  const Bench bench("", "", "", "",
    "<panoramicError horizontalBeamOffset_m=\"0.001\" verticalBeamOffset_m=\"0.002\" "
    "transitOffset_m=\"0.003\" mirrorOffset_m=\"0.004\" verticalIndexOffset_deg=\"0.5\" "
    "horizontalBeamTilt_deg=\"0.6\" verticalBeamTilt_deg=\"0.7\" mirrorTilt_deg=\"0.8\" "
    "transitTilt_deg=\"0.9\" rangeOffset_m=\"0.01\"/>");
  bench.CheckQuiet();
  std::ostringstream printed;
  bench.SetUp()->GetErrorModel()->Print(printed);
  for (const char* property : { "HorizontalBeamOffset: 0.001 m", "VerticalBeamOffset: 0.002 m",
         "TransitOffset: 0.003 m", "MirrorOffset: 0.004 m", "VerticalIndexOffset: 0.5 deg",
         "HorizontalBeamTilt: 0.6 deg", "VerticalBeamTilt: 0.7 deg", "MirrorTilt: 0.8 deg",
         "TransitTilt: 0.9 deg", "RangeOffset: 0.01 m" })
  {
    INFO(property << " in " << printed.str());
    CHECK(printed.str().find(property) != std::string::npos);
  }
  Bench("", "", "", "", "<panoramicError mirrorTilt_deg=\"11\"/>")
    .CheckRefused({ "assets.xml:8: mirrorTilt_deg=\"11\" is out of range" });
  Bench("", "", "", "", "<panoramicError transitOffset_m=\"1.5\"/>")
    .CheckRefused({ "transitOffset_m=\"1.5\" is out of range" });
}

TEST_CASE("SurveyReceiver: expressions that are long, deep or never finite", "[SurveyReceiver]")
{
  const std::string deep = std::string(101, '(') + "t" + std::string(101, ')');
  std::string longText = "0";
  while (longText.size() < 100000)
  {
    longText += "+t*t";
  }
  const std::pair<std::string, const char*> bad[] = {
    { "ln(-1)", "\"ln(-1)\": its value is never finite" },
    { "1/0*t", "its value is never finite" },
    { "1e308*1e308", "its value is never finite" },
    { "1e10", "never finite and within 1e9" },
    { "sqrt(-1-t^2)", "its value is never finite" },
    { deep, "more than 100 nested brackets" },
    { longText, "it has 100001 characters, and at most 1000 are allowed" },
  };
  for (const auto& [text, message] : bad)
  {
    CAPTURE(text.substr(0, 20), message);
    Bench("", "", "", "<detectorSettings distanceMeasurementError=\"" + text + "\"/>")
      .CheckRefused({ "survey.xml:", "distanceMeasurementError=\"", message });
    Bench("", "", "", "", "<headError expr=\"" + text + "\"/>")
      .CheckRefused({ "assets.xml:8: expr=\"", message });
  }
  const Bench partly("", "", "", "<detectorSettings distanceMeasurementError=\"ln(t - 5)\"/>");
  partly.CheckQuiet();
  CHECK_THAT(partly.SetUp()->GetErrorModel()->GetTermName(vtkHeliosErrorModel::RANGE_NOISE_FACTOR),
    Catch::EndsWith("survey.xml:5: distanceMeasurementError=\"ln(t - 5)\""));
}

TEST_CASE("SurveyReceiver: invalid values are refused with their line", "[SurveyReceiver]")
{
  const std::vector<std::pair<std::string, std::string>> fwf = {
    { "rangeTolerance_m=\"0\"", "rangeTolerance_m=\"0\" is out of range; give a number from" },
    { "energyTolerance=\"2\"", "energyTolerance=\"2\" is out of range" },
    { "binSize_ns=\"0.0005\"",
      "binSize_ns=\"0.0005\" makes an echo of pulseLength_ns=\"5\" 50000 bins long, and at most "
      "5000 are allowed" },
    { "pulseLength_ns=\"1e6\"",
      "pulseLength_ns=\"1e6\" is out of range; give a number from 0.01 to 1000" },
    { "winSize_ns=\"-1\"", "winSize_ns=\"-1\" is out of range" },
    { "numFullwaveBins=\"0\"", "numFullwaveBins=\"0\" is out of range" },
    { "maxFullwaveRange_ns=\"1,5\"", "maxFullwaveRange_ns=\"1,5\"" },
    { "scannerEfficiency=\"0\"", "scannerEfficiency=\"0\" is out of range" },
    { "echoDetector=\"gausian\"", "echoDetector=\"gausian\" is not valid; did you mean gaussian?" },
    { "echoDetector=\"xyzzy\"",
      "echoDetector=\"xyzzy\" is not valid: expected peak, gaussian, cfd, leadingEdge or "
      "photonCounting" },
    { "returnSelection=\"frist\"", "returnSelection=\"frist\" is not valid; did you mean first?" },
    { "pulseShape=\"nowhere.txt\"",
      "pulseShape=\"nowhere.txt\" is neither a pulse shape nor a file: expected" },
    { "binSize_ns=\"3\"", "binSize_ns=\"3\" is wider than half of pulseLength_ns=\"5\"" },
    { "maxFullwaveRange_ns=\"4\"",
      "waveforms of 4 ns (maxFullwaveRange_ns) are shorter than "
      "pulseLength_ns=\"5\"; give longer ones" },
    { "numFullwaveBins=\"10\"", "waveforms of 2.25 ns (numFullwaveBins) are shorter than" },
  };
  for (const auto& [attributes, message] : fwf)
  {
    INFO(attributes);
    Bench(attributes).CheckRefused({ "assets.xml:8: ", message });
    Bench("", "", "", Fwf(attributes)).CheckRefused({ "survey.xml:6: ", message });
  }
  const std::vector<std::pair<std::string, std::string>> scanner = {
    { "opticalEfficiency=\"0\"", "opticalEfficiency=\"0\" is out of range" },
    { "opticalEfficiency=\"1.1\"", "opticalEfficiency=\"1.1\" is out of range" },
    { "receiverDiameter_m=\"0\"", "receiverDiameter_m=\"0\" is out of range" },
    { "receiverDiameter_m=\"-0.1\"", "receiverDiameter_m=\"-0.1\" is out of range" },
    { "wavelength_nm=\"-1064\"", "wavelength_nm=\"-1064\" is out of range" },
    { "beamQualityFactor=\"0.5\"", "beamQualityFactor=\"0.5\" is out of range" },
    { "detectorNoise_nW=\"-1\"", "detectorNoise_nW=\"-1\" is out of range" },
    { "angleAccuracy_rad=\"1\"", "angleAccuracy_rad=\"1\" is out of range" },
    { "atmosphericExtinction_1_m=\"-1\"", "atmosphericExtinction_1_m=\"-1\" is out of range" },
  };
  for (const auto& [attributes, message] : scanner)
  {
    INFO(attributes);
    Bench("", attributes).CheckRefused({ "assets.xml:5: ", message });
  }
  Bench("", "", "rangeTolerance_m=\"x\"")
    .CheckRefused({ "survey.xml:3: ", "rangeTolerance_m=\"x\"" });
}

namespace
{

/// A run of the bench, with output in its folder.
struct Playing
{
  vtkNew<vtkHeliosSurveyPlayer> Player;
  vtkSmartPointer<helios::ErrorObserver> Log = Observe(Player);

  explicit Playing(const Bench& bench)
  {
    this->Player->SetSurvey(bench.Reading.Reader->GetSurvey());
    this->Player->SetOutputDirectory((bench.Folder / "out").c_str());
    this->Player->SetOverwrite(true);
  }

  bool FailsWith(const std::string& message)
  {
    this->Log->Clear();
    return !this->Player->Run() && this->Log->HasError(message);
  }
};

} // namespace

TEST_CASE("SurveyReceiver: a run counts the sampling methods of its pulses", "[SurveyReceiver]")
{
  const Bench bench;
  Playing playing(bench);
  vtkHeliosSurveyPlayer* player = playing.Player;
  REQUIRE(player->Run());
  const vtkIdType fired = player->GetCount("pulsesFired");
  CHECK(player->GetCount("pulsesOnPlane") > 0); // the floor
  CHECK(player->GetCount("pulsesOnPlane") + player->GetCount("pulsesWithoutBins") +
      player->GetCount("pulsesBinned") <=
    fired);
  CHECK(player->GetSampling().find("planar footprints") != std::string::npos);

  player->GetOptions()->SetNumberOfSubRays(7); // always bins
  REQUIRE(player->Run());
  CHECK(player->GetSampling().find("fixed, 7 sub-rays per pulse") != std::string::npos);
  CHECK(player->GetCount("pulsesOnPlane") == 0);
  CHECK(player->GetCount("pulsesWithoutBins") == 0);
  CHECK(player->GetCount("pulsesBinned") > 0);
  CHECK(player->GetCount("subRays") == 7 * player->GetCount("pulsesFired"));
}

TEST_CASE("SurveyReceiver: waveforms have the format of the points", "[SurveyReceiver]")
{
  const Bench bench;
  Playing playing(bench);
  playing.Player->SetWriteWaveforms(true);
  REQUIRE(playing.Player->Run());
  CHECK(fs::exists(bench.Folder / "out/test/leg000_fullwave.txt"));
  playing.Player->SetFormat("vtp");
  playing.Player->SetPulsesPerBlock(20000);
  REQUIRE(playing.Player->Run());
  CHECK_FALSE(fs::exists(bench.Folder / "out/test/leg000_fullwave.txt"));
  CHECK(fs::exists(bench.Folder / "out/test/leg000_fullwave.pvtt"));
  CHECK(fs::exists(bench.Folder / "out/test/leg000_fullwave_0001.vtt"));
}

TEST_CASE("SurveyReceiver: invalid options of a run are errors", "[SurveyReceiver]")
{
  const Bench bench;
  Playing playing(bench);
  playing.Player->GetOptions()->SetRangeTolerance(1e-7);
  CHECK(playing.FailsWith("RangeTolerance is 1e-07; give 1e-06 to 1 m, or 0"));
  playing.Player->GetOptions()->SetRangeTolerance(0.0);
  playing.Player->GetOptions()->SetEnergyTolerance(-1.0);
  CHECK(playing.FailsWith("EnergyTolerance is -1; give 0.0001 to 1, or 0"));
  playing.Player->GetOptions()->SetEnergyTolerance(0.1);
  playing.Player->GetOptions()->SetNumberOfSubRays(19);
  CHECK(playing.FailsWith("NumberOfSubRays is 19, but a tolerance"));
  playing.Player->GetOptions()->SetEnergyTolerance(0.0);
  playing.Player->GetOptions()->SetAccuracy("instrument");
  CHECK(playing.FailsWith(
    "NumberOfSubRays is 19, but Accuracy selects adaptive sampling; leave one of them out"));
  playing.Player->GetOptions()->SetNumberOfSubRays(0);
  playing.Player->GetOptions()->SetAccuracy("best");
  CHECK(playing.FailsWith("Accuracy is \"best\"; give instrument"));
  playing.Player->GetOptions()->SetAccuracy("");
  playing.Player->GetOptions()->SetNumberOfSubRays(19);
  playing.Player->GetOptions()->SetEchoDetector("none");
  CHECK(playing.FailsWith(
    "EchoDetector is \"none\"; give peak, gaussian, cfd, leadingEdge and photonCounting"));
  playing.Player->GetOptions()->SetEchoDetector("");
  playing.Player->GetOptions()->SetSubRayPattern("Star");
  CHECK(playing.FailsWith("SubRayPattern is \"Star\"; give GaussLegendre, Circles and Vogel"));
  playing.Player->GetOptions()->SetSubRayPattern("Circles");
  playing.Player->GetOptions()->SetNumberOfSubRays(20);
  CHECK(playing.FailsWith("NumberOfSubRays is 20, which SubRayPattern \"Circles\" does not have; "
                          "give 19 or 37, or the pattern Vogel"));
  playing.Player->GetOptions()->SetSubRayPattern("GaussLegendre");
  playing.Player->GetOptions()->SetNumberOfSubRays(3);
  CHECK(playing.FailsWith("does not have; give 4, or the pattern Vogel"));
  playing.Player->GetOptions()->SetNumberOfSubRays(0);
  CHECK(playing.FailsWith("SubRayPattern is \"GaussLegendre\", but NumberOfSubRays is 0; give a "
                          "fixed number of sub-rays, too"));
}
