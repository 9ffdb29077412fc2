// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosTrajectoryTextWriter
 * @brief   a trajectory in HELIOS text columns
 *
 * One sample a line, blanks between the columns, no header: x y z [m], 4
 * decimals; GPS time [s], 9 decimals; roll, pitch, yaw [deg], 4 decimals.
 *
 * The angles are the Cardan angles X-Y-Z of the attitude
 *
 *   A = Rx(roll) Ry(pitch) Rz(yaw),
 *
 * the matrix that takes body coordinates (x right, y forward, z up) to the
 * world; Rx, Ry, Rz are right-handed rotations about x, y, z. A vector of the
 * body is turned by yaw first. This is HELIOS's CANONICAL convention: roll is
 * about the right axis, so a body that heads along y with its nose up has a
 * roll, and a level body only a yaw. Yaw is counter-clockwise from above, 0
 * where forward is y, in [0, 360); roll in [-180, 180], pitch in [-90, 90].
 * Within 1e-9 rad of a pitch of 90 or -90 degrees (gimbal lock) roll and yaw
 * cannot be told apart: roll is 0 then, and yaw has the whole turn.
 *
 * Blocks: samples as vtkHeliosPlatform gives them: vtkPolyData, points of
 * doubles, point arrays GpsTime [s] and Orientation (quaternion w, x, y, z, body
 * to world, of any length but 0). A block without points needs no arrays.
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
