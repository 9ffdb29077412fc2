// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosGeoTiffSceneReader
 * @brief   read a height raster as a triangle mesh
 *
 * Output 0 is a vtkPolyData of triangles:
 * - points: the pixel centres used by triangles, row by row, double; x, y in the coordinate system
 *   of the raster, z in metres;
 * - polys: two triangles for every 2 x 2 pixels, (UL, LL, UR) and (LL, LR, UR), block by block
 *   along the rows; normals point up for any geotransform (rotated, sheared, mirrored);
 * - cell data MaterialIds (int): 0;
 * - field data: one default material; CRS as WKT, if the file has one.
 *
 * A height is (value scale + offset) unit, with the scale and offset of the band. The unit comes
 * from the band, else from the vertical part of the coordinate system, else metres. CRS states
 * metres accordingly: a vertical part in feet is rewritten, and its name says so.
 *
 * If AREA_OR_POINT is Area, the first sample is half a pixel inside the corner of the raster; if it
 * is Point, it is on the tie point: GDAL shifts the geotransform in this case.
 *
 * Pixels without height become holes: the no-data value (compared exactly, in the type of the
 * band), NaN, pixels masked by the mask or alpha band, and pixels of blocks missing in the file
 * ("sparse"). A triangle is dropped if one of its corners has no height.
 *
 * The file is read in blocks of rows: the reader needs little more memory than its output.
 *
 * Errors, without output: a file that is missing, damaged or not a GeoTIFF; a band that does not
 * exist; no geotransform (or ground control points only); an infinite height; an unknown unit; more
 * than 2^31 points. Warnings: heights beyond 9000 m (an undeclared no-data value), map units in
 * feet without a height unit, a raster without triangles, and GDAL warnings.
 *
 * @warning
 * Coordinates stay in the coordinate system of the file, including degrees or feet:
 * vtkHeliosReproject converts them to metres. A coordinate system without a location on Earth
 * (LOCAL_CS) is dropped.
 *
 * @sa
 * vtkHeliosReproject vtkHeliosMaterialReader vtkHeliosSceneComposer
 */

#ifndef vtkHeliosGeoTiffSceneReader_h
#define vtkHeliosGeoTiffSceneReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <limits> // For the default NoDataValue

namespace helios
{
class RasterFile;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosGeoTiffSceneReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosGeoTiffSceneReader* New();
  vtkTypeMacro(vtkHeliosGeoTiffSceneReader, vtkPolyDataAlgorithm);
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
  vtkHeliosGeoTiffSceneReader();
  ~vtkHeliosGeoTiffSceneReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeliosGeoTiffSceneReader(const vtkHeliosGeoTiffSceneReader&) = delete;
  void operator=(const vtkHeliosGeoTiffSceneReader&) = delete;

  template <typename IndexArrayT>
  bool ReadMesh(helios::RasterFile& file, vtkPolyData* scene);
  bool Fail(const std::string& message);

  char* FileName = nullptr;
  int Band = 1;
  double HeightUnit = 0.0;
  double NoDataValue = std::numeric_limits<double>::quiet_NaN();
};

#endif
