// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPointXMLWriter
 * @brief   echoes as VTP pieces under a PVTP
 *
 * FileName ends in .pvtp; block k goes to <name>_000k.vtp beside it (through a
 * .part of its own), with all its points, point arrays and field arrays. A block
 * without cells gets a vertex a point, so that ParaView and PyVista show it; the
 * block itself is not changed. The .pvtp lists the pieces by their names alone:
 * a folder can be moved. Read it with vtkXMLPPolyDataReader, or any piece with
 * vtkXMLPolyDataReader. An abandoned <FileName>.part is a .pvtp too.
 *
 * Data are appended raw, with 64-bit ids and sizes, and compressed by LZ4:
 * for echoes 40 % smaller at the same speed. VTK's default, zlib, saves another
 * 15 % and is twenty times slower.
 *
 * Blocks: vtkPolyData, points of doubles, the same point arrays in every block,
 * all of numbers. A block without points makes no piece. Numbers that are not
 * finite are written as they are.
 *
 * @warning
 * Pieces of an earlier, longer run of the same name stay, and are not listed.
 *
 * @sa
 * vtkHeliosStreamWriter
 */

#ifndef vtkHeliosPointXMLWriter_h
#define vtkHeliosPointXMLWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosStreamWriter.h"

#include <cstdint> // For sizes

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosPointXMLWriter : public vtkHeliosStreamWriter
{
public:
  static vtkHeliosPointXMLWriter* New();
  vtkTypeMacro(vtkHeliosPointXMLWriter, vtkHeliosStreamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Starts the index; there is no piece yet.
   */
  bool Open() override;

  /**
   * Writes a block as a piece.
   */
  bool Write(vtkDataObject* block) override;

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
  vtkHeliosPointXMLWriter() = default;
  ~vtkHeliosPointXMLWriter() override = default;

  const char* GetBlockSource() const override;
  std::string GetSafePlace() const override;

private:
  vtkHeliosPointXMLWriter(const vtkHeliosPointXMLWriter&) = delete;
  void operator=(const vtkHeliosPointXMLWriter&) = delete;

  std::string GetPieceName(int piece) const;
  bool CheckArrays(vtkPolyData* echoes);
  std::int64_t WritePiece(vtkPolyData* echoes, const std::string& name); // its size; -1: an error
  bool WriteHead();
  bool WriteFoot();

  std::string Arrays;   // as the index declares them
  bool HasHead = false; // the index
  int NumberOfPieces = 0;
};

#endif
