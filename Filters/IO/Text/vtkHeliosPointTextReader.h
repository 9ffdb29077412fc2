// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPointTextReader
 * @brief   read points from text: HELIOS columns, XYZ, CSV, PTS, PTX
 *
 * Output 0 is a vtkPolyData without cells:
 * - points, double;
 * - of a file whose first row has the eleven columns of vtkHeliosPointTextWriter between blanks, point
 *   data Amplitude [W], EchoWidth [ns] and GpsTime [s], double; ReturnNumber and NumberOfReturns,
 *   unsigned char; PulseIds, 64 bits; PartIds and ClassificationIds, int; with thirteen columns also
 *   ScanDirectionFlag and EdgeOfFlightLine, with fifteen RelativeAmplitude and Reflectance [dB];
 * - of a file whose first row is names, x, y and z among them, or whose last comment before the first
 *   row is (CloudCompare: //X Y Z R G B): the arrays of the columns with known names, such as RGB,
 *   Normals, Intensity, ClassificationIds, GpsTime (GetArrayOfColumn());
 * - of PTS, which begins with the number of its points: x y z, Intensity, RGB; of PTX: the same in
 *   the world, by the matrix of each scan. Its points 0 0 0 have no return and are dropped;
 * - field data Part.Name: the names of parts by PartIds, if parts have names.
 *
 * Of other files with three or more columns, the first three are read as x y z.
 *
 * Columns are separated by blanks and tabs, else by semicolons, commas or bars, as the first row is.
 * Between semicolons, a comma is a decimal point. Lines end in LF, CR LF or CR; a byte-order mark is
 * skipped; # and // at the beginning of a word start a comment. RGB is of 8 bits, or of 16 if a colour
 * of the file is above 255, or a fraction. Intensity is double, as in the file. A part is a name,
 * which gets the next free number, or a number. Names keep their numbers over all updates and files
 * until SetPartNames().
 *
 * A file larger than memory is read in parts: set MaximumNumberOfPoints, and Begin to GetEnd() of
 * the update before, until GetEnd() is GetFileSize(). The points of an update are of one scan.
 *
 * Errors, without output: a row with too few or too many columns; a word that is not a
 * number, or not one of its array's type; NaN and infinities, unless KeepInvalid is on; a file that
 * cannot be read or has no rows, UTF-16, decimal commas between blanks. Messages start with
 * file:line. Warnings: header lines and columns that are not used.
 *
 * A progress event is sent per MiB read; AbortExecute stops reading, and the update fails.
 *
 * @sa
 * vtkHeliosPointTextWriter vtkHeliosXyzReader
 */

#ifndef vtkHeliosPointTextReader_h
#define vtkHeliosPointTextReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For the numbers of parts and the layout

class vtkStringArray;

namespace helios
{
class PartNumbers;
class LineFile;
struct TextReport;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosPointTextReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosPointTextReader* New();
  vtkTypeMacro(vtkHeliosPointTextReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Returns the array that a column with a name is read as, such as Intensity (empty for
   * coordinates, null if the name is not known), and the component of the array. GetCommonName()
   * returns the name of an array in files of other programs.
   */
  static const char* GetArrayOfColumn(const char* name);
  static int GetComponentOfColumn(const char* name);
  static const char* GetCommonName(const char* array);

  ///@{
  /**
   * Set/Get the name of the file. Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Set/Get where reading begins [bytes]: the first row is on the next line. Valid range: [0,
   * infinity). Default: 0.
   */
  vtkSetClampMacro(Begin, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(Begin, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get the largest number of points of an update; 0: all. Valid range: [0, infinity).
   * Default: 0.
   */
  vtkSetClampMacro(MaximumNumberOfPoints, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get whether numbers that are not finite are kept. Default: off, they are errors.
   */
  vtkSetMacro(KeepInvalid, bool);
  vtkGetMacro(KeepInvalid, bool);
  vtkBooleanMacro(KeepInvalid, bool);
  ///@}

  /**
   * Reads how the file is laid out, as an update does; false after an error. Colours and
   * intensities of the whole file are read for it.
   */
  bool ReadLayout();

  ///@{
  /**
   * Returns, from the layout, the number of columns, and the kind of the file: echoes, x y z, named
   * columns, PTS or PTX.
   */
  int GetNumberOfColumns() const;
  const char* GetKind() const;
  ///@}

  ///@{
  /**
   * Returns, from the layout, the number of scans, and the matrix from the frame of a scanner to
   * the world; false without one: only PTX has it.
   */
  int GetNumberOfScans() const;
  bool GetScanMatrix(int scan, double matrix[16]) const;
  ///@}

  ///@{
  /**
   * Get, from the layout, the smallest and largest intensity, and whether all are whole numbers.
   */
  vtkGetVector2Macro(IntensityRange, double);
  vtkGetMacro(HasWholeIntensities, bool);
  ///@}

  ///@{
  /**
   * Get, from the last update, the scan of its points, the number of points of PTX without a
   * return, which are dropped, and the sum of the numbers of points that PTS gives.
   */
  vtkGetMacro(Scan, int);
  vtkGetMacro(NumberOfDropped, vtkIdType);
  vtkGetMacro(NumberOfCounted, double);
  ///@}

  /**
   * Forgets all names of parts, and starts with the names of the parts 0, 1, ... of a scene, which
   * files also give by number; null: none.
   */
  void SetPartNames(vtkStringArray* names);

  ///@{
  /**
   * Where the last update ended, and the size of the file then [bytes].
   */
  vtkGetMacro(End, vtkIdType);
  vtkGetMacro(FileSize, vtkIdType);
  ///@}

protected:
  vtkHeliosPointTextReader();
  ~vtkHeliosPointTextReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeliosPointTextReader(const vtkHeliosPointTextReader&) = delete;
  void operator=(const vtkHeliosPointTextReader&) = delete;

  class Layout;
  bool FindLayout(helios::LineFile& file, helios::TextReport& report);
  void FindRanges(helios::LineFile& file);
  bool ReadFile(helios::LineFile& file, vtkPolyData* cloud, helios::TextReport& report);
  bool ReadEchoes(helios::LineFile& file, vtkPolyData* cloud, helios::TextReport& report);
  bool ReadColumns(helios::LineFile& file, vtkPolyData* cloud, helios::TextReport& report);
  bool Report(bool isRead, helios::TextReport& report);
  void AddPartNames(vtkPolyData* cloud) const;

  char* FileName = nullptr;
  vtkIdType Begin = 0;
  vtkIdType MaximumNumberOfPoints = 0;
  bool KeepInvalid = false;
  vtkIdType End = 0;
  vtkIdType FileSize = 0;
  double IntensityRange[2] = { 0.0, 0.0 };
  bool HasWholeIntensities = true;
  int Scan = 0;
  vtkIdType NumberOfDropped = 0;
  double NumberOfCounted = 0.0;
  std::unique_ptr<helios::PartNumbers> Parts;
  std::unique_ptr<Layout> Known; // layout of the file that was read last
};

#endif
