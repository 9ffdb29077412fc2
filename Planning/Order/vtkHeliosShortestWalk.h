// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosShortestWalk
 * @brief   scan positions in the order of the shortest walk
 *
 * Input: positions (vtkPolyData, its points). Output: the same points with their arrays, as vertices,
 * in the order of the shortest walk through all of them. It begins and ends anywhere; with Closed it
 * returns to its beginning. Of the two directions the one is taken that begins nearer to the first
 * position of the input. Distances are straight lines: obstacles and slopes do not count.
 *
 * The walk is the shortest for up to 14 positions, 15 if Closed (dynamic programming). For more it is
 * improved until reversing no part and moving no up to three positions shortens it, and LowerBound is
 * the one of Held and Karp: no walk is shorter.
 *
 * Errors: more than 1000 positions, one that is not finite.
 *
 * @sa
 * vtkHeliosScanPositionPlanner
 */

#ifndef vtkHeliosShortestWalk_h
#define vtkHeliosShortestWalk_h

#include "vtkHeliosPlanningModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSPLANNING_EXPORT vtkHeliosShortestWalk : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosShortestWalk* New();
  vtkTypeMacro(vtkHeliosShortestWalk, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get whether the walk returns to its beginning. Default: off.
   */
  vtkSetMacro(Closed, bool);
  vtkGetMacro(Closed, bool);
  vtkBooleanMacro(Closed, bool);
  ///@}

  ///@{
  /**
   * Get, for the last update: the length of the walk [m], and a length that no walk is shorter than
   * [m].
   */
  vtkGetMacro(Length, double);
  vtkGetMacro(LowerBound, double);
  ///@}

protected:
  vtkHeliosShortestWalk() = default;
  ~vtkHeliosShortestWalk() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosShortestWalk(const vtkHeliosShortestWalk&) = delete;
  void operator=(const vtkHeliosShortestWalk&) = delete;

  bool Closed = false;
  double Length = 0.0;
  double LowerBound = 0.0;
};

#endif
