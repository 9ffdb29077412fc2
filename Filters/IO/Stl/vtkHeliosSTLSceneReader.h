// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSTLSceneReader
 * @brief   read a stereolithography file (STL) as a scene
 *
 * Binary and text files. Output 0 is a scene, as from every vtkHeliosSceneReader, with one default
 * material, which vtkHeliosMaterialReader replaces. Equal vertices become one. Normals are not
 * read: incidence is measured from the triangles. STL has no unit: many programs write millimetres,
 * and vtkHeliosSceneTransform scales.
 *
 * Coordinates are double: text is correctly rounded, binary files have single precision, about 0.03
 * m at 500 km from the origin.
 *
 * Errors, without output: a file that is neither, or is cut off; text that is malformed; a
 * coordinate that is NaN or infinite. Messages start with file:line, or with the file and the
 * number of the triangle. Warning: bytes after the last triangle.
 *
 * @sa
 * vtkHeliosSceneReader vtkHeliosMaterialReader
 */

#ifndef vtkHeliosSTLSceneReader_h
#define vtkHeliosSTLSceneReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosSceneReader.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosSTLSceneReader : public vtkHeliosSceneReader
{
public:
  static vtkHeliosSTLSceneReader* New();
  vtkTypeMacro(vtkHeliosSTLSceneReader, vtkHeliosSceneReader);

protected:
  vtkHeliosSTLSceneReader() = default;
  ~vtkHeliosSTLSceneReader() override = default;

  const char* GetFormatName() const override { return "STL"; }
  bool ReadScene(vtkPolyData* scene, helios::TextReport& report) override;

private:
  vtkHeliosSTLSceneReader(const vtkHeliosSTLSceneReader&) = delete;
  void operator=(const vtkHeliosSTLSceneReader&) = delete;
};

#endif
