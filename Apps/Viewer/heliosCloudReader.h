// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Finished runs and clouds from files, block by block.

#ifndef heliosCloudReader_h
#define heliosCloudReader_h

#include "heliosPointTextFile.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkPolyData;

namespace helios
{

class Cloud;

/**
 * Reads the folder of a run (run_summary.json names the files of its legs) or one file:
 * - .xyz, .txt, .asc: the columns of vtkHeliosPointTextWriter, or any text with x y z first;
 * - .las (vtkHeliosLASReader), .vtp, .pvtp, .ply.
 * The trajectories of a run come as polylines (of a static platform: a vertex) in the world, also
 * that beside a single legNNN_points file.
 */
class CloudReader
{
public:
  /// Names of parts in the order of their ids; set those of the scene before reading text files.
  std::vector<std::string> PartNames;

  /// Files read so far, and the trajectories found.
  std::vector<std::string> Files;
  std::vector<vtkSmartPointer<vtkPolyData>> Trajectories;

  /// Whether the name of a file, or what is in a folder, is something this reads.
  static bool CanRead(const std::string& path);

  /// Hands the blocks over one by one. Says in words what is wrong, or returns an empty text.
  std::string Read(const std::string& path, const BlockFunction& onBlock);

  /// Appends all points to a cloud.
  std::string Read(const std::string& path, Cloud& cloud);

private:
  std::string ReadRun(const std::string& folder);
  std::string ReadCloud(const std::string& path);
  std::string ReadText(const std::string& path);
  std::string ReadPieces(vtkAlgorithm* reader, const std::string& path, int pieces, int leg = -1);
  std::string ReadTrajectory(const std::string& path);

  BlockFunction OnBlock;
  bool Stopped = false;
  double FirstShare = 0.0; // of the file being read, among all
  double ShareOfFile = 1.0;
};

} // namespace helios

#endif
