// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a scene file while it is read.

#ifndef heliosSceneMesh_h
#define heliosSceneMesh_h

#include "heliosGrowingArray.h"
#include "heliosMaterialTable.h"
#include "heliosTextFile.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkTypeInt32Array.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

/**
 * Extent of a scene [m] beyond which a vertex is an outlier: half the circumference of the Earth is
 * 2e7, and no projected or geocentric scene is wider than half of that.
 */
constexpr double LargestExtent = 1e7;

/// Maximum number of corners (and vertices) of 32-bit cells.
constexpr std::int64_t MaximumCorners = std::numeric_limits<vtkTypeInt32>::max();

/// Vertices, triangles and materials; after reading, call the functions in their order.
class VTKHELIOSFILTERSIO_EXPORT SceneMesh
{
public:
  GrowingArray<vtkDoubleArray> Points;     ///< x y z per vertex
  GrowingArray<vtkTypeInt32Array> Corners; ///< three vertices per triangle, from 0
  GrowingArray<vtkIntArray> MaterialIds;   ///< row of Materials per triangle
  /// u v of the three corners per triangle; empty if not read
  GrowingArray<vtkFloatArray> TextureCoordinates;
  GrowingArray<vtkIntArray> PartIds; ///< index into PartNames per triangle; empty: no parts
  MaterialTable Materials;
  std::vector<std::string> Notes; ///< sentences on triangles that were cut

  /// The faces of a file, as they are in it, if KeepsAll is set: frames of a mesh have equal ones.
  struct FaceList
  {
    vtkIdType Count = 0;
    std::uint64_t Hash = 14695981039346656037u; ///< FNV-1a of their vertices

    template <typename RangeT>
    void Add(const RangeT& vertices)
    {
      ++this->Count;
      for (const auto vertex : vertices)
      {
        this->AddNumber(static_cast<std::uint64_t>(vertex));
      }
      this->AddNumber(~std::uint64_t(0));
    }

  private:
    void AddNumber(std::uint64_t number) { this->Hash = (this->Hash ^ number) * 1099511628211u; }
  };
  FaceList Faces;
  bool KeepsAll = false; ///< whether no triangle and no vertex is dropped

  /// Triangles from here on are of a part with a name: of each, PartIds; call it before the first.
  void StartPart(const std::string& name) { this->PartNames.push_back(name); }

  void AddPoint(double x, double y, double z);
  void AddTriangle(vtkTypeInt32 a, vtkTypeInt32 b, vtkTypeInt32 c, int material);
  vtkIdType GetNumberOfPoints() const { return this->Points.GetSize() / 3; }
  vtkIdType GetNumberOfTriangles() const { return this->MaterialIds.GetSize(); }

  /**
   * Drops degenerate triangles: those whose normal is within the rounding error of their
   * coordinates. Warns with their number.
   */
  void DropFlatTriangles(const std::string& path, TextReport& report);

  /// Warns about a vertex far from the others; its place in the file, if known, starts the message.
  void CheckExtent(const std::string& path, TextReport& report,
    const std::function<std::string(vtkIdType)>& findPlace = {});

  /// Drops vertices that no triangle uses.
  void DropUnusedPoints();

  /// Converts y up to z up.
  void TurnUp();

  /// Moves the arrays to a scene.
  void MoveTo(vtkPolyData* scene);

  vtkIdType GetNumberOfDroppedTriangles() const { return this->DroppedTriangles; }

private:
  std::vector<std::string> PartNames;
  std::vector<unsigned char> IsUsed; // per vertex
  vtkIdType DroppedTriangles = 0;
};

} // namespace helios

#endif
