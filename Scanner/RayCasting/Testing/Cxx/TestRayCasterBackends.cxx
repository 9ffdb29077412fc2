// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosBvhRayCaster.h"
#include "vtkHeliosRayCaster.h"

#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <catch2/catch.hpp>

#include <string>

namespace
{

/// Captures the output.
class Texts : public vtkOutputWindow
{
public:
  static Texts* New() { VTK_STANDARD_NEW_BODY(Texts); }
  vtkTypeMacro(Texts, vtkOutputWindow);
  void DisplayText(const char* text) override { this->All += text; }
  std::string All;
};

} // namespace

TEST_CASE("RayCaster: backends by their names", "[RayCaster]")
{
  // This program links no backend of another library.
  REQUIRE(vtkHeliosRayCaster::GetNumberOfBackends() == 2);
  CHECK(vtkHeliosRayCaster::GetBackendName(0) == std::string("beam"));
  CHECK(vtkHeliosRayCaster::GetBackendName(1) == std::string("bvh"));
  CHECK(vtkHeliosRayCaster::GetBackendName(2) == nullptr);
  CHECK(vtkHeliosRayCaster::GetBackendName(-1) == nullptr);
  for (const char* name : { "beam", "", static_cast<const char*>(nullptr) })
  {
    const auto caster = vtkSmartPointer<vtkHeliosRayCaster>::Take(vtkHeliosRayCaster::Create(name));
    REQUIRE(caster);
    CHECK(caster->GetName() == std::string("beam"));
    CHECK(caster->GetReferenceCount() == 1);
  }
}

TEST_CASE("RayCaster: a backend that is not there", "[RayCaster]")
{
  const auto texts = vtkSmartPointer<Texts>::New();
  vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  vtkOutputWindow::SetInstance(texts);
  vtkHeliosRayCaster* caster = vtkHeliosRayCaster::Create("embre");
  vtkOutputWindow::SetInstance(before);
  CHECK(caster == nullptr);
  CHECK(texts->All.find("There is no ray caster \"embre\" in this build; give one of beam, bvh") !=
    std::string::npos);
}

TEST_CASE("RayCaster: backends are listed by priority", "[RayCaster]")
{
  const auto make = []() -> vtkHeliosRayCaster* { return vtkHeliosBvhRayCaster::New(); };
  REQUIRE(vtkHeliosRayCaster::Register("slow", -1, make));
  REQUIRE(vtkHeliosRayCaster::Register("fast", 9, make));
  CHECK(vtkHeliosRayCaster::GetBackendName(0) == std::string("fast"));
  CHECK(vtkHeliosRayCaster::GetBackendName(1) == std::string("beam"));
  CHECK(vtkHeliosRayCaster::GetBackendName(2) == std::string("bvh"));
  CHECK(vtkHeliosRayCaster::GetBackendName(3) == std::string("slow"));
}
