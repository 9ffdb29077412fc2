// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What the sources of LASzip need from its files that are not here: memory and messages.

#include "mydefs.hpp"

#include <cstdlib>
#include <new>

void* malloc_las(size_t size)
{
  void* memory = std::malloc(size);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

void* realloc_las(void* memory, size_t size)
{
  void* larger = std::realloc(memory, size);
  if (!larger)
  {
    throw std::bad_alloc();
  }
  return larger;
}

// Errors are values of functions, or exceptions; nothing is printed.
void LASMessage(LAS_MESSAGE_TYPE, const char*, ...) {}

// All supported machines are little-endian, as the files are.
namespace Endian
{
extern const bool IS_LITTLE_ENDIAN;
const bool IS_LITTLE_ENDIAN = true;
}
