// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "../../../../Filters/IO/Testing/Cxx/heliosTempFolder.h"
#include "../../../Core/Testing/Cxx/heliosScannerBench.h"
#include "heliosAborts.h"
#include "heliosReturnSelection.h"
#include "heliosTestWaveform.h"
#include "vtkHeliosConstantFractionDetector.h"
#include "vtkHeliosEchoDetection.h"
#include "vtkHeliosGaussianDecomposition.h"
#include "vtkHeliosLASReader.h"
#include "vtkHeliosLASWriter.h"
#include "vtkHeliosLeadingEdgeDetector.h"
#include "vtkHeliosPeakDetector.h"

#include <vtkCallbackCommand.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkSMPTools.h>
#include <vtkTable.h>
#include <vtkTypeInt64Array.h>

#include <catch2/catch.hpp>

#include <functional>
#include <limits>
#include <map>

namespace names = vtkHeliosArrayNames;

using namespace helios::testing;

namespace
{

template <typename ArrayT>
void AddColumn(vtkFieldData* data, const char* name, std::vector<double> values, int components = 1)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (const double value : values)
  {
    array->InsertNextValue(static_cast<typename ArrayT::ValueType>(value));
  }
  data->AddArray(array);
}

/// Two waveforms: three echoes, then one.
vtkSmartPointer<vtkTable> MakeTable()
{
  std::vector<float> samples = MakeSamples({ { 2.0, 20.0 }, { 3.0, 32.0 }, { 1.0, 45.0 } }, 0.5);
  const auto first = static_cast<double>(samples.size());
  const std::vector<float> second = MakeSamples({ { 1.0, 10.0 } }, 0.5, 20.0);
  samples.insert(samples.end(), second.begin(), second.end());
  auto table = vtkSmartPointer<vtkTable>::New();
  vtkFieldData* rows = table->GetRowData();
  AddColumn<vtkTypeInt64Array>(rows, names::PulseIds, { 70, 71 });
  AddColumn<vtkIntArray>(rows, names::LegIds, { 3, 3 });
  AddColumn<vtkIntArray>(rows, names::ChannelIds, { 0, 1 });
  AddColumn<vtkDoubleArray>(rows, names::Origin, { 1, 2, 3, 4, 5, 6 }, 3);
  AddColumn<vtkDoubleArray>(rows, names::Direction, { 0, 1, 0, 0, 0, -1 }, 3);
  AddColumn<vtkDoubleArray>(rows, names::GpsTime, { 0.5, 0.6 });
  AddColumn<vtkDoubleArray>(rows, names::StartTime, { 600, 700 });
  AddColumn<vtkDoubleArray>(rows, names::BinSize, { 0.5, 0.5 });
  AddColumn<vtkTypeInt64Array>(rows, names::Offset, { 0, first });
  AddColumn<vtkTypeInt64Array>(rows, names::Count, { first, static_cast<double>(second.size()) });
  AddColumn<vtkFloatArray>(
    table->GetFieldData(), names::Samples, std::vector<double>(samples.begin(), samples.end()));
  AddColumn<vtkDoubleArray>(table->GetFieldData(), names::PulseLength, { PulseLength });
  return table;
}

struct Detection
{
  vtkNew<vtkHeliosEchoDetection> Filter;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());

  Detection()
  {
    this->Log->Watch(this->Filter);
    this->Log->Watch(this->Filter->GetExecutive());
  }
  explicit Detection(vtkTable* table)
    : Detection()
  {
    this->Filter->SetInputData(table);
  }
  vtkPolyData* Run()
  {
    this->Filter->Update();
    return this->Filter->GetOutput();
  }
};

/// Steps, slopes and gaps: pulses have one or more echoes.
vtkSmartPointer<vtkPolyData> MakeStairs()
{
  return MakeScene({ { { -50, 60, -50 }, { 50.001, 0, 0 }, { 0, 0, 100 } },
    { { -50, 61, -50 }, { 100, 30, 0 }, { 0, 0, 100 } },
    { { -0.004, 59, -50 }, { 0.005, 0, 0 }, { 0, 0, 100 } } });
}

void SetUpScanner(Bench& bench, vtkHeliosEchoDetector* detector)
{
  bench.Scanner->GenerateWaveformsOn();
  bench.Scanner->SetEchoDetector(detector);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(4e-4);
  bench.Scanner->SetAngleAccuracy(2e-4); // pulses differ
}

/// The bytes of the arrays common to the scanner and the filter.
std::string CommonBytes(vtkPolyData* cloud, vtkPolyData* like)
{
  vtkNew<vtkPolyData> common;
  common->SetPoints(cloud->GetPoints());
  for (int i = 0; i < like->GetPointData()->GetNumberOfArrays(); ++i)
  {
    const char* name = like->GetPointData()->GetArrayName(i);
    REQUIRE(cloud->GetPointData()->GetArray(name));
    common->GetPointData()->AddArray(cloud->GetPointData()->GetArray(name));
  }
  return Bytes(common);
}

} // namespace

TEST_CASE("EchoDetection: detects the echoes of a table", "[EchoDetection]")
{
  Detection detection(MakeTable());
  vtkPolyData* echoes = detection.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 4);
  const double range = 0.5 * 0.299792458 * (600.0 + 32.0);
  CHECK(Value(echoes, names::Range, 1) == Approx(range).epsilon(1e-8));
  CHECK(echoes->GetPoint(1)[0] == 1.0);
  CHECK(echoes->GetPoint(1)[1] == 2.0 + Value(echoes, names::Range, 1));
  CHECK(echoes->GetPoint(3)[2] == 6.0 - Value(echoes, names::Range, 3));
  CHECK(Value(echoes, names::Amplitude, 1) == Approx(3.0).epsilon(1e-5));
  CHECK(Value(echoes, names::EchoWidth, 1) == Approx(PulseLength).epsilon(1e-4));
  CHECK(Value(echoes, names::ReturnNumber, 1) == 2);
  CHECK(Value(echoes, names::NumberOfReturns, 1) == 3);
  CHECK(Value(echoes, names::NumberOfReturns, 3) == 1);
  CHECK(Value(echoes, names::PulseIds, 2) == 70);
  CHECK(Value(echoes, names::WaveformIds, 3) == 71);
  CHECK(Value(echoes, names::LegIds, 3) == 3);
  CHECK(Value(echoes, names::ChannelIds, 3) == 1);
  CHECK(Value(echoes, names::GpsTime, 3) == 0.6);
  CHECK_FALSE(echoes->GetPointData()->GetArray(names::Deviation));
  vtkNew<vtkHeliosGaussianDecomposition> gaussian;
  detection.Filter->SetEchoDetector(gaussian);
  CHECK(Value(detection.Run(), names::Deviation, 0) < 1e-4);
}

TEST_CASE("EchoDetection: return selection", "[EchoDetection]")
{
  using Instrument = vtkHeliosInstrument;
  const double times[] = { 20, 32, 45 };
  const std::map<int, std::vector<int>> kept = { { Instrument::ALL, { 0, 1, 2 } },
    { Instrument::FIRST, { 0 } }, { Instrument::LAST, { 2 } }, { Instrument::STRONGEST, { 1 } },
    { Instrument::FIRST_AND_LAST, { 0, 2 } } };
  Detection detection(MakeTable());
  for (const auto& [selection, expected] : kept)
  {
    for (const int maximum : { 0, 1, 2 })
    {
      CAPTURE(selection, maximum);
      detection.Filter->SetReturnSelection(selection);
      detection.Filter->SetMaximumNumberOfReturns(maximum);
      vtkPolyData* echoes = detection.Run();
      const std::size_t count =
        maximum == 0 ? expected.size() : std::min<std::size_t>(expected.size(), maximum);
      REQUIRE(echoes->GetNumberOfPoints() == static_cast<vtkIdType>(count) + 1);
      for (std::size_t i = 0; i < count; ++i)
      {
        const auto row = static_cast<vtkIdType>(i);
        const double time = Value(echoes, names::Range, row) / (0.5 * 0.299792458) - 600.0;
        CHECK(time == Approx(times[expected[i]]).epsilon(1e-5));
        CHECK(Value(echoes, names::ReturnNumber, row) == i + 1);
        CHECK(Value(echoes, names::NumberOfReturns, row) == count);
      }
    }
  }
}

TEST_CASE(
  "EchoDetection: byte-identical to the scanner's echoes with fixed sampling", "[EchoDetection]")
{
  const vtkSmartPointer<vtkHeliosEchoDetector> detectors[] = {
    vtkSmartPointer<vtkHeliosPeakDetector>::New(),
    vtkSmartPointer<vtkHeliosGaussianDecomposition>::New(),
    vtkSmartPointer<vtkHeliosLeadingEdgeDetector>::New(),
    vtkSmartPointer<vtkHeliosConstantFractionDetector>::New()
  };
  for (vtkHeliosEchoDetector* detector : detectors)
  {
    for (const int selection : { vtkHeliosInstrument::ALL, vtkHeliosInstrument::STRONGEST })
    {
      CAPTURE(detector->GetClassName(), selection);
      Bench bench(MakeStairs());
      SetUpScanner(bench, detector);
      bench.Scanner->SetReturnSelection(selection);
      bench.Run();
      Detection detection;
      detection.Filter->SetInputConnection(bench.Scanner->GetOutputPort(1));
      detection.Filter->SetEchoDetector(detector);
      detection.Filter->SetReturnSelection(selection);
      vtkPolyData* echoes = detection.Run();
      vtkPolyData* truth = bench.Scanner->GetOutput();
      REQUIRE(truth->GetNumberOfPoints() > 500);
      REQUIRE(echoes->GetNumberOfPoints() == truth->GetNumberOfPoints());
      const bool areSame = Bytes(echoes) == CommonBytes(truth, echoes);
      CHECK(areSame);
      CHECK(detection.Log->Errors.empty());
    }
  }
}

TEST_CASE("EchoDetection: waveforms stored as LAS have the same echoes", "[EchoDetection]")
{
  vtkSmartPointer<vtkHeliosEchoDetector> detector = vtkSmartPointer<vtkHeliosPeakDetector>::New();
  if (GENERATE(true, false))
  {
    detector = vtkSmartPointer<vtkHeliosGaussianDecomposition>::New();
  }
  CAPTURE(detector->GetClassName());
  Bench bench(MakeStairs());
  SetUpScanner(bench, detector);
  bench.Run();
  vtkPolyData* truth = bench.Scanner->GetOutput();
  auto* waveforms = vtkTable::SafeDownCast(bench.Scanner->GetOutputDataObject(1));
  const helios::TempFolder folder;
  const std::string path = folder / "points.las";
  vtkNew<vtkHeliosLASWriter> writer;
  writer->SetFileName(path.c_str());
  writer->WriteWaveformsOn();
  writer->SetWaveforms(waveforms);
  REQUIRE((writer->Open() && writer->Write(truth) && writer->Close()));
  vtkNew<vtkHeliosLASReader> reader;
  reader->SetFileName(path.c_str());
  reader->ReadWaveformsOn();
  Detection detection;
  detection.Filter->SetInputConnection(reader->GetOutputPort(1));
  detection.Filter->SetEchoDetector(detector);
  detection.Filter->SetPulseLength(
    waveforms->GetFieldData()->GetArray(names::PulseLength)->GetTuple1(0));
  vtkPolyData* echoes = detection.Run();
  CHECK(detection.Log->Errors.empty());
  REQUIRE(truth->GetNumberOfPoints() > 500);
  REQUIRE(echoes->GetNumberOfPoints() == truth->GetNumberOfPoints());
  double worstRange = 0.0, worstAmplitude = 0.0, worstPlace = 0.0;
  vtkIdType otherPulses = 0;
  for (vtkIdType i = 0; i < truth->GetNumberOfPoints(); ++i)
  {
    const auto difference = [echoes, truth, i](const char* name)
    { return std::abs(Value(echoes, name, i) - Value(truth, name, i)); };
    otherPulses += difference(names::PulseIds) + difference(names::ReturnNumber) == 0.0 ? 0 : 1;
    worstRange = std::max(worstRange, difference(names::Range));
    worstAmplitude =
      std::max(worstAmplitude, difference(names::Amplitude) / Value(truth, names::Amplitude, i));
    for (int k = 0; k < 3; ++k)
    {
      worstPlace = std::max(worstPlace, std::abs(echoes->GetPoint(i)[k] - truth->GetPoint(i)[k]));
    }
  }
  CHECK(otherPulses == 0);
  CHECK(worstRange < 5e-6);
  CHECK(worstAmplitude < 1e-5);
  CHECK(worstPlace < 1e-4); // coordinates are rounded to 0.1 mm
}

TEST_CASE(
  "EchoDetection: with adaptive sampling echoes agree within the tolerances", "[EchoDetection]")
{
  Bench bench(MakeStairs());
  vtkNew<vtkHeliosPeakDetector> detector;
  SetUpScanner(bench, detector);
  bench.Scanner->SetSamplingToTolerance();
  bench.Run();
  Detection detection;
  detection.Filter->SetInputConnection(bench.Scanner->GetOutputPort(1));
  vtkPolyData* echoes = detection.Run();
  vtkPolyData* truth = bench.Scanner->GetOutput();
  REQUIRE(truth->GetNumberOfPoints() > 500);
  std::map<std::pair<vtkIdType, int>, vtkIdType> rows;
  for (vtkIdType i = 0; i < truth->GetNumberOfPoints(); ++i)
  {
    rows[{ static_cast<vtkIdType>(Value(truth, names::PulseIds, i)),
      static_cast<int>(Value(truth, names::ReturnNumber, i)) }] = i;
  }
  ErrorSums ranges, amplitudes;
  int alike = 0;
  for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
  {
    const auto found = rows.find({ static_cast<vtkIdType>(Value(echoes, names::PulseIds, i)),
      static_cast<int>(Value(echoes, names::ReturnNumber, i)) });
    if (found != rows.end() &&
      Value(echoes, names::NumberOfReturns, i) ==
        Value(truth, names::NumberOfReturns, found->second))
    {
      ++alike;
      ranges.Add(Value(echoes, names::Range, i) - Value(truth, names::Range, found->second));
      amplitudes.Add(
        Value(echoes, names::Amplitude, i) / Value(truth, names::Amplitude, found->second) - 1.0);
    }
  }
  CHECK(alike > 0.99 * static_cast<double>(truth->GetNumberOfPoints()));
  CHECK(ranges.GetRms() < bench.Scanner->GetRangeTolerance());
  CHECK(amplitudes.GetRms() < bench.Scanner->GetEnergyTolerance());
}

TEST_CASE("EchoDetection: byte-identical for any number of threads and pieces", "[EchoDetection]")
{
  Bench bench(MakeStairs());
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  SetUpScanner(bench, detector);
  Detection detection;
  detection.Filter->SetInputConnection(bench.Scanner->GetOutputPort(1));
  detection.Filter->SetEchoDetector(detector);
  const std::string whole = Bytes(detection.Run());
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    detection.Filter->Modified();
    const bool isSame = Bytes(detection.Run()) == whole;
    CHECK(isSame);
  }
  std::vector<double> ranges, ofPieces;
  vtkPolyData* output = detection.Filter->GetOutput();
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    ranges.push_back(Value(output, names::Range, i));
  }
  for (int piece = 0; piece < 3; ++piece)
  {
    detection.Filter->UpdatePiece(piece, 3, 0);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      ofPieces.push_back(Value(output, names::Range, i));
    }
  }
  CHECK(ofPieces == ranges);
}

TEST_CASE("EchoDetection: executes again if the detector changes", "[EchoDetection]")
{
  Detection detection(MakeTable());
  CHECK(detection.Run()->GetNumberOfPoints() == 4);
  detection.Filter->GetEchoDetector()->SetDetectionThreshold(1.5);
  CHECK(detection.Run()->GetNumberOfPoints() == 2);
}

TEST_CASE("EchoDetection: samples of another type", "[EchoDetection]")
{
  auto table = MakeTable();
  Detection floats(table);
  const std::string expected = Bytes(floats.Run());
  auto other = MakeTable();
  vtkDataArray* samples = table->GetFieldData()->GetArray(names::Samples);
  vtkNew<vtkDoubleArray> doubles;
  doubles->DeepCopy(samples);
  doubles->SetName(names::Samples);
  other->GetFieldData()->AddArray(doubles);
  Detection detection(other);
  const bool isSame = Bytes(detection.Run()) == expected;
  CHECK(isSame);
}

TEST_CASE("EchoDetection: a table without rows has no echoes", "[EchoDetection]")
{
  vtkNew<vtkTable> table;
  Detection detection(table);
  CHECK(detection.Run()->GetNumberOfPoints() == 0);
  CHECK(detection.Log->Errors.empty());
}

TEST_CASE("EchoDetection: bad tables are errors", "[EchoDetection]")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto set = [](const char* name, int component, double value)
  {
    return [=](vtkTable* table)
    { table->GetRowData()->GetArray(name)->SetComponent(1, component, value); };
  };
  const std::pair<std::function<void(vtkTable*)>, const char*> bad[] = {
    { [](vtkTable* t) { t->GetRowData()->RemoveArray(names::Count); }, "has no array Count" },
    { [](vtkTable* t) { t->GetFieldData()->RemoveArray(names::Samples); }, "has no array Samples" },
    { [](vtkTable* t) { t->GetFieldData()->RemoveArray(names::PulseLength); },
      "has no PulseLength in its field data" },
    { [nan](vtkTable* t)
      { t->GetFieldData()->GetArray(names::PulseLength)->SetComponent(0, 0, nan); },
      "set the property PulseLength" },
    { set(names::Offset, 0, 140), "has a row 1 with Offset 140" },
    { set(names::Count, 0, -1), "and Count -1, not within its" },
    { set(names::BinSize, 0, 0), "BinSize of row 1 is not a positive number of ns" },
    { set(names::BinSize, 0, nan), "BinSize of row 1 is not a positive number of ns" },
    { set(names::StartTime, 0, nan), "StartTime of row 1 is not a finite number" },
    { set(names::GpsTime, 0, nan), "GpsTime of row 1 is not a finite number" },
    { set(names::Origin, 2, nan), "Origin of row 1 is not a finite vector" },
    { set(names::Direction, 0, nan), "Direction of row 1 is not a finite vector" },
    { set(names::Direction, 0, 2), "Direction of row 1 is not a unit vector" },
    { [nan](vtkTable* t)
      { t->GetFieldData()->GetArray(names::Samples)->SetComponent(130, 0, nan); },
      "Samples of row 1 are not all finite" },
  };
  for (const auto& [damage, message] : bad)
  {
    auto table = MakeTable();
    damage(table);
    Detection detection(table);
    CHECK(detection.Run()->GetNumberOfPoints() == 0);
    CAPTURE(message, detection.Log->Errors);
    CHECK(detection.Log->HasError(message));
  }
  Detection detection(MakeTable());
  detection.Filter->SetEchoDetector(nullptr);
  CHECK(detection.Run()->GetNumberOfPoints() == 0);
  CHECK(detection.Log->HasError("EchoDetector is not set"));
}

TEST_CASE("EchoDetection: an abort is an error without output", "[EchoDetection]")
{
  const vtkIdType rows = 100000; // all equal to the first
  const auto one = MakeTable();
  vtkNew<vtkTable> table;
  table->GetFieldData()->ShallowCopy(one->GetFieldData());
  for (int i = 0; i < one->GetNumberOfColumns(); ++i)
  {
    auto* from = vtkDataArray::SafeDownCast(one->GetColumn(i));
    const auto column = vtkSmartPointer<vtkDataArray>::Take(from->NewInstance());
    column->SetName(from->GetName());
    column->SetNumberOfComponents(from->GetNumberOfComponents());
    column->SetNumberOfTuples(rows);
    for (vtkIdType row = 0; row < rows; ++row)
    {
      column->SetTuple(row, 0, from);
    }
    table->AddColumn(column);
  }
  Detection detection(table);
  int reports = 0;
  vtkNew<vtkCallbackCommand> abort;
  abort->SetClientData(&reports);
  abort->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* filter = static_cast<vtkAlgorithm*>(caller);
      *static_cast<int*>(data) += filter->GetProgress() > 0.0 ? 1 : 0;
      filter->SetAbortExecute(filter->GetProgress() > 0.0);
    });
  detection.Filter->AddObserver(vtkCommand::ProgressEvent, abort);
  CHECK(detection.Run()->GetNumberOfPoints() == 0);
  CHECK(detection.Log->HasError("The work was aborted at "));
  CHECK(detection.Log->HasError(" %; update again to complete it"));
  CHECK(reports == 1 + helios::ReportsAfterAbort);
}

TEST_CASE("EchoDetection: detectors by name", "[EchoDetection]")
{
  const char* classes[] = { "vtkHeliosPeakDetector", "vtkHeliosGaussianDecomposition",
    "vtkHeliosConstantFractionDetector", "vtkHeliosLeadingEdgeDetector",
    "vtkHeliosPhotonCountingDetector" };
  const auto getClass = [](const char* name) -> std::string
  {
    const auto detector =
      vtkSmartPointer<vtkHeliosEchoDetector>::Take(vtkHeliosEchoDetection::MakeDetector(name));
    return detector ? detector->GetClassName() : "none";
  };
  REQUIRE(vtkHeliosEchoDetection::GetNumberOfDetectors() == 5);
  for (int i = 0; i < 5; ++i)
  {
    CHECK(getClass(vtkHeliosEchoDetection::GetDetectorName(i)) == classes[i]);
  }
  CHECK(getClass("") == classes[0]);
  CHECK(getClass(nullptr) == classes[0]);
  CHECK(getClass("pek") == "none");
  CHECK(vtkHeliosEchoDetection::GetDetectorName(5) == nullptr);
  CHECK(vtkHeliosEchoDetection::GetDetectorName(-1) == nullptr);
}
