// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Which connections of a composer are parts, and which are prototypes of instances.

#ifndef heliosInstanceParts_h
#define heliosInstanceParts_h

#include "heliosSceneJoin.h"
#include "heliosStatus.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <vector>

class vtkDataSet;
class vtkPolyData;

namespace helios
{

/// An input of a composer: a mesh, or a raster of heights.
struct Connection
{
  vtkDataSet* Data = nullptr; ///< null: without triangles
  vtkIdType Triangles = 0;

  /// Sets a mesh or a raster. Errors: cells that are not triangles, instances, invalid rasters.
  Status Set(vtkDataSet* data);

  vtkPolyData* GetMesh() const; ///< null: a raster, or without triangles
  bool IsRaster() const { return this->Data && !this->GetMesh(); }
};
using ConnectionList = std::vector<Connection>;

/// Returns the meshes; null for the others.
PartList GetMeshes(const ConnectionList& connections);

/// A raster that no instance uses is a part, and an instance at its own place.
class InstanceParts
{
public:
  /**
   * Sets the connections, and the ids of those that are parts (negative: the number of parts before
   * them), and the instances. Errors: prototypes that are not connections with triangles, ids that
   * do not ascend or are given twice.
   */
  Status Set(
    const ConnectionList& connections, const std::vector<int>& ids, vtkPolyData* instances);

  bool IsPrototype(std::size_t connection) const { return this->Numbers[connection] >= 0; }

  /// Returns the connections that are meshes of the scene; null for the others.
  const PartList& GetParts() const { return this->Parts; }

  /// Returns the id of a connection that is a part, else -1.
  int GetPartId(std::size_t connection) const { return this->Ids[connection]; }

  /// Returns the connections that are prototypes, in their new order.
  const std::vector<std::size_t>& GetPrototypes() const { return this->Prototypes; }

  /// Returns all connections in the order in which parts use them first.
  std::vector<std::size_t> GetOrder() const;

  /// Returns the instances with PrototypeIds, PartIds and FirstCellIds of the scene, and
  /// MaterialIds of instances of rasters, by connection, if there are any.
  vtkSmartPointer<vtkPolyData> MakeInstances(const std::vector<int>& materials) const;

  int GetNumberOfParts() const { return this->NumberOfParts; }

  /// Returns the part of a given instance.
  int GetInstancePart(vtkIdType instance) const
  {
    return this->GivenIds[static_cast<std::size_t>(instance)];
  }

private:
  /// An instance of the scene.
  struct Row
  {
    vtkIdType Given; ///< number of the given instance; -1: a raster at its own place
    std::size_t Connection;
    int Part;
  };

  Status FindPrototypes();
  void AddPrototype(std::size_t connection);
  Status SetIds(const std::vector<int>& ids);
  vtkSmartPointer<vtkPolyData> CopyInstances() const;

  ConnectionList All;
  PartList Parts;
  vtkPolyData* Instances = nullptr; ///< given instances; null: none
  std::vector<int> Numbers;         ///< number of each connection as a prototype; -1: part
  std::vector<std::size_t> Prototypes;
  std::vector<int> Ids;          ///< id of each connection that is a part
  std::vector<int> GivenIds;     ///< ids of the given instances
  std::vector<std::size_t> Uses; ///< the connections of the given instances
  std::vector<Row> Rows;         ///< all instances
  int NumberOfParts = 0;
};

} // namespace helios

#endif
