// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The numbers of an accessor of a glTF document.

#ifndef heliosGltfAccessor_h
#define heliosGltfAccessor_h

#include "heliosStatus.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Json
{
class Value;
}

namespace helios
{

class GltfDocument;

/// Elements of one to four numbers, or of sixteen; integers that are normalized are fractions.
struct GltfNumbers
{
  std::vector<double> Values;
  int Components = 1;

  std::int64_t GetCount() const
  {
    return static_cast<std::int64_t>(this->Values.size()) / this->Components;
  }
};

/// Reads an accessor, sparse ones, too. The type is one of SCALAR, VEC2, VEC3, VEC4 and MAT4; value is its index,
/// at a JSON path.
Status ReadAccessor(GltfDocument& document, const Json::Value& value, const std::string& where,
  const std::string& type, GltfNumbers& numbers);

} // namespace helios

#endif
