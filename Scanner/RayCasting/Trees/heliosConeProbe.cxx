// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosConeProbe.h"

#include "heliosBeamTree.h"
#include "heliosConeCollector.h"
#include "heliosConeGroup.h"
#include "heliosConeTest.h"
#include "heliosSceneTree.h"
#include "heliosTriangleMesh.h"

namespace helios
{

namespace
{

class TreeProbe : public ConeProbe
{
public:
  explicit TreeProbe(const SceneTree& scene)
    : Tree(&scene)
  {
  }

  TreeProbe(const TriangleMesh& mesh, StopCheck& check)
    : OwnTree(std::make_unique<SceneTree>())
    , Tree(this->OwnTree.get())
  {
    this->OwnTree->Build(mesh, check);
  }

  vtkHeliosConeHit Probe(const double origin[3], const double axis[3], double tanHalfAngle,
    const PlaneLimits& limits, ConeLayer* layer) const override
  {
    return ConeTest(origin, axis, tanHalfAngle, limits).Run(*this->Tree, layer, nullptr);
  }

  vtkHeliosConeHit ProbeGroup(const double origin[3], const double axis[3], double tanHalfAngle,
    const PlaneLimits& limits, ConeLayer* layer, const ConeGroup& group) const override
  {
    return ConeTest(origin, axis, tanHalfAngle, limits).Run(*this->Tree, layer, &group);
  }

  bool FindGroup(const ConeAxis* cones, std::size_t count, double tanHalfAngle,
    const MomentSpan& span, ConeGroup& group) const override
  {
    return group.Find(*this->Tree, cones, count, tanHalfAngle, span);
  }

  bool Collect(const double origin[3], const double axis[3], double tanHalfAngle, double nearest,
    std::size_t maximum, ConeView& view) const override
  {
    return ConeCollector(origin, axis, tanHalfAngle).Run(*this->Tree, nearest, maximum, view);
  }

  std::size_t GetMemorySize() const override
  {
    return this->OwnTree ? this->OwnTree->GetMemorySize() : 0;
  }

private:
  std::unique_ptr<SceneTree> OwnTree;
  const SceneTree* Tree;
};

} // namespace

std::unique_ptr<ConeProbe> MakeConeProbe(const SceneTree& scene)
{
  return std::make_unique<TreeProbe>(scene);
}

std::unique_ptr<ConeProbe> MakeConeProbe(const TriangleMesh& mesh, StopCheck& check)
{
  const bool isSmall = mesh.GetNumberOfTriangles() <= BeamTree::MaximumTriangles;
  return isSmall ? std::make_unique<TreeProbe>(mesh, check) : nullptr;
}

} // namespace helios
