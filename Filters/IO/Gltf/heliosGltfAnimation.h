// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// An animation of a glTF document.

#ifndef heliosGltfAnimation_h
#define heliosGltfAnimation_h

#include "heliosStatus.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace Json
{
class Value;
}

namespace helios
{

class GltfDocument;

/// The values of a node that an animation moves; empty: as in the node.
struct GltfNodePose
{
  std::vector<double> Translation; ///< three numbers
  std::vector<double> Rotation;    ///< four
  std::vector<double> Scale;       ///< three
  std::vector<double> Weights;     ///< weights of morph targets
};

/// The poses of nodes over time, by linear interpolation (rotations: spherical), steps or cubic
/// splines.
class GltfAnimation
{
public:
  /// Reads the animation with a name, or with a number from 0; an empty name: the first one.
  Status Read(GltfDocument& document, const std::string& name);

  /// Returns the time of the last key [s].
  double GetDuration() const { return this->Duration; }

  /// Computes the poses at a time [s]; before its first key and after its last a value stays as there.
  void SetTime(double time);

  /// Returns the pose of a node; null: it is not moved.
  const GltfNodePose* Find(std::int64_t node) const
  {
    const auto found = this->Poses.find(node);
    return found == this->Poses.end() ? nullptr : &found->second;
  }

private:
  enum class Kind
  {
    Linear,
    Step,
    Cubic
  };
  /// The values of one property of a node.
  struct Channel
  {
    std::int64_t Node = 0;
    std::vector<double> GltfNodePose::*Target = nullptr;
    Kind Interpolation = Kind::Linear;
    std::vector<double> Times;
    std::vector<double> Values; ///< values of each key; cubic: tangent, value, tangent
    std::size_t Size = 0;       ///< numbers of a value
  };

  static Status FindNumber(
    const GltfDocument& document, const std::string& name, std::int64_t& number);
  Status ReadChannel(GltfDocument& document, std::int64_t animation, unsigned index);
  static Status ReadSampler(
    GltfDocument& document, const Json::Value& sampler, const std::string& where, Channel& channel);
  static std::vector<double> Interpolate(const Channel& channel, double time);

  std::vector<Channel> Channels;
  std::map<std::int64_t, GltfNodePose> Poses;
  double Duration = 0.0;
};

} // namespace helios

#endif
