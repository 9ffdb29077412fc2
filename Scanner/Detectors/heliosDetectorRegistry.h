// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The echo detectors that surveys may name: those of vtkHelios, and those of plug-ins.

#ifndef heliosDetectorRegistry_h
#define heliosDetectorRegistry_h

#include "vtkHeliosEchoDetector.h"

#include <vtkSmartPointer.h>

#include <list>
#include <string>

namespace helios
{

struct DetectorKind
{
  std::string Name;
  vtkSmartPointer<vtkHeliosEchoDetector> Prototype;
  std::string File; ///< the plug-in; empty: none
};

/// Returns the known detectors; the first is the default. A list never moves its members.
std::list<DetectorKind>& GetDetectorKinds();

/// Returns a detector by its name, or the default one if the name is empty; null if it is unknown.
DetectorKind* FindDetectorKind(const std::string& name);

/// Adds a detector; false if the prototype is null, or the name is empty, has blanks, or is known.
bool AddDetectorKind(const std::string& name, vtkHeliosEchoDetector* prototype);

/// Removes a detector that was added; false for any other.
bool RemoveDetectorKind(const std::string& name);

} // namespace helios

#endif
