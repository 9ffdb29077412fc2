// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPointXMLWriter
 * @brief   write echoes as VTP pieces with a PVTP index
 *
 * FileName ends in .pvtp; block k is written to <name>_000k.vtp beside it, with
 * its points, point arrays and field arrays. A block without cells gets one
 * vertex per point for display in ParaView and PyVista; the block itself is not
 * modified. Read the file with vtkXMLPPolyDataReader, or any piece with
 * vtkXMLPolyDataReader.
 *
 * Blocks: vtkPolyData, double points.
 *
 * @sa
 * vtkHeliosXMLPieceWriter
 */

#ifndef vtkHeliosPointXMLWriter_h
#define vtkHeliosPointXMLWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosXMLPieceWriter.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosPointXMLWriter : public vtkHeliosXMLPieceWriter
{
public:
  static vtkHeliosPointXMLWriter* New();
  vtkTypeMacro(vtkHeliosPointXMLWriter, vtkHeliosXMLPieceWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkHeliosPointXMLWriter() = default;
  ~vtkHeliosPointXMLWriter() override = default;

  const char* GetBlockSource() const override;
  const char* GetPieceEnding() const override;
  const char* GetIndexElement() const override;
  vtkFieldData* GetRecords(vtkDataObject* block, vtkIdType& count) override;
  std::string DeclareArrays(const std::string& lines) const override;
  vtkSmartPointer<vtkXMLWriter> MakeWriter(vtkDataObject* block) const override;

private:
  vtkHeliosPointXMLWriter(const vtkHeliosPointXMLWriter&) = delete;
  void operator=(const vtkHeliosPointXMLWriter&) = delete;
};

#endif
