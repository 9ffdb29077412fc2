// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosObjSceneReader
 * @brief   a Wavefront OBJ file as a scene
 */

#ifndef vtkHeliosObjSceneReader_h
#define vtkHeliosObjSceneReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosObjSceneReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosObjSceneReader* New();
  vtkTypeMacro(vtkHeliosObjSceneReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetFileName(const std::string& name); // API

protected:
  vtkHeliosObjSceneReader();
  ~vtkHeliosObjSceneReader() override;

private:
  vtkHeliosObjSceneReader(const vtkHeliosObjSceneReader&) = delete;
  void operator=(const vtkHeliosObjSceneReader&) = delete;
};

#endif
