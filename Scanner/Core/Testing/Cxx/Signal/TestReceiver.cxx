// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosConstants.h"
#include "heliosReceiver.h"
#include "vtkHeliosPeakDetector.h"

#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>
#include <random>

using helios::Echo;
using helios::Receiver;
using helios::SubReturn;

namespace
{

constexpr double PulseLength = 4.0;
constexpr double SigmaRange = 0.5 * helios::SpeedOfLight * PulseLength / helios::FwhmPerSigma;

std::vector<SubReturn> MakeReturns(std::initializer_list<std::pair<double, double>> rangesAndPowers)
{
  std::vector<SubReturn> returns;
  for (const auto& [range, power] : rangesAndPowers)
  {
    returns.push_back({ range, power, 1.0, 0, static_cast<int>(returns.size()) });
  }
  return returns;
}

helios::ReceiverSettings MakeSettings(vtkHeliosEchoDetector* detector, double binSize)
{
  helios::ReceiverSettings settings;
  settings.Shape = helios::PulseShape::MakeGaussian(PulseLength);
  settings.BinSize = settings.DetectionBin = binSize;
  settings.Detector = detector;
  return settings;
}

std::vector<Echo> Find(std::vector<SubReturn>& returns, double binSize = 0.25)
{
  vtkNew<vtkHeliosPeakDetector> detector;
  Receiver receiver(MakeSettings(detector, binSize));
  std::vector<Echo> echoes;
  receiver.FindMaxima(returns, echoes);
  return echoes;
}

/// The maximum of the sum of Gaussians nearest to a start, by bisection of its derivative.
double TrueMaximum(const std::vector<SubReturn>& returns, double from, double to)
{
  const auto slope = [&returns](double x)
  {
    double sum = 0;
    for (const SubReturn& r : returns)
    {
      const double u = (x - r.Range) / SigmaRange;
      sum -= r.Power * u * std::exp(-0.5 * u * u);
    }
    return sum;
  };
  for (int i = 0; i < 200; ++i)
  {
    const double middle = 0.5 * (from + to);
    (slope(middle) > 0 ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

} // namespace

TEST_CASE("Receiver: equal ranges add up", "[Receiver]")
{
  std::vector<SubReturn> returns(19, { 100.0, 1e-8, 1.0, 0, 0 });
  const auto echoes = Find(returns);
  REQUIRE(echoes.size() == 1);
  CHECK(echoes[0].Range == 100.0);
  CHECK(echoes[0].Amplitude == Approx(19e-8).epsilon(1e-14));
  CHECK(echoes[0].Width == Approx(PulseLength).epsilon(1e-14));
}

TEST_CASE("Receiver: returns within c sigma have one maximum", "[Receiver]")
{
  auto returns = MakeReturns({ { 50.0, 3e-8 }, { 50.31, 1e-8 }, { 50.4, 2e-8 }, { 50.05, 1e-8 } });
  const auto echoes = Find(returns);
  REQUIRE(echoes.size() == 1);
  CHECK(echoes[0].Range == Approx(TrueMaximum(returns, 50.0, 50.4)).epsilon(0).margin(1e-11));
  CHECK(echoes[0].Nearest->Range == 50.05);
}

TEST_CASE(
  "Receiver: two halves almost 2 sigma apart have one flat maximum at the centre", "[Receiver]")
{
  auto returns = MakeReturns({ { 10.0, 1e-7 }, { 10.0 + 1.999 * SigmaRange, 1e-7 } });
  const auto echoes = Find(returns);
  REQUIRE(echoes.size() == 1);
  CHECK(echoes[0].Range == Approx(10.0 + 0.9995 * SigmaRange).epsilon(1e-12));
}

TEST_CASE("Receiver: bins agree with the exact maximum", "[Receiver]")
{
  // A spread over 0.6 m: the group is binned, and its sum still has one maximum.
  auto returns =
    MakeReturns({ { 200.0, 1e-7 }, { 200.2, 4e-7 }, { 200.3, 3e-7 }, { 200.6, 1e-7 } });
  const auto echoes = Find(returns);
  REQUIRE(echoes.size() == 1);
  const double exact = TrueMaximum(returns, 200.0, 200.6);
  CHECK(std::abs(echoes[0].Range - exact) < 2e-4);
}

TEST_CASE("Receiver: separation limit of two equal echoes", "[Receiver]")
{
  // Two maxima for separations in time from 2 sigma: 0.509241 m at 4 ns (1 % below and above).
  for (const double factor : { 0.99, 1.01 })
  {
    const double limit = 0.509241;
    auto returns = MakeReturns({ { 30.0, 1e-7 }, { 30.0 + factor * limit, 1e-7 } });
    CHECK(Find(returns, 0.05).size() == (factor < 1 ? 1u : 2u));
  }
}

TEST_CASE("Receiver: separation limit of unequal echoes", "[Receiver]")
{
  struct Row
  {
    double Ratio, Limit;
  };
  for (const Row& row : { Row{ 0.5, 0.669017 }, Row{ 0.1, 0.853995 }, Row{ 0.01, 1.041001 } })
  {
    for (const double factor : { 0.99, 1.01 })
    {
      auto returns =
        MakeReturns({ { 30.0, 1e-7 }, { 30.0 + factor * row.Limit, row.Ratio * 1e-7 } });
      CHECK(Find(returns, 0.05).size() == (factor < 1 ? 1u : 2u));
    }
  }
}

TEST_CASE("Receiver: distant surfaces are separate echoes", "[Receiver]")
{
  auto returns = MakeReturns({ { 900.0, 1e-9 }, { 5.0, 1e-6 }, { 5.001, 1e-6 }, { 90.0, 1e-8 } });
  const auto echoes = Find(returns);
  REQUIRE(echoes.size() == 3);
  CHECK(echoes[0].Range == Approx(5.0005).epsilon(1e-9));
  CHECK(echoes[1].Range == 90.0);
  CHECK(echoes[2].Range == 900.0);
  CHECK(echoes[2].Amplitude == 1e-9);
}

TEST_CASE("Receiver: a waveform has the energy and the exact times", "[Receiver]")
{
  vtkNew<vtkHeliosPeakDetector> detector;
  const double bin = 0.25;
  helios::ReceiverSettings settings = MakeSettings(detector, bin);
  Receiver receiver(settings);
  auto returns = MakeReturns({ { 20.0123, 2e-7 }, { 23.3456, 1e-7 } });
  CHECK_FALSE(receiver.Fill(returns, 0.0, 0));
  const helios::Waveform& wave = receiver.GetWaveform();
  const double sigma = PulseLength / helios::FwhmPerSigma;

  double sum = 0, worst = 0;
  for (std::size_t i = 0; i < wave.Samples.size(); ++i)
  {
    const double t = wave.StartTime + bin * static_cast<double>(i);
    double exact = 0;
    for (const SubReturn& r : returns)
    {
      const double u = (t - 2 * r.Range / helios::SpeedOfLight) / sigma;
      exact += r.Power * std::exp(-0.5 * u * u);
    }
    worst = std::max(worst, std::abs(wave.Samples[i] - exact));
    sum += wave.Samples[i];
  }
  CHECK(worst < 2e-7 * 6e-8); // float samples
  const double area = 3e-7 * sigma * std::sqrt(2 * std::acos(-1.0));
  CHECK(sum * bin == Approx(area).epsilon(2e-6));

  settings.MaximumCount = 10;
  Receiver cut(settings);
  CHECK(cut.Fill(returns, 0.0, 0));
  CHECK(cut.GetWaveform().Samples.size() == 10);
}

TEST_CASE("Receiver: the bins around maxima give the echoes of the complete waveform", "[Receiver]")
{
  vtkNew<vtkHeliosPeakDetector> detector;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Echo> few, all;
  std::size_t found = 0;
  for (const double binSize : { 0.05, 0.25, 1.0 })
  {
    Receiver receiver(MakeSettings(detector, binSize));
    for (int pulse = 0; pulse < 3000; ++pulse)
    {
      std::vector<SubReturn> returns;
      const double spread = std::pow(10.0, 4.0 * unit(random) - 2.5); // 3 mm to 30 m
      const int surfaces = 1 + pulse % 5;
      for (int i = 0; i < 1 + pulse % 40; ++i)
      {
        const double range = 500.0 + spread * (i % surfaces) + 0.05 * unit(random);
        returns.push_back({ range, 1e-9 * std::pow(unit(random), 3), 1.0, 0, i });
      }
      few.clear();
      all.clear();
      REQUIRE(receiver.FindBinnedMaxima(returns, few));
      receiver.Fill(returns, 0.0, 0);
      receiver.DetectEchoes(returns, all);
      CAPTURE(binSize, pulse, spread);
      REQUIRE(few.size() == all.size());
      for (std::size_t i = 0; i < all.size(); ++i)
      {
        REQUIRE(few[i].Range == all[i].Range);
        REQUIRE(few[i].Amplitude == all[i].Amplitude);
        REQUIRE(few[i].Width == all[i].Width);
        REQUIRE(few[i].Nearest == all[i].Nearest);
      }
      found += all.size();
    }
  }
  CHECK(found > 15000);
}

TEST_CASE("Receiver: a truncated waveform, or one without single maxima, is searched completely",
  "[Receiver]")
{
  vtkNew<vtkHeliosPeakDetector> detector;
  helios::ReceiverSettings settings = MakeSettings(detector, 0.25);
  settings.MaximumCount = 100;
  std::vector<Echo> echoes;
  CHECK_FALSE(
    Receiver(settings).FindBinnedMaxima(MakeReturns({ { 100, 1e-9 }, { 110, 1e-9 } }), echoes));
  CHECK_FALSE(
    Receiver(MakeSettings(detector, 0.25)).FindBinnedMaxima(MakeReturns({ { 100, 0.0 } }), echoes));
  // Bins so small that floats are constant over some of them.
  CHECK_FALSE(Receiver(MakeSettings(detector, 1e-4))
                .FindBinnedMaxima(MakeReturns({ { 100, 1e-9 } }), echoes));
  CHECK(echoes.empty());
}

TEST_CASE("Receiver: many returns, sorted, have the echoes that they have unsorted", "[Receiver]")
{
  vtkNew<vtkHeliosPeakDetector> detector;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(0, 1);
  for (const double depth : { 0.3, 40.0, 3000.0 })
  {
    std::vector<SubReturn> returns;
    for (int i = 0; i < 2000; ++i)
    {
      returns.push_back({ 100 + depth * number(random), number(random), 1.0, i, i });
    }
    helios::ReceiverSettings settings = MakeSettings(detector, 0.25);
    std::vector<Echo> echoes[2];
    std::vector<vtkIdType> cells[2];
    for (const bool isSorted : { false, true })
    {
      settings.HasLimit = !isSorted;
      Receiver receiver(settings);
      receiver.FindMaxima(returns, echoes[isSorted]);
      for (const Echo& echo : echoes[isSorted])
      {
        cells[isSorted].push_back(echo.Nearest->CellId);
      }
    }
    CAPTURE(depth);
    REQUIRE(echoes[0].size() == echoes[1].size());
    CHECK(echoes[0].size() > (depth > 1 ? 20u : 0u));
    CHECK(cells[0] == cells[1]);
    for (std::size_t i = 0; i < echoes[0].size(); ++i)
    {
      CHECK(std::abs(echoes[0][i].Range - echoes[1][i].Range) < 1e-7);
      CHECK(echoes[0][i].Amplitude == Approx(echoes[1][i].Amplitude).epsilon(1e-6));
    }
  }
}
