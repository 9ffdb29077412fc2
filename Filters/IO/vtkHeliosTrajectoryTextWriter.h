// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosTrajectoryTextWriter
 * @brief   a trajectory in HELIOS text columns
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



protected:
  vtkHeliosTrajectoryTextWriter();
  ~vtkHeliosTrajectoryTextWriter() override;

private:
  vtkHeliosTrajectoryTextWriter(const vtkHeliosTrajectoryTextWriter&) = delete;
  void operator=(const vtkHeliosTrajectoryTextWriter&) = delete;
};

#endif
