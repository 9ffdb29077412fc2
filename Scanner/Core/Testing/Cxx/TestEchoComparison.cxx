// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Known differences between hand-made echoes, and published confidence intervals.
#include "heliosConfidence.h"
#include "heliosEchoComparison.h"
#include "heliosErrorObserver.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosEchoComparison.h"

#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>
#include <vtkTypeInt64Array.h>
#include <vtkVariant.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace names = vtkHeliosArrayNames;
using namespace helios;

namespace
{

struct Row
{
  vtkIdType Pulse;
  double Range;
  double Amplitude = 1.0;
  double Width = 4.0;
};

vtkSmartPointer<vtkPolyData> MakeEchoes(const std::vector<Row>& rows)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkTypeInt64Array> ids;
  vtkNew<vtkDoubleArray> columns[3];
  ids->SetName(names::PulseIds);
  columns[0]->SetName(names::Range);
  columns[1]->SetName(names::Amplitude);
  columns[2]->SetName(names::EchoWidth);
  auto echoes = vtkSmartPointer<vtkPolyData>::New();
  for (const Row& row : rows)
  {
    points->InsertNextPoint(0, row.Range, 0);
    ids->InsertNextValue(row.Pulse);
    columns[0]->InsertNextValue(row.Range);
    columns[1]->InsertNextValue(row.Amplitude);
    columns[2]->InsertNextValue(row.Width);
  }
  echoes->SetPoints(points);
  echoes->GetPointData()->AddArray(ids);
  for (const auto& column : columns)
  {
    echoes->GetPointData()->AddArray(column);
  }
  return echoes;
}

EchoErrors Compare(const std::vector<Row>& run, const std::vector<Row>& reference,
  const EchoMatching& matching = EchoMatching())
{
  EchoComparison comparison;
  REQUIRE(comparison.Add(MakeEchoes(run), MakeEchoes(reference), matching).IsOk());
  return comparison.GetErrors();
}

double Find(vtkTable* table, const std::string& name, const char* column)
{
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    if (table->GetValueByName(row, "Name").ToString() == name)
    {
      return table->GetValueByName(row, column).ToDouble();
    }
  }
  return std::nan("");
}

} // namespace

TEST_CASE("A fraction has Wilson's interval, as published")
{
  // Newcombe (1998), Statistics in Medicine 17, 857-872, Table I, method 3
  const Estimate many = EstimateFraction(81, 263);
  CHECK(many.Value == Approx(81.0 / 263.0));
  CHECK(many.Lower == Approx(0.2553).margin(5e-5));
  CHECK(many.Upper == Approx(0.3662).margin(5e-5));
  const Estimate few = EstimateFraction(15, 148);
  CHECK(few.Lower == Approx(0.0624).margin(5e-5));
  CHECK(few.Upper == Approx(0.1605).margin(5e-5));
  const Estimate none = EstimateFraction(0, 20);
  CHECK(none.Lower == 0.0);
  CHECK(none.Upper == Approx(0.1611).margin(5e-5));
  const Estimate one = EstimateFraction(1, 29);
  CHECK(one.Lower == Approx(0.0061).margin(5e-5));
  CHECK(one.Upper == Approx(0.1718).margin(5e-5));
}

TEST_CASE("A fraction of nothing may be anything, and a fraction of all ends at one")
{
  const Estimate nothing = EstimateFraction(0, 0);
  CHECK((nothing.Lower == 0.0 && nothing.Upper == 1.0));
  CHECK(EstimateFraction(20, 20).Upper == 1.0);
  CHECK(EstimateFraction(25, 20).Value == 1.0);
}

TEST_CASE("A quantile has the interval of order statistics")
{
  std::vector<double> sorted(100);
  std::iota(sorted.begin(), sorted.end(), 1.0);
  // Conover (1999), Practical Nonparametric Statistics: ranks 40 and 61 of 100 for the median
  const Estimate median = EstimateQuantile(sorted, 0.5);
  CHECK(median.Value == 50.0);
  CHECK(median.Lower == Approx(40.0).margin(1.0));
  CHECK(median.Upper == Approx(61.0).margin(1.0));
  const Estimate p95 = EstimateQuantile(sorted, 0.95);
  CHECK(p95.Value == 95.0);
  CHECK(p95.Lower == Approx(90.0).margin(1.0));
  CHECK(p95.Upper == Approx(99.0).margin(1.0));
  CHECK(EstimateQuantile({}, 0.5).Value == 0.0);
  CHECK(EstimateQuantile({ 7.0 }, 0.95).Upper == 7.0);
}

TEST_CASE("The interval of a quantile holds it in 95 % of samples")
{
  std::uint64_t state = 1;
  int held = 0;
  for (int sample = 0; sample < 1000; ++sample)
  {
    std::vector<double> values;
    for (int i = 0; i < 300; ++i)
    {
      state = state * 6364136223846793005u + 1442695040888963407u;
      values.push_back(static_cast<double>(state >> 11) / 9007199254740992.0);
    }
    std::sort(values.begin(), values.end());
    const Estimate p95 = EstimateQuantile(values, 0.95);
    held += p95.Lower <= 0.95 && 0.95 <= p95.Upper ? 1 : 0;
  }
  CHECK(held >= 940);
  CHECK(held <= 985);
}

TEST_CASE("A root mean square of equal deviations has no spread")
{
  const Estimate rms = EstimateRms({ 3.0, -3.0, 3.0, -3.0 });
  CHECK(rms.Value == 3.0);
  CHECK(rms.Lower == 3.0);
  CHECK(rms.Upper == 3.0);
  CHECK(EstimateRms({}).Value == 0.0);
}

TEST_CASE("Echoes that equal the reference have no error")
{
  const std::vector<Row> rows = { { 1, 10.0 }, { 1, 12.0 }, { 3, 20.0 } };
  const EchoErrors errors = Compare(rows, rows);
  CHECK(errors.Echoes == 3);
  CHECK(errors.Matched == 3);
  CHECK(errors.RangeP95.Upper == 0.0);
  CHECK(errors.Lost.Value == 0.0);
  CHECK(errors.AmplitudeRms.Value == 0.0);
  CHECK(errors.WidthRms.Value == 0.0);
}

TEST_CASE("Known deviations have their quantiles, whatever the order of the echoes")
{
  std::vector<Row> run;
  std::vector<Row> reference;
  for (vtkIdType pulse = 0; pulse < 101; ++pulse)
  {
    const double sign = pulse % 2 == 0 ? 1.0 : -1.0;
    reference.push_back({ pulse, 50.0, 2.0, 4.0 });
    run.push_back({ 100 - pulse, 50.0 + sign * 1e-3 * static_cast<double>(pulse), 2.2, 4.5 });
  }
  const EchoErrors errors = Compare(run, reference);
  CHECK(errors.RangeP50.Value == Approx(0.050));
  CHECK(errors.RangeP95.Value == Approx(0.095));
  CHECK(errors.RangeRms.Value == Approx(1e-3 * std::sqrt(100.0 * 201.0 / 6.0)));
  CHECK(errors.AmplitudeRms.Value == Approx(0.1));
  CHECK(errors.WidthRms.Value == Approx(0.5));
}

TEST_CASE("An echo without a partner in its pulse is missed or invented")
{
  const std::vector<Row> reference = { { 1, 10.0 }, { 2, 10.0 }, { 3, 10.0 }, { 4, 10.0 } };
  const std::vector<Row> run = { { 1, 10.1 }, { 2, 10.4 }, { 4, 10.0 }, { 5, 10.0 }, { 6, 9.0 } };
  const EchoErrors errors = Compare(run, reference);
  CHECK(errors.Echoes == 4);
  CHECK(errors.Matched == 2);
  CHECK(errors.Missed.Value == 0.5);    // share of pulses 2 and 3
  CHECK(errors.Invented.Value == 0.75); // share of pulses 2, 5 and 6
  CHECK(errors.Lost.Value == 1.0);
}

TEST_CASE("The nearest echoes are partners, and none has two")
{
  const EchoErrors errors =
    Compare({ { 1, 10.25 } }, { { 1, 10.0 }, { 1, 10.3 } }); // both within the distance
  CHECK(errors.Missed.Value == 0.5);
  CHECK(errors.Invented.Value == 0.0);
  CHECK(errors.RangeRms.Value == Approx(0.05));
}

TEST_CASE("Echoes weaker than the limit do not count, but may be partners")
{
  EchoMatching matching;
  matching.FullAmplitude = 10000.0; // 100 W at 10 m, 25 W at 20 m
  const std::vector<Row> reference = { { 1, 10.0, 1.9 }, { 2, 10.0, 2.1 }, { 3, 20.0, 0.4 },
    { 4, 20.0, 0.6 } };
  const EchoErrors none = Compare({}, reference, matching);
  CHECK(none.Echoes == 2);
  CHECK(none.Missed.Value == 1.0);
  const EchoErrors weak =
    Compare({ { 2, 10.0, 1.9 }, { 4, 20.0, 0.4 }, { 5, 10.0, 1.9 } }, reference, matching);
  CHECK(weak.Missed.Value == 0.0);
  CHECK(weak.Invented.Value == 0.0);
  CHECK(weak.AmplitudeRms.Value ==
    Approx(std::sqrt(0.5 * (std::pow(0.2 / 100.0, 2) + std::pow(0.2 / 25.0, 2)))));
  matching.LeastAmplitude = 0.7;
  CHECK(Compare({}, reference, matching).Echoes == 1);
}

TEST_CASE("A full footprint is darker behind air")
{
  EchoMatching matching;
  matching.FullAmplitude = 100.0;
  matching.Extinction = 0.01;
  CHECK(matching.GetFullAmplitude(10.0) == Approx(std::exp(-0.2)));
}

TEST_CASE("vtkHeliosEchoComparison makes a table of measures with their intervals")
{
  vtkNew<vtkHeliosEchoComparison> comparison;
  comparison->SetInputData(0, MakeEchoes({ { 1, 10.1, 1.1 }, { 2, 20.1, 1.1 } }));
  comparison->SetInputData(1, MakeEchoes({ { 1, 10.0 }, { 2, 20.0 }, { 3, 30.0 } }));
  comparison->Update();
  vtkTable* table = comparison->GetOutput();
  CHECK(Find(table, "rangeP95_m", "Value") == Approx(0.1));
  CHECK(Find(table, "amplitudeRms", "Value") == Approx(0.1));
  CHECK(Find(table, "missed", "Value") == Approx(1.0 / 3.0));
  CHECK(Find(table, "missed", "Lower") == Approx(EstimateFraction(1, 3).Lower));
  CHECK(Find(table, "missed", "Upper") == Approx(EstimateFraction(1, 3).Upper));
  CHECK(Find(table, "echoes", "Value") == 3.0);
  CHECK(Find(table, "matched", "Upper") == 2.0);
  comparison->SetMatchingDistance(0.05);
  comparison->Update();
  CHECK(Find(comparison->GetOutput(), "missed", "Value") == 1.0);
}

TEST_CASE("Echoes without an array are an error that names it")
{
  auto log = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());
  vtkNew<vtkHeliosEchoComparison> comparison;
  log->Watch(comparison);
  log->Watch(comparison->GetExecutive());
  const auto bare = MakeEchoes({ { 1, 10.0 } });
  bare->GetPointData()->RemoveArray(names::EchoWidth);
  comparison->SetInputData(0, MakeEchoes({ { 1, 10.0 } }));
  comparison->SetInputData(1, bare);
  comparison->Update();
  CHECK(log->HasError("no point array EchoWidth; compare outputs of vtkHeliosScanner"));
}
