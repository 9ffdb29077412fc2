// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosTrajectoryTextWriter
 * @brief   a trajectory in HELIOS text columns
 *
 * One sample a line, blanks between the columns, no header: x y z [m], 4
 * decimals; GPS time [s], 9 decimals; roll, pitch, yaw [deg], 4 decimals.
 *
 * The angles are Cardan angles of the attitude A = Rx(roll) Ry(pitch) Rz(yaw),
 * body to world with x right, y forward, z up, as HELIOS++ writes them: yaw in
 * [0, 360) turns about z, counter-clockwise from above. At a pitch of +-90
 * degrees, where roll and yaw cannot be told apart, roll is 0.
 *
 * Blocks: trajectory samples (vtkPolyData with GpsTime and Orientation).
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

  bool Write(vtkDataObject* block) override;

protected:
  vtkHeliosTrajectoryTextWriter() = default;
  ~vtkHeliosTrajectoryTextWriter() override = default;

private:
  vtkHeliosTrajectoryTextWriter(const vtkHeliosTrajectoryTextWriter&) = delete;
  void operator=(const vtkHeliosTrajectoryTextWriter&) = delete;
};

#endif
