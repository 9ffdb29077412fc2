// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFileBytes.h"

#include "heliosLineFile.h"
#include "heliosMemoryCheck.h"

#include <cstdint>
#include <cstdio>

namespace helios
{

//------------------------------------------------------------------------------
Status ReadBytes(const std::string& path, double bytesPerByte, std::string& bytes)
{
  InputFile file;
  std::int64_t size = 0;
  Status status = OpenInput(path, file, size);
  if (!status.IsOk())
  {
    return status;
  }
  status = CheckMemory("bytes of the file", static_cast<double>(size), bytesPerByte);
  if (!status.IsOk())
  {
    return Status::Error(path + ": " + status.Message());
  }
  bytes.resize(static_cast<std::size_t>(size));
  return std::fread(bytes.data(), 1, bytes.size(), file.get()) == bytes.size()
    ? Status()
    : Status::Error(path + ": cannot be read to its end; check the disk");
}

} // namespace helios
