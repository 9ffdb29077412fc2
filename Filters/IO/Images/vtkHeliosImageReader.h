// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosImageReader
 * @brief   read an image, as textures are read
 *
 * Output 0 is a vtkImageData of one slice; row 0 is the lowest one that is seen:
 * - point data: RGB (unsigned char, 3 components), the active scalars. Greys have equal components,
 *   16 bits are rounded to 8, transparency is ignored, CMYK is converted without a colour profile.
 *
 * Formats, by the first bytes of the file:
 * - PNG: all variants; the checksum of every chunk is checked;
 * - JPEG: baseline and progressive, of 8 bits. A warning tells if EXIF gives an orientation: it is
 *   not applied, since texture coordinates refer to the pixels as stored;
 * - TIFF and BigTIFF: the first image; strips and tiles, planes, grey, RGB, palette, CMYK, YCbCr
 *   with JPEG, of 1, 2, 4, 8 or 16 bits, all compressions of libtiff but old JPEG, upright by its
 *   orientation (1 to 8);
 * - BMP: 1 to 32 bits, palettes, bit fields, run lengths, from the bottom or the top;
 * - PNM: P1 to P6.
 *
 * Errors, without output, name the file: one that does not exist, is no regular file, is damaged,
 * incomplete or of another variant, or needs more memory than vtkHeliosMemoryLimit allows. Sizes
 * are checked before memory is allocated. The size is known without reading pixels:
 * UpdateInformation().
 *
 * @sa
 * vtkHeliosObjSceneReader vtkHeliosScanner
 */

#ifndef vtkHeliosImageReader_h
#define vtkHeliosImageReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkImageAlgorithm.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosImageReader : public vtkImageAlgorithm
{
public:
  static vtkHeliosImageReader* New();
  vtkTypeMacro(vtkHeliosImageReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the file to read. Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkHeliosImageReader();
  ~vtkHeliosImageReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeliosImageReader(const vtkHeliosImageReader&) = delete;
  void operator=(const vtkHeliosImageReader&) = delete;

  char* FileName = nullptr;
};

#endif
