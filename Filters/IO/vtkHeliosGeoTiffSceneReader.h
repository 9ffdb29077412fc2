// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosGeoTiffSceneReader
 * @brief   a height raster as a mesh of triangles
 *
 * Output 0 is a vtkPolyData of triangles:
 * - points: the pixel centres that triangles use, row by row, double; x, y in the raster's
 *   coordinate system, z in metres;
 * - polys: two for every four neighbours, (UL, LL, UR) and (LL, LR, UR), block by block along the
 *   rows; whatever the geotransform (rotated, sheared, mirrored), normals point up;
 * - cell data MaterialIds (int): 0;
 * - field data: one default material; CRS as WKT, if the file has one.
 *
 * A height is (value scale + offset) unit, with scale and offset of the band and the unit of the
 * band or else of the vertical part of the coordinate system; metres where nobody says. CRS has its
 * heights in metres accordingly: a vertical part in feet is rewritten, and its name says so.
 *
 * Where AREA_OR_POINT is Area, the first sample lies half a pixel inside the raster's corner; where
 * it is Point, on the tie point: GDAL moves the geotransform then.
 *
 * Pixels without height make holes: those of the no-data value (compared exactly, as the band's
 * type holds it), NaN, those that the mask or the alpha band hides, and those of blocks that are
 * not in the file ("sparse"). A triangle is left out if one of its own corners has no height.
 *
 * The file is read by blocks of rows, so that the memory is little more than the output's.
 *
 * Errors end the reading without output: files that are missing, damaged or no GeoTIFF; a band
 * that is not there; no geotransform (or ground control points only); an infinite height; an
 * unknown unit; more than 2^31 points. Warned of are heights beyond 9000 m (an undeclared no-data
 * value), feet on the map without a unit of heights, a raster without triangles, and what GDAL
 * warns of.
 *
 * @warning
 * Coordinates stay as the file's coordinate system has them, be it degrees or feet:
 * vtkHeliosReproject turns them into metres. A coordinate system without place on Earth (LOCAL_CS)
 * is left out.
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
   * Set/Get the band with the heights, counted from 1. Valid range: [1, 65535]. Default: 1.
   */
  vtkSetClampMacro(Band, int, 1, 65535);
  vtkGetMacro(Band, int);
  ///@}

  ///@{
  /**
   * Set/Get the unit of the heights, instead of the file's [m]; 0: the file's. Valid range:
   * [0, 1e6]. Default: 0.
   */
  vtkSetClampMacro(HeightUnit, double, 0.0, 1e6);
  vtkGetMacro(HeightUnit, double);
  ///@}

  ///@{
  /**
   * Set/Get the value of pixels without height, before scale and offset, instead of the file's;
   * NaN: the file's. Default: NaN.
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
