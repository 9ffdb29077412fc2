// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMemoryCheck.h"
#include "heliosStatus.h"
#include "vtkHeliosMemoryLimit.h"

#include <catch2/catch.hpp>

#include <string>

using helios::CheckMemory;

namespace
{

/// A memory limit for one test.
struct Limit
{
  explicit Limit(double mebibytes) { vtkHeliosMemoryLimit::SetLimit(mebibytes); }
  ~Limit() { vtkHeliosMemoryLimit::SetLimit(0.0); }
};

} // namespace

TEST_CASE("MemoryLimit: memory of the machine", "[MemoryLimit]")
{
  CHECK(vtkHeliosMemoryLimit::GetLimit() == 0.0);
  const double available = vtkHeliosMemoryLimit::GetAvailable();
  CHECK(available > 1.0);
  CHECK(CheckMemory("cells", 1000.0, 8.0).IsOk());
  const helios::Status text = CheckMemory("cells", 1e10, 2e6);
  CHECK(text.Message().find("10000000000 cells need about 20 PB of memory, and ") == 0);
  CHECK(text.Message().find(" are available; use fewer, or allow more with vtkhelios run --memory "
                            "(vtkHeliosMemoryLimit)") != std::string::npos);
}

TEST_CASE("MemoryLimit: limit less the memory in use", "[MemoryLimit]")
{
  const Limit limit(1e6);
  CHECK(vtkHeliosMemoryLimit::GetLimit() == 1e6);
  const double available = vtkHeliosMemoryLimit::GetAvailable();
  CHECK(available < 1e6 - 1.0);
  CHECK(available > 1e6 - 10000.0);
  CHECK(available == Approx(1e6 - vtkHeliosMemoryLimit::GetUsed()).margin(10.0));
  CHECK(CheckMemory("cells", available - 100.0, 1048576.0).IsOk()); // the machine may have less
  CHECK(CheckMemory("cells", available + 100.0, 1048576.0)
          .Message()
          .find(" of the 1.05 TB that may be used") != std::string::npos);
}

TEST_CASE("MemoryLimit: no memory left", "[MemoryLimit]")
{
  const Limit limit(0.001);
  CHECK(vtkHeliosMemoryLimit::GetAvailable() == 0.0);
  CHECK(CheckMemory("cells", 0.0, 8.0).IsOk());
  CHECK(CheckMemory("cells", 1.0, 1e6).Message() ==
    "1 cells need about 1 MB of memory, and 0 MB are available of the 0.00105 MB that may be used; "
    "use fewer, or allow more with vtkhelios run --memory (vtkHeliosMemoryLimit)");
  vtkHeliosMemoryLimit::SetLimit(-1.0);
  CHECK(vtkHeliosMemoryLimit::GetLimit() == 0.0);
}
