// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosWaveformXMLWriter
 * @brief   write waveforms as VTT pieces with a PVTT index
 *
 * FileName ends in .pvtt; block k is written to <name>_000k.vtt beside it, bit
 * for bit: its columns, and Samples in the field data. A piece is a table in
 * the layout of the scanner output; its Offset refers to its own Samples.
 *
 * Read a piece with vtkXMLTableReader, or piece k of n (GetNumberOfPieces()) with
 * vtkXMLPTableReader and UpdatePiece(k, n, 0).
 *
 * @warning
 * If several pieces are requested at once, vtkXMLPTableReader (VTK 9.1 and
 * later) returns the last one only; vtkHeliosWaveformXMLReader returns all of
 * them as one table.
 *
 * Blocks: waveforms in the layout of vtkHeliosScanner: vtkTable with the columns PulseIds, Origin,
 * Direction, GpsTime [s], StartTime [ns], BinSize [ns], Offset, Count (at least 1), and Samples [W]
 * in its field data. A block without rows needs no columns.
 *
 * @sa
 * vtkHeliosXMLPieceWriter vtkHeliosWaveformXMLReader vtkHeliosWaveformTextWriter
 */

#ifndef vtkHeliosWaveformXMLWriter_h
#define vtkHeliosWaveformXMLWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosXMLPieceWriter.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosWaveformXMLWriter : public vtkHeliosXMLPieceWriter
{
public:
  static vtkHeliosWaveformXMLWriter* New();
  vtkTypeMacro(vtkHeliosWaveformXMLWriter, vtkHeliosXMLPieceWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkHeliosWaveformXMLWriter() = default;
  ~vtkHeliosWaveformXMLWriter() override = default;

  const char* GetBlockSource() const override;
  const char* GetPieceEnding() const override;
  const char* GetIndexElement() const override;
  vtkFieldData* GetRecords(vtkDataObject* block, vtkIdType& count) override;
  std::string DeclareArrays(const std::string& lines) const override;
  vtkSmartPointer<vtkXMLWriter> MakeWriter(vtkDataObject* block) const override;

private:
  vtkHeliosWaveformXMLWriter(const vtkHeliosWaveformXMLWriter&) = delete;
  void operator=(const vtkHeliosWaveformXMLWriter&) = delete;
};

#endif
