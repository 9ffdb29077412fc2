// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scan plan written by vtkhelios plan: scan positions, and their coverage.

#ifndef heliosPlanView_h
#define heliosPlanView_h

#include "heliosColorMaps.h"
#include "heliosPose.h"
#include "heliosStatus.h"
#include "heliosViewerTool.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;

namespace helios::viewer
{

class Viewer;

/// The files of a plan.
struct Plan
{
  vtkSmartPointer<vtkPolyData> Positions;  ///< selected, largest gain first
  vtkSmartPointer<vtkPolyData> Candidates; ///< may be null
  vtkSmartPointer<vtkPolyData> TestPoints; ///< may be null
  std::string Survey;                      ///< file; empty: missing
};

/// Whether a path is a plan's folder, or its positions.vtp.
bool IsPlan(const std::string& path);

/// Reads a plan.
Status ReadPlan(const std::string& path, Plan& plan);

/// Test points in five colours by number of scans, numbered tripods, small candidates.
class PlanView
{
public:
  /// Drawn relative to an origin [m].
  PlanView(vtkRenderer* renderer, const Plan& plan, const Vec3& origin);
  ~PlanView();
  PlanView(const PlanView&) = delete;
  void operator=(const PlanView&) = delete;

  void SetVisible(bool visible);
  bool IsVisible() const { return this->Visible; }

  /// Hides numbers behind the camera; call before every frame.
  void Update();

  /// Not coverable, by no selected position, by 1, 2, and 3 or more.
  static const Rgb& GetColor(bool isCoverable, int scans);

  vtkIdType GetNumberOfPositions() const;
  vtkIdType GetNumberOfTestPoints() const { return this->NumberOfTestPoints; }
  vtkIdType GetNumberCoverable() const { return this->NumberCoverable; }
  vtkIdType GetNumberCovered() const { return this->NumberCovered; }

  /// The coverage and the meaning of the colours, as text.
  std::string Describe() const;

private:
  void AddTestPoints(vtkPolyData* points);
  void AddCandidates(vtkPolyData* candidates);
  void AddPositions(vtkPolyData* positions, double size);

  vtkRenderer* Renderer;
  Vec3 Origin;
  bool Visible = true;
  vtkIdType NumberOfTestPoints = 0;
  vtkIdType NumberCoverable = 0;
  vtkIdType NumberCovered = 0;
  vtkNew<vtkActor> TestPoints;
  vtkNew<vtkActor> Candidates;
  std::vector<vtkSmartPointer<vtkActor>> Tripods;
  std::vector<vtkSmartPointer<vtkTextActor>> Labels;
};

/// Shows the plan from a viewer's inputs, over its scene.
class PlanTool : public ViewerTool
{
public:
  explicit PlanTool(Viewer& viewer);
  ~PlanTool() override;

  std::string GetName() const override { return "Plan"; }
  std::vector<KeyHelp> GetKeys() const override;
  bool OnKey(const std::string& key, bool control) override;
  bool OnClick(int, int) override { return false; }
  bool OnFrame() override;
  void OnNewSurvey() override;
  std::string GetStatus() const override;
  void Describe(Json::Value& state) const override;

private:
  Viewer& Owner;
  bool IsWanted = false; // the inputs include a plan
  Vec3 Origin{ 0.0, 0.0, 0.0 };
  Plan Files;
  std::unique_ptr<PlanView> View;
};

} // namespace helios::viewer

#endif
