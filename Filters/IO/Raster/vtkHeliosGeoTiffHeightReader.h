// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosGeoTiffHeightReader
 * @brief   read a height raster that stays a raster
 *
 * The heights of vtkHeliosGeoTiffSceneReader in 4 or 8 bytes a pixel, without its mesh. Output 0 is
 * a vtkImageData with one point a pixel, row by row from the top of the file:
 * - point data Heights: [m], NaN for pixels without height; float if all heights are floats, else
 *   double;
 * - field data GeoTransform: the six values of GDAL, for which the first pixel centre is at 0.5;
 *   one default material; CRS as WKT, if the file has one.
 *
 * Origin, spacing and direction of the image place its points at the pixel centres, at z = 0, up to
 * rounding.
 *
 * Heights that do not fit into memory (vtkHeliosMemoryLimit) are in a temporary file in the folder
 * TMPDIR (default: /var/tmp), of which the system holds the pages used last in memory.
 *
 * Heights, units and holes, errors and warnings: see vtkHeliosGeoTiffSceneReader. Further error: no
 * room for the temporary file.
 *
 * @sa
 * vtkHeliosGeoTiffSceneReader
 */

#ifndef vtkHeliosGeoTiffHeightReader_h
#define vtkHeliosGeoTiffHeightReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For the file

#include <limits> // For the default NoDataValue

namespace helios
{
class RasterFile;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosGeoTiffHeightReader : public vtkImageAlgorithm
{
public:
  static vtkHeliosGeoTiffHeightReader* New();
  vtkTypeMacro(vtkHeliosGeoTiffHeightReader, vtkImageAlgorithm);
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
   * Set/Get the height band, counted from 1. Valid range: [1, 65535]. Default: 1.
   */
  vtkSetClampMacro(Band, int, 1, 65535);
  vtkGetMacro(Band, int);
  ///@}

  ///@{
  /**
   * Set/Get the height unit [m], which overrides the unit in the file; 0: use the file's. Valid
   * range: [0, 1e6]. Default: 0.
   */
  vtkSetClampMacro(HeightUnit, double, 0.0, 1e6);
  vtkGetMacro(HeightUnit, double);
  ///@}

  ///@{
  /**
   * Set/Get the value of pixels without height, before scale and offset, which overrides the value
   * in the file; NaN: use the file's. Default: NaN.
   */
  vtkSetMacro(NoDataValue, double);
  vtkGetMacro(NoDataValue, double);
  ///@}

protected:
  vtkHeliosGeoTiffHeightReader();
  ~vtkHeliosGeoTiffHeightReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeliosGeoTiffHeightReader(const vtkHeliosGeoTiffHeightReader&) = delete;
  void operator=(const vtkHeliosGeoTiffHeightReader&) = delete;

  bool Open(std::unique_ptr<helios::RasterFile>& file);
  bool ReadHeights(helios::RasterFile& file, vtkImageData* image);
  bool Fail(const std::string& message);

  char* FileName = nullptr;
  int Band = 1;
  double HeightUnit = 0.0;
  double NoDataValue = std::numeric_limits<double>::quiet_NaN();
};

#endif
