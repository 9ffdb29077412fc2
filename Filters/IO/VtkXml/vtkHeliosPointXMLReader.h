// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPointXMLReader
 * @brief   read points from VTP files with validation, single or as pieces
 *
 * Reads .vtp files of any program, and a .pvtp with all its pieces, as written by
 * vtkHeliosPointXMLWriter. The readers of VTK do the parsing after a validation: an invalid count,
 * size or offset in a file would crash the process.
 *
 * Output 0: a vtkPolyData with the arrays and cells of the file. Piece i of n (UPDATE_PIECE_NUMBER)
 * is a share of the pieces of the file; field data come from the first piece.
 *
 * Errors, without output; messages start with the file: a file that does not exist, not VTK XML
 * with points, a piece that is missing or has other arrays than the first, counts, sizes, offsets
 * or types that are invalid or do not fit the file, cells that refer to missing points, arrays that
 * need more than 500 MB and 10 times the file size.
 *
 * @sa
 * vtkHeliosPointXMLWriter vtkHeliosWaveformXMLReader
 */

#ifndef vtkHeliosPointXMLReader_h
#define vtkHeliosPointXMLReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For the names of pieces
#include <vector> // For the names of pieces

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosPointXMLReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosPointXMLReader* New();
  vtkTypeMacro(vtkHeliosPointXMLReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the file to read. Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Returns the number of pieces of the file, after UpdateInformation(): 1 for a .vtp.
   */
  int GetNumberOfPieces() const { return static_cast<int>(this->Pieces.size()); }

  /**
   * Returns the number of points of a .vtp, after UpdateInformation(); 0 for a .pvtp.
   */
  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }

protected:
  vtkHeliosPointXMLReader();
  ~vtkHeliosPointXMLReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosPointXMLReader(const vtkHeliosPointXMLReader&) = delete;
  void operator=(const vtkHeliosPointXMLReader&) = delete;

  bool FindPieces();

  char* FileName = nullptr;
  std::vector<std::string> Pieces; // file names
  vtkIdType NumberOfPoints = 0;
};

#endif
