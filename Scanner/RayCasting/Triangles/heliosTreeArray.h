// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A large array that is never in memory twice.

#ifndef heliosTreeArray_h
#define heliosTreeArray_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

namespace helios
{

/// Values of a plain type. It grows and shrinks by realloc(), which moves the pages of a large array
/// instead of its values; values are not initialized, and pages that are not written take no memory.
template <typename T>
class TreeArray
{
public:
  static constexpr std::size_t Line = 64; ///< bytes

  static_assert(std::is_trivially_copyable_v<T>, "values are moved as bytes");
  static_assert(alignof(T) <= Line, "values are aligned to cache lines");

  TreeArray() = default;
  TreeArray(TreeArray&& other) noexcept { this->Swap(other); }
  TreeArray& operator=(TreeArray&& other) noexcept
  {
    TreeArray old(std::move(*this));
    this->Swap(other);
    return *this;
  }
  ~TreeArray() { std::free(this->Bytes); }

  std::size_t GetSize() const { return this->Size; }
  std::size_t GetMemorySize() const { return this->Capacity * sizeof(T); }

  T& operator[](std::size_t i) { return this->Values[i]; }
  const T& operator[](std::size_t i) const { return this->Values[i]; }

  /// Changes the number of values; grows in steps.
  void Resize(std::size_t size)
  {
    if (size > this->Capacity)
    {
      this->SetCapacity(std::max(size, this->Capacity + this->Capacity / 4));
    }
    this->Size = size;
  }

  /// Copies the values of another array.
  void Copy(const TreeArray& other)
  {
    this->Resize(other.Size);
    std::copy_n(other.Values, other.Size, this->Values);
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
  void Swap(TreeArray& other)
  {
    std::swap(this->Bytes, other.Bytes);
    std::swap(this->Values, other.Values);
    std::swap(this->Size, other.Size);
    std::swap(this->Capacity, other.Capacity);
  }

  /// Returns the distance to the next cache line.
  static std::size_t GetShift(const void* from)
  {
    return (Line - reinterpret_cast<std::uintptr_t>(from) % Line) % Line;
  }

  void SetCapacity(std::size_t capacity)
  {
    const std::size_t before = GetShift(this->Bytes);
    void* moved = std::realloc(this->Bytes, capacity * sizeof(T) + Line);
    if (!moved)
    {
      throw std::bad_alloc();
    }
    this->Bytes = static_cast<char*>(moved);
    char* values = this->Bytes + GetShift(moved);
    if (GetShift(moved) != before)
    {
      std::memmove(values, this->Bytes + before, std::min(this->Size, capacity) * sizeof(T));
    }
    this->Values = reinterpret_cast<T*>(values);
    this->Capacity = capacity;
  }

  char* Bytes = nullptr;
  T* Values = nullptr; ///< in the bytes, from a cache line on
  std::size_t Size = 0;
  std::size_t Capacity = 0;
};

} // namespace helios

#endif
