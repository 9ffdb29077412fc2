// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPointXMLReader
 * @brief   points from VTP files, one or pieces, damaged ones among them
 *
 * Reads .vtp files of any program, and a .pvtp with all its pieces, as
 * vtkHeliosPointXMLWriter writes them. VTK's own readers do the work, after a
 * check: they end the process where a count, size or place in a file is wrong.
 *
 * Output 0: a vtkPolyData with the arrays and cells of the file. Piece i of n
 * (UPDATE_PIECE_NUMBER) is a share of the pieces of the file; field data are
 * those of the first piece.
 *
 * Errors end the reading without output; messages start with the file: no such
 * file, no VTK XML of points, a piece that is missing or has other arrays than
 * the first, counts, sizes, places or types that are not valid or do not fit
 * the file, cells of points that there are not, arrays that need more than
 * 500 MB and 10 times the file.
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
   * Set/Get the file to read. No default: an error without.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Get the number of pieces that the file has, after UpdateInformation(): 1 for a .vtp.
   */
  int GetNumberOfPieces() const { return static_cast<int>(this->Pieces.size()); }

  /**
   * Get the number of points of a .vtp, after UpdateInformation(); 0 for a .pvtp.
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
  std::vector<std::string> Pieces; // the names of the files
  vtkIdType NumberOfPoints = 0;
};

#endif
