// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosReturnSelection.h"

#include <catch2/catch.hpp>

namespace
{

struct Found
{
  double Amplitude;
};

std::vector<std::size_t> Select(const std::vector<Found>& echoes, int selection, int maximum = 0)
{
  std::vector<std::size_t> kept = { 77 };
  helios::SelectReturns(echoes, selection, maximum, kept);
  return kept;
}

} // namespace

TEST_CASE("ReturnSelection: selection, then MaximumNumberOfReturns", "[ReturnSelection]")
{
  using Instrument = vtkHeliosInstrument;
  using Kept = std::vector<std::size_t>;
  const std::vector<Found> echoes = { { 2 }, { 5 }, { 5 }, { 1 } };
  CHECK(Select(echoes, Instrument::ALL) == Kept{ 0, 1, 2, 3 });
  CHECK(Select(echoes, Instrument::ALL, 3) == Kept{ 0, 1, 2 });
  CHECK(Select(echoes, Instrument::FIRST) == Kept{ 0 });
  CHECK(Select(echoes, Instrument::LAST, 1) == Kept{ 3 });
  CHECK(Select(echoes, Instrument::STRONGEST) == Kept{ 1 }); // the first of equal ones
  CHECK(Select(echoes, Instrument::FIRST_AND_LAST) == Kept{ 0, 3 });
  CHECK(Select(echoes, Instrument::FIRST_AND_LAST, 1) == Kept{ 0 });
  CHECK(Select({ { 1 } }, Instrument::FIRST_AND_LAST) == Kept{ 0 });
  for (const int selection : { Instrument::ALL, Instrument::FIRST, Instrument::LAST,
         Instrument::STRONGEST, Instrument::FIRST_AND_LAST })
  {
    CHECK(Select({}, selection).empty());
  }
  CHECK(Select(std::vector<Found>(300, Found{ 1 }), Instrument::ALL).size() == 255);
}

TEST_CASE("ReturnSelection: the range is half the light path", "[ReturnSelection]")
{
  CHECK(helios::GetRange(600.0, 67.128190396) == Approx(100.0).epsilon(1e-10));
}
