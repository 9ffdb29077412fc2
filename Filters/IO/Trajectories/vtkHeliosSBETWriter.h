// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSBETWriter
 * @brief   write a trajectory as SBET
 *
 * A record of 17 little-endian doubles per sample, as vtkHeliosTrajectoryReader reads it: GPS time
 * [s]; latitude and longitude [rad], altitude [m]; velocity [m/s] to the north, west and up; roll,
 * pitch, true heading [rad]; wander angle 0; accelerations and angular rates of the body, which are
 * not modelled and 0.
 *
 * Blocks: samples in the layout of vtkHeliosPlatform and vtkHeliosTrajectoryReader: vtkPolyData,
 * double points in the system CRS, point arrays GpsTime [s], increasing over all blocks,
 * Orientation (quaternion w, x, y, z, body to world, of any nonzero length), and optionally
 * Velocity [m/s]; without it velocities are differences of positions within the block. Attitudes
 * are rotated from the axes of CRS to east, north, up: heading = yaw + meridian convergence.
 *
 * Errors, besides the errors of vtkHeliosStreamWriter: no CRS or an unknown one, no transformation
 * to FileCRS, times that do not increase, orientations that are 0 or not finite.
 *
 * @sa
 * vtkHeliosTrajectoryReader vtkHeliosPoseTextWriter vtkHeliosTrajectoryTextWriter
 */

#ifndef vtkHeliosSBETWriter_h
#define vtkHeliosSBETWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosStreamWriter.h"

#include <memory> // For the encoder
#include <string> // For systems

namespace helios
{
class SbetEncoder;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosSBETWriter : public vtkHeliosStreamWriter
{
public:
  static vtkHeliosSBETWriter* New();
  vtkTypeMacro(vtkHeliosSBETWriter, vtkHeliosStreamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the system of the points, as EPSG:n, WKT, PROJ, or "ENU latitude longitude height";
   * applied by Write(). Default: empty, the field data CRS of a block.
   */
  vtkSetMacro(CRS, std::string);
  vtkGetMacro(CRS, std::string);
  ///@}

  ///@{
  /**
   * Set/Get the geographic system of the file. Default: EPSG:4979, WGS 84 with ellipsoidal heights.
   */
  vtkSetMacro(FileCRS, std::string);
  vtkGetMacro(FileCRS, std::string);
  ///@}

  /**
   * Creates the file.
   */
  bool Open() override;

  /**
   * Appends the samples of a block.
   */
  bool Write(vtkDataObject* block) override;

protected:
  vtkHeliosSBETWriter();
  ~vtkHeliosSBETWriter() override;

  const char* GetBlockSource() const override;

private:
  vtkHeliosSBETWriter(const vtkHeliosSBETWriter&) = delete;
  void operator=(const vtkHeliosSBETWriter&) = delete;

  bool Refuse(const std::string& problem);

  std::string CRS;
  std::string FileCRS = "EPSG:4979";
  std::unique_ptr<helios::SbetEncoder> Encoder;
};

#endif
