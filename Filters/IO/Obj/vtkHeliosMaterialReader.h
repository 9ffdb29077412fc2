// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosMaterialReader
 * @brief   assign one material of an MTL file to a scene
 *
 * For scenes without materials in their own file: height rasters, voxelized points. Input 0 is a
 * scene; output 0 is the same scene with that one material in the material columns and MaterialIds
 * 0 on every triangle. The file is read like the material libraries of vtkHeliosObjSceneReader.
 * Input and output may also be a raster of heights (vtkImageData), which gets the material columns.
 *
 * If NumberOfMaterials is above 1, the others are copies with a different reflectance: the original
 * plus a random number, uniform in +-RandomRange and keyed by Seed and the material index, clamped
 * to [0, 1]. MaterialIds are then the ids of the input, modulo NumberOfMaterials.
 *
 * @warning
 * A material with a spectrum but no reflectance is not varied; a warning is given.
 *
 * Errors: no file, a file that cannot be read or is malformed (with file:line), a file without
 * materials, a MaterialName that is not in the file (the available names are listed).
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
   * Set/Get the name of the material. Default: none, which selects the alphabetically first.
   */
  vtkSetStringMacro(MaterialName);
  vtkGetStringMacro(MaterialName);
  ///@}

  ///@{
  /**
   * Set/Get the number of materials derived from it. Valid range: [1, 1000000]. Default: 1.
   */
  vtkSetClampMacro(NumberOfMaterials, int, 1, 1000000);
  vtkGetMacro(NumberOfMaterials, int);
  ///@}

  ///@{
  /**
   * Set/Get the maximum change of the reflectance. Valid range: [0, 1]. Default: 1.
   */
  vtkSetClampMacro(RandomRange, double, 0.0, 1.0);
  vtkGetMacro(RandomRange, double);
  ///@}

  ///@{
  /**
   * Set/Get the seed of the random numbers. Valid range: [0, 2^62]. Default: 0.
   */
  vtkSetClampMacro(Seed, vtkIdType, 0, 4611686018427387904LL);
  vtkGetMacro(Seed, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get whether Kd and map_Kd become the colour of the material (vtkHeliosObjSceneReader).
   * Default: off.
   */
  vtkSetMacro(ReadColors, bool);
  vtkGetMacro(ReadColors, bool);
  vtkBooleanMacro(ReadColors, bool);
  ///@}

protected:
  vtkHeliosMaterialReader() = default;
  ~vtkHeliosMaterialReader() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeliosMaterialReader(const vtkHeliosMaterialReader&) = delete;
  void operator=(const vtkHeliosMaterialReader&) = delete;

  char* FileName = nullptr;
  char* MaterialName = nullptr;
  int NumberOfMaterials = 1;
  double RandomRange = 1.0;
  vtkIdType Seed = 0;
  bool ReadColors = false;
};

#endif
