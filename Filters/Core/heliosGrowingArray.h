// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Growable storage for values, in the array that a filter passes on.

#ifndef heliosGrowingArray_h
#define heliosGrowingArray_h

#include <vtkNew.h>
#include <vtkType.h>

#include <new>

namespace helios
{

/// A VTK array that grows by doubling, with raw pointer access.
template <typename ArrayT>
class GrowingArray
{
public:
  using T = typename ArrayT::ValueType;

  /// Appends uninitialized values, which the caller writes.
  T* Append(vtkIdType count)
  {
    if (this->Size + count > this->Capacity)
    {
      this->Grow(count);
    }
    T* values = this->Values + this->Size;
    this->Size += count;
    return values;
  }

  vtkIdType GetSize() const { return this->Size; }
  T* GetValues() { return this->Values; }
  void Truncate(vtkIdType size) { this->Size = size; }

  /// Returns the array, shrunk to the values written.
  ArrayT* Finish(int components)
  {
    this->Array->Resize(this->Size);
    this->Array->SetNumberOfComponents(components);
    this->Array->SetNumberOfTuples(this->Size / components);
    return this->Array;
  }

private:
  void Grow(vtkIdType count)
  {
    if (!this->Array->Resize(this->Size + count)) // at least doubles the capacity
    {
      throw std::bad_alloc();
    }
    this->Capacity = this->Array->GetSize();
    this->Values = this->Array->GetPointer(0);
  }

  vtkNew<ArrayT> Array;
  T* Values = nullptr;
  vtkIdType Size = 0;
  vtkIdType Capacity = 0;
};

} // namespace helios

#endif
