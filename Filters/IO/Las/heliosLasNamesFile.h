// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The file of names of a LAS file that is written block by block.

#ifndef heliosLasNamesFile_h
#define heliosLasNamesFile_h

#include "heliosStatus.h"

#include <vtkNew.h>
#include <vtkType.h>

#include <string>
#include <vector>

class vtkFieldData;

namespace helios
{

struct FileBlock;

/// Names of the first block are written beside the .part, so that a resumed run has them, too; the
/// file of names has its name and its number of points when the LAS file is complete.
class LasNamesFile
{
public:
  LasNamesFile();
  ~LasNamesFile();

  /// Begins the names of a LAS file; resumed: those that are there belong to it.
  void Begin(const std::string& path, bool isResumed);

  /// Adds the names in the field data of a block; a later one may have more of them.
  Status Add(vtkFieldData* fields);

  /// Writes the names of a file with this number of points, or removes the names of an earlier
  /// file.
  Status Finish(vtkIdType points);

  /// Appends the finished file, if there is one, to the blocks that are safe.
  void CollectBlock(std::vector<FileBlock>& blocks) const;

private:
  std::string GetPart() const;

  std::string Path; // LAS file
  bool IsResumed = false;
  vtkIdType Count = 0; // number of names in the blocks
  vtkNew<vtkFieldData> Names;
};

} // namespace helios

#endif
