// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGltfSkin.h"

#include "heliosGltfAccessor.h"
#include "heliosGltfDocument.h"
#include "heliosGltfNodes.h"

#include <json/json.h>

#include <cmath>

namespace helios
{

//------------------------------------------------------------------------------
std::array<double, 3> GltfWeights::Apply(
  std::size_t vertex, const double* p, const std::vector<GltfTransform>& joints) const
{
  std::array<double, 3> sum{};
  for (std::size_t i = vertex > 0 ? this->Ends[vertex - 1] : 0; i < this->Ends[vertex]; ++i)
  {
    const Influence& each = this->Influences[i];
    const std::array<double, 3> q = joints[static_cast<std::size_t>(each.Joint)].Apply(p);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      sum[axis] += each.Weight * q[axis];
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
Status ReadGltfWeights(GltfDocument& document, const Json::Value& primitive,
  const std::string& path, std::int64_t vertices, GltfWeights& weights)
{
  const Json::Value& attributes = GetMember(primitive, "attributes");
  std::vector<GltfNumbers> joints, shares;
  for (int set = 0;; ++set)
  {
    for (const char* name : { "JOINTS_", "WEIGHTS_" })
    {
      const std::string attribute = name + std::to_string(set);
      const std::string where = path + ".attributes." + attribute;
      const Json::Value& value = GetMember(attributes, attribute.c_str());
      if (value.isNull() && (set == 0 || joints.size() > shares.size()))
      {
        return document.Fail(
          where, "is missing, but a skin moves the mesh; paint weights, or remove it");
      }
      if (value.isNull())
      {
        break;
      }
      std::vector<GltfNumbers>& all = name[0] == 'J' ? joints : shares;
      all.emplace_back();
      const Status status = ReadAccessor(document, value, where, "VEC4", all.back());
      if (!status.IsOk())
      {
        return status;
      }
      if (all.back().GetCount() != vertices)
      {
        return document.Fail(where,
          "has " + std::to_string(all.back().GetCount()) + " elements, and the primitive has " +
            std::to_string(vertices) + " vertices; write the file again");
      }
    }
    if (joints.size() <= static_cast<std::size_t>(set))
    {
      break;
    }
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices); ++i)
  {
    const std::size_t first = weights.Influences.size();
    double sum = 0.0;
    for (std::size_t k = 0; k < 4 * joints.size(); ++k)
    {
      const double share = shares[k / 4].Values[4 * i + k % 4];
      if (share != 0.0)
      {
        weights.Influences.push_back(
          { static_cast<std::int64_t>(joints[k / 4].Values[4 * i + k % 4]), share });
        sum += share;
      }
    }
    if (!(sum > 0.0) || !std::isfinite(sum))
    {
      return document.Fail(path + ".attributes.WEIGHTS_0",
        "vertex " + std::to_string(i) + " has no weights; paint its weights");
    }
    for (std::size_t k = first; k < weights.Influences.size(); ++k)
    {
      weights.Influences[k].Weight /= sum;
    }
    weights.Ends.push_back(weights.Influences.size());
  }
  return {};
}

//------------------------------------------------------------------------------
Status FindGltfJoints(GltfDocument& document, std::int64_t number, const GltfNodes& nodes,
  std::vector<GltfTransform>& joints)
{
  const Json::Value& skin = document.GetElement("skins", number);
  const Json::Value& list = GetMember(skin, "joints");
  const std::string path = ElementPath("skins", number);
  if (!list.isArray() || list.empty())
  {
    return document.Fail(path + ".joints", "has no joints; write the file again");
  }
  GltfNumbers inverse;
  const Json::Value& matrices = GetMember(skin, "inverseBindMatrices");
  Status status = matrices.isNull()
    ? Status()
    : ReadAccessor(document, matrices, path + ".inverseBindMatrices", "MAT4", inverse);
  if (status.IsOk() && !matrices.isNull() &&
    inverse.GetCount() < static_cast<std::int64_t>(list.size()))
  {
    status = document.Fail(path + ".inverseBindMatrices",
      "has " + std::to_string(inverse.GetCount()) + " matrices for " + std::to_string(list.size()) +
        " joints; write the file again");
  }
  for (Json::ArrayIndex i = 0; status.IsOk() && i < list.size(); ++i)
  {
    std::int64_t node = 0;
    const std::string where = ElementPath((path + ".joints").c_str(), i);
    status = document.FindIndex("nodes", list[i], where, node);
    const GltfTransform* place = status.IsOk() ? nodes.FindPlace(node) : nullptr;
    if (status.IsOk() && !place)
    {
      status = document.Fail(
        where, "is " + ElementPath("nodes", node) + ", which is not in the scene; add it");
    }
    if (place)
    {
      joints.push_back(matrices.isNull()
          ? *place
          : *place * GltfTransform::FromColumns(inverse.Values.data() + 16 * std::size_t(i)));
    }
  }
  return status;
}

} // namespace helios
