// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads runs and clouds from files, block by block.

#ifndef heliosCloudReader_h
#define heliosCloudReader_h

#include "heliosStatus.h"

#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkPolyData;

namespace helios::viewer
{

class Cloud;

/// Receives a block of points and the fraction read so far [0..1]; false stops.
using BlockFunction = std::function<bool(vtkPolyData*, double)>;

/**
 * Reads a run folder (run_summary.json lists the files of its legs) or one file:
 * - .xyz, .txt, .asc: the columns of vtkHeliosPointTextWriter, or any text with x y z first;
 * - .las (vtkHeliosLASReader), .vtp, .pvtp, .ply (vtkHeliosPLYPointReader).
 * Coordinates are converted to metres by the coordinate system of the file; degrees are an error.
 * The trajectories of a run are polylines (of a static platform: a vertex) in world coordinates,
 * also the one beside a single legNNN_points file.
 */
class CloudReader
{
public:
  ///@{
  /// Returns whether a folder is a finished run, and whether a file has an ending that is read.
  static bool IsRun(const std::string& folder);
  static bool CanRead(const std::string& fileName);
  ///@}

  /// Part names in id order; set the scene's names before reading text files.
  std::vector<std::string> PartNames;

  /// Files read so far, and the trajectories found.
  std::vector<std::string> Files;
  std::vector<vtkSmartPointer<vtkPolyData>> Trajectories;

  /// Passes on the blocks one by one.
  Status Read(const std::string& path, const BlockFunction& onBlock);

  /// Appends all points to a cloud.
  Status Read(const std::string& path, Cloud& cloud);

private:
  Status ReadRun(const std::string& folder);
  Status ReadCloud(const std::string& path);
  Status ReadText(const std::string& path);
  Status ReadPieces(vtkAlgorithm* reader, const std::string& path, int pieces, int leg = -1);
  Status ReadTrajectory(const std::string& path);

  BlockFunction OnBlock;
  std::string Problem; // problem of a coordinate system
  bool Stopped = false;
  double FirstShare = 0.0; // share of the current file in the total
  double ShareOfFile = 1.0;
};

} // namespace helios::viewer

#endif
