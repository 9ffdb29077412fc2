// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosObjSceneWriter
 * @brief   a scene as a Wavefront OBJ file
 *
 * Input 0 is a scene: a vtkPolyData of triangles, with cell data MaterialIds (none: all 0) and the
 * material columns in its field data. Write makes the OBJ file, and beside it the material file of
 * the same name with the extension .mtl.
 *
 * vtkHeliosObjSceneReader reads the same scene back: points bit for bit, triangles in the same
 * order, equal materials. Numbers have the fewest digits that do so. The reader leaves out points
 * that no triangle uses and triangles without area; part ids, the CRS and other arrays are not
 * written.
 *
 * Names of materials become words of their own where they are not: blanks give way to underscores
 * and a name met again gets a number; a warning counts them. Files are written under the name
 * .part and renamed when they are whole, so that a failure leaves older ones as they were.
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
