// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosTrajectoryReader
 * @brief   read a trajectory from a file of navigation software
 *
 * Formats: text columns, SBET, TUM and EuRoC (FileFormat).
 *
 * Output 0 is a vtkPolyData, one polyline (a vertex for a single row) through the rows in order of
 * time, with the point arrays
 * - GpsTime [s] as in the file, continued over the end of a GPS week (604,800 s) or day (86,400 s)
 *   with a warning;
 * - Orientation (unit quaternion w, x, y, z, body to world; body x right, y forward, z up), with a
 *   consistent sign from row to row, and, for SBET, the field data CRS and, unless all are 0,
 * - Velocity [m/s], along the axes of TargetCRS.
 *
 * COLUMNS: a row is a line of numbers t, roll, pitch, yaw, x, y, z. Their columns are, in order of
 * precedence, the columns set (TimeColumn, XColumn ...), the columns of the comment #HEADER: "t",
 * "roll", "pitch", "yaw", "x", "y", "z"
 *
 * (any order; names with or without quotes), or the order above, where the comment #TIME_COLUMN: n
 * moves t to column n. A word that starts with # or // starts a comment. Lines may end in CR LF.
 * Numbers are parsed strictly and correctly rounded; other columns are not read.
 *
 * Attitude with AngleConvention ARINC_705, body coordinates to world:
 *
 * A = Rz(-yaw) Ry(roll) Rx(pitch),
 *
 * yaw clockwise from north (y), pitch nose up, roll right side down. CANONICAL:
 *
 * A = Rx(roll) Ry(pitch) Rz(yaw),
 *
 * with roll about the right axis, as written by vtkHeliosTrajectoryTextWriter. NAVIGATION:
 *
 * A = Rz(-yaw) Rx(pitch) Ry(roll),
 *
 * the angles of ARINC_705 applied in the order of navigation software. With Domain POSITION angles
 * are not read: the body is level and its heading is the direction of motion in x, y, at a row
 * along the parabola through it and its neighbours. Below MinimumSpeed the last heading is kept.
 *
 * Two rows at one time are a jump, with a warning if their positions differ. SlopeFilterThreshold
 * keeps only the rows where the motion changes.
 *
 * SBET: records of 17 little-endian doubles: time [s]; latitude, longitude [rad], altitude above
 * the ellipsoid [m]; velocity x, y, z; roll, pitch, platform heading, wander angle [rad];
 * acceleration and angular rate x, y, z of the body. Positions are transformed from FileCRS to
 * TargetCRS. The attitude is NAVIGATION with the true heading
 *
 * heading = platform heading - wander angle,
 *
 * and rotated from east, north, up of the ellipsoid to the axes of TargetCRS: in a map projection
 * the yaw is heading - meridian convergence. Velocities, whose x and y are turned by the wander
 * angle, y to the left, are rotated likewise, not scaled. Accelerations and rates are not read.
 *
 * TUM: rows t x y z qx qy qz qw between blanks, t in seconds. EuRoC: rows t,x,y,z,qw,qx,qy,qz and
 * further columns that are not read, t in nanoseconds (GpsTime is a double, exact to 0.25 us for
 * Unix times). The quaternion transforms the body, with the axes of BodyFrame, to the world; it is
 * normalized.
 *
 * Missing rows, 50 times the usual step and more than 1 s, and steps that look like milliseconds
 * are warnings; times that cannot be seconds and times of two clocks are errors. Rows of COLUMNS
 * that are not in order are sorted, with a warning.
 *
 * Errors of SBET (with record and byte), TUM and EuRoC (with file:line): a file that does not end
 * with a whole record, numbers that are not finite, latitudes and longitudes out of range, times
 * that do not increase, quaternions whose length differs from 1 by more than 1e-3, a system that is
 * unknown or not metric.
 *
 * Errors of COLUMNS, with file:line, without output: three rows at one time, a row that is too
 * short, a word that is not a finite number, a header with an unknown, repeated or missing name, a
 * column read twice, a file that cannot be read or has no rows.
 *
 * A progress event is sent per MiB read; AbortExecute stops reading, and the update fails.
 *
 * @sa
 * vtkHeliosInterpolatedPlatform vtkHeliosTrajectoryTextWriter
 */

#ifndef vtkHeliosTrajectoryReader_h
#define vtkHeliosTrajectoryReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For the separators

namespace helios
{
struct RecordedPath;
struct TextReport;
struct TrajectoryFormat;
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

  /// Formats of files.
  enum FileFormats
  {
    AUTOMATIC = 0, ///< by the ending: .sbet and .out SBET, .tum TUM, others COLUMNS
    COLUMNS = 1,   ///< text columns
    SBET = 2,
    TUM = 3,
    EUROC = 4
  };

  ///@{
  /**
   * Set/Get the format of the file. Default: AUTOMATIC.
   */
  vtkSetClampMacro(FileFormat, int, AUTOMATIC, EUROC);
  vtkGetMacro(FileFormat, int);
  void SetFileFormatToAutomatic() { this->SetFileFormat(AUTOMATIC); }
  void SetFileFormatToColumns() { this->SetFileFormat(COLUMNS); }
  void SetFileFormatToSbet() { this->SetFileFormat(SBET); }
  void SetFileFormatToTum() { this->SetFileFormat(TUM); }
  void SetFileFormatToEuroc() { this->SetFileFormat(EUROC); }
  ///@}

  /// Returns whether the file, by FileFormat or its name, is SBET.
  bool IsSbet() const { return this->FindFormat() == SBET; }

  ///@{
  /**
   * Set/Get the geographic system of the positions in an SBET file, as EPSG:n, WKT or PROJ. Default:
   * EPSG:4979, WGS 84 with ellipsoidal heights.
   */
  vtkSetMacro(FileCRS, std::string);
  vtkGetMacro(FileCRS, std::string);
  ///@}

  ///@{
  /**
   * Set/Get the metric system that an SBET file is transformed to, as EPSG:n, WKT, PROJ, or "ENU
   * latitude longitude height". Without vertical part heights stay above the ellipsoid. Default:
   * empty, the UTM zone on WGS 84 of the first record.
   */
  vtkSetMacro(TargetCRS, std::string);
  vtkGetMacro(TargetCRS, std::string);
  ///@}

  /// Axes x, y, z of the body.
  enum BodyFrames
  {
    RIGHT_FORWARD_UP = 0,
    FORWARD_LEFT_UP = 1,   ///< axes of ROS
    FORWARD_RIGHT_DOWN = 2 ///< axes of aviation
  };

  ///@{
  /**
   * Set/Get the axes of the body in TUM and EuRoC files. Default: RIGHT_FORWARD_UP.
   */
  vtkSetClampMacro(BodyFrame, int, RIGHT_FORWARD_UP, FORWARD_RIGHT_DOWN);
  vtkGetMacro(BodyFrame, int);
  void SetBodyFrameToRightForwardUp() { this->SetBodyFrame(RIGHT_FORWARD_UP); }
  void SetBodyFrameToForwardLeftUp() { this->SetBodyFrame(FORWARD_LEFT_UP); }
  void SetBodyFrameToForwardRightDown() { this->SetBodyFrame(FORWARD_RIGHT_DOWN); }
  ///@}

  ///@{
  /**
   * Set/Get the characters that separate columns. A blank or a tab stands for
   * any run of blanks and tabs; two adjacent other separators enclose an empty
   * column, and blanks beside them are ignored. Valid range: no digits,
   * letters, + - . # /. Default: comma.
   */
  vtkSetMacro(Separators, std::string);
  vtkGetMacro(Separators, std::string);
  ///@}

  ///@{
  /**
   * Set/Get the columns from 0; -1: not set. If any is set, the unset ones are 0 to 6 in this
   * order, and comments are ignored. Valid range: [-1, 999]. Default: -1.
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

  /// Content of the file.
  enum Domains
  {
    POSITION = 0,             ///< t, x, y, z; heading along the direction of motion
    POSITION_AND_ATTITUDE = 1 ///< all columns
  };

  ///@{
  /**
   * Set/Get the values that are read. Default: POSITION_AND_ATTITUDE.
   */
  vtkSetClampMacro(Domain, int, POSITION, POSITION_AND_ATTITUDE);
  vtkGetMacro(Domain, int);
  void SetDomainToPosition() { this->SetDomain(POSITION); }
  void SetDomainToPositionAndAttitude() { this->SetDomain(POSITION_AND_ATTITUDE); }
  ///@}

  /// Unit of the angles in the file.
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

  /// Convention of roll, pitch and yaw.
  enum AngleConventions
  {
    ARINC_705 = 0,
    CANONICAL = 1,
    NAVIGATION = 2
  };

  ///@{
  /**
   * Set/Get the angle convention. Default: ARINC_705.
   */
  vtkSetClampMacro(AngleConvention, int, ARINC_705, NAVIGATION);
  vtkGetMacro(AngleConvention, int);
  void SetAngleConventionToArinc705() { this->SetAngleConvention(ARINC_705); }
  void SetAngleConventionToCanonical() { this->SetAngleConvention(CANONICAL); }
  void SetAngleConventionToNavigation() { this->SetAngleConvention(NAVIGATION); }
  ///@}

  /**
   * Sets separators, columns and angles to the format of vtkHeliosTrajectoryTextWriter: x y z t
   * roll pitch yaw between blanks, CANONICAL, in degrees.
   */
  void UseWriterFormat();

  ///@{
  /**
   * Set/Get the threshold of the row filter: a row is kept if a component of
   * the velocity [m/s] or turning rate [deg/s] changed by more since the last
   * kept row; 0 keeps all. The position error between kept rows is at most the
   * threshold times the time between them. Valid range: [0, 1e6]. Default: 0.
   */
  vtkSetClampMacro(SlopeFilterThreshold, double, 0.0, 1e6);
  vtkGetMacro(SlopeFilterThreshold, double);
  ///@}

  ///@{
  /**
   * Set/Get the speed in x, y [m/s] below which the motion gives no heading
   * (POSITION only). Valid range: [0, 1e6]. Default: 0, at rest.
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
  int FindFormat() const;
  bool ReadFile(helios::TextReport& report, helios::RecordedPath& path);
  bool ReadSbet(helios::TextReport& report, helios::RecordedPath& path);
  bool ReadText(helios::TextReport& report, helios::RecordedPath& path);
  void FindAttitudes(helios::RecordedPath& path) const;
  void Fill(const helios::RecordedPath& path, vtkPolyData* trajectory) const;

  char* FileName = nullptr;
  int FileFormat = AUTOMATIC;
  std::string FileCRS = "EPSG:4979";
  std::string TargetCRS;
  int BodyFrame = RIGHT_FORWARD_UP;
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
