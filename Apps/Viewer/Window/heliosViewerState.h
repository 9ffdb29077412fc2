// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The viewer state as JSON: for scripts that drive it, and for tests.

#ifndef heliosViewerState_h
#define heliosViewerState_h

#include <json/forwards.h>

#include <string>

namespace helios::viewer
{

class Viewer;

class ViewerState
{
public:
  explicit ViewerState(Viewer& viewer)
    : Owner(viewer)
  {
  }

  Json::Value Describe() const;

  /// Replaces a file atomically, so that it is never read half written; an empty name: no file.
  void Write(const std::string& fileName) const;

private:
  Json::Value DescribeCamera() const;
  Json::Value DescribeTime() const;
  Json::Value DescribeCloud() const;

  Viewer& Owner;
};

} // namespace helios::viewer

#endif
