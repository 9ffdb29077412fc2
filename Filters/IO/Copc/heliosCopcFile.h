// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The points of a LAZ file in the order of an octree: COPC 1.0, https://copc.io.

#ifndef heliosCopcFile_h
#define heliosCopcFile_h

#include "heliosLasFile.h"
#include "heliosLazCodec.h"
#include "heliosOctreeNodes.h"
#include "heliosPartFile.h"
#include "heliosPointSort.h"
#include "heliosStatus.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace helios
{

class VTKHELIOSFILTERSIO_EXPORT CopcFile
{
public:
  /// Is called with the share that is done; false stops the work.
  using Watch = std::function<bool(double)>;

  /// The message of the status after Watch stopped the work, which is no fault.
  static constexpr const char* Stopped = "stopped";

  /// Points in memory at once [bytes]; others are in a scratch file in the folder of the file.
  static constexpr std::uint64_t Memory = std::uint64_t(256) << 20;

  explicit CopcFile(Watch watch, std::uint64_t memory = Memory);

  /// Writes <path>.part with the points of a LAZ file of point format 6, 7 or 8, and flushes it to
  /// disk; removes it after an error. Points of a node are in the order of the LAZ file.
  Status Write(const std::string& laz, const std::string& path);

private:
  using Triple = std::array<double, 3>;

  /// A node in the file.
  struct Entry
  {
    int Level;
    std::uint64_t Code;
    std::uint64_t Place;
    LazChunk Chunk;
  };

  Status WriteFile(const std::string& laz);
  Status Open(const std::string& laz);
  Status ReadPoints(PointSort& sort);
  Status WriteNodes(PointSort& sort);
  Status AddNode(OctreeNode&& node);
  Status WriteBatch();
  Status WriteTable();
  std::string EncodeInfo() const;
  std::string EncodePages() const;
  Status Append(const std::string& bytes);
  Status Overwrite(std::uint64_t place, const std::string& bytes);
  Status Report(double share) const;

  Watch OnProgress;
  std::uint64_t Bytes; ///< memory for points
  LasFile Source;
  LazForm Form;
  std::string Head; ///< header and records
  PartFile File;
  Triple Low{}; ///< corner of the cube [units of the points]
  double Side =
    0.0; ///< largest extent of the points, which readers of the header's box assume, too
  double FirstTime = 0.0;
  double LastTime = 0.0;
  std::vector<OctreeNode> Batch; ///< nodes that are compressed together
  std::uint64_t BatchPoints = 0;
  std::uint64_t Done = 0; ///< points in nodes
  std::vector<Entry> Entries;
  std::uint64_t PagesPlace = 0;
};

} // namespace helios

#endif
