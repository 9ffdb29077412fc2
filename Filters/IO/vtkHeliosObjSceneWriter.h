// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosObjSceneWriter
 * @brief   a scene as a Wavefront OBJ file
 */

#ifndef vtkHeliosObjSceneWriter_h
#define vtkHeliosObjSceneWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosObjSceneWriter : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosObjSceneWriter* New();
  vtkTypeMacro(vtkHeliosObjSceneWriter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;



protected:
  vtkHeliosObjSceneWriter();
  ~vtkHeliosObjSceneWriter() override;

private:
  vtkHeliosObjSceneWriter(const vtkHeliosObjSceneWriter&) = delete;
  void operator=(const vtkHeliosObjSceneWriter&) = delete;
};

#endif
