// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Playback time, and the frame rate limit.
#include "heliosFrameBudget.h"
#include "heliosPlayClock.h"

#include <catch2/catch.hpp>

#include <cmath>

using helios::viewer::FrameBudget;
using helios::viewer::PlayClock;

TEST_CASE("PlayClock: time advances at the set speed, up to the available data", "[Viewer]")
{
  PlayClock clock;
  clock.SetSpan(10.0, 20.0);
  CHECK(clock.GetTime() == 10.0);
  clock.SetSpeed(2.0);
  clock.Advance(1.5, 20.0);
  CHECK(clock.GetTime() == 13.0);
  clock.Advance(1.0, 14.0); // limited by computed time
  CHECK(clock.GetTime() == 14.0);
  clock.SetSpeed(PlayClock::AsFastAsItComputes);
  clock.Advance(0.001, 17.0);
  CHECK(clock.GetTime() == 17.0);
  CHECK(std::isinf(clock.GetTarget()));
  clock.Advance(1.0, 99.0);
  CHECK(clock.GetTime() == 20.0);
}

TEST_CASE("PlayClock: a pause persists, and seeking sets the target time", "[Viewer]")
{
  PlayClock clock;
  clock.SetSpan(0.0, 100.0);
  clock.SetPlaying(false);
  clock.Seek(40.0);
  clock.Advance(5.0, 10.0);
  CHECK(clock.GetTime() == 40.0);
  CHECK(clock.GetTarget() == 40.0);
  clock.SetPlaying(true);
  clock.SetSpeed(1.0);
  clock.Advance(1.0, 10.0); // nothing computed yet: waits, does not go back
  CHECK(clock.GetTime() == 40.0);
  clock.Seek(-5.0);
  CHECK(clock.GetTime() == 0.0);
  CHECK(clock.GetTarget() > 0.0); // slightly ahead
}

TEST_CASE("PlayClock: the speed changes in steps", "[Viewer]")
{
  PlayClock clock;
  clock.ChangeSpeed(1);
  CHECK(std::isinf(clock.GetSpeed()));
  clock.ChangeSpeed(-1);
  CHECK(clock.GetSpeed() == 1000.0);
  clock.SetSpeed(3.0); // between 2 and 5
  clock.ChangeSpeed(-1);
  CHECK(clock.GetSpeed() == 2.0);
  clock.ChangeSpeed(-99);
  CHECK(clock.GetSpeed() == 0.01);
  clock.SetSpeed(0.0); // rejected
  CHECK(clock.GetSpeed() == 0.01);
}

TEST_CASE("FrameBudget: drawing takes a limited share, and more during interaction", "[Viewer]")
{
  FrameBudget budget;
  CHECK(budget.IsDue(0.0, true));
  budget.RecordFrame(10.0, 0.05);
  CHECK(budget.IsDue(10.01, false)); // no computation
  CHECK_FALSE(budget.IsDue(10.01, true));
  CHECK(budget.IsDue(10.0 + 0.05 / FrameBudget::Share, true));
  budget.RecordInput(10.02);
  CHECK(budget.IsDue(10.03, true));
  budget.RecordFrame(20.0, 30.0); // a frame that took very long
  CHECK_FALSE(budget.IsDue(20.0 + 0.9 * FrameBudget::Longest, true));
  CHECK(budget.IsDue(20.0 + FrameBudget::Longest, true));
}
