// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosVoxelWriter
 * @brief   write a grid of plant area density as a .vox file
 *
 * Input 0 is a vtkImageData with cubic cells along the axes and cell data PAD, such as the output of
 * vtkHeliosPlantAreaDensity. The file is that of AMAPVox 1.4, which vtkHeliosVoxelReader reads back
 * as turbid voxels: a header, and a row of each cell,
 *
 *   i j k PadBVTotal angleMean bsEntering bsIntercepted bsPotential ground_distance lMeanTotal
 *   lgTotal nbEchos nbSampling transmittance attenuation attenuationBiasCorrection
 *
 * With the arrays of vtkHeliosPlantAreaDensity, bsEntering and bsIntercepted are energies in pulses,
 * bsPotential the number of beams with and without energy, lMeanTotal and lgTotal the mean and the
 * sum of the free paths [m], nbSampling the beams with energy, and transmittance the energy that
 * passes, ground_distance the cell array GroundDistance. What is not known is NaN, as angleMean;
 * nbEchos is 0. Numbers
 * have the fewest digits that restore them.
 *
 * Errors: no PAD, cells that are not cubes, turned axes, a file that cannot be written. The file has
 * the suffix .part until it is complete.
 *
 * @sa
 * vtkHeliosVoxelReader vtkHeliosPlantAreaDensity
 */

#ifndef vtkHeliosVoxelWriter_h
#define vtkHeliosVoxelWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <string> // For errors

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosVoxelWriter : public vtkImageAlgorithm
{
public:
  static vtkHeliosVoxelWriter* New();
  vtkTypeMacro(vtkHeliosVoxelWriter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the file to write. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Writes the file; updates the input first. Returns 1, or 0 after an error.
   */
  int Write();

protected:
  vtkHeliosVoxelWriter();
  ~vtkHeliosVoxelWriter() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosVoxelWriter(const vtkHeliosVoxelWriter&) = delete;
  void operator=(const vtkHeliosVoxelWriter&) = delete;

  std::string WriteGrid(vtkImageData* grid);

  char* FileName = nullptr;
  bool IsWritten = false;
};

#endif
