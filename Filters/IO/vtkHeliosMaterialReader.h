// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosMaterialReader
 * @brief   gives a scene one material of an MTL file
 *
 * For scenes whose own file has no materials: height rasters, voxelised points. Input 0 is a scene;
 * output 0 is the same with that one material in the material columns and MaterialIds 0 on every
 * triangle. The file is read as vtkHeliosObjSceneReader reads its material libraries.
 *
 * Errors: no file, a file that cannot be read or is malformed (with file:line), a file without
 * materials, a MaterialName that the file does not have (the names it has are listed).
 *
 * @sa
 * vtkHeliosGeoTiffSceneReader vtkHeliosPointVoxelizer
 */

#ifndef vtkHeliosMaterialReader_h
#define vtkHeliosMaterialReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosMaterialReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosMaterialReader* New();
  vtkTypeMacro(vtkHeliosMaterialReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the MTL file. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Set/Get the name of the material. Default: none, which takes the alphabetically first.
   */
  vtkSetStringMacro(MaterialName);
  vtkGetStringMacro(MaterialName);
  ///@}

protected:
  vtkHeliosMaterialReader() = default;
  ~vtkHeliosMaterialReader() override;

  int RequestData(vtkInformation* request,
    vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeliosMaterialReader(const vtkHeliosMaterialReader&) = delete;
  void operator=(const vtkHeliosMaterialReader&) = delete;

  char* FileName = nullptr;
  char* MaterialName = nullptr;
};

#endif
