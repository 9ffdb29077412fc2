// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosDetectorRegistry.h"

#include "vtkHeliosConstantFractionDetector.h"
#include "vtkHeliosGaussianDecomposition.h"
#include "vtkHeliosLeadingEdgeDetector.h"
#include "vtkHeliosPeakDetector.h"
#include "vtkHeliosPhotonCountingDetector.h"

#include <algorithm>
#include <iterator>

namespace helios
{
namespace
{

constexpr int NumberOfOwnKinds = 5; // which are not removed

} // namespace

//------------------------------------------------------------------------------
std::list<DetectorKind>& GetDetectorKinds()
{
  static std::list<DetectorKind> kinds = {
    { "peak", vtkSmartPointer<vtkHeliosPeakDetector>::New(), "" },
    { "gaussian", vtkSmartPointer<vtkHeliosGaussianDecomposition>::New(), "" },
    { "cfd", vtkSmartPointer<vtkHeliosConstantFractionDetector>::New(), "" },
    { "leadingEdge", vtkSmartPointer<vtkHeliosLeadingEdgeDetector>::New(), "" },
    { "photonCounting", vtkSmartPointer<vtkHeliosPhotonCountingDetector>::New(), "" },
  };
  return kinds;
}

//------------------------------------------------------------------------------
DetectorKind* FindDetectorKind(const std::string& name)
{
  std::list<DetectorKind>& kinds = GetDetectorKinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(),
    [&name](const DetectorKind& kind) { return name.empty() || kind.Name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
bool AddDetectorKind(const std::string& name, vtkHeliosEchoDetector* prototype)
{
  const bool isValid = prototype && !name.empty() &&
    name.find_first_of(" \t\n") == std::string::npos && !FindDetectorKind(name);
  if (isValid)
  {
    GetDetectorKinds().push_back({ name, prototype, "" });
  }
  return isValid;
}

//------------------------------------------------------------------------------
bool RemoveDetectorKind(const std::string& name)
{
  std::list<DetectorKind>& kinds = GetDetectorKinds();
  const auto found = std::find_if(std::next(kinds.begin(), NumberOfOwnKinds), kinds.end(),
    [&name](const DetectorKind& kind) { return kind.Name == name; });
  const bool isAdded = found != kinds.end();
  if (isAdded)
  {
    kinds.erase(found);
  }
  return isAdded;
}

} // namespace helios
