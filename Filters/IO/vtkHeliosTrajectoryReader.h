// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosTrajectoryReader
 * @brief   a trajectory from a text file, as navigation software writes it
 *
 * Output 0 is a vtkPolyData, one polyline (of a single row: a vertex) through the
 * rows in the order of time, with the point arrays
 * - GpsTime [s] as in the file;
 * - Orientation (unit quaternion w, x, y, z, body to world; body x right, y
 *   forward, z up), of one sign from row to row.
 *
 * A row is a line of numbers t, roll, pitch, yaw, x, y, z, which columns hold
 * is, in this order, what is set (TimeColumn, XColumn ...), what the file says in
 * the comment
 *
 *   #HEADER: "t", "roll", "pitch", "yaw", "x", "y", "z"
 *
 * (any order; names in quotes or not), or the order above, where the comment
 * #TIME_COLUMN: n puts t into column n. What follows a word that starts with # or
 * // is a comment. Lines may end in CR LF. Numbers are parsed strictly and
 * correctly rounded; of other columns nothing is read.
 *
 * Attitude, with AngleConvention ARINC_705, of body coordinates to the world:
 *
 *   A = Rz(-yaw) Ry(roll) Rx(pitch),
 *
 * yaw clockwise from north (y), pitch nose up, roll right side down. CANONICAL:
 *
 *   A = Rx(roll) Ry(pitch) Rz(yaw),
 *
 * with roll about the right axis, as vtkHeliosTrajectoryTextWriter writes it. With Domain
 * POSITION angles are not read: the body is level and heads where it flies in
 * x, y; at a row that is the direction of the parabola through it and its
 * neighbours, and below MinimumSpeed the heading before.
 *
 * Two rows at one time are a jump, with a warning where their places differ.
 * With SlopeFilterThreshold only the rows are kept where the motion changes.
 *
 * Errors, with file:line, end the reading without output: three rows at one
 * time, a row that is too short, a word that is no finite number, a header with
 * another name, with a name twice or without one that is needed, a column read
 * twice, a file that cannot be read or has no rows.
 *
 * Progress events come for every MiB read; AbortExecute ends the reading, and
 * the update fails.
 *
 * @sa
 * vtkHeliosInterpolatedPlatform vtkHeliosTrajectoryTextWriter
 */

#ifndef vtkHeliosTrajectoryReader_h
#define vtkHeliosTrajectoryReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For the separators
#include <vector> // For the rows

namespace helios
{
struct TextReport;
struct TrajectoryFormat;
struct TrajectoryRow;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosTrajectoryReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosTrajectoryReader* New();
  vtkTypeMacro(vtkHeliosTrajectoryReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the file to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Set/Get the characters that separate columns. A blank or a tab stands for
   * any run of blanks and tabs; between two of any other there is an empty
   * column, and blanks beside it do not count. Valid range: none of digits,
   * letters, + - . # /. Default: comma.
   */
  vtkSetMacro(Separators, std::string);
  vtkGetMacro(Separators, std::string);
  ///@}

  ///@{
  /**
   * Set/Get the columns from 0; -1: not given. Where any is given, those that are
   * not are 0 to 6 in this order, and comments are not asked. Valid range:
   * [-1, 999]. Default: -1.
   */
  vtkSetClampMacro(TimeColumn, int, -1, 999);
  vtkGetMacro(TimeColumn, int);
  vtkSetClampMacro(RollColumn, int, -1, 999);
  vtkGetMacro(RollColumn, int);
  vtkSetClampMacro(PitchColumn, int, -1, 999);
  vtkGetMacro(PitchColumn, int);
  vtkSetClampMacro(YawColumn, int, -1, 999);
  vtkGetMacro(YawColumn, int);
  vtkSetClampMacro(XColumn, int, -1, 999);
  vtkGetMacro(XColumn, int);
  vtkSetClampMacro(YColumn, int, -1, 999);
  vtkGetMacro(YColumn, int);
  vtkSetClampMacro(ZColumn, int, -1, 999);
  vtkGetMacro(ZColumn, int);
  ///@}

  /// What the file gives.
  enum Domains
  {
    POSITION = 0,             ///< t, x, y, z; the body heads where it flies
    POSITION_AND_ATTITUDE = 1 ///< all columns
  };

  ///@{
  /**
   * Set/Get what is read. Default: POSITION_AND_ATTITUDE.
   */
  vtkSetClampMacro(Domain, int, POSITION, POSITION_AND_ATTITUDE);
  vtkGetMacro(Domain, int);
  void SetDomainToPosition() { this->SetDomain(POSITION); }
  void SetDomainToPositionAndAttitude() { this->SetDomain(POSITION_AND_ATTITUDE); }
  ///@}

  /// The unit of angles in the file.
  enum AngleUnits
  {
    DEGREES = 0,
    RADIANS = 1
  };

  ///@{
  /**
   * Set/Get the unit of the angles. Default: DEGREES.
   */
  vtkSetClampMacro(AngleUnit, int, DEGREES, RADIANS);
  vtkGetMacro(AngleUnit, int);
  void SetAngleUnitToDegrees() { this->SetAngleUnit(DEGREES); }
  void SetAngleUnitToRadians() { this->SetAngleUnit(RADIANS); }
  ///@}

  /// What roll, pitch and yaw are.
  enum AngleConventions
  {
    ARINC_705 = 0,
    CANONICAL = 1
  };

  ///@{
  /**
   * Set/Get what the angles are. Default: ARINC_705.
   */
  vtkSetClampMacro(AngleConvention, int, ARINC_705, CANONICAL);
  vtkGetMacro(AngleConvention, int);
  void SetAngleConventionToArinc705() { this->SetAngleConvention(ARINC_705); }
  void SetAngleConventionToCanonical() { this->SetAngleConvention(CANONICAL); }
  ///@}

  /**
   * Sets separators, columns and angles to what vtkHeliosTrajectoryTextWriter
   * writes: x y z t roll pitch yaw between blanks, CANONICAL, in degrees.
   */
  void UseWriterFormat();

  ///@{
  /**
   * Set/Get how much the velocity [m/s] or the turning rate [deg/s] in any
   * component must have changed since the last row that was kept for a row to be
   * kept; 0 keeps all. Between rows that are kept the position is off by at
   * most the threshold times the time between them. Valid range: [0, 1e6].
   * Default: 0.
   */
  vtkSetClampMacro(SlopeFilterThreshold, double, 0.0, 1e6);
  vtkGetMacro(SlopeFilterThreshold, double);
  ///@}

  ///@{
  /**
   * Set/Get the speed in x, y [m/s] below which the flight gives no heading
   * (POSITION only). Valid range: [0, 1e6]. Default: 0, it stands still.
   */
  vtkSetClampMacro(MinimumSpeed, double, 0.0, 1e6);
  vtkGetMacro(MinimumSpeed, double);
  ///@}

protected:
  vtkHeliosTrajectoryReader();
  ~vtkHeliosTrajectoryReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosTrajectoryReader(const vtkHeliosTrajectoryReader&) = delete;
  void operator=(const vtkHeliosTrajectoryReader&) = delete;

  bool CheckProperties();
  helios::TrajectoryFormat MakeFormat() const;
  bool ReadRows(helios::TextReport& report, std::vector<helios::TrajectoryRow>& rows);
  void Fill(const std::vector<helios::TrajectoryRow>& rows, vtkPolyData* trajectory) const;

  char* FileName = nullptr;
  std::string Separators = ",";
  int TimeColumn = -1;
  int RollColumn = -1;
  int PitchColumn = -1;
  int YawColumn = -1;
  int XColumn = -1;
  int YColumn = -1;
  int ZColumn = -1;
  int Domain = POSITION_AND_ATTITUDE;
  int AngleUnit = DEGREES;
  int AngleConvention = ARINC_705;
  double SlopeFilterThreshold = 0.0;
  double MinimumSpeed = 0.0;
};

#endif
