// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPLYPointReader
 * @brief   read the vertices of a polygon file (PLY) as points
 *
 * Text, and binary files of both byte orders. Output 0 is a vtkPolyData without cells:
 * - points: the properties x, y and z of the element vertex, double, or X, Y and Z. Coordinates of
 *   text are read in full precision, whatever their type;
 * - point data: each other property by its name, with its type. Integers that vtkhelios stored as
 *   floats have their type again (comment vtkhelios type:NAME int64);
 * - field data: CRS, GpsEpoch, Species.Name and Organ.Name if comments of vtkhelios state them
 *   (comment vtkhelios name:Species.Name:0 Fagus sylvatica).
 *
 * Other elements, which follow the vertices, are not read. A file larger than memory is read by
 * pieces, in their order.
 *
 * Errors, without output: a malformed header, elements before the vertices, lists, a file that is cut
 * off, numbers that are malformed or not of the type of their property. Messages start with
 * file:line, or with the file and the number of the vertex.
 *
 * @sa
 * vtkHeliosPLYSceneReader vtkHeliosPCDReader
 */

#ifndef vtkHeliosPLYPointReader_h
#define vtkHeliosPLYPointReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For the open file

namespace helios
{
class Status;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosPLYPointReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosPLYPointReader* New();
  vtkTypeMacro(vtkHeliosPLYPointReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the file to read. Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Get, from the last update, the number of points of the file, and its format: ascii,
   * binary_little_endian or binary_big_endian.
   */
  vtkGetMacro(NumberOfVertices, vtkIdType);
  const char* GetFormat() const;
  ///@}

protected:
  vtkHeliosPLYPointReader();
  ~vtkHeliosPLYPointReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeliosPLYPointReader(const vtkHeliosPLYPointReader&) = delete;
  void operator=(const vtkHeliosPLYPointReader&) = delete;

  class Vertices;
  helios::Status ReadPiece(int piece, int pieces, vtkPolyData* cloud);

  char* FileName = nullptr;
  vtkIdType NumberOfVertices = 0;
  std::unique_ptr<Vertices> File; // file of the last update
};

#endif
