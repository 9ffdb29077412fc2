// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPointTextReader
 * @brief   read echoes in HELIOS text columns
 *
 * Output 0 is a vtkPolyData without cells:
 * - points, double;
 * - of a file whose first row has the eleven columns of vtkHeliosPointTextWriter, point data
 *   Amplitude [W], EchoWidth [ns] and GpsTime [s], double; ReturnNumber and NumberOfReturns,
 *   unsigned char; PulseIds, 64 bits; PartIds and ClassificationIds, int; with thirteen columns also
 *   ScanDirectionFlag and EdgeOfFlightLine, with fifteen RelativeAmplitude and Reflectance [dB];
 * - field data Part.Name: the names of parts by PartIds, if parts have names.
 *
 * Of other files with three or more columns, the first three are read as x y z.
 *
 * Lines may end in CR LF; a byte-order mark is skipped; # and // at the beginning of a word start a
 * comment. A part is a name, which gets the next free number, or a number. Names keep their numbers
 * over all updates and files until SetPartNames().
 *
 * A file larger than memory is read in parts: set MaximumNumberOfPoints, and Begin to GetEnd() of
 * the update before, until GetEnd() is GetFileSize().
 *
 * Errors, without output: a row with too few or too many columns; a word that is not a
 * number, or not one of its array's type; NaN and infinities, unless KeepInvalid is on; a file that
 * cannot be read or has no rows. Messages start with file:line.
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

#include <memory> // For the numbers of parts

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
   * The number of columns in the first row of a file; 0 if it cannot be read or has no rows.
   */
  static int CountColumns(const char* fileName);

  /**
   * Whether the first row of a file has eleven, thirteen or fifteen valid columns.
   */
  static bool CanReadFile(const char* fileName);

  ///@{
  /**
   * Set/Get the name of the file. Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Set/Get where reading begins [bytes]: the first row is that of the next line. Valid range:
   * [0, infinity). Default: 0.
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
   * Forget all names of parts, and start with the names of the parts 0, 1, ... of a scene, which
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

  bool ReadFile(helios::LineFile& file, vtkPolyData* cloud, helios::TextReport& report);
  void AddPartNames(vtkPolyData* cloud) const;

  char* FileName = nullptr;
  vtkIdType Begin = 0;
  vtkIdType MaximumNumberOfPoints = 0;
  bool KeepInvalid = false;
  vtkIdType End = 0;
  vtkIdType FileSize = 0;
  std::unique_ptr<helios::PartNumbers> Parts;
};

#endif
