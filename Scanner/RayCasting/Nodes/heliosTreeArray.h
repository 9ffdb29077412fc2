// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A large array that is never in memory twice.

#ifndef heliosTreeArray_h
#define heliosTreeArray_h

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace helios
{

/// Values of a plain type. It grows and shrinks by realloc(), which moves the pages of a large array
/// instead of its values; values are not initialized, and pages that are not written take no memory.
template <typename T>
class TreeArray
{
public:
  static_assert(std::is_trivially_copyable_v<T>, "values are moved as bytes");
  static_assert(alignof(T) <= alignof(std::max_align_t), "values are aligned as by malloc()");

  std::size_t GetSize() const { return this->Size; }
  std::size_t GetMemorySize() const { return this->Capacity * sizeof(T); }

  T& operator[](std::size_t i) { return this->Values.get()[i]; }
  const T& operator[](std::size_t i) const { return this->Values.get()[i]; }

  /// Changes the number of values; grows in steps.
  void Resize(std::size_t size)
  {
    if (size > this->Capacity)
    {
      this->SetCapacity(std::max(size, this->Capacity + this->Capacity / 4));
    }
    this->Size = size;
  }

  /// Returns the memory that values do not need.
  void Shrink()
  {
    if (this->Size < this->Capacity)
    {
      this->SetCapacity(this->Size);
    }
  }

private:
  struct Free
  {
    void operator()(T* values) const { std::free(values); }
  };

  void SetCapacity(std::size_t capacity)
  {
    if (capacity == 0)
    {
      this->Values.reset();
    }
    else
    {
      void* moved = std::realloc(this->Values.get(), capacity * sizeof(T));
      if (!moved)
      {
        throw std::bad_alloc();
      }
      this->Values.release(); // realloc() took it
      this->Values.reset(static_cast<T*>(moved));
    }
    this->Capacity = capacity;
  }

  std::unique_ptr<T, Free> Values;
  std::size_t Size = 0;
  std::size_t Capacity = 0;
};

} // namespace helios

#endif
