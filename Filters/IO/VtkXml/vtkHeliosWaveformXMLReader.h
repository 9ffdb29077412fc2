// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosWaveformXMLReader
 * @brief   read waveforms from VTT pieces, some or all as one table
 *
 * Reads a .pvtt and its .vtt pieces, as written by vtkHeliosWaveformXMLWriter; also the .part of an
 * interrupted run.
 *
 * Output 0: a vtkTable in the layout of vtkHeliosScanner. Piece i of n (UPDATE_PIECE_NUMBER) is a
 * share of the pieces of the file: the pieces in order are the whole, each with its own Samples. If
 * several pieces of the file become one table, Offset refers to the merged Samples; other field
 * data come from the first.
 *
 * Errors: a file that cannot be read or has another format, a piece that is missing, has no
 * waveforms or other columns than the first.
 *
 * @sa
 * vtkHeliosWaveformXMLWriter vtkHeliosWaveformTextReader
 */

#ifndef vtkHeliosWaveformXMLReader_h
#define vtkHeliosWaveformXMLReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For the names of pieces
#include <vector> // For the names of pieces

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosWaveformXMLReader : public vtkTableAlgorithm
{
public:
  static vtkHeliosWaveformXMLReader* New();
  vtkTypeMacro(vtkHeliosWaveformXMLReader, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the file to read. Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Returns the number of pieces of the file, after UpdateInformation().
   */
  int GetNumberOfPieces() const { return static_cast<int>(this->Pieces.size()); }

protected:
  vtkHeliosWaveformXMLReader();
  ~vtkHeliosWaveformXMLReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosWaveformXMLReader(const vtkHeliosWaveformXMLReader&) = delete;
  void operator=(const vtkHeliosWaveformXMLReader&) = delete;

  bool FindPieces();
  bool AppendPiece(const std::string& name, vtkTable* waveforms);

  char* FileName = nullptr;
  std::vector<std::string> Pieces; // file names
};

#endif
