// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A point cloud held by the viewer: 34 bytes/point, 38 with colours, in chunks that never move.

#ifndef heliosCloud_h
#define heliosCloud_h

#include "heliosCloudColumn.h"
#include "heliosPose.h"

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkType.h>

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

class vtkPolyData;

namespace helios::viewer
{

/// A point with all its attributes; unknown values: NaN, ids -1, counts and classes 0.
struct Echo
{
  vtkIdType Row = -1; ///< in the cloud, in Append() order
  Vec3 Position;      ///< [m]
  std::int64_t PulseId = -1;
  int ReturnNumber = 0;
  int NumberOfReturns = 0;
  int Class = 0;
  int Part = -1;
  int Material = -1;
  int Leg = -1;
  double GpsTime;        ///< [s]
  double Amplitude;      ///< [W], or in units of the file; to 0.07 %
  double Range;          ///< [m]
  double IncidenceAngle; ///< [deg], to 0.18
};

/// Consecutive points, at most a fixed number, so that growth copies nothing.
struct CloudChunk
{
  static constexpr vtkIdType Capacity = vtkIdType(1) << 17;

  vtkIdType FirstRow = 0;
  vtkNew<vtkFloatArray> Xyz; ///< [m], less the cloud's origin
  std::vector<std::int32_t> Pulses;
  std::vector<float> Times; ///< [s], less TimeBase
  std::vector<float> Ranges;
  std::vector<std::uint32_t> Tags; ///< rows of the cloud's table of leg, part and material
  std::vector<std::uint16_t> Amplitudes;
  std::vector<std::uint8_t> ReturnNumbers;
  std::vector<std::uint8_t> NumbersOfReturns;
  std::vector<std::uint8_t> Classes;
  std::vector<std::uint8_t> Incidences;
  std::vector<std::uint32_t> Colors; ///< PackColor(); empty until a block has some
  std::int64_t PulseBase = 0;
  double TimeBase = 0.0;
  double FirstTime; ///< [s], NaN: no point has a time
  double LastTime;
  bool IsInTimeOrder = true;
  double Bounds[6]; ///< [m], less the origin

  CloudChunk();
  vtkIdType GetSize() const { return static_cast<vtkIdType>(this->Tags.size()); }
  const float* GetXyz() const { return this->Xyz->GetPointer(0); }
  double GetTime(vtkIdType i) const
  {
    return this->TimeBase + static_cast<double>(this->Times[static_cast<std::size_t>(i)]);
  }
  std::size_t GetMemorySize() const;
  void Squeeze();
};

struct CloudBlock;

/**
 * Grows by blocks of echoes. Positions are floats relative to an origin; times are floats relative
 * to the chunk's first, so exact to 2^-24 of the time of 131,072 points: microseconds in a day-long
 * run. Not thread-safe: append and draw in one thread.
 */
class Cloud
{
public:
  /// Sets the origin of the coordinates [m], before any data. Default: the first point, rounded.
  bool SetOrigin(const Vec3& origin);
  const Vec3& GetOrigin() const { return this->Origin; }

  /**
   * Appends the points of a block with the arrays of vtkHeliosScanner or vtkHeliosLASReader that
   * are present (Intensity replaces a missing Amplitude). Points that are not finite are skipped
   * and counted.
   */
  void Append(vtkPolyData* echoes);

  void Clear();

  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }
  vtkIdType GetNumberOfDroppedPoints() const { return this->NumberOfDropped; }

  /// Returns whether any block had this column.
  bool Has(CloudColumn column) const { return this->Present[static_cast<int>(column)]; }

  /// Returns whether amplitudes are raw file values (Intensity), not watts.
  bool HasRawAmplitudes() const { return this->RawAmplitudes; }

  /// Gets world bounds x0 x1 y0 y1 z0 z1 [m]; false without points.
  bool GetBounds(double bounds[6]) const;

  /// Gets the first and last GPS time [s]; false without points.
  bool GetTimeRange(double range[2]) const;

  /// Returns the point of a row in [0, number of points).
  Echo GetEcho(vtkIdType row) const;

  /// Values of a column for points [begin, end) of a chunk; height is world z [m].
  void GetValues(const CloudChunk& chunk, CloudColumn column, vtkIdType begin, vtkIdType end,
    double* values) const;

  const std::vector<std::unique_ptr<CloudChunk>>& GetChunks() const { return this->Chunks; }

  /// Returns the name of a part in the field data of the blocks; empty: unknown.
  std::string GetPartName(int part) const;
  /// Returns the name of a material in that data; empty: unknown.
  std::string GetMaterialName(int material) const;

  /// Finds the chunk that contains a row.
  const CloudChunk& FindChunk(vtkIdType row) const;

  /// Returns the memory in bytes, capacity included.
  std::size_t GetMemorySize() const;

private:
  struct Tag
  {
    int Leg, Part, Material;
    bool operator==(const Tag& b) const
    {
      return this->Leg == b.Leg && this->Part == b.Part && this->Material == b.Material;
    }
  };
  struct TagHash
  {
    std::size_t operator()(const Tag& tag) const;
  };

  void AppendRows(vtkPolyData* echoes, vtkIdType begin, vtkIdType stop);
  void AppendRun(const CloudBlock& block, vtkIdType begin, vtkIdType end);
  CloudChunk& GetOpenChunk(const CloudBlock& block, vtkIdType row);
  void AppendPlaces(CloudChunk& chunk, const CloudBlock& block, vtkIdType begin, vtkIdType end);
  void AppendTimes(CloudChunk& chunk, const CloudBlock& block, vtkIdType begin, vtkIdType end);
  void AppendColors(CloudChunk& chunk, const CloudBlock& block, vtkIdType begin, vtkIdType end);
  void AppendTags(CloudChunk& chunk, const CloudBlock& block, vtkIdType begin, vtkIdType end);
  std::uint32_t GetTag(const Tag& tag);

  Vec3 Origin{ 0.0, 0.0, 0.0 };
  bool HasOrigin = false;
  bool Present[NumberOfCloudColumns] = {};
  bool RawAmplitudes = false;
  vtkIdType NumberOfPoints = 0;
  vtkIdType NumberOfDropped = 0;
  std::vector<std::unique_ptr<CloudChunk>> Chunks;
  std::vector<Tag> Tags;
  vtkSmartPointer<vtkStringArray> PartNames,
    MaterialNames; // names of the latest block that has them
  std::unordered_map<Tag, std::uint32_t, TagHash> TagRows;
  std::uint32_t LastTag = 0;
};

} // namespace helios::viewer

#endif
