// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosObjSceneWriter
 * @brief   write a scene as a Wavefront OBJ file
 *
 * Input 0 is a scene: a vtkPolyData of triangles, with cell data MaterialIds (missing: all 0) and
 * the material columns in its field data. Write creates the OBJ file and, beside it, a material
 * file of the same name with the extension .mtl.
 *
 * vtkHeliosObjSceneReader reads the same scene back: bit-identical points, the same triangle order,
 * equal materials. Numbers have the fewest digits that allow it. The reader drops points that no
 * triangle uses and degenerate triangles; part ids, the CRS and other arrays are not written.
 *
 * Material names become unique words: underscores replace blanks, and a repeated name gets a
 * number; a warning gives the number of changes. Files are written with the suffix .part and
 * renamed when complete, so a failure leaves existing files unchanged.
 *
 * @sa
 * vtkHeliosObjSceneReader
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

  ///@{
  /**
   * Set/Get the OBJ file to write. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Writes both files; updates the input first. Returns 1, or 0 after an error.
   */
  int Write();

protected:
  vtkHeliosObjSceneWriter();
  ~vtkHeliosObjSceneWriter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeliosObjSceneWriter(const vtkHeliosObjSceneWriter&) = delete;
  void operator=(const vtkHeliosObjSceneWriter&) = delete;

  bool WriteFiles(vtkPolyData* scene);

  char* FileName = nullptr;
  bool IsWritten = false;
};

#endif
