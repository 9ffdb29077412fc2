// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBinaryProgram.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <random>
#include <thread>
#include <unistd.h>

namespace
{

/// Rows of random columns, each needing one of them: a set cover.
helios::BinaryProgram MakeCover(int columns, int rows, int each, unsigned int seed)
{
  std::mt19937 random(seed);
  helios::BinaryProgram program;
  program.HasWholeCosts = true;
  for (int c = 0; c < columns; ++c)
  {
    program.AddColumn(1.0, true);
  }
  for (int r = 0; r < rows; ++r)
  {
    std::vector<char> isIn(columns);
    for (int k = 0; k < each; ++k)
    {
      isIn[random() % columns] = 1;
    }
    for (int c = 0; c < columns; ++c)
    {
      if (isIn[c])
      {
        program.Add(c, 1.0);
      }
    }
    program.EndRow(1.0);
  }
  return program;
}

bool Holds(const helios::BinaryProgram& program, const std::vector<double>& values)
{
  for (std::size_t r = 0; r < program.Lower.size(); ++r)
  {
    double sum = 0.0;
    for (int k = program.Starts[r]; k < program.Starts[r + 1]; ++k)
    {
      sum += program.Coefficients[k] * values[program.Columns[k]];
    }
    if (sum < program.Lower[r] - 1e-6)
    {
      return false;
    }
  }
  return true;
}

double GetCost(const helios::BinaryProgram& program, const std::vector<double>& values)
{
  double cost = 0.0;
  for (std::size_t c = 0; c < values.size(); ++c)
  {
    cost += program.Costs[c] * values[c];
  }
  return cost;
}

/// CPU time of this thread.
double GetThreadSeconds()
{
  timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The minimum cost, by enumeration.
double TryAll(const helios::BinaryProgram& program)
{
  double least = 1e300;
  const auto columns = static_cast<unsigned int>(program.Costs.size());
  for (unsigned int set = 0; set < 1u << columns; ++set)
  {
    std::vector<double> values(columns);
    for (unsigned int c = 0; c < columns; ++c)
    {
      values[c] = set >> c & 1u;
    }
    least = Holds(program, values) ? std::min(least, GetCost(program, values)) : least;
  }
  return least;
}

} // namespace

TEST_CASE("BinaryProgram: a triangle needs two columns, its relaxation 1.5", "[BinaryProgram]")
{
  helios::BinaryProgram program;
  program.HasWholeCosts = true;
  for (int c = 0; c < 3; ++c)
  {
    program.AddColumn(1.0, true);
  }
  for (int c = 0; c < 3; ++c)
  {
    program.Add(c, 1.0);
    program.Add((c + 1) % 3, 1.0);
    program.EndRow(1.0);
  }
  CHECK(helios::SolveRelaxed(program) == Approx(1.5).margin(1e-5));
  const helios::BinaryAnswer answer = helios::SolveBinary(program);
  CHECK(answer.IsProved);
  CHECK(GetCost(program, answer.Values) == Approx(2.0));
  CHECK(answer.LinearBound == Approx(1.5).margin(1e-5));
  CHECK(answer.Bound == Approx(2.0).margin(1e-5));
}

TEST_CASE("BinaryProgram: small programs agree with exhaustive search", "[BinaryProgram]")
{
  for (unsigned int seed = 0; seed < 40; ++seed)
  {
    INFO(seed);
    helios::BinaryProgram program = MakeCover(10, 25, 2 + static_cast<int>(seed % 3), seed);
    if (seed % 2)
    {
      program.HasWholeCosts = false;
      program.Costs[seed % 10] = 0.4;
      program.Costs[(seed + 3) % 10] = 1.7;
    }
    if (seed % 4 < 2)
    {
      program.Start.assign(10, 1.0);
    }
    const helios::BinaryAnswer answer = helios::SolveBinary(program);
    REQUIRE(answer.IsProved);
    CHECK(Holds(program, answer.Values));
    CHECK(GetCost(program, answer.Values) == Approx(TryAll(program)));
    CHECK(answer.LinearBound <= TryAll(program));
    CHECK(answer.Bound <= TryAll(program) + 1e-6);
  }
}

TEST_CASE("BinaryProgram: relaxed columns are fractional", "[BinaryProgram]")
{
  helios::BinaryProgram program;
  program.AddColumn(1.0, true);
  program.AddColumn(1.0, false);
  program.Add(0, 2.0);
  program.Add(1, 1.0);
  program.EndRow(2.25);
  const helios::BinaryAnswer answer = helios::SolveBinary(program);
  CHECK(answer.IsProved);
  CHECK(answer.Values[0] == Approx(1.0));
  CHECK(answer.Values[1] == Approx(0.25));
}

TEST_CASE("BinaryProgram: infeasible programs are proved infeasible", "[BinaryProgram]")
{
  helios::BinaryProgram program;
  program.AddColumn(1.0, true);
  program.Add(0, 1.0);
  program.EndRow(2.0);
  const helios::BinaryAnswer answer = helios::SolveBinary(program);
  CHECK(answer.IsProved);
  CHECK(answer.Values.empty());
}

TEST_CASE("BinaryProgram: after the time limit the start and a bound remain", "[BinaryProgram]")
{
  helios::BinaryProgram program = MakeCover(200, 400, 8, 1);
  program.Start.assign(200, 1.0);
  SECTION("abort")
  {
    program.Stop = [] { return true; };
  }
  SECTION("time limit")
  {
    program.TimeLimit = 0.2;
  }
  const helios::BinaryAnswer answer = helios::SolveBinary(program);
  REQUIRE(answer.Values.size() == 200);
  CHECK(Holds(program, answer.Values));
  CHECK_FALSE(answer.IsProved);
  CHECK(answer.Bound > 20.0);
  CHECK(answer.Bound <= GetCost(program, answer.Values));
}

TEST_CASE("BinaryProgram: a linear solve stops between its iterations", "[BinaryProgram]")
{
  helios::BinaryProgram program = MakeCover(400, 1500, 12, 1);
  int calls = 0;
  int last = 0;
  program.Stop = [&] { return ++calls == last; };
  REQUIRE(helios::SolveRelaxed(program) > 20.0);
  REQUIRE(calls > 100);
  last = 100;
  calls = 0;
  CHECK(helios::SolveRelaxed(program) == 0.0);
  CHECK(calls == last);
}

TEST_CASE("BinaryProgram: results are valid wherever a search is stopped", "[BinaryProgram]")
{
  for (unsigned int seed = 0; seed < 2; ++seed)
  {
    helios::BinaryProgram program = MakeCover(50, 100, 4, seed);
    const helios::BinaryAnswer whole = helios::SolveBinary(program);
    REQUIRE(whole.IsProved);
    const double least = GetCost(program, whole.Values);
    program.Start.assign(50, 1.0);
    bool wasStopped = true;
    for (int last = 1; wasStopped; last *= 2)
    {
      INFO(seed << ", stopped at question " << last);
      int calls = 0;
      program.Stop = [&] { return ++calls == last; };
      const helios::BinaryAnswer answer = helios::SolveBinary(program);
      wasStopped = calls >= last;
      REQUIRE(Holds(program, answer.Values));
      REQUIRE(answer.Bound <= least + 1e-6);
      REQUIRE(answer.IsProved != wasStopped);
      REQUIRE(calls <= last); // no further calls
    }
  }
}

// CBC's own limit is CPU time. With busy threads, 8 per core, a search of 2 s wall time has less
// CPU time than that, and the less the busier the machine is.
TEST_CASE("BinaryProgram: the time limit is wall-clock time", "[BinaryProgram]")
{
  std::atomic<bool> isOver{ false };
  std::vector<std::thread> busy;
  for (unsigned int i = 0; i < 8 * std::max(1u, std::thread::hardware_concurrency()); ++i)
  {
    busy.emplace_back(
      [&isOver]
      {
        while (!isOver)
        {
        }
      });
  }
  helios::BinaryProgram program = MakeCover(200, 400, 8, 1);
  program.Start.assign(200, 1.0);
  program.TimeLimit = 2.0;
  const double start = GetThreadSeconds();
  const helios::BinaryAnswer answer = helios::SolveBinary(program);
  const double time = GetThreadSeconds() - start;
  isOver = true;
  for (std::thread& thread : busy)
  {
    thread.join();
  }
  CHECK_FALSE(answer.IsProved);
  CHECK(Holds(program, answer.Values));
  CHECK(time < 0.75 * program.TimeLimit);
}

TEST_CASE("BinaryProgram: signal handlers are kept during a solve", "[BinaryProgram]")
{
  const auto own = [](int) {};
  struct sigaction old = {};
  struct sigaction mine = {};
  mine.sa_handler = own;
  sigaction(SIGINT, &mine, &old);
  helios::BinaryProgram program = MakeCover(40, 120, 4, 2);
  int calls = 0;
  int elsewhere = 0;
  program.Stop = [&]
  {
    struct sigaction now = {};
    sigaction(SIGINT, nullptr, &now);
    ++calls;
    elsewhere += now.sa_handler == mine.sa_handler ? 0 : 1;
    return false;
  };
  helios::SolveBinary(program);
  sigaction(SIGINT, &old, nullptr);
  CHECK(calls > 100);
  CHECK(elsewhere == 0);
}

TEST_CASE("BinaryProgram: prints nothing and restores signal handlers", "[BinaryProgram]")
{
  const auto own = [](int) {};
  struct sigaction old = {};
  struct sigaction mine = {};
  mine.sa_handler = own;
  sigaction(SIGINT, &mine, &old);
  std::FILE* file = std::tmpfile();
  std::fflush(stdout);
  const int out = dup(1);
  const int err = dup(2);
  dup2(fileno(file), 1);
  dup2(fileno(file), 2);
  const helios::BinaryAnswer answer = helios::SolveBinary(MakeCover(40, 120, 4, 2));
  const double relaxed = helios::SolveRelaxed(MakeCover(40, 120, 4, 2));
  std::fflush(stdout);
  dup2(out, 1);
  dup2(err, 2);
  close(out);
  close(err);
  std::fseek(file, 0, SEEK_END);
  CHECK(std::ftell(file) == 0);
  std::fclose(file);
  struct sigaction now = {};
  sigaction(SIGINT, &old, &now);
  CHECK(now.sa_handler == mine.sa_handler);
  CHECK(answer.IsProved);
  CHECK(relaxed == Approx(answer.LinearBound));
}
