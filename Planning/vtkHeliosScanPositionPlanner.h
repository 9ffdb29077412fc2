// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosScanPositionPlanner
 * @brief   selects scan positions among candidates
 *
 * Port 0: candidates (vtkPolyData, the points are the instrument positions) with the point array
 * Visibility (unsigned 64-bit words; bit v % 64 of word v / 64: sees test point v) and, if known,
 * MeanIncidenceAngle [deg]. Port 1: test points (vtkPolyData), with the point arrays Normal
 * (3 components) and Area [m2], if known.
 *
 * Outputs:
 * - port 0: all candidates, with ViewshedSize (test points seen), MeanIncidenceAngle [deg] (of the
 *   points seen; NaN: unknown), Selected (0 or 1) and Exclusivity (test points no other selected
 *   one sees; 0 if not selected). The numbers below are also in the field data
 *   (Plan.NumberOfSelected and so on).
 * - port 1: the test points, with Coverable (1: some candidate sees it), NumberOfScans (selected
 *   candidates that see it) and BestIncidenceAngle [deg] of these (NaN: none, or no normal).
 * - port 2: the selected candidates as vertices, in order of decreasing gain, with the arrays of
 *   port 0 except Visibility, and NewlyCovered, the test points each adds to those before it.
 *
 * Finding the fewest scans that see enough is a set cover problem. The methods:
 * - VIEWSHED_SIZE and MEAN_INCIDENCE_ANGLE, the paper's: candidates leave in the order of viewshed
 *   size or mean angle of incidence, if others see all points they see; ties by lower index, those
 *   that see nothing first. One pass, O(bits set). With a MinimumCoverage below 100 the one with
 *   the smallest exclusivity then leaves, as long as coverage stays at least that.
 * - GREEDY: takes the candidate that adds most, then removes redundant ones.
 * - BEST: removes dominated candidates and points; greedy by 1/c^2 for a point seen by c
 *   candidates; removes redundant ones; local search. Then, with normals, the best worst and mean
 *   incidence it finds among plans of as many scans.
 * - OPTIMAL: starts from BEST and proves the smallest number by branch and cut (COIN-OR CBC), then
 *   the smallest worst angle (bisection over the distinct angles), then the smallest mean
 *   (enumeration of all such plans). The last two need all coverable points required, no overlap,
 *   and at most 2e7 pairs of candidate and point. After TimeLimit the result is the best found,
 *   with its bound and Gap.
 *
 * Angles of incidence are between line of sight and normal, folded to [0, 90].
 *
 * Errors: no candidates, no test points, a Visibility that does not fit, no candidate that sees any
 * point, unreachable coverage, no connected network, a missing or unusable array that a property
 * needs, OPTIMAL in a build without CBC, an abort request.
 *
 * @sa
 * vtkHeliosViewsheds
 */

#ifndef vtkHeliosScanPositionPlanner_h
#define vtkHeliosScanPositionPlanner_h

#include "vtkHeliosPlanningModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSPLANNING_EXPORT vtkHeliosScanPositionPlanner : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosScanPositionPlanner* New();
  vtkTypeMacro(vtkHeliosScanPositionPlanner, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Selection methods.
  enum Methods
  {
    VIEWSHED_SIZE = 0,
    MEAN_INCIDENCE_ANGLE = 1,
    GREEDY = 2,
    BEST = 3,
    OPTIMAL = 4
  };

  ///@{
  /**
   * Set/Get the selection method. Default: BEST.
   */
  vtkSetClampMacro(Method, int, VIEWSHED_SIZE, OPTIMAL);
  vtkGetMacro(Method, int);
  void SetMethodToViewshedSize() { this->SetMethod(VIEWSHED_SIZE); }
  void SetMethodToMeanIncidenceAngle() { this->SetMethod(MEAN_INCIDENCE_ANGLE); }
  void SetMethodToGreedy() { this->SetMethod(GREEDY); }
  void SetMethodToBest() { this->SetMethod(BEST); }
  void SetMethodToOptimal() { this->SetMethod(OPTIMAL); }
  ///@}

  /// Order of removal.
  enum RemovalOrders
  {
    ASCENDING = 0,
    DESCENDING = 1
  };

  ///@{
  /**
   * Set/Get whether the paper's methods remove the smallest key first, as in the paper, or the
   * largest. Default: ASCENDING.
   */
  vtkSetClampMacro(RemovalOrder, int, ASCENDING, DESCENDING);
  vtkGetMacro(RemovalOrder, int);
  void SetRemovalOrderToAscending() { this->SetRemovalOrder(ASCENDING); }
  void SetRemovalOrderToDescending() { this->SetRemovalOrder(DESCENDING); }
  ///@}

  ///@{
  /**
   * Set/Get the required share of CoverageOf [%]. Valid range: [0, 100], 0 only with a
   * MinimumObjectCoverage. Default: 100.
   */
  vtkSetClampMacro(MinimumCoverage, double, 0.0, 100.0);
  vtkGetMacro(MinimumCoverage, double);
  ///@}

  /// Reference of MinimumCoverage.
  enum CoverageBases
  {
    COVERABLE = 0,
    ALL = 1
  };

  ///@{
  /**
   * Set/Get the reference of MinimumCoverage: the test points that some candidate sees, or all.
   * Default: COVERABLE.
   */
  vtkSetClampMacro(CoverageOf, int, COVERABLE, ALL);
  vtkGetMacro(CoverageOf, int);
  void SetCoverageOfToCoverable() { this->SetCoverageOf(COVERABLE); }
  void SetCoverageOfToAll() { this->SetCoverageOf(ALL); }
  ///@}

  ///@{
  /**
   * Set/Get the required share of each object [%]: of the test points of each part (point array
   * PartIds) that some candidate sees, or with UseAreas of their area.
   * Points without a part (-1) are no object. With a MinimumCoverage of 0 nothing else is required;
   * with one of 100 all objects are complete. Every method meets it; BEST does not search further
   * than greedy choices without redundant members, and incidence is not improved. Valid range: [0,
   * 100]. Default: 0, not required.
   */
  vtkSetClampMacro(MinimumObjectCoverage, double, 0.0, 100.0);
  vtkGetMacro(MinimumObjectCoverage, double);
  ///@}

  ///@{
  /**
   * Set/Get whether test points are weighted by the array Area in coverage, viewshed order, gains,
   * overlap and mean angles, instead of 1 each. Default: off.
   */
  vtkSetMacro(UseAreas, bool);
  vtkGetMacro(UseAreas, bool);
  vtkBooleanMacro(UseAreas, bool);
  ///@}

  ///@{
  /**
   * Set/Get the overlap of neighbouring scans for registration: two are neighbours if the test
   * points seen by both are at least this share of the smaller viewshed, and the selected ones are
   * a connected network of neighbours. Valid range: [0, 0.999]. Default: 0, not required.
   */
  vtkSetClampMacro(MinimumOverlap, double, 0.0, 0.999);
  vtkGetMacro(MinimumOverlap, double);
  ///@}

  ///@{
  /**
   * Set/Get the wall time limit of the proofs of OPTIMAL [s]; the part taken from BEST is not
   * limited. Valid range: [0, 1e6]. Default: 300.
   */
  vtkSetClampMacro(TimeLimit, double, 0.0, 1e6);
  vtkGetMacro(TimeLimit, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of local searches of BEST. Their random numbers are counter-based: results
   * do not depend on the number of threads. Valid range: [1, 1000]. Default: 4.
   */
  vtkSetClampMacro(NumberOfStarts, int, 1, 1000);
  vtkGetMacro(NumberOfStarts, int);
  ///@}

  ///@{
  /**
   * Get, for the last update: the candidates selected; the test points these see, and those that
   * some candidate sees; the first as a share of all and of the second [%], by area with UseAreas.
   */
  vtkGetMacro(NumberOfSelected, vtkIdType);
  vtkGetMacro(NumberCovered, vtkIdType);
  vtkGetMacro(NumberCoverable, vtkIdType);
  vtkGetMacro(Coverage, double);
  vtkGetMacro(CoverableCoverage, double);
  ///@}

  ///@{
  /**
   * Get, for the last update: a lower bound on the number of scans, from the linear relaxation or a
   * valid one below; the best known bound in whole scans; the gap of the plan to it [% of the
   * plan]; and whether the plan is proved to have the fewest scans.
   */
  vtkGetMacro(LowerBound, double);
  vtkGetMacro(BestBound, vtkIdType);
  vtkGetMacro(Gap, double);
  vtkGetMacro(IsProvedOptimal, bool);
  ///@}

  ///@{
  /**
   * Get, for the last update: the largest and the mean of BestIncidenceAngle [deg] (NaN: no
   * normals); whether no plan of as many scans has a smaller largest one, and none of these a
   * smaller mean.
   */
  vtkGetMacro(WorstIncidenceAngle, double);
  vtkGetMacro(MeanBestIncidenceAngle, double);
  vtkGetMacro(IsWorstProvedOptimal, bool);
  vtkGetMacro(IsMeanProvedOptimal, bool);
  ///@}

  /**
   * Returns whether this build supports OPTIMAL.
   */
  static bool HasOptimal();

protected:
  vtkHeliosScanPositionPlanner();
  ~vtkHeliosScanPositionPlanner() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosScanPositionPlanner(const vtkHeliosScanPositionPlanner&) = delete;
  void operator=(const vtkHeliosScanPositionPlanner&) = delete;

  class Run;

  int Method = BEST;
  int RemovalOrder = ASCENDING;
  double MinimumObjectCoverage = 0.0;
  double MinimumCoverage = 100.0;
  int CoverageOf = COVERABLE;
  bool UseAreas = false;
  double MinimumOverlap = 0.0;
  double TimeLimit = 300.0;
  int NumberOfStarts = 4;

  vtkIdType NumberOfSelected = 0;
  vtkIdType NumberCovered = 0;
  vtkIdType NumberCoverable = 0;
  double Coverage = 0.0;
  double CoverableCoverage = 0.0;
  double LowerBound = 0.0;
  vtkIdType BestBound = 0;
  double Gap = 0.0;
  bool IsProvedOptimal = false;
  double WorstIncidenceAngle = 0.0;
  double MeanBestIncidenceAngle = 0.0;
  bool IsWorstProvedOptimal = false;
  bool IsMeanProvedOptimal = false;
};

#endif
