// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPLYSceneReader
 * @brief   read a polygon file (PLY) as a scene
 *
 * Text, and binary files of both byte orders. Read are the properties x, y and z of the element
 * vertex, of any number type, and the list vertex_indices (or vertex_index) of the element face;
 * other elements and properties are skipped. Output 0 is a scene, as from every
 * vtkHeliosSceneReader, with one default material, which vtkHeliosMaterialReader replaces. Polygons
 * are triangulated, also concave ones. Colours are not read: they are no reflectances at the
 * wavelength of a laser.
 *
 * Coordinates are double, and have the precision of the file.
 *
 * Errors, without output: a malformed header, a file that is cut off, a number that is malformed, a
 * coordinate that is NaN or infinite, an index out of range, a face with fewer than three corners.
 * Messages start with file:line, or with the file and the number of the vertex or face. Warnings:
 * polygons whose sides cross, bytes after the last element.
 *
 * @sa
 * vtkHeliosSceneReader vtkHeliosMaterialReader
 */

#ifndef vtkHeliosPLYSceneReader_h
#define vtkHeliosPLYSceneReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosSceneReader.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosPLYSceneReader : public vtkHeliosSceneReader
{
public:
  static vtkHeliosPLYSceneReader* New();
  vtkTypeMacro(vtkHeliosPLYSceneReader, vtkHeliosSceneReader);

protected:
  vtkHeliosPLYSceneReader() = default;
  ~vtkHeliosPLYSceneReader() override = default;

  const char* GetFormatName() const override { return "PLY"; }
  bool ReadScene(vtkPolyData* scene, helios::TextReport& report) override;

private:
  vtkHeliosPLYSceneReader(const vtkHeliosPLYSceneReader&) = delete;
  void operator=(const vtkHeliosPLYSceneReader&) = delete;
};

#endif
