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

class vtkPolyData;

namespace helios
{

class InstanceParts
{
public:
  /**
   * Sets the connections, and the ids of those that are parts (negative: the number of parts before
   * them), and the instances. Errors: prototypes that are not connections with triangles, ids that
   * do not ascend or are given twice.
   */
  Status Set(const PartList& parts, const std::vector<int>& ids, vtkPolyData* instances);

  bool IsPrototype(std::size_t connection) const { return this->Numbers[connection] >= 0; }

  /// The connections that are parts; null for the others.
  const PartList& GetParts() const { return this->Parts; }
  int GetPartId(std::size_t connection) const { return this->Ids[connection]; }

  /// The connections that are prototypes, in their new order.
  const std::vector<std::size_t>& GetPrototypes() const { return this->Prototypes; }

  /// All connections in the order in which parts use them first.
  std::vector<std::size_t> GetOrder() const;

  /// The instances with PrototypeIds, PartIds and FirstCellIds of the scene.
  vtkSmartPointer<vtkPolyData> MakeInstances() const;

  int GetNumberOfParts() const { return this->NumberOfParts; }
  int GetInstancePart(vtkIdType instance) const
  {
    return this->InstanceIds[static_cast<std::size_t>(instance)];
  }

private:
  Status FindPrototypes(const PartList& parts);
  Status SetIds(const std::vector<int>& ids);

  PartList All;
  PartList Parts;
  vtkPolyData* Instances = nullptr;
  std::vector<int> Numbers; ///< of connections as prototypes; -1: parts
  std::vector<std::size_t> Prototypes;
  std::vector<int> Ids;          ///< of the connections that are parts
  std::vector<int> InstanceIds;  ///< of the instances
  std::vector<std::size_t> Uses; ///< the connections of the instances
  int NumberOfParts = 0;
};

} // namespace helios

#endif
