// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosXyzReader
 * @brief   read points from text files, piece by piece
 *
 * Output 0 is a vtkPolyData without cells:
 * - points: x, y, z of the columns with these names, else of columns 0, 1, 2, double and correctly
 *   rounded;
 * - point data Normals (double, 3) with ReadNormals;
 * - point data RGB (float, 3, each in [0..1]) with ReadColors.
 *
 * The layout of a file is found as in vtkHeliosPointTextReader: separators, a header line of names,
 * numbers of points (PTS), scans with poses (PTX). Columns with the names of normals and colours are
 * these; without names, they are those set here.
 *
 * A row is a line. Lines end in LF, CR LF or CR; the last one may lack its end; a byte-order mark is
 * skipped. A word that starts with # or // starts a comment. Blanks and tabs beside a separator are
 * ignored, and so are quotes. Only the requested columns of a row are read, and strictly: 1,5 is a
 * number between semicolons only, and nan is not a coordinate. If the first row of a file has no
 * numbers and no names x, y, z, it is skipped as a header, with a warning.
 *
 * Piece i of n (UPDATE_PIECE_NUMBER) is the rows that start in the i-th of n equal byte ranges of
 * all files: the pieces in order are the whole. A cloud larger than memory can therefore be
 * requested piece by piece, as in vtkHeliosPointVoxelizer.
 *
 * Errors, without output: a row that is too short, a word that is not a number, NaN and infinities,
 * a colour out of range, a file that cannot be read or, read in one piece, has no rows. Messages
 * start with file:line.
 *
 * A progress event is sent per MiB read; AbortExecute stops reading, and the update fails.
 *
 * @sa
 * vtkHeliosPointVoxelizer
 */

#ifndef vtkHeliosXyzReader_h
#define vtkHeliosXyzReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <cstdint> // For positions in files
#include <map>     // For the layouts of files
#include <string>  // For the names of files
#include <vector>  // For the names of files

namespace helios
{
class LineFile;
class XyzParser;
struct TextLayout;
struct TextReport;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosXyzReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosXyzReader* New();
  vtkTypeMacro(vtkHeliosXyzReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the file to read, or add further ones: their points follow in that order. Default:
   * none.
   */
  void SetFileName(const char* name);
  void AddFileName(const char* name);
  void RemoveAllFileNames();
  int GetNumberOfFileNames() const { return static_cast<int>(this->FileNames.size()); }
  const char* GetFileName(int index = 0) const;
  ///@}

  ///@{
  /**
   * Set/Get the characters that separate columns. A blank or a tab stands for any run of blanks and
   * tabs; two adjacent other separators enclose an empty column. Empty: found from the first row:
   * blanks, or semicolons, commas or bars. Valid range: no digits, letters, + - . # /. Default: empty.
   */
  vtkSetMacro(Separators, std::string);
  vtkGetMacro(Separators, std::string);
  ///@}

  ///@{
  /**
   * Set/Get whether normals are read, and their columns from 0. Valid range of a column: [0, 999].
   * Default: off; 3, 4, 5.
   */
  vtkSetMacro(ReadNormals, bool);
  vtkGetMacro(ReadNormals, bool);
  vtkBooleanMacro(ReadNormals, bool);
  vtkSetClampMacro(NormalXIndex, int, 0, 999);
  vtkGetMacro(NormalXIndex, int);
  vtkSetClampMacro(NormalYIndex, int, 0, 999);
  vtkGetMacro(NormalYIndex, int);
  vtkSetClampMacro(NormalZIndex, int, 0, 999);
  vtkGetMacro(NormalZIndex, int);
  ///@}

  ///@{
  /**
   * Set/Get whether colours are read, and their columns from 0. Valid range of a column: [0, 999].
   * Default: off; 6, 7, 8.
   */
  vtkSetMacro(ReadColors, bool);
  vtkGetMacro(ReadColors, bool);
  vtkBooleanMacro(ReadColors, bool);
  vtkSetClampMacro(RgbRIndex, int, 0, 999);
  vtkGetMacro(RgbRIndex, int);
  vtkSetClampMacro(RgbGIndex, int, 0, 999);
  vtkGetMacro(RgbGIndex, int);
  vtkSetClampMacro(RgbBIndex, int, 0, 999);
  vtkGetMacro(RgbBIndex, int);
  ///@}

  ///@{
  /**
   * Set/Get the value of full colour in the file. Valid range: greater than 0. Default: 255.
   */
  vtkSetMacro(MaximumColorValue, double);
  vtkGetMacro(MaximumColorValue, double);
  ///@}

protected:
  vtkHeliosXyzReader();
  ~vtkHeliosXyzReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeliosXyzReader(const vtkHeliosXyzReader&) = delete;
  void operator=(const vtkHeliosXyzReader&) = delete;

  bool CheckProperties();
  bool FindLayout(helios::LineFile& file, helios::TextReport& report);
  void SetColumns(helios::TextLayout& layout) const;
  bool ReadPiece(
    helios::XyzParser& parser, helios::TextReport& report, std::int64_t piece, std::int64_t count);
  void WarnOnce(const std::vector<std::string>& warnings);

  std::vector<std::string> FileNames;
  std::string Separators;
  bool ReadNormals = false;
  int NormalXIndex = 3;
  int NormalYIndex = 4;
  int NormalZIndex = 5;
  bool ReadColors = false;
  int RgbRIndex = 6;
  int RgbGIndex = 7;
  int RgbBIndex = 8;
  double MaximumColorValue = 255.0;
  std::vector<std::string> Warned; // since the last change: pieces may be read several times
  vtkMTimeType WarnedTime = 0;
  std::map<std::string, helios::TextLayout> Layouts; // by file, since the last change
  vtkMTimeType LayoutTime = 0;
};

#endif
