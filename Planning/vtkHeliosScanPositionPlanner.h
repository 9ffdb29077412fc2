// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosScanPositionPlanner
 * @brief   which candidates to scan from
 *
 * Port 0: candidates (vtkPolyData, the points are the instrument's positions) with the point
 * array Visibility (unsigned 64-bit words; bit v % 64 of word v / 64: sees test point v) and, if
 * known, MeanIncidenceAngle [deg]. Port 1: test points (vtkPolyData), with the point arrays
 * Normal (3 components) and Area [m2], if known.
 *
 * Outputs:
 * - port 0: all candidates, with ViewshedSize (test points seen), MeanIncidenceAngle [deg] (of
 *   what they see; NaN: unknown), Selected (0 or 1) and Exclusivity (test points no other
 *   selected one sees; 0 where not selected). The numbers below are in the field data, too
 *   (Plan.NumberOfSelected and so on).
 * - port 1: the test points, with Coverable (1: some candidate sees it), NumberOfScans (selected
 *   candidates that see it) and BestIncidenceAngle [deg] of these (NaN: none, or no normal).
 * - port 2: the selected candidates as vertices, those first that add most, with the arrays of
 *   port 0 but Visibility, and NewlyCovered, the test points each adds to those before it.
 *
 * To see enough with as few scans as possible is a set cover. The methods:
 * - VIEWSHED_SIZE and MEAN_INCIDENCE_ANGLE, the paper's: candidates leave in the order of the size
 *   of their viewshed or their mean angle of incidence, if others see all that they see; ties by
 *   lower index, whoever sees nothing first. One pass, O(bits set). With a MinimumCoverage below
 *   100 the one with the smallest exclusivity then leaves, as long as coverage stays at least that.
 * - GREEDY: take what adds most, then remove what is not needed.
 * - BEST: leave out candidates and points that others dominate; greedy by 1/c^2 for a point that c
 *   candidates see; remove what is not needed; local search. Then, with normals, the best worst and
 *   mean incidence it finds among plans of so many scans.
 * - OPTIMAL: starts from BEST and proves the smallest number by branch and cut (COIN-OR CBC), then
 *   the smallest worst angle (bisection over the distinct angles), then the smallest mean (through
 *   all such plans), the last two where all of the coverable points are asked, no overlap, and at
 *   most 2e7 pairs of candidate and point. What TimeLimit cuts off is the best found, with its bound
 *   and Gap.
 *
 * Angles of incidence are from the normal, folded to [0, 90], between line of sight and normal.
 *
 * Errors: no candidates, no test points, a Visibility that does not fit, no candidate sees
 * anything, coverage out of reach, no connected network, a missing or unusable array that a property
 * asks for, OPTIMAL in a build without CBC, abortion.
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

  /// How candidates are chosen.
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
   * Set/Get how candidates are chosen. Default: BEST.
   */
  vtkSetClampMacro(Method, int, VIEWSHED_SIZE, OPTIMAL);
  vtkGetMacro(Method, int);
  void SetMethodToViewshedSize() { this->SetMethod(VIEWSHED_SIZE); }
  void SetMethodToMeanIncidenceAngle() { this->SetMethod(MEAN_INCIDENCE_ANGLE); }
  void SetMethodToGreedy() { this->SetMethod(GREEDY); }
  void SetMethodToBest() { this->SetMethod(BEST); }
  void SetMethodToOptimal() { this->SetMethod(OPTIMAL); }
  ///@}

  /// Who leaves first.
  enum RemovalOrders
  {
    ASCENDING = 0,
    DESCENDING = 1
  };

  ///@{
  /**
   * Set/Get whether the paper's methods remove the smallest key first, as the paper does, or the
   * largest. Default: ASCENDING.
   */
  vtkSetClampMacro(RemovalOrder, int, ASCENDING, DESCENDING);
  vtkGetMacro(RemovalOrder, int);
  void SetRemovalOrderToAscending() { this->SetRemovalOrder(ASCENDING); }
  void SetRemovalOrderToDescending() { this->SetRemovalOrder(DESCENDING); }
  ///@}

  ///@{
  /**
   * Set/Get the share of CoverageOf that is to be seen [%]. Valid range: [1e-6, 100].
   * Default: 100.
   */
  vtkSetClampMacro(MinimumCoverage, double, 1e-6, 100.0);
  vtkGetMacro(MinimumCoverage, double);
  ///@}

  /// What MinimumCoverage is a share of.
  enum CoverageBases
  {
    COVERABLE = 0,
    ALL = 1
  };

  ///@{
  /**
   * Set/Get what MinimumCoverage is a share of: the test points that some candidate sees, or
   * all. Default: COVERABLE.
   */
  vtkSetClampMacro(CoverageOf, int, COVERABLE, ALL);
  vtkGetMacro(CoverageOf, int);
  void SetCoverageOfToCoverable() { this->SetCoverageOf(COVERABLE); }
  void SetCoverageOfToAll() { this->SetCoverageOf(ALL); }
  ///@}

  ///@{
  /**
   * Set/Get whether test points count by the array Area in coverage, the order of viewsheds, gains,
   * overlap and mean angles, instead of one each. Default: off.
   */
  vtkSetMacro(UseAreas, bool);
  vtkGetMacro(UseAreas, bool);
  vtkBooleanMacro(UseAreas, bool);
  ///@}

  ///@{
  /**
   * Set/Get the overlap of neighbouring scans, so that they can be registered: two are neighbours
   * where the test points both see are at least this share of the smaller viewshed, and the selected
   * ones are a connected network of neighbours. Valid range: [0, 0.999]. Default: 0, none is asked.
   */
  vtkSetClampMacro(MinimumOverlap, double, 0.0, 0.999);
  vtkGetMacro(MinimumOverlap, double);
  ///@}

  ///@{
  /**
   * Set/Get how long OPTIMAL may take for its proofs [s], on the clock of the wall however busy the
   * machine is; what it takes from BEST is not cut short. Valid range: [0, 1e6]. Default: 300.
   */
  vtkSetClampMacro(TimeLimit, double, 0.0, 1e6);
  vtkGetMacro(TimeLimit, double);
  ///@}

  ///@{
  /**
   * Set/Get how many local searches BEST makes. Their random numbers are counter-based: results do
   * not depend on the number of threads. Valid range: [1, 1000]. Default: 4.
   */
  vtkSetClampMacro(NumberOfStarts, int, 1, 1000);
  vtkGetMacro(NumberOfStarts, int);
  ///@}

  ///@{
  /**
   * Get, of the last update: the candidates selected; the test points these see, and those that
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
   * Get, of the last update: a lower bound of the number of scans, that of the linear
   * relaxation or a valid one below it; the best bound known in whole scans; by how much the plan
   * is above that [% of the plan]; and whether it is proved to have the fewest scans.
   */
  vtkGetMacro(LowerBound, double);
  vtkGetMacro(BestBound, vtkIdType);
  vtkGetMacro(Gap, double);
  vtkGetMacro(IsProvedOptimal, bool);
  ///@}

  ///@{
  /**
   * Get, of the last update: the largest and the mean of BestIncidenceAngle [deg] (NaN: no normals);
   * whether no plan of so many scans has a smaller largest one, and none of these a smaller mean.
   */
  vtkGetMacro(WorstIncidenceAngle, double);
  vtkGetMacro(MeanBestIncidenceAngle, double);
  vtkGetMacro(IsWorstProvedOptimal, bool);
  vtkGetMacro(IsMeanProvedOptimal, bool);
  ///@}

  /**
   * Whether this build has OPTIMAL.
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
