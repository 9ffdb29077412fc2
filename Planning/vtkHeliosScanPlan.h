// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosScanPlan
 * @brief   the filters of a plan, connected and set up by a planner document
 *
 * Holds a vtkHeliosScanPositionCandidates and a vtkHeliosVisibilityTestPoints of a scene,
 * vtkHeliosViewsheds of both, and a vtkHeliosScanPositionPlanner, which selects the positions. The
 * scene is the output of the document. SetDocument() sets the properties of all filters from it;
 * they may be changed afterwards. Update the planner, or one filter after the other.
 *
 * @sa
 * vtkHeliosPlannerReader vtkHeliosScanPositionPlanner
 */

#ifndef vtkHeliosScanPlan_h
#define vtkHeliosScanPlan_h

#include "vtkHeliosPlanningModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For the filters

class vtkHeliosPlannerReader;
class vtkHeliosScanPositionCandidates;
class vtkHeliosScanPositionPlanner;
class vtkHeliosViewsheds;
class vtkHeliosVisibilityTestPoints;

class VTKHELIOSPLANNING_EXPORT vtkHeliosScanPlan : public vtkObject
{
public:
  static vtkHeliosScanPlan* New();
  vtkTypeMacro(vtkHeliosScanPlan, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the planner document. Setting it sets all properties that it determines; call its
   * Read() before. Default: none.
   */
  void SetDocument(vtkHeliosPlannerReader* document);
  vtkHeliosPlannerReader* GetDocument() const;
  ///@}

  ///@{
  /**
   * Returns the filters, in the order of the pipeline.
   */
  vtkHeliosScanPositionCandidates* GetCandidates() const;
  vtkHeliosVisibilityTestPoints* GetTestPoints() const;
  vtkHeliosViewsheds* GetViewsheds() const;
  vtkHeliosScanPositionPlanner* GetPlanner() const;
  ///@}

protected:
  vtkHeliosScanPlan();
  ~vtkHeliosScanPlan() override;

private:
  vtkHeliosScanPlan(const vtkHeliosScanPlan&) = delete;
  void operator=(const vtkHeliosScanPlan&) = delete;

  vtkSmartPointer<vtkHeliosPlannerReader> Document;
  vtkSmartPointer<vtkHeliosScanPositionCandidates> Candidates;
  vtkSmartPointer<vtkHeliosVisibilityTestPoints> TestPoints;
  vtkSmartPointer<vtkHeliosViewsheds> Viewsheds;
  vtkSmartPointer<vtkHeliosScanPositionPlanner> Planner;
};

#endif
