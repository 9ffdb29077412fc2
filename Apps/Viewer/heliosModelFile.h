// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What platforms and scanners look like in the files that surveys name for it.

#ifndef heliosModelFile_h
#define heliosModelFile_h

#include <vtkSmartPointer.h>

#include <map>
#include <string>

class vtkPolyData;

namespace helios
{

struct ModelData;

/// Each file is read once. OBJ, in metres and as it stands in the file: x right, y forward, z up.
class ModelFiles
{
public:
  /// The model, with colours of its cells where it has several materials; null where none is given or
  /// none can be shown.
  vtkPolyData* Find(const ModelData& model);

  /// Why a model that is given cannot be shown; empty: it can.
  std::string GetProblem(const ModelData& model);

private:
  struct Entry
  {
    vtkSmartPointer<vtkPolyData> Model;
    std::string Problem;
  };

  const Entry& Get(const ModelData& model);

  std::map<std::string, Entry> Known; // by what the survey says
};

} // namespace helios

#endif
