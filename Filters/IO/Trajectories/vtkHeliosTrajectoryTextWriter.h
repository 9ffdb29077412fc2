// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosTrajectoryTextWriter
 * @brief   write a trajectory in HELIOS text columns
 *
 * One sample per line, columns separated by blanks, no header: x y z [m], 4
 * decimals; GPS time [s], 9 decimals; roll, pitch, yaw [deg], 4 decimals.
 *
 * The angles are the Cardan angles X-Y-Z of the attitude
 *
 *   A = Rx(roll) Ry(pitch) Rz(yaw),
 *
 * the matrix from body coordinates (x right, y forward, z up) to the world; Rx,
 * Ry, Rz are right-handed rotations about x, y, z. Yaw is applied to a body
 * vector first. This is the CANONICAL convention of HELIOS: roll is about the
 * right axis, so a body that heads along y with its nose up has a roll, and a
 * level body only a yaw. Yaw is counter-clockwise from above, 0 if forward is
 * y, in [0, 360); roll in [-180, 180], pitch in [-90, 90]. Within 1e-9 rad of a
 * pitch of 90 or -90 degrees (gimbal lock) roll and yaw are not separable: roll
 * is then 0, and yaw is the full rotation.
 *
 * Blocks: samples in the layout of vtkHeliosPlatform: vtkPolyData, double
 * points, point arrays GpsTime [s] and Orientation (quaternion w, x, y, z, body
 * to world, of any nonzero length). A block without points needs no arrays.
 *
 * @sa
 * vtkHeliosStreamWriter vtkHeliosPlatform
 */

#ifndef vtkHeliosTrajectoryTextWriter_h
#define vtkHeliosTrajectoryTextWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosStreamWriter.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosTrajectoryTextWriter : public vtkHeliosStreamWriter
{
public:
  static vtkHeliosTrajectoryTextWriter* New();
  vtkTypeMacro(vtkHeliosTrajectoryTextWriter, vtkHeliosStreamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Appends the samples of a block.
   */
  bool Write(vtkDataObject* block) override;

protected:
  vtkHeliosTrajectoryTextWriter() = default;
  ~vtkHeliosTrajectoryTextWriter() override = default;

  const char* GetBlockSource() const override;

private:
  vtkHeliosTrajectoryTextWriter(const vtkHeliosTrajectoryTextWriter&) = delete;
  void operator=(const vtkHeliosTrajectoryTextWriter&) = delete;
};

#endif
