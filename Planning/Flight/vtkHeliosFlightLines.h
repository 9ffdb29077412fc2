// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosFlightLines
 * @brief   parallel flight lines over an area
 *
 * Port 0: the area (vtkPolyData), polygons or closed lines; only x and y are used. Output: a
 * two-point line per flight line, in flight order, each in the opposite direction of the one before.
 * The points are the waypoints of the flight, with the point arrays Speed [m/s], LegIds (the number of
 * the line, from 0) and Active: 1 where a line begins, 0 where a turn begins.
 *
 * Lines are SwathWidth wide and at most LineSpacing apart, evenly spread over the extent of the area
 * across, so that the outer swaths end at its edges. A line covers all of the area within its swath:
 * it is as long as that part, plus RunIn at both ends, and runs across gaps of an area that is not
 * convex.
 *
 * With OptimizeHeading the heading is the one with the shortest time of lines and turns: of steps of
 * a quarter degree and the edges of the convex hull, refined about the best four to 0.01 degrees.
 * A turn takes TurnTime; or, if that is 0, it is a straight part to the level of the next line, and
 * the shortest half turn of TurnRadius at Speed: with a distance d of the lines and the radius R
 * - d >= 2 R: pi R + d - 2 R
 * - d < 2 R: R (pi + 4 acos(1 / 2 + d / (4 R))), three arcs
 *
 * (Dubins 1957, Am. J. Math. 79, 497-516). With neither, the turn is a straight line. There is no
 * wind.
 *
 * Errors: no polygon with a surface, a vertex that is not finite, LineSpacing above SwathWidth, more
 * than 100,000 lines.
 *
 * @sa
 * vtkHeliosPulseDensity vtkHeliosTerrainFollow vtkHeliosSurveyWriter
 */

#ifndef vtkHeliosFlightLines_h
#define vtkHeliosFlightLines_h

#include "vtkHeliosPlanningModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSPLANNING_EXPORT vtkHeliosFlightLines : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosFlightLines* New();
  vtkTypeMacro(vtkHeliosFlightLines, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the width on the ground that a line covers [m]. Valid range: [1e-3, 1e6]. Default: 100.
   */
  vtkSetClampMacro(SwathWidth, double, 1e-3, 1e6);
  vtkGetMacro(SwathWidth, double);
  ///@}

  ///@{
  /**
   * Set/Get the largest distance of neighbouring lines [m], at most SwathWidth. Valid range: [1e-3,
   * 1e6]. Default: 80.
   */
  vtkSetClampMacro(LineSpacing, double, 1e-3, 1e6);
  vtkGetMacro(LineSpacing, double);
  ///@}

  ///@{
  /**
   * Set/Get whether the heading is searched. Default: on.
   */
  vtkSetMacro(OptimizeHeading, bool);
  vtkGetMacro(OptimizeHeading, bool);
  vtkBooleanMacro(OptimizeHeading, bool);
  ///@}

  ///@{
  /**
   * Set/Get the heading of the first line if it is not searched [deg], clockwise from north (y).
   * Valid range: [-360, 360]. Default: 0.
   */
  vtkSetClampMacro(Heading, double, -360.0, 360.0);
  vtkGetMacro(Heading, double);
  ///@}

  ///@{
  /**
   * Set/Get the z of the lines [m]. Valid range: [-1e6, 1e6]. Default: 0.
   */
  vtkSetClampMacro(Altitude, double, -1e6, 1e6);
  vtkGetMacro(Altitude, double);
  ///@}

  ///@{
  /**
   * Set/Get the length of the run in and of the run out of a line [m]. Valid range: [0, 1e6].
   * Default: 0.
   */
  vtkSetClampMacro(RunIn, double, 0.0, 1e6);
  vtkGetMacro(RunIn, double);
  ///@}

  ///@{
  /**
   * Set/Get the speed [m/s]. Valid range: [1e-3, 1e4]. Default: 60.
   */
  vtkSetClampMacro(Speed, double, 1e-3, 1e4);
  vtkGetMacro(Speed, double);
  ///@}

  ///@{
  /**
   * Set/Get the radius of turns [m]; the time of a turn [s], 0: the time for the radius. Valid
   * ranges: [0, 1e6]. Default: 0 and 0.
   */
  vtkSetClampMacro(TurnRadius, double, 0.0, 1e6);
  vtkGetMacro(TurnRadius, double);
  vtkSetClampMacro(TurnTime, double, 0.0, 1e6);
  vtkGetMacro(TurnTime, double);
  ///@}

  /**
   * Returns the radius [m] of a level turn with a bank angle [deg] at a speed [m/s].
   */
  static double ComputeTurnRadius(double speed, double bank);

  ///@{
  /**
   * Get, for the last update: the heading of the first line [deg]; the number of lines; the length of
   * the lines and of the turns [m], with TurnTime the latter at Speed; the time of all [s].
   */
  vtkGetMacro(FirstHeading, double);
  vtkGetMacro(NumberOfLines, int);
  vtkGetMacro(LineLength, double);
  vtkGetMacro(TurnLength, double);
  vtkGetMacro(FlightTime, double);
  ///@}

protected:
  vtkHeliosFlightLines() = default;
  ~vtkHeliosFlightLines() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosFlightLines(const vtkHeliosFlightLines&) = delete;
  void operator=(const vtkHeliosFlightLines&) = delete;

  double SwathWidth = 100.0;
  double LineSpacing = 80.0;
  bool OptimizeHeading = true;
  double Heading = 0.0;
  double Altitude = 0.0;
  double RunIn = 0.0;
  double Speed = 60.0;
  double TurnRadius = 0.0;
  double TurnTime = 0.0;
  double FirstHeading = 0.0;
  int NumberOfLines = 0;
  double LineLength = 0.0;
  double TurnLength = 0.0;
  double FlightTime = 0.0;
};

#endif
