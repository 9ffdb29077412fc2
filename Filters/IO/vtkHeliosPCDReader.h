// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCDReader
 * @brief   points from a PCD file of the Point Cloud Library
 *
 * PCD 0.5 to 0.7; DATA ascii, binary and binary_compressed. Output 0 is a vtkPolyData without cells:
 * - points: x, y, z, double. What a file of vtkHeliosPCDWriter says of its origin is added; VIEWPOINT is
 *   checked and not applied, as in PCL. Coordinates of ascii files are read with all their digits,
 *   whatever their SIZE;
 * - point data: each field by its name, of its TYPE, SIZE and COUNT; the fields normal_x, normal_y
 *   and normal_z are Normals (3), intensity is Intensity, or Amplitude [W] where the writer said so.
 *   Fields with the name _ are left out;
 * - field data: CRS and GpsEpoch where the writer said them.
 *
 * HEIGHT above 1 makes no difference. Points whose x, y or z is not finite, as in PCL's organized
 * clouds, are dropped with a warning that counts them. Bytes behind the last point get a warning.
 *
 * Errors end the reading without output; messages start with file:line, or file where it is about
 * binary data: entries that are unknown, missing, given twice or do not fit each other (FIELDS,
 * SIZE, TYPE, COUNT, WIDTH, HEIGHT, POINTS), no x, y, z, lines with too few or too many numbers or
 * words that are none, fewer or more points than POINTS, data that are cut off or cannot be
 * decompressed.
 *
 * @sa
 * vtkHeliosPCDWriter
 */

#ifndef vtkHeliosPCDReader_h
#define vtkHeliosPCDReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosPCDReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosPCDReader* New();
  vtkTypeMacro(vtkHeliosPCDReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the file to read. No default: an error without.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkHeliosPCDReader();
  ~vtkHeliosPCDReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeliosPCDReader(const vtkHeliosPCDReader&) = delete;
  void operator=(const vtkHeliosPCDReader&) = delete;

  class Work;
  bool Read(vtkPolyData* output);

  char* FileName = nullptr;
};

#endif
