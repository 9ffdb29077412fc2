// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosBvhRayCaster.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosRayCasterFactory.h"

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

TEST_CASE("RayCaster: creation by name", "[RayCasterFactory]")
{
  // This program links no backend of another library.
  REQUIRE(vtkHeliosRayCasterFactory::GetNumberOfBackends() == 2);
  CHECK(vtkHeliosRayCasterFactory::GetBackendName(0) == std::string("beam"));
  CHECK(vtkHeliosRayCasterFactory::GetBackendName(1) == std::string("bvh"));
  CHECK(vtkHeliosRayCasterFactory::GetBackendName(2) == nullptr);
  CHECK(vtkHeliosRayCasterFactory::GetBackendName(-1) == nullptr);
  for (const char* name : { "beam", "", static_cast<const char*>(nullptr) })
  {
    const auto caster =
      vtkSmartPointer<vtkHeliosRayCaster>::Take(vtkHeliosRayCasterFactory::Create(name));
    REQUIRE(caster);
    CHECK(caster->GetName() == std::string("beam"));
    CHECK(caster->GetReferenceCount() == 1);
  }
}

TEST_CASE("RayCaster: an unknown or missing backend", "[RayCasterFactory]")
{
  const auto texts = vtkSmartPointer<Texts>::New();
  vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  vtkOutputWindow::SetInstance(texts);
  vtkHeliosRayCaster* caster = vtkHeliosRayCasterFactory::Create("embre");
  vtkOutputWindow::SetInstance(before);
  CHECK(caster == nullptr);
  CHECK(texts->All.find("There is no ray caster \"embre\" in this build; give one of beam, bvh") !=
    std::string::npos);
}

TEST_CASE("RayCasterFactory: backends are listed by priority", "[RayCasterFactory]")
{
  const auto make = []() -> vtkHeliosRayCaster* { return vtkHeliosBvhRayCaster::New(); };
  REQUIRE(vtkHeliosRayCasterFactory::Register("slow", -1, make));
  REQUIRE(vtkHeliosRayCasterFactory::Register("fast", 9, make));
  CHECK(vtkHeliosRayCasterFactory::GetBackendName(0) == std::string("fast"));
  CHECK(vtkHeliosRayCasterFactory::GetBackendName(1) == std::string("beam"));
  CHECK(vtkHeliosRayCasterFactory::GetBackendName(2) == std::string("bvh"));
  CHECK(vtkHeliosRayCasterFactory::GetBackendName(3) == std::string("slow"));
}
