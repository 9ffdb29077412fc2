// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosCOPCWriter
 * @brief   write echoes as COPC
 *
 * COPC 1.0 (https://copc.io) is a LAZ 1.4 file whose points, of format 6, 7 or 8, are in the order of
 * an octree. Until Close(), <FileName>.part is LAZ with the points in the order in which they came,
 * as by vtkHeliosLASWriter with WriteCompressed. Close() makes the file of it in two passes: points
 * are sorted along a Morton curve, and divided among the nodes of the octree as they come along it.
 *
 * The root is the cube of the largest extent of the points, from their least coordinates on. A node has one point per cell of a grid of 128 x 128 x 128,
 * or all of its points if they are at most 20,000; its children have the others. Points of a node
 * are in the order in which they came; the bytes do not depend on blocks and threads.
 *
 * Memory: 256 MB for points; if there are more, a scratch file in the folder of the file has them
 * [record + 16 bytes a point], which has no name and disappears when the process ends.
 *
 * Close() invokes ProgressEvent with the share that is done; Abort() stops it. An error, or Abort(),
 * leaves the .part, which Reopen() continues.
 *
 * @sa
 * vtkHeliosLASWriter
 */

#ifndef vtkHeliosCOPCWriter_h
#define vtkHeliosCOPCWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosLASWriter.h"

#include <functional> // For progress

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosCOPCWriter : public vtkHeliosLASWriter
{
public:
  static vtkHeliosCOPCWriter* New();
  vtkTypeMacro(vtkHeliosCOPCWriter, vtkHeliosLASWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  bool Open() override;

  ///@{
  /**
   * Set/Get whether Close() leaves the .part, until RemovePart(): a run continues with it if it is
   * interrupted before its journal states that the file is complete. Default: off.
   */
  vtkSetMacro(LeavesPart, bool);
  vtkGetMacro(LeavesPart, bool);
  vtkBooleanMacro(LeavesPart, bool);
  ///@}

  /**
   * Removes the .part of FileName if the file itself exists.
   */
  void RemovePart();

#ifndef __VTK_WRAP__
  /**
   * Sets a function that Close() calls with its progress; false stops it, as Abort() does.
   */
  void SetOnProgress(std::function<bool(double)> onProgress);
#endif

  ///@{
  /**
   * Stops Close() at its next ProgressEvent. Returns whether the last Close() was stopped.
   */
  void Abort()
  {
    this->IsAborted = true;
  }
  bool GetWasAborted() const
  {
    return this->IsAborted;
  }
  ///@}

  /**
   * Get the share of Close() that is done. Range: [0, 1].
   */
  vtkGetMacro(Progress, double);

protected:
  vtkHeliosCOPCWriter();
  ~vtkHeliosCOPCWriter() override = default;

  bool FinishFile() override;

private:
  vtkHeliosCOPCWriter(const vtkHeliosCOPCWriter&) = delete;
  void operator=(const vtkHeliosCOPCWriter&) = delete;

  bool Report(double share);

  std::function<bool(double)> OnProgress;
  bool LeavesPart = false;
  bool IsAborted = false;
  double Progress = 0.0;
};

#endif
