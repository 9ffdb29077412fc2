// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPointXMLWriter
 * @brief   echoes as VTP pieces under a PVTP
 *
 * FileName ends in .pvtp; block k goes to <name>_000k.vtp beside it, with all its
 * arrays, and Close() writes the .pvtp that lists them. Every piece has one
 * vertex a point, so that ParaView and PyVista show it. The data are appended
 * raw and not compressed: echoes compress by a fifth only and slow the writer
 * down tenfold.
 *
 * Blocks: any vtkPolyData; all with the same arrays.
 *
 * @sa
 * vtkHeliosStreamWriter
 */

#ifndef vtkHeliosPointXMLWriter_h
#define vtkHeliosPointXMLWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosStreamWriter.h"

#include <string> // For the pieces
#include <vector> // For the arrays

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosPointXMLWriter : public vtkHeliosStreamWriter
{
public:
  static vtkHeliosPointXMLWriter* New();
  vtkTypeMacro(vtkHeliosPointXMLWriter, vtkHeliosStreamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  bool Open() override;
  bool Write(vtkDataObject* block) override;
  bool Close() override;

protected:
  vtkHeliosPointXMLWriter() = default;
  ~vtkHeliosPointXMLWriter() override = default;

private:
  vtkHeliosPointXMLWriter(const vtkHeliosPointXMLWriter&) = delete;
  void operator=(const vtkHeliosPointXMLWriter&) = delete;

  std::string GetPieceName(int piece) const;

  std::vector<std::string> Arrays; // as the .pvtp declares them
  int NumberOfPieces = 0;
};

#endif
