// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Ids that are zero without taking memory.

#ifndef heliosZeroIds_h
#define heliosZeroIds_h

#include <vtkAbstractArray.h>
#include <vtkIntArray.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <cstdlib>
#include <new>

namespace helios
{

/// Returns zeros: pages of a large array that are never written are not in memory.
inline vtkSmartPointer<vtkIntArray> MakeZeroIds(const char* name, vtkIdType count)
{
  auto ids = vtkSmartPointer<vtkIntArray>::New();
  ids->SetName(name);
  if (count > 0)
  {
    void* zeros = std::calloc(static_cast<std::size_t>(count), sizeof(int));
    if (!zeros)
    {
      throw std::bad_alloc();
    }
    ids->SetArray(static_cast<int*>(zeros), count, 0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  }
  return ids;
}

} // namespace helios

#endif
