// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The filters of a plan have the settings of its document.
#include "vtkHeliosScanPlan.h"

#include "heliosPlanningTest.h"
#include "vtkHeliosPlannerReader.h"
#include "vtkHeliosScanPositionCandidates.h"
#include "vtkHeliosScanPositionPlanner.h"
#include "vtkHeliosViewsheds.h"
#include "vtkHeliosVisibilityTestPoints.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

using Candidates = vtkHeliosScanPositionCandidates;
using Planner = vtkHeliosScanPositionPlanner;

namespace
{

/// The plan of a <surveyPlanner> with some attributes, for a floor of 10 m by 10 m.
struct Site
{
  vtkNew<vtkHeliosPlannerReader> Document;
  vtkNew<vtkHeliosScanPlan> Plan;

  explicit Site(const std::string& attributes)
  {
    const auto path = std::filesystem::temp_directory_path() /
      ("vtkhelios-plan-" + std::to_string(::getpid()) + ".xml");
    std::ofstream(path) << "<document><surveyPlanner platform=\"#p\" scanner=\"#s\" " << attributes
                        << "/><platform id=\"p\"><scannerMount z=\"1.5\"/></platform>"
                           "<scanner id=\"s\" optics=\"rotating\" pulseFreqs_Hz=\"100000\" "
                           "scanAngleMax_deg=\"120\" headRotatePerSecMax_deg=\"60\"/></document>";
    vtkNew<helios::ErrorObserver> log;
    log->Watch(this->Document);
    this->Document->SetFileName(path.c_str());
    this->Document->SetInputDataObject(0, helios::MakeFloor(5.0, 0.0));
    const bool isRead = this->Document->Read();
    std::filesystem::remove(path);
    INFO(log->Errors);
    REQUIRE(isRead);
    this->Plan->SetDocument(this->Document);
  }
};

} // namespace

TEST_CASE("ScanPlan: without settings the filters have their defaults", "[ScanPlan]")
{
  Site site("");
  vtkHeliosScanPlan* plan = site.Plan;
  CHECK(plan->GetDocument() == site.Document.Get());
  const vtkNew<Candidates> candidates;
  CHECK(plan->GetCandidates()->GetXStep() == candidates->GetXStep());
  CHECK(plan->GetCandidates()->GetYStep() == candidates->GetYStep());
  CHECK(plan->GetCandidates()->GetMaximumSlope() == candidates->GetMaximumSlope());
  CHECK(plan->GetCandidates()->GetSurface() == candidates->GetSurface());
  CHECK(plan->GetCandidates()->GetSkipEnclosed() == candidates->GetSkipEnclosed());
  CHECK(plan->GetCandidates()->GetScannerHeight() == 1.5);
  const vtkNew<vtkHeliosVisibilityTestPoints> points;
  CHECK(plan->GetTestPoints()->GetZStep() == points->GetZStep());
  CHECK(plan->GetTestPoints()->GetVertical());
  CHECK(plan->GetTestPoints()->GetHorizontal());
  CHECK_FALSE(plan->GetTestPoints()->GetGenerateAreas());
  const vtkNew<vtkHeliosViewsheds> viewsheds;
  CHECK(plan->GetViewsheds()->GetHitTolerance() == viewsheds->GetHitTolerance());
  CHECK_FALSE(plan->GetViewsheds()->GetBothSides());
  CHECK(plan->GetViewsheds()->GetMinimumRange() == viewsheds->GetMinimumRange());
  CHECK(plan->GetViewsheds()->GetMaximumRange() == viewsheds->GetMaximumRange());
  CHECK(plan->GetViewsheds()->GetMinimumElevation() == viewsheds->GetMinimumElevation());
  CHECK(plan->GetViewsheds()->GetMaximumElevation() == viewsheds->GetMaximumElevation());
  CHECK(plan->GetViewsheds()->GetMaximumIncidenceAngle() == 90.0);
  CHECK(plan->GetViewsheds()->GetMinimumPointDensity() == 0.0);
  CHECK(plan->GetViewsheds()->GetAngularStep() == Approx(0.1)); // step of the document's scan
  const vtkNew<Planner> planner;
  CHECK(plan->GetPlanner()->GetMethod() == Planner::VIEWSHED_SIZE); // default of documents
  CHECK(plan->GetPlanner()->GetRemovalOrder() == planner->GetRemovalOrder());
  CHECK(plan->GetPlanner()->GetMinimumCoverage() == planner->GetMinimumCoverage());
  CHECK(plan->GetPlanner()->GetCoverageOf() == planner->GetCoverageOf());
  CHECK_FALSE(plan->GetPlanner()->GetUseAreas());
  CHECK(plan->GetPlanner()->GetMinimumOverlap() == 0.0);
  CHECK(plan->GetPlanner()->GetTimeLimit() == planner->GetTimeLimit());
}

TEST_CASE("ScanPlan: all settings of a document", "[ScanPlan]")
{
  Site site(R"(method="optimal" minCoverage_percent="95" coverageOf="all" gridSizePSP_m="2"
 gridSizePSPy_m="3" gridSizeVTP_m="0.5" maxSlope_deg="30" vtpLines="vertical" hitBehind="false"
 minPointDensity_1_m2="9" enclosed="1" groundOnly="open" scannerHeight_m="2.5" hitTolerance_m="0.1"
 rangeMin_m="1" rangeMax_m="80" elevationMin_deg="-40" elevationMax_deg="60" maxIncidence_deg="75"
 areaWeights="true" minOverlap_percent="20" timeLimit_s="5" pspRemoveFirst="largest")");
  vtkHeliosScanPlan* plan = site.Plan;
  CHECK(plan->GetCandidates()->GetXStep() == 2.0);
  CHECK(plan->GetCandidates()->GetYStep() == 3.0);
  CHECK(plan->GetCandidates()->GetMaximumSlope() == 30.0);
  CHECK(plan->GetCandidates()->GetSurface() == Candidates::OPEN_GROUND);
  CHECK_FALSE(plan->GetCandidates()->GetSkipEnclosed());
  CHECK(plan->GetCandidates()->GetScannerHeight() == 2.5);
  CHECK(plan->GetTestPoints()->GetXStep() == 0.5);
  CHECK(plan->GetTestPoints()->GetVertical());
  CHECK_FALSE(plan->GetTestPoints()->GetHorizontal());
  CHECK(plan->GetTestPoints()->GetGenerateAreas());
  CHECK(plan->GetViewsheds()->GetHitTolerance() == 0.1);
  CHECK(plan->GetViewsheds()->GetBothSides());
  CHECK(plan->GetViewsheds()->GetMinimumRange() == 1.0);
  CHECK(plan->GetViewsheds()->GetMaximumRange() == 80.0);
  CHECK(plan->GetViewsheds()->GetMinimumElevation() == -40.0);
  CHECK(plan->GetViewsheds()->GetMaximumElevation() == 60.0);
  CHECK(plan->GetViewsheds()->GetMaximumIncidenceAngle() == 75.0);
  CHECK(plan->GetViewsheds()->GetMinimumPointDensity() == 9.0);
  CHECK(plan->GetPlanner()->GetMethod() == Planner::OPTIMAL);
  CHECK(plan->GetPlanner()->GetRemovalOrder() == Planner::DESCENDING);
  CHECK(plan->GetPlanner()->GetMinimumCoverage() == 95.0);
  CHECK(plan->GetPlanner()->GetCoverageOf() == Planner::ALL);
  CHECK(plan->GetPlanner()->GetUseAreas());
  CHECK(plan->GetPlanner()->GetMinimumOverlap() == 0.2);
  CHECK(plan->GetPlanner()->GetTimeLimit() == 5.0);
}

TEST_CASE("ScanPlan: words of a document", "[ScanPlan]")
{
  const auto method = [](const std::string& words)
  { return Site(words).Plan->GetPlanner()->GetMethod(); };
  CHECK(method(R"(pspRemoveOrder="meanIncidenceAngle")") == Planner::MEAN_INCIDENCE_ANGLE);
  CHECK(method(R"(method="bestcoverage")") == Planner::GREEDY);
  CHECK(method(R"(method="greedy")") == Planner::GREEDY);
  CHECK(method(R"(method="best" pspRemoveOrder="meanIncidenceAngle")") == Planner::BEST);
  const auto surface = [](const std::string& words)
  { return Site(words).Plan->GetCandidates()->GetSurface(); };
  CHECK(surface(R"(groundOnly="auto")") == Candidates::AUTOMATIC);
  CHECK(surface(R"(groundOnly="1")") == Candidates::GROUND);
  CHECK(surface(R"(groundOnly="false")") == Candidates::HIGHEST);
  Site site(R"(vtpLines="horizontal")");
  CHECK_FALSE(site.Plan->GetTestPoints()->GetVertical());
  CHECK(site.Plan->GetTestPoints()->GetHorizontal());
}

TEST_CASE("ScanPlan: the filters are connected", "[ScanPlan]")
{
  Site site(R"(method="best" gridSizePSP_m="2" vtpLines="vertical")");
  vtkHeliosScanPlan* plan = site.Plan;
  plan->GetPlanner()->Update();
  CHECK(plan->GetCandidates()->GetOutput()->GetNumberOfPoints() == 25);
  CHECK(plan->GetPlanner()->GetNumberOfSelected() == 1);
  CHECK(plan->GetPlanner()->GetIsProvedOptimal());
  plan->SetDocument(nullptr);
  CHECK(plan->GetCandidates()->GetNumberOfInputConnections(0) == 0);
}
