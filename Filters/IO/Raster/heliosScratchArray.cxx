// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScratchArray.h"

#include <vtkAbstractArray.h>
#include <vtkDataArray.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

namespace helios
{

namespace
{

/// Before the values of a mapping: its size, which the function that frees it is not given.
constexpr std::size_t HeaderSize = 4096;

void Unmap(void* values)
{
  char* begin = static_cast<char*>(values) - HeaderSize;
  std::size_t size;
  std::memcpy(&size, begin, sizeof(size));
  munmap(begin, size);
}

/// Makes a new file of a size without a name; negative, with errno set, on failure.
int MakeFile(const std::string& folder, std::size_t size)
{
  std::string path = folder + "/vtkHelios-heights-XXXXXX";
  const int file = mkstemp(path.data());
  if (file < 0)
  {
    return file;
  }
  unlink(path.c_str());
  const int error = posix_fallocate(file, 0, static_cast<off_t>(size));
  if (error != 0)
  {
    close(file);
    errno = error;
    return -1;
  }
  return file;
}

} // namespace

//------------------------------------------------------------------------------
Status MapScratchFile(vtkDataArray* array, std::size_t count)
{
  const char* chosen = std::getenv("TMPDIR");
  const std::string folder = chosen && *chosen ? chosen : "/var/tmp";
  const std::size_t size = HeaderSize + count * static_cast<std::size_t>(array->GetDataTypeSize());
  const int file = MakeFile(folder, size);
  void* begin =
    file < 0 ? MAP_FAILED : mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  const int error = errno;
  if (file >= 0)
  {
    close(file); // the mapping holds it
  }
  if (begin == MAP_FAILED)
  {
    return Status::Error("a temporary file of " + std::to_string(size / 1000000) + " MB in " +
      folder + " cannot be made: " + std::strerror(error) +
      "; set TMPDIR to a folder with enough room");
  }
  std::memcpy(begin, &size, sizeof(size));
  array->SetVoidArray(static_cast<char*>(begin) + HeaderSize, static_cast<vtkIdType>(count), 0,
    vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
  array->SetArrayFreeFunction(Unmap);
  return {};
}

} // namespace helios
