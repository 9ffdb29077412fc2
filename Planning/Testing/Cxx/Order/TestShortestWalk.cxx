// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Walks against all permutations, and on lattices whose shortest walk is known.
#include "vtkHeliosShortestWalk.h"

#include "heliosPlanningTest.h"
#include "heliosTour.h"

#include <vtkDoubleArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace
{

using Places = std::vector<std::array<double, 3>>;

Places MakeRandom(std::size_t count, unsigned seed)
{
  std::mt19937 generator(seed);
  const auto draw = [&generator] { return static_cast<double>(generator() % 10000) / 100.0; };
  Places places;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = draw();
    const double y = draw();
    places.push_back({ x, y, draw() / 10.0 });
  }
  return places;
}

double Measure(const Places& places, const std::vector<int>& order, bool isClosed)
{
  double length = 0.0;
  for (std::size_t i = 0; i + (isClosed ? 0 : 1) < order.size(); ++i)
  {
    const auto& a = places[static_cast<std::size_t>(order[i])];
    const auto& b = places[static_cast<std::size_t>(order[(i + 1) % order.size()])];
    length += std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
  }
  return length;
}

double FindShortest(const Places& places, bool isClosed)
{
  std::vector<int> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  double least = std::numeric_limits<double>::max();
  do
  {
    least = std::min(least, Measure(places, order, isClosed));
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

struct Walk
{
  vtkNew<vtkHeliosShortestWalk> Filter;
  vtkNew<helios::ErrorObserver> Log;

  explicit Walk(const Places& places)
  {
    auto positions = helios::MakePoints(places);
    vtkNew<vtkDoubleArray> numbers;
    numbers->SetName("number");
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      numbers->InsertNextValue(static_cast<double>(i));
    }
    positions->GetPointData()->AddArray(numbers);
    this->Filter->SetInputData(positions);
    this->Log->Watch(this->Filter);
  }

  std::vector<int> Update()
  {
    this->Filter->Update();
    std::vector<int> order;
    vtkDataArray* numbers = this->Filter->GetOutput()->GetPointData()->GetArray("number");
    for (vtkIdType i = 0; numbers && i < numbers->GetNumberOfTuples(); ++i)
    {
      order.push_back(static_cast<int>(numbers->GetTuple1(i)));
    }
    return order;
  }
};

} // namespace

TEST_CASE("ShortestWalk: as the best permutation", "[ShortestWalk]")
{
  const std::size_t count = GENERATE(1, 2, 3, 4, 5, 8);
  const bool isClosed = GENERATE(false, true);
  const Places places = MakeRandom(count, 3);
  Walk walk(places);
  walk.Filter->SetClosed(isClosed);
  const std::vector<int> order = walk.Update();
  REQUIRE(order.size() == count);
  const double shortest = FindShortest(places, isClosed);
  CHECK(Measure(places, order, isClosed) == Approx(shortest).margin(1e-12));
  CHECK(walk.Filter->GetLength() == Approx(shortest).margin(1e-12));
  CHECK(walk.Filter->GetLowerBound() == Approx(shortest).margin(1e-12));
}

TEST_CASE(
  "ShortestWalk: the bound and the walk of many places enclose the shortest", "[ShortestWalk]")
{
  // The heuristic on as many places as the exact method solves.
  const unsigned seed = GENERATE(1U, 2U, 3U, 4U);
  const Places many = MakeRandom(60, seed);
  Walk walk(many);
  std::vector<int> order = walk.Update();
  CHECK(Measure(many, order, false) == Approx(walk.Filter->GetLength()));
  CHECK(walk.Filter->GetLowerBound() <= walk.Filter->GetLength());
  CHECK(walk.Filter->GetLowerBound() >= 0.9 * walk.Filter->GetLength());
  std::sort(order.begin(), order.end());
  REQUIRE(order.size() == 60);
  CHECK(std::adjacent_find(order.begin(), order.end()) == order.end());
}

TEST_CASE("ShortestWalk: a lattice is walked row by row", "[ShortestWalk]")
{
  Places places;
  for (int i = 0; i < 36; ++i)
  {
    const int k = (i * 7) % 36; // in a scrambled order
    places.push_back({ 10.0 * (k % 6), 10.0 * (k / 6), 0.0 });
  }
  places.erase(std::unique(places.begin(), places.end()), places.end());
  Walk walk(places);
  walk.Update();
  // No walk of 36 places is shorter than 35 steps.
  CHECK(walk.Filter->GetLength() >= 350.0 - 1e-9);
  CHECK(walk.Filter->GetLength() <= 350.0 * 1.05);
  CHECK(walk.Filter->GetLowerBound() <= 350.0 + 1e-9);
}

TEST_CASE("ShortestWalk: errors", "[ShortestWalk]")
{
  Walk far({ { 0, 0, 0 }, { std::nan(""), 0, 0 } });
  far.Update();
  CHECK_THAT(far.Log->Errors, Catch::Contains("position 1 is (nan, 0, 0)"));
  Walk many(Places(1001, { 0, 0, 0 }));
  many.Update();
  CHECK_THAT(many.Log->Errors, Catch::Contains("there are 1001 positions; give at most 1000"));
  Walk none({});
  CHECK(none.Update().empty());
  CHECK(none.Log->Errors.empty());
}
