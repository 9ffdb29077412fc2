// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosXMLPieceWriter
 * @brief   write blocks as VTK XML pieces with an index
 *
 * Block k is written to <name>_000k.vt? beside FileName (through its own
 * .part), with its field data; FileName becomes the index, which lists the
 * pieces by file name only: the folder can be moved. A piece is read by the
 * serial reader of VTK, the index by the parallel one. The index is updated
 * during the run; an abandoned <FileName>.part is also a valid index.
 *
 * Data are appended raw, with 64-bit ids and sizes, compressed with LZ4: echoes
 * are 40 % smaller at the same speed. The VTK default, zlib, saves another 15 %
 * and is twenty times slower.
 *
 * All blocks have the same arrays, all numeric; an empty block creates no
 * piece. Non-finite numbers are written unchanged.
 *
 * @warning
 * Pieces of an earlier, longer run with the same name remain and are not listed.
 *
 * @sa
 * vtkHeliosPointXMLWriter vtkHeliosWaveformXMLWriter
 */

#ifndef vtkHeliosXMLPieceWriter_h
#define vtkHeliosXMLPieceWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosStreamWriter.h"
#include "vtkSmartPointer.h" // For the block writer

#include <cstdint> // For sizes

class vtkXMLWriter;

namespace helios
{
class Status;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosXMLPieceWriter : public vtkHeliosStreamWriter
{
public:
  vtkTypeMacro(vtkHeliosXMLPieceWriter, vtkHeliosStreamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Creates the index, without pieces.
   */
  bool Open() override;

  /**
   * Resumes after the pieces that the index lists in its first fileSize bytes.
   */
  bool Reopen(vtkIdType fileSize, vtkIdType numberOfRecords, vtkIdType numberOfBytes) override;

  /**
   * Writes a block as a piece.
   */
  bool Write(vtkDataObject* block) override;

  /**
   * Flushes the pieces and the index to disk (fsync). Returns the error message, empty after
   * success.
   */
  std::string Sync() override;

#ifndef __VTK_WRAP__
  /**
   * Returns and clears the bytes written to the index and the pieces.
   */
  std::vector<helios::FileBlock> CollectBlocks() override;
#endif

  /**
   * Finishes the index and gives it its final name.
   */
  bool Close() override;

  /**
   * Finishes the index and keeps its .part name.
   */
  bool Abandon() override;

  /**
   * Get the number of pieces written since Open().
   */
  vtkGetMacro(NumberOfPieces, int);

protected:
  vtkHeliosXMLPieceWriter();
  ~vtkHeliosXMLPieceWriter() override;

  /// Returns the file extension of a piece, and the element of the index.
  virtual const char* GetPieceEnding() const = 0;
  virtual const char* GetIndexElement() const = 0;

  /// Arrays of a block, one tuple per record; null after an error about an invalid block.
  virtual vtkFieldData* GetRecords(vtkDataObject* block, vtkIdType& count) = 0;

  /// Returns the array declarations of the index, given the lines of the arrays.
  virtual std::string DeclareArrays(const std::string& lines) const = 0;

  /// Creates the writer of a block; the base class sets the output and the encoding.
  virtual vtkSmartPointer<vtkXMLWriter> MakeWriter(vtkDataObject* block) const = 0;

  std::string GetSafePlace() const override;

private:
  vtkHeliosXMLPieceWriter(const vtkHeliosXMLPieceWriter&) = delete;
  void operator=(const vtkHeliosXMLPieceWriter&) = delete;

  std::string GetPieceName(int piece) const;
  bool CheckArrays(vtkFieldData* data, vtkIdType records);
  std::int64_t WritePiece(vtkDataObject* block, const std::string& name); // its size; -1: an error
  helios::Status WritePieceFile(const std::string& bytes, const std::string& name);
  bool WriteHead();
  bool WriteFoot();

  std::string Arrays;   // arrays declared by the index
  bool HasHead = false; // the head of the index is written
  int NumberOfPieces = 0;
  int NumberOfPiecesOnDisk = 0;
  std::unique_ptr<std::vector<helios::FileBlock>> PieceBlocks; // since CollectBlocks()
};

#endif
