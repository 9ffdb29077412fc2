// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosVoxelReader
 * @brief   read a vegetation grid from a .vox file
 *
 * Output 0 is a vtkImageData whose cells are the cells of the grid (its points are the cell
 * corners):
 * - cell data PAD (double) [m2/m3]: the plant area density, NaN if the file says so, 0 in cells
 *   missing in the file;
 * - cell data Transmittance (double), if the file has that column: NaN if the file says so, 1 in
 *   missing cells;
 * - field data MaximumPAD (double), if the file gives max_pad;
 * - field data LeafProjection (double, 4) with LeafTableFileName: rows x y z G, the projection G of
 *   unit leaf area along a direction.
 *
 * The file is text: lines "#min_corner: x y z", "#max_corner: x y z", "#split: nx ny nz" and "#res:
 * r", in any order, also several on one line ("#max_pad: m" may be among them); titles; the column
 * names; then rows "i j k PadBVTotal ... transmittance ..." separated by blanks. Columns are found
 * by name; without names they are PadBVTotal in 3 and transmittance in 13. Cell i j k, from 0,
 * starts at min_corner + (i j k) r. Empty cells need no row.
 *
 * Errors, without output: a file that cannot be read, a header without corner, split and size or an
 * inconsistent one, a row that is too short, a word that is not a number, a density that is
 * negative or infinite (NaN is valid), a cell that is outside the grid or repeated, more cells than
 * MaximumNumberOfCells. Messages start with file:line.
 *
 * A cell uses 16 bytes. A progress event is sent per MiB read; AbortExecute stops reading.
 *
 * @sa
 * vtkHeliosVoxelCubes vtkHeliosScanner
 */

#ifndef vtkHeliosVoxelReader_h
#define vtkHeliosVoxelReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <string> // For the name of a column

namespace helios
{
class VoxelFile;
struct TextReport;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosVoxelReader : public vtkImageAlgorithm
{
public:
  static vtkHeliosVoxelReader* New();
  vtkTypeMacro(vtkHeliosVoxelReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the file to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Set/Get a table of leaf angles: a text file of rows x,y,z,G. Default: none; the scanner then
   * assumes a spherical leaf angle distribution.
   */
  vtkSetFilePathMacro(LeafTableFileName);
  vtkGetFilePathMacro(LeafTableFileName);
  ///@}

  ///@{
  /**
   * Set/Get the name of the density column, case-insensitive. Default: PadBVTotal.
   */
  vtkSetMacro(PADColumn, std::string);
  vtkGetMacro(PADColumn, std::string);
  ///@}

  ///@{
  /**
   * Set/Get the maximum number of grid cells, a memory guard. Valid range: [1, 4e9]. Default:
   * 200000000.
   */
  vtkSetClampMacro(MaximumNumberOfCells, vtkIdType, 1, 4000000000);
  vtkGetMacro(MaximumNumberOfCells, vtkIdType);
  ///@}

protected:
  vtkHeliosVoxelReader();
  ~vtkHeliosVoxelReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeliosVoxelReader(const vtkHeliosVoxelReader&) = delete;
  void operator=(const vtkHeliosVoxelReader&) = delete;

  bool ReadHead(helios::VoxelFile& file, helios::TextReport& report);
  bool Read(helios::VoxelFile& file, helios::TextReport& report, vtkImageData* grid);

  char* FileName = nullptr;
  char* LeafTableFileName = nullptr;
  std::string PADColumn = "PadBVTotal";
  vtkIdType MaximumNumberOfCells = 200000000;
};

#endif
