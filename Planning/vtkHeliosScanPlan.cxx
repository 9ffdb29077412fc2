// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosScanPlan.h"

#include "heliosPlannerSettings.h"
#include "vtkHeliosPlannerReader.h"
#include "vtkHeliosScanPositionCandidates.h"
#include "vtkHeliosScanPositionPlanner.h"
#include "vtkHeliosViewsheds.h"
#include "vtkHeliosVisibilityTestPoints.h"

#include <vtkObjectFactory.h>

#include <map>
#include <string>

vtkStandardNewMacro(vtkHeliosScanPlan);

namespace
{

using Planner = vtkHeliosScanPositionPlanner;

int FindSurface(const std::string& ground)
{
  using Candidates = vtkHeliosScanPositionCandidates;
  static const std::map<std::string, int> surfaces = {
    { "auto", Candidates::AUTOMATIC },
    { "true", Candidates::GROUND },
    { "false", Candidates::HIGHEST },
    { "open", Candidates::OPEN_GROUND },
  };
  return surfaces.at(ground);
}

int FindMethod(const helios::PlannerSettings& settings)
{
  static const std::map<std::string, int> methods = {
    { "", Planner::BEST },
    { "bestcoverage", Planner::GREEDY },
    { "greedy", Planner::GREEDY },
    { "best", Planner::BEST },
    { "optimal", Planner::OPTIMAL },
  };
  if (settings.Method == "reduce")
  {
    return settings.RemoveOrder == "viewshedSize" ? Planner::VIEWSHED_SIZE
                                                  : Planner::MEAN_INCIDENCE_ANGLE;
  }
  return methods.at(settings.Method);
}

void Configure(vtkHeliosScanPositionCandidates* candidates, const helios::PlannerSettings& settings)
{
  candidates->SetXStep(settings.PositionStep[0]);
  candidates->SetYStep(settings.PositionStep[1]);
  candidates->SetMaximumSlope(settings.MaximumSlope);
  candidates->SetSurface(FindSurface(settings.GroundOnly));
  candidates->SetSkipEnclosed(!settings.TakesEnclosed);
  candidates->SetScannerHeight(settings.ScannerHeight);
}

void Configure(vtkHeliosVisibilityTestPoints* points, const helios::PlannerSettings& settings)
{
  points->SetStep(settings.TestPointStep);
  points->SetVertical(settings.TestLines != "horizontal");
  points->SetHorizontal(settings.TestLines != "vertical");
  points->SetGenerateAreas(settings.UseAreas);
}

void Configure(vtkHeliosViewsheds* viewsheds, const helios::PlannerSettings& settings)
{
  viewsheds->SetHitTolerance(settings.HitTolerance);
  viewsheds->SetBothSides(!settings.SeesBefore);
  viewsheds->SetMinimumRange(settings.RangeMin);
  viewsheds->SetMaximumRange(settings.RangeMax);
  viewsheds->SetMinimumElevation(settings.ElevationMin);
  viewsheds->SetMaximumElevation(settings.ElevationMax);
  viewsheds->SetMaximumIncidenceAngle(settings.MaximumIncidenceAngle);
  viewsheds->SetMinimumPointDensity(settings.MinimumPointDensity);
}

void Configure(Planner* planner, const helios::PlannerSettings& settings)
{
  planner->SetMethod(FindMethod(settings));
  planner->SetRemovalOrder(
    settings.RemoveFirst == "largest" ? Planner::DESCENDING : Planner::ASCENDING);
  planner->SetMinimumCoverage(settings.MinimumCoverage);
  planner->SetCoverageOf(settings.CoverageOf == "all" ? Planner::ALL : Planner::COVERABLE);
  planner->SetUseAreas(settings.UseAreas);
  planner->SetMinimumOverlap(settings.MinimumOverlap / 100.0);
  planner->SetTimeLimit(settings.TimeLimit);
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosScanPlan::vtkHeliosScanPlan()
  : Candidates(vtkSmartPointer<vtkHeliosScanPositionCandidates>::New())
  , TestPoints(vtkSmartPointer<vtkHeliosVisibilityTestPoints>::New())
  , Viewsheds(vtkSmartPointer<vtkHeliosViewsheds>::New())
  , Planner(vtkSmartPointer<vtkHeliosScanPositionPlanner>::New())
{
  this->Viewsheds->SetInputConnection(1, this->Candidates->GetOutputPort());
  this->Viewsheds->SetInputConnection(2, this->TestPoints->GetOutputPort());
  this->Planner->SetInputConnection(0, this->Viewsheds->GetOutputPort());
  this->Planner->SetInputConnection(1, this->TestPoints->GetOutputPort());
}

//------------------------------------------------------------------------------
vtkHeliosScanPlan::~vtkHeliosScanPlan() = default;

//------------------------------------------------------------------------------
void vtkHeliosScanPlan::SetDocument(vtkHeliosPlannerReader* document)
{
  this->Document = document;
  this->Modified();
  vtkAlgorithmOutput* scene = document ? document->GetOutputPort() : nullptr;
  this->Candidates->SetInputConnection(0, scene);
  this->TestPoints->SetInputConnection(0, scene);
  this->Viewsheds->SetInputConnection(0, scene);
  if (document)
  {
    const helios::PlannerSettings& settings = document->GetSettings();
    Configure(this->Candidates, settings);
    Configure(this->TestPoints, settings);
    Configure(this->Viewsheds, settings);
    Configure(this->Planner, settings);
    this->Viewsheds->SetAngularStep(document->GetLegAngularStep());
  }
}

//------------------------------------------------------------------------------
vtkHeliosPlannerReader* vtkHeliosScanPlan::GetDocument() const
{
  return this->Document;
}

//------------------------------------------------------------------------------
vtkHeliosScanPositionCandidates* vtkHeliosScanPlan::GetCandidates() const
{
  return this->Candidates;
}

//------------------------------------------------------------------------------
vtkHeliosVisibilityTestPoints* vtkHeliosScanPlan::GetTestPoints() const
{
  return this->TestPoints;
}

//------------------------------------------------------------------------------
vtkHeliosViewsheds* vtkHeliosScanPlan::GetViewsheds() const
{
  return this->Viewsheds;
}

//------------------------------------------------------------------------------
vtkHeliosScanPositionPlanner* vtkHeliosScanPlan::GetPlanner() const
{
  return this->Planner;
}

//------------------------------------------------------------------------------
void vtkHeliosScanPlan::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Document: " << this->Document.Get() << "\n"
     << indent << "Candidates: " << this->Candidates.Get() << "\n"
     << indent << "TestPoints: " << this->TestPoints.Get() << "\n"
     << indent << "Viewsheds: " << this->Viewsheds.Get() << "\n"
     << indent << "Planner: " << this->Planner.Get() << "\n";
}
