// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPartFile.h"

#include "heliosStatus.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace helios
{

namespace
{

/// Fsyncs a file; returns 0 or the error. Files that cannot be synced (pipes) are no error.
int SyncDescriptor(int descriptor)
{
  while (::fsync(descriptor) != 0)
  {
    if (errno != EINTR)
    {
      return errno == EINVAL || errno == EROFS ? 0 : errno;
    }
  }
  return 0;
}

/// Flushes a file or folder given by name, like SyncDescriptor().
int SyncPath(const std::string& path)
{
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
  {
    return errno;
  }
  const int error = SyncDescriptor(descriptor);
  ::close(descriptor);
  return error;
}

bool IsUnlinked(int descriptor)
{
  struct stat status = {};
  return ::fstat(descriptor, &status) == 0 && status.st_nlink == 0;
}

/// Writes all bytes and adds the number written to total; returns 0 or the error.
int WriteAll(int descriptor, const char* bytes, std::size_t count, std::uint64_t& total)
{
  while (count > 0)
  {
    const ssize_t written = ::write(descriptor, bytes, count);
    if (written < 0 && errno == EINTR)
    {
      continue;
    }
    if (written <= 0)
    {
      return written < 0 ? errno : EIO;
    }
    total += static_cast<std::uint64_t>(written);
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return 0;
}

std::string Explain(const std::string& path, const char* what, int error)
{
  return path + " cannot be " + what + ": " + std::strerror(error);
}

constexpr const char* WasRemoved = "was removed while it was written";

} // namespace

Status MakeFoldersFor(const std::string& path)
{
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty() && !std::filesystem::is_directory(folder, error))
  {
    std::filesystem::create_directories(folder, error);
    if (error)
    {
      return Status::Error(
        "the folder " + folder.string() + " cannot be created: " + error.message());
    }
  }
  return {};
}

Status RenameFile(const std::string& from, const std::string& to)
{
  if (std::rename(from.c_str(), to.c_str()) != 0)
  {
    return Status::Error(from + " cannot be renamed to " + to + ": " + std::strerror(errno));
  }
  return {};
}

Status SyncFile(const std::string& path)
{
  const int error = SyncPath(path);
  return error ? Status::Error(path + " cannot be flushed to disk: " + std::strerror(error))
               : Status();
}

Status SyncFolderOf(const std::string& path)
{
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return SyncFile(folder.empty() ? "." : folder);
}

std::int64_t GetSizeOfWhole(const std::string& path, const std::string& ending)
{
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::int64_t size = file.tellg();
  std::string last(ending.size(), '\0');
  file.seekg(-static_cast<std::int64_t>(ending.size()), std::ios::end);
  file.read(last.data(), static_cast<std::streamsize>(last.size()));
  return file && last == ending ? size : -1;
}

FileBlock MakeFileBlock(const std::string& path, std::uint64_t begin, std::uint64_t end)
{
  return { std::filesystem::path(path).filename().string(), begin, end,
    ComputeChecksum(path, begin, end), true };
}

void RemoveFile(const std::string& path)
{
  std::remove(path.c_str());
}

int CreatePart(const std::string& path)
{
  const std::string part = path + PartEnding;
  if (::unlink(part.c_str()) != 0 && errno != ENOENT)
  {
    return -1;
  }
  return ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
}

namespace
{

/// Removes what was written, and returns the reason.
Status Remove(PartFile& file)
{
  const Status status = Status::Error(file.GetProblem());
  file.Abandon();
  RemoveFile(file.GetPartPath());
  return status;
}

} // namespace

Status WriteWhole(const std::string& path, const std::string& text)
{
  PartFile file;
  const bool good = file.Open(path) && file.Append(text.data(), text.size()) && file.Close();
  return good ? Status() : Remove(file);
}

Status WriteUnsynced(const std::string& path, const std::string& text)
{
  PartFile file;
  if (!file.Open(path) || !file.Append(text.data(), text.size()) || !file.Abandon())
  {
    return Remove(file);
  }
  const Status status = RenameFile(file.GetPartPath(), path);
  if (!status.IsOk())
  {
    RemoveFile(file.GetPartPath());
  }
  return status;
}

PartFile::~PartFile()
{
  this->Abandon();
}

bool PartFile::Fail(const char* what, int error)
{
  this->Problem = Explain(this->GetPartPath(), what, error);
  return false;
}

bool PartFile::Open(const std::string& path, Folders folders)
{
  this->Abandon();
  this->Path = path;
  this->Size = 0;
  this->BeginBlock();
  this->IsNowhere = this->IsInFolder = this->IsReplaced = false;
  this->Problem = folders == Folders::Make ? MakeFoldersFor(path).Message() : std::string();
  std::error_code error;
  if (this->Problem.empty() && std::filesystem::is_directory(path, error))
  {
    this->Problem = path + " is a folder, not a file";
  }
  if (!this->Problem.empty())
  {
    return false;
  }
  this->Descriptor = CreatePart(path);
  return this->Descriptor >= 0 || this->Fail("opened", errno);
}

bool PartFile::Reopen(const std::string& path, std::uint64_t size)
{
  this->Abandon();
  this->Path = path;
  this->IsNowhere = this->IsInFolder = this->IsReplaced = false;
  std::error_code error;
  const std::string part = this->GetPartPath();
  if (!std::filesystem::exists(part, error) && std::filesystem::exists(path, error))
  {
    this->Problem = RenameFile(path, part).Message();
    if (!this->Problem.empty())
    {
      return false;
    }
  }
  const auto found = std::filesystem::file_size(part, error);
  if (error || found < size)
  {
    this->Problem = part + " cannot be resumed: " +
      (error ? error.message()
             : "it has " + std::to_string(found) + " bytes of " + std::to_string(size));
    return false;
  }
  if (std::filesystem::is_symlink(part, error))
  {
    this->Problem = part + " cannot be resumed: it is a link to another file, which is kept";
    return false;
  }
  this->Descriptor = ::open(part.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
  if (this->Descriptor < 0)
  {
    return this->Fail("opened", errno);
  }
  this->Size = this->BlockBegin = size;
  return this->Cut(size);
}

bool PartFile::OpenCountOnly(const std::string& path)
{
  this->Abandon();
  this->Path = path;
  this->Size = 0;
  this->BeginBlock();
  this->IsNowhere = true;
  this->IsReplaced = false;
  this->Descriptor = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  return this->Descriptor >= 0 || this->Fail("opened", errno);
}

bool PartFile::Append(const char* bytes, std::size_t count)
{
  const int error = WriteAll(this->Descriptor, bytes, count, this->Size);
  if (error != 0)
  {
    return this->Fail("written", error);
  }
  if (!this->IsNowhere)
  {
    this->BlockSum.Add(bytes, count);
  }
  return true;
}

bool PartFile::Overwrite(std::uint64_t place, const char* bytes, std::size_t count)
{
  while (count > 0)
  {
    const ssize_t written = ::pwrite(this->Descriptor, bytes, count, static_cast<off_t>(place));
    if (written <= 0 && errno != EINTR)
    {
      return this->Fail("written", written < 0 ? errno : EIO);
    }
    const auto done = static_cast<std::size_t>(std::max<ssize_t>(written, 0));
    place += done;
    bytes += done;
    count -= done;
  }
  return true;
}

bool PartFile::Cut(std::uint64_t size)
{
  const auto end = static_cast<off_t>(size);
  if (::ftruncate(this->Descriptor, end) != 0 || ::lseek(this->Descriptor, end, SEEK_SET) != end)
  {
    return this->Fail("cut", errno);
  }
  if (size == this->Size)
  {
    return true;
  }
  this->Size = size;
  this->BlockBegin = std::min(this->BlockBegin, size);
  this->BlockSum.Reset();
  return size == this->BlockBegin ||
    this->BlockSum.AddFile(this->GetPartPath(), this->BlockBegin, size) || this->Fail("read", EIO);
}

FileBlock PartFile::CollectBlock()
{
  const FileBlock block{ std::filesystem::path(this->Path).filename().string(), this->BlockBegin,
    this->Size, this->BlockSum.Finish(), this->IsReplaced };
  this->BlockBegin = this->Size;
  return block;
}

void PartFile::BeginBlock()
{
  this->BlockBegin = this->Size;
  this->BlockSum.Reset();
}

bool PartFile::IsRemoved() const
{
  return this->Descriptor >= 0 && IsUnlinked(this->Descriptor);
}

Status PartFile::Sync()
{
  if (this->IsNowhere)
  {
    return {};
  }
  if (this->IsRemoved())
  {
    return Status::Error(this->GetPartPath() + " " + WasRemoved);
  }
  if (!this->IsInFolder)
  {
    Status status = SyncFolderOf(this->Path);
    if (!status.IsOk())
    {
      return status;
    }
    this->IsInFolder = true;
  }
  const int error = SyncDescriptor(this->Descriptor);
  return error == 0 ? Status()
                    : Status::Error(Explain(this->GetPartPath(), "flushed to disk", error));
}

bool PartFile::Close()
{
  const Status kept = this->Sync();
  if (!this->Abandon())
  {
    return false;
  }
  if (!kept.IsOk())
  {
    this->Problem = kept.Message();
    return false;
  }
  if (!this->IsNowhere)
  {
    const Status status = RenameFile(this->GetPartPath(), this->Path);
    this->Problem = (status.IsOk() ? SyncFolderOf(this->Path) : status).Message();
  }
  return this->Problem.empty();
}

bool PartFile::Abandon()
{
  const int descriptor = this->Descriptor;
  this->Descriptor = -1;
  return descriptor < 0 || ::close(descriptor) == 0 || this->Fail("closed", errno);
}

bool PartFile::ReplaceBy(const std::string& made)
{
  if (!this->Abandon())
  {
    return false;
  }
  std::error_code error;
  this->Size = std::filesystem::file_size(made, error);
  this->BeginBlock();
  this->BlockBegin = 0;
  Status status = SyncFile(made);
  status = status.IsOk() ? RenameFile(made, this->Path) : status;
  status = status.IsOk() ? SyncFolderOf(this->Path) : status;
  this->Problem = status.Message();
  this->IsReplaced = status.IsOk();
  return status.IsOk() &&
    (this->BlockSum.AddFile(this->Path, 0, this->Size) || this->Fail("read", EIO));
}

bool LogFile::Fail(const std::string& what)
{
  this->Problem = this->Path + " " + what;
  return false;
}

bool LogFile::Open(const std::string& path)
{
  this->Close();
  this->Path = path;
  this->Descriptor = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (this->Descriptor < 0)
  {
    return this->Fail(std::string("cannot be opened: ") + std::strerror(errno));
  }
  if (::flock(this->Descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
  {
    this->Close();
    return this->Fail("is being written by another process");
  }
  return true;
}

bool LogFile::Cut(std::uint64_t size)
{
  return ::ftruncate(this->Descriptor, static_cast<off_t>(size)) == 0 ||
    this->Fail(std::string("cannot be truncated: ") + std::strerror(errno));
}

bool LogFile::Append(const std::string& text)
{
  std::uint64_t written = 0;
  int error = WriteAll(this->Descriptor, text.data(), text.size(), written);
  error = error ? error : SyncDescriptor(this->Descriptor);
  if (error)
  {
    return this->Fail(std::string("cannot be written: ") + std::strerror(error));
  }
  return this->Check();
}

bool LogFile::Check()
{
  return !IsUnlinked(this->Descriptor) || this->Fail(WasRemoved);
}

void LogFile::Close()
{
  if (this->Descriptor >= 0)
  {
    ::close(this->Descriptor);
  }
  this->Descriptor = -1;
}

} // namespace helios
