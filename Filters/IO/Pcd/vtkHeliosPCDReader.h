// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCDReader
 * @brief   read points from a PCD file of the Point Cloud Library
 *
 * PCD 0.5 to 0.7; DATA ascii, binary and binary_compressed. Output 0 is a vtkPolyData without
 * cells:
 * - points: x, y, z, double. An origin given by vtkHeliosPCDWriter is added; VIEWPOINT is checked
 *   and not applied, as in PCL. Coordinates of ascii files are read in full precision, whatever
 *   their SIZE;
 * - point data: each field by its name, with its TYPE, SIZE and COUNT; the fields normal_x,
 *   normal_y and normal_z become Normals (3), intensity becomes Intensity, or Amplitude [W] if the
 *   writer stated so. Fields named _ are dropped;
 * - field data: CRS and GpsEpoch if the writer stated them.
 *
 * HEIGHT above 1 has no effect. Points whose x, y or z is not finite, as in organized clouds of
 * PCL, are dropped; a warning gives their number. Trailing bytes after the last point cause a
 * warning.
 *
 * Errors, without output; messages start with file:line, or file for binary data: header entries
 * that are unknown, missing, repeated or inconsistent (FIELDS, SIZE, TYPE, COUNT, WIDTH, HEIGHT,
 * POINTS), no x, y, z, lines with too few or too many numbers or with words that are not numbers,
 * fewer or more points than POINTS, data that are truncated or cannot be decompressed.
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
   * Set/Get the file to read. Required.
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
