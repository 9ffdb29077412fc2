// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Valid instruments, and the errors of invalid ones.
#include "vtkHeliosInstrument.h"

#include "heliosScannerBench.h"
#include "vtkHeliosEchoDetector.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>

namespace names = vtkHeliosArrayNames;
using namespace helios::testing;

namespace
{

const double NaN = std::numeric_limits<double>::quiet_NaN();

void WriteText(const std::string& name, const std::string& text)
{
  std::ofstream(name) << text;
}

} // namespace

TEST_CASE(
  "Instrument: values out of range are refused with name, value, range and remedy", "[Instrument]")
{
  struct Row
  {
    std::function<void(vtkHeliosScanner*)> Set;
    const char* Message;
  };
  const Row rows[] = {
    { [](auto* s) { s->SetPulseLength(0); }, "PulseLength is 0 ns, outside [0.001" },
    { [](auto* s) { s->SetBinSize(NaN); }, "BinSize is nan ns" },
    { [](auto* s) { s->SetBinSize(3); }, "BinSize is 3 ns, more than half of the pulse (4 ns)" },
    { [](auto* s) { s->SetMaximumWaveformLength(2); },
      "the waveform is limited to 2 ns (MaximumWaveformLength, NumberOfBins), less than the "
      "pulse" },
    { [](auto* s) { s->SetNumberOfBins(5); }, "the waveform is limited to 1 ns" },
    { [](auto* s) { s->SetNumberOfBins(-5); }, "NumberOfBins is -5, outside" },
    { [](auto* s) { s->SetAveragePower(-1); }, "AveragePower is -1 W, outside" },
    { [](auto* s) { s->SetWavelength(0); }, "Wavelength is 0 nm, outside [200" },
    { [](auto* s) { s->SetOpticalEfficiency(0); }, "OpticalEfficiency is 0, outside (0, 1]" },
    { [](auto* s) { s->SetOpticalEfficiency(1.2); }, "OpticalEfficiency is 1.2, outside" },
    { [](auto* s) { s->SetReceiverDiameter(0); }, "ReceiverDiameter is 0 m, outside (0, 100]" },
    { [](auto* s) { s->SetReceiverDiameter(-0.1); }, "give the aperture in metres, above 0" },
    { [](auto* s) { s->SetAtmosphericVisibility(0); }, "AtmosphericVisibility is 0 km" },
    { [](auto* s) { s->SetAtmosphericExtinction(-3); }, "AtmosphericExtinction is -3 1/m" },
    { [](auto* s) { s->SetDetectorNoise(-1); }, "DetectorNoise is -1 W" },
    { [](auto* s) { s->SetSolarIrradiance(-1); }, "SolarIrradiance is -1 W/m^2/nm" },
    { [](auto* s) { s->SetFilterBandwidth(-1); }, "FilterBandwidth is -1 nm" },
    { [](auto* s) { s->SetFieldOfView(2); }, "FieldOfView is 2 rad" },
    { [](auto* s) { s->SetRangeAccuracy(-1); }, "RangeAccuracy is -1 m" },
    { [](auto* s) { s->SetRangeAccuracyPerMeter(2); }, "RangeAccuracyPerMeter is 2 m/m" },
    { [](auto* s) { s->SetRangeAccuracyAtThreshold(-1); }, "RangeAccuracyAtThreshold is -1 m" },
    { [](auto* s) { s->SetAngleAccuracy(1); }, "AngleAccuracy is 1 rad" },
    { [](auto* s) { s->SetRangeMin(-1); }, "RangeMin is -1 m" },
    { [](auto* s) { s->SetRangeMax(NaN); }, "RangeMax is nan m" },
    { [](auto* s) { s->SetPulseShapeToSampled(); }, "PulseFileName is not set" },
    { [](auto* s) { s->SetPulseWindow(7, 5); }, "PulseWindow is [7, 5); give two indices" },
    { [](auto* s) { s->SetRangeTolerance(0); }, "RangeTolerance is 0 m and EnergyTolerance 0.01" },
    { [](auto* s) { s->SetEnergyTolerance(2); }, "give them within [1e-06, 1] m and [0.0001, 1]" },
    { [](auto* s) { s->GetBeamSampler()->SetBeamDivergence(NaN); }, "BeamDivergence" },
  };
  const auto scene = MakeScene({ Wall(100) });
  for (const Row& row : rows)
  {
    INFO(row.Message);
    Bench bench(scene);
    bench.Log->Watch(bench.Scanner->GetBeamSampler());
    row.Set(bench.Scanner);
    bench.Scanner->Update();
    CHECK((bench.Log->HasError(row.Message) || bench.Log->HasWarning(row.Message)));
  }
}

TEST_CASE("Instrument: a pulse from a file", "[Instrument]")
{
  // A triangle that rises for 1 ns and falls for 3 ns.
  WriteText("triangle.txt", "# time power\n10 0\n11 5  # peak\n\n14 0\n");
  Bench bench(MakeScene({ Wall(100) }));
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(0);
  bench.Scanner->SetPulseShapeToSampled();
  bench.Scanner->SetPulseFileName("triangle.txt");
  bench.Scanner->GenerateWaveformsOn();
  REQUIRE(bench.Run()->GetNumberOfPoints() > 0);
  std::remove("triangle.txt");
  auto* table = vtkTable::SafeDownCast(bench.Scanner->GetOutputDataObject(1));
  vtkDataArray* samples = table->GetFieldData()->GetArray(names::Samples);
  std::vector<double> fall; // the samples of the first pulse after its peak, in bins of 0.25 ns
  double largest = 0.0;
  for (int i = 0; i < table->GetValueByName(0, names::Count).ToInt(); ++i)
  {
    const double sample = samples->GetTuple1(i);
    if (sample >= largest)
    {
      largest = sample;
      fall.clear();
    }
    else if (sample > 0.0)
    {
      fall.push_back(sample);
    }
  }
  REQUIRE(fall.size() >= 11);
  for (std::size_t i = 2; i < 11; ++i)
  {
    CHECK(fall[i - 1] - fall[i] == Approx(fall[0] - fall[1]).epsilon(1e-4));
  }
  CHECK(fall[0] - fall[1] == Approx(largest / 12.0).epsilon(0.1));
}

TEST_CASE("Instrument: bad pulse files are refused with file and line", "[Instrument]")
{
  const auto scene = MakeScene({ Wall(100) });
  const auto expect = [&scene](const char* text, const char* message)
  {
    INFO(text);
    WriteText("pulse.txt", text);
    Bench bench(scene);
    bench.Scanner->SetPulseShapeToSampled();
    bench.Scanner->SetPulseFileName("pulse.txt");
    bench.Scanner->Update();
    CHECK(bench.Log->HasError(message));
  };
  expect("0 0\n1 nan\n2 0\n", "pulse.txt:2: times and powers must be finite");
  expect("0 0\n1,2\n2 -5\n3 0\n",
    "pulse.txt: the energy of the pulse is not positive: the integral is -3.0");
  expect("0 0\n1 1,5\n2 0\n", "pulse.txt:2: expected two numbers per line");
  expect("0 0\n1 1 1\n2 0\n", "pulse.txt:2: expected two numbers per line");
  expect(
    "0 0\n2 1\n1 0\n", "pulse.txt:3: its time is not after that of the previous one; sort them");
  expect("0 0\n1 1\n", "pulse.txt: a pulse needs at least three samples");
  expect("1 1\n", "and one above zero; it has 1");
  expect("0 0\n1 0\n2 0\n", "and one above zero");
  expect("0 0\n0.1 1\n0.2 0\n", "BinSize is 0.25 ns, more than half of the pulse (0.1 ns)");
  expect("", "pulse.txt");
  std::remove("pulse.txt");
  Bench bench(scene);
  bench.Scanner->SetPulseShapeToSampled();
  bench.Scanner->SetPulseFileName("is-not-there.txt");
  bench.Scanner->Update();
  CHECK(bench.Log->HasError("is-not-there.txt"));
}

TEST_CASE("Instrument: impossible materials are refused", "[Instrument]")
{
  const auto scene = MakeScene({ Wall(100) });
  const auto addColumn = [&scene](const char* name, double value)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    column->InsertNextValue(value);
    scene->GetFieldData()->AddArray(column);
  };
  vtkNew<vtkStringArray> material;
  material->SetName(names::MaterialName);
  material->InsertNextValue("chalk");
  scene->GetFieldData()->AddArray(material);
  addColumn(names::MaterialReflectance, 1.7);
  Bench bench(scene);
  bench.Scanner->Update();
  CHECK(bench.Log->HasError("material 0 of the scene, chalk, has reflectance 1.7"));
  bench.Log->Clear();
  addColumn(names::MaterialReflectance, 0.7);
  addColumn(names::MaterialSpecularity, -0.1);
  bench.Scanner->Modified();
  bench.Scanner->Update();
  CHECK(bench.Log->HasError("give the first two within [0, 1]"));
}

TEST_CASE(
  "Instrument: a threshold above all signals is reported with the strongest", "[Instrument]")
{
  const auto scene = MakeScene({ Wall(100) });
  Bench bench(scene);
  bench.Scanner->GetEchoDetector()->SetDetectionThreshold(1);
  CHECK(bench.Run()->GetNumberOfPoints() == 0);
  CHECK(
    bench.Log->HasWarning("no echo was detected: the largest amplitude of 1000 pulses is 1.09"));
  CHECK(bench.Log->HasWarning("below DetectionThreshold (1 W)"));
}

TEST_CASE("Instrument: a short waveform is truncated and counted", "[Instrument]")
{
  const auto scene = MakeScene({ Wall(130), { { -50, 50, 0.0001 }, { 100, 0, 0 }, { 0, 0, 50 } } });
  Bench bench(scene);
  bench.Scanner->GenerateWaveformsOn();
  CHECK(bench.Run()->GetNumberOfPoints() == 2000);
  CHECK(bench.Log->Warnings.empty());
  bench.Scanner->SetNumberOfBins(500); // the paper's: 18.7 m in bins of 0.25 ns
  CHECK(bench.Run()->GetNumberOfPoints() == 1000);
  CHECK(bench.Log->HasWarning("1000 waveforms were truncated"));
  auto* table = vtkTable::SafeDownCast(bench.Scanner->GetOutputDataObject(1));
  CHECK(table->GetValueByName(0, names::Count).ToInt() == 500);
  bench.Scanner->SetNumberOfBins(0);
  bench.Scanner->SetMaximumWaveformLength(100);
  CHECK(bench.Run()->GetNumberOfPoints() == 1000);
}

TEST_CASE("Instrument: return selection", "[Instrument]")
{
  // Three steps in the beam; it mostly hits the middle one.
  const auto scene = MakeScene({ { { -50, 50, 0.008 }, { 100, 0, 0 }, { 0, 0, 50 } },
    { { -50, 55, -0.008 }, { 100, 0, 0 }, { 0, 0, 50 } }, Wall(60) });
  Bench bench(scene);
  bench.Scanner->GetBeamSampler()->SetNumberOfCircles(8);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(6e-4);
  bench.Scanner->SetDuration(1e-5);
  using Instrument = vtkHeliosInstrument;
  const auto run = [&bench](int selection, int maximum)
  {
    bench.Scanner->SetReturnSelection(selection);
    bench.Scanner->SetMaximumNumberOfReturns(maximum);
    std::string ranges;
    vtkPolyData* echoes = bench.Run();
    for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
    {
      ranges += std::to_string(std::lround(Value(echoes, names::Range, i))) + " ";
      CHECK(Value(echoes, names::ReturnNumber, i) == i + 1);
      CHECK(Value(echoes, names::NumberOfReturns, i) == echoes->GetNumberOfPoints());
    }
    return ranges;
  };
  CHECK(run(Instrument::ALL, 0) == "50 55 60 ");
  CHECK(run(Instrument::ALL, 2) == "50 55 ");
  CHECK(run(Instrument::FIRST, 0) == "50 ");
  CHECK(run(Instrument::LAST, 0) == "60 ");
  CHECK(run(Instrument::STRONGEST, 0) == "55 ");
  CHECK(run(Instrument::FIRST_AND_LAST, 0) == "50 60 ");
  CHECK(run(Instrument::FIRST_AND_LAST, 1) == "50 ");
}
