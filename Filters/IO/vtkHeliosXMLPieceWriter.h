// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosXMLPieceWriter
 * @brief   blocks as VTK XML pieces under an index
 *
 * Block k goes to <name>_000k.vt? beside FileName (through a .part of its own),
 * whole, with its field data; FileName becomes the index that lists the pieces
 * by their names alone: a folder can be moved. Any piece is read by VTK's serial
 * reader, the index by its parallel one. The index is written as the run goes
 * on; an abandoned <FileName>.part is an index, too.
 *
 * Data are appended raw, with 64-bit ids and sizes, and compressed by LZ4:
 * for echoes 40 % smaller at the same speed. VTK's default, zlib, saves another
 * 15 % and is twenty times slower.
 *
 * All blocks have the same arrays, all of numbers; an empty block makes no
 * piece. Numbers that are not finite are written as they are.
 *
 * @warning
 * Pieces of an earlier, longer run of the same name stay, and are not listed.
 *
 * @sa
 * vtkHeliosPointXMLWriter vtkHeliosWaveformXMLWriter
 */

#ifndef vtkHeliosXMLPieceWriter_h
#define vtkHeliosXMLPieceWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosStreamWriter.h"
#include "vtkSmartPointer.h" // For what a block is written by

#include <cstdint> // For sizes

class vtkXMLWriter;

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosXMLPieceWriter : public vtkHeliosStreamWriter
{
public:
  vtkTypeMacro(vtkHeliosXMLPieceWriter, vtkHeliosStreamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Starts the index; there is no piece yet.
   */
  bool Open() override;

  /**
   * Goes on after the pieces that the index lists in its first fileSize bytes.
   */
  bool Reopen(vtkIdType fileSize, vtkIdType numberOfRecords, vtkIdType numberOfBytes) override;

  /**
   * Writes a block as a piece.
   */
  bool Write(vtkDataObject* block) override;

  /**
   * Returns when the disk has the pieces and the index, or says what went wrong.
   */
  std::string Sync() override;

#ifndef __VTK_WRAP__
  /**
   * What was written to the index, and the pieces.
   */
  std::vector<helios::FileBlock> TakeBlocks() override;
#endif

  /**
   * Ends the index and gives it its final name.
   */
  bool Close() override;

  /**
   * Ends the index and leaves it under its .part name.
   */
  bool Abandon() override;

  /**
   * Get the number of pieces written since Open().
   */
  vtkGetMacro(NumberOfPieces, int);

protected:
  vtkHeliosXMLPieceWriter();
  ~vtkHeliosXMLPieceWriter() override;

  /// How the name of a piece ends, and the element of the index.
  virtual const char* GetPieceEnding() const = 0;
  virtual const char* GetIndexElement() const = 0;

  /// The arrays of a block, one tuple a record; null after an error about a block that is none.
  virtual vtkFieldData* GetRecords(vtkDataObject* block, vtkIdType& count) = 0;

  /// What the index declares, for the lines of the arrays.
  virtual std::string DeclareArrays(const std::string& lines) const = 0;

  /// Writes the block; the base class sets the file and how its bytes are kept.
  virtual vtkSmartPointer<vtkXMLWriter> MakeWriter(vtkDataObject* block) const = 0;

  std::string GetSafePlace() const override;

private:
  vtkHeliosXMLPieceWriter(const vtkHeliosXMLPieceWriter&) = delete;
  void operator=(const vtkHeliosXMLPieceWriter&) = delete;

  std::string GetPieceName(int piece) const;
  bool CheckArrays(vtkFieldData* data, vtkIdType records);
  std::int64_t WritePiece(vtkDataObject* block, const std::string& name); // its size; -1: an error
  std::string WritePieceFile(const std::string& bytes, const std::string& name);
  bool WriteHead();
  bool WriteFoot();

  std::string Arrays;   // as the index declares them
  bool HasHead = false; // the index
  int NumberOfPieces = 0;
  int NumberOfPiecesOnDisk = 0;
  std::unique_ptr<std::vector<helios::FileBlock>> PieceBlocks; // since TakeBlocks()
};

#endif
