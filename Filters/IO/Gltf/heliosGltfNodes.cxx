// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGltfNodes.h"

#include "heliosGltfAccessor.h"
#include "heliosGltfAnimation.h"

#include <json/json.h>

#include <algorithm>

namespace helios
{

namespace
{

constexpr const char* Instancing = "EXT_mesh_gpu_instancing";
constexpr const char* Visibility = "KHR_node_visibility";

bool IsRotation(const double* q)
{
  return std::isfinite(2.0 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]));
}

} // namespace

//------------------------------------------------------------------------------
Status GltfNodes::Find(std::vector<GltfPlacement>& placements)
{
  this->Placements = &placements;
  this->IsVisited.assign(static_cast<std::size_t>(this->Document.GetCount("nodes")), false);
  std::vector<Visit> visits;
  Status status = this->FindRoots(visits);
  while (status.IsOk() && !visits.empty())
  {
    const Visit visit = visits.back();
    visits.pop_back();
    status = this->AddNode(visit, visits);
  }
  return status;
}

//------------------------------------------------------------------------------
Status GltfNodes::FindRoots(std::vector<Visit>& visits) const
{
  if (this->Document.GetCount("scenes") > 0)
  {
    const Json::Value& given = GetMember(this->Document.GetRoot(), "scene");
    std::int64_t scene = 0;
    const Status status =
      given.isNull() ? Status() : this->Document.FindIndex("scenes", given, "scene", scene);
    return status.IsOk()
      ? this->AddNodes(GetMember(this->Document.GetElement("scenes", scene), "nodes"),
          ElementPath("scenes", scene) + ".nodes", {}, visits)
      : status;
  }
  this->AddParentless(visits);
  return {};
}

//------------------------------------------------------------------------------
void GltfNodes::AddParentless(std::vector<Visit>& visits) const
{
  const std::int64_t count = this->Document.GetCount("nodes");
  std::vector<bool> isChild(static_cast<std::size_t>(count), false);
  for (std::int64_t i = 0; i < count; ++i)
  {
    const Json::Value& children = GetMember(this->Document.GetElement("nodes", i), "children");
    for (Json::ArrayIndex k = 0; children.isArray() && k < children.size(); ++k)
    {
      if (const std::int64_t child = ReadIndex(children[k], count); child >= 0)
      {
        isChild[static_cast<std::size_t>(child)] = true;
      }
    }
  }
  for (std::int64_t i = count; i-- > 0;)
  {
    if (!isChild[static_cast<std::size_t>(i)])
    {
      visits.emplace_back(i, GltfTransform());
    }
  }
}

//------------------------------------------------------------------------------
/// Adds nodes in reverse order: the last one is visited first.
Status GltfNodes::AddNodes(const Json::Value& list, const std::string& where,
  const GltfTransform& parent, std::vector<Visit>& visits) const
{
  for (Json::ArrayIndex i = list.isArray() ? list.size() : 0; i-- > 0;)
  {
    std::int64_t node = 0;
    const Status status =
      this->Document.FindIndex("nodes", list[i], ElementPath(where.c_str(), i), node);
    if (!status.IsOk())
    {
      return status;
    }
    visits.emplace_back(node, parent);
  }
  return {};
}

//------------------------------------------------------------------------------
Status GltfNodes::AddNode(const Visit& visit, std::vector<Visit>& visits)
{
  const std::int64_t index = visit.first;
  const std::string where = ElementPath("nodes", index);
  if (this->IsVisited[static_cast<std::size_t>(index)])
  {
    return this->Document.Fail(where,
      "is reached twice, and a node has one parent at most; copy it, or remove one reference");
  }
  this->IsVisited[static_cast<std::size_t>(index)] = true;
  const Json::Value& node = this->Document.GetElement("nodes", index);
  GltfTransform local;
  bool isVisible = true;
  Status status = this->ReadVisibility(node, where, isVisible);
  status = status.IsOk() ? this->ReadPlace(node, index, local) : status;
  if (!status.IsOk() || !isVisible)
  {
    return status;
  }
  GltfPlacement placement{ 0, index, visit.second * local };
  if (!placement.Place.IsFinite())
  {
    return this->Document.Fail(where, "is moved to infinity; correct its matrix, or its parents'");
  }
  if (this->Animation)
  {
    this->Places[index] = placement.Place;
  }
  const Json::Value& mesh = GetMember(node, "mesh");
  const Json::Value& instances =
    GetMember(GetMember(GetMember(node, "extensions"), Instancing), "attributes");
  if (!mesh.isNull())
  {
    status = this->Document.FindIndex("meshes", mesh, where + ".mesh", placement.Mesh);
    status = status.IsOk() ? this->ReadWeights(node, placement) : status;
    const Json::Value& skin = GetMember(node, "skin");
    if (status.IsOk() && this->Animation && !skin.isNull())
    {
      status = this->Document.FindIndex("skins", skin, where + ".skin", placement.Skin);
    }
    if (status.IsOk() && instances.isObject())
    {
      status = this->AddInstances(
        instances, where + ".extensions." + Instancing + ".attributes", placement);
    }
    else if (status.IsOk())
    {
      this->Placements->push_back(placement);
    }
  }
  return status.IsOk()
    ? this->AddNodes(GetMember(node, "children"), where + ".children", placement.Place, visits)
    : status;
}

//------------------------------------------------------------------------------
Status GltfNodes::ReadVisibility(
  const Json::Value& node, const std::string& where, bool& isVisible) const
{
  const Json::Value& value =
    GetMember(GetMember(GetMember(node, "extensions"), Visibility), "visible");
  isVisible = !value.isBool() || value.asBool();
  return value.isNull() || value.isBool()
    ? Status()
    : this->Document.Fail(where + ".extensions." + Visibility + ".visible",
        "is " + Describe(value) + ", not true or false; correct it");
}

//------------------------------------------------------------------------------
/// Reads the weights of morph targets of the node, else of its mesh.
Status GltfNodes::ReadWeights(const Json::Value& node, GltfPlacement& placement) const
{
  const GltfNodePose* pose = this->Animation ? this->Animation->Find(placement.Node) : nullptr;
  if (pose && !pose->Weights.empty())
  {
    placement.Weights = pose->Weights;
    return {};
  }
  const Json::Value& own = GetMember(node, "weights");
  const Json::Value& given =
    own.isNull() ? GetMember(this->Document.GetElement("meshes", placement.Mesh), "weights") : own;
  if (given.isNull())
  {
    return {};
  }
  placement.Weights.resize(given.isArray() ? given.size() : 0);
  if (!given.isArray() || !ReadNumbers(given, placement.Weights.data(), placement.Weights.size()))
  {
    return this->Document.Fail(own.isNull() ? ElementPath("meshes", placement.Mesh) + ".weights"
                                            : ElementPath("nodes", placement.Node) + ".weights",
      "is " + Describe(given) + ", not a list of finite numbers; correct it");
  }
  const auto& all = placement.Weights;
  if (std::all_of(all.begin(), all.end(), [](double weight) { return weight == 0.0; }))
  {
    placement.Weights.clear();
  }
  return {};
}

//------------------------------------------------------------------------------
/// Reads a matrix, or translation, rotation and scale.
Status GltfNodes::ReadPlace(const Json::Value& node, std::int64_t index, GltfTransform& place) const
{
  const std::string where = ElementPath("nodes", index);
  double matrix[16];
  double t[3] = { 0, 0, 0 };
  double q[4] = { 0, 0, 0, 1 };
  double s[3] = { 1, 1, 1 };
  const struct
  {
    const char* Name;
    double* Values;
    std::size_t Count;
  } members[] = { { "matrix", matrix, 16 }, { "translation", t, 3 }, { "rotation", q, 4 },
    { "scale", s, 3 } };
  for (const auto& member : members)
  {
    const Json::Value& value = GetMember(node, member.Name);
    if (!value.isNull() && !ReadNumbers(value, member.Values, member.Count))
    {
      return this->Document.Fail(where + '.' + member.Name,
        "is " + Describe(value) + ", not " + std::to_string(member.Count) + " numbers; correct it");
    }
  }
  if (const GltfNodePose* pose = this->Animation ? this->Animation->Find(index) : nullptr)
  {
    std::copy(pose->Translation.begin(), pose->Translation.end(), t);
    std::copy(pose->Rotation.begin(), pose->Rotation.end(), q);
    std::copy(pose->Scale.begin(), pose->Scale.end(), s);
  }
  if (!IsRotation(q))
  {
    return this->Document.Fail(where + ".rotation", "has no length; give a unit quaternion");
  }
  place = GetMember(node, "matrix").isNull() ? GltfTransform::FromParts(t, q, s)
                                             : GltfTransform::FromColumns(matrix);
  return {};
}

//------------------------------------------------------------------------------
Status GltfNodes::AddInstances(
  const Json::Value& attributes, const std::string& where, const GltfPlacement& node)
{
  std::int64_t count = -1;
  std::vector<double> t;
  std::vector<double> q;
  std::vector<double> s;
  Status status = this->ReadAttribute(attributes, "TRANSLATION", "VEC3", where, t, count);
  status =
    status.IsOk() ? this->ReadAttribute(attributes, "ROTATION", "VEC4", where, q, count) : status;
  status =
    status.IsOk() ? this->ReadAttribute(attributes, "SCALE", "VEC3", where, s, count) : status;
  const double zero[3] = { 0, 0, 0 };
  const double one[3] = { 1, 1, 1 };
  const double none[4] = { 0, 0, 0, 1 };
  for (std::size_t i = 0; status.IsOk() && static_cast<std::int64_t>(i) < count; ++i)
  {
    const double* rotation = q.empty() ? none : q.data() + 4 * i;
    GltfPlacement placement = node;
    placement.Place = node.Place *
      GltfTransform::FromParts(
        t.empty() ? zero : t.data() + 3 * i, rotation, s.empty() ? one : s.data() + 3 * i);
    if (!IsRotation(rotation) || !placement.Place.IsFinite())
    {
      return this->Document.Fail(where,
        "instance " + std::to_string(i) +
          " has no length of rotation, or is not finite; correct it");
    }
    this->Placements->push_back(placement);
  }
  return status;
}

//------------------------------------------------------------------------------
/// Reads an attribute that may be missing; all attributes have the same count.
Status GltfNodes::ReadAttribute(const Json::Value& attributes, const char* name, const char* type,
  const std::string& where, std::vector<double>& values, std::int64_t& count)
{
  const Json::Value& accessor = GetMember(attributes, name);
  if (accessor.isNull())
  {
    return {};
  }
  GltfNumbers numbers;
  const std::string path = where + '.' + name;
  const Status status = ReadAccessor(this->Document, accessor, path, type, numbers);
  if (status.IsOk() && count >= 0 && numbers.GetCount() != count)
  {
    return this->Document.Fail(path,
      "has " + std::to_string(numbers.GetCount()) + " elements, and others have " +
        std::to_string(count) + "; write the file again");
  }
  count = numbers.GetCount();
  values = std::move(numbers.Values);
  return status;
}

} // namespace helios
