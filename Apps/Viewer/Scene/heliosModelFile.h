// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the platform and scanner models that surveys name.

#ifndef heliosModelFile_h
#define heliosModelFile_h

#include <vtkSmartPointer.h>

#include <map>
#include <string>

class vtkPolyData;

namespace helios
{
struct ModelData;
}

namespace helios::viewer
{

/// Each file is read once. OBJ, in metres, axes as in the file: x right, y forward, z up.
class ModelFiles
{
public:
  /// Returns the model, with cell colours if it has several materials; null if none is set or it
  /// cannot be shown.
  vtkPolyData* Find(const ModelData& model);

  /// Returns why a model that is set cannot be shown; empty: it can.
  std::string GetProblem(const ModelData& model);

private:
  struct Entry
  {
    vtkSmartPointer<vtkPolyData> Model;
    std::string Problem;
  };

  const Entry& Get(const ModelData& model);

  std::map<std::string, Entry> Known; // by survey entry
};

} // namespace helios::viewer

#endif
