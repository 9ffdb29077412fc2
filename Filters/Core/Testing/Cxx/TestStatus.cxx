// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosStatus.h"

#include <catch2/catch.hpp>

#include <string>
#include <type_traits>

using helios::Status;

namespace
{

Status Halve(int number, int& half)
{
  if (number % 2 != 0)
  {
    return Status::Error(std::to_string(number) + " is odd; give an even number");
  }
  half = number / 2;
  return {};
}

} // namespace

TEST_CASE("Status: success is the default and has no message", "[Status]")
{
  int half = 0;
  const Status status = Halve(6, half);
  CHECK(status.IsOk());
  CHECK(status.Message() == "");
  CHECK(half == 3);
  CHECK(Status().IsOk());
}

TEST_CASE("Status: an error keeps its message when copied and replaced", "[Status]")
{
  int half = 0;
  Status status = Halve(7, half);
  CHECK_FALSE(status.IsOk());
  CHECK(status.Message() == "7 is odd; give an even number");
  const Status copy = status;
  status = Halve(8, half);
  CHECK(status.IsOk());
  CHECK(status.Message() == "");
  CHECK(copy.Message() == "7 is odd; give an even number");
}

TEST_CASE("Status: a text or a truth value is not taken for one", "[Status]")
{
  CHECK_FALSE(std::is_convertible_v<std::string, Status>);
  CHECK_FALSE(std::is_convertible_v<const char*, Status>);
  CHECK_FALSE(std::is_convertible_v<Status, std::string>);
  CHECK_FALSE(std::is_constructible_v<bool, Status>);
}
