// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Room for values that come one after another, in the array that a filter hands on.

#ifndef heliosGrowingArray_h
#define heliosGrowingArray_h

#include <vtkNew.h>
#include <vtkType.h>

#include <new>

namespace helios
{

/// A VTK array that grows by doubling and is written through a plain pointer.
template <typename ArrayT>
class GrowingArray
{
public:
  using T = typename ArrayT::ValueType;

  /// Room for more values, which the caller writes.
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

  /// The array with the values written, nothing spare.
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
    if (!this->Array->Resize(this->Size + count)) // makes it at least twice as large
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
