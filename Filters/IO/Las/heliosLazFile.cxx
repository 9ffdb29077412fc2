// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLazFile.h"

#include "heliosInputFile.h"
#include "heliosLasFormat.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace helios
{

namespace
{

constexpr const char* Program = "vtkhelios";

/// Returns the program of the installation that this library belongs to, else the program in PATH.
std::string FindProgram()
{
  static const int Library = 0; // in this library
  Dl_info info;
  std::error_code ignored;
  fs::path folder =
    ::dladdr(&Library, &info) ? fs::canonical(info.dli_fname, ignored).parent_path() : fs::path();
  for (; folder.has_relative_path(); folder = folder.parent_path())
  {
    const fs::path candidate = folder / "bin" / Program;
    if (::access(candidate.c_str(), X_OK) == 0)
    {
      return candidate.string();
    }
  }
  return Program;
}

/// Runs a command with its output in a file. Returns its exit code, 128 and more for a signal, or
/// -1 if it could not be started.
int Run(const std::vector<std::string>& command, const std::string& log)
{
  std::vector<char*> words;
  for (const std::string& word : command)
  {
    words.push_back(const_cast<char*>(word.c_str())); // not changed by posix_spawnp
  }
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(
    &actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  const int fault = ::posix_spawnp(&child, words[0], &actions, nullptr, words.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  int state = 0;
  while (fault == 0 && ::waitpid(child, &state, 0) < 0 && errno == EINTR)
  {
  }
  return fault != 0 ? -1 : WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
}

/// Returns the last line of a log, without the names of the program and of the file.
std::string ReadLastLine(const std::string& log, const std::string& path)
{
  std::ifstream file(log);
  std::string last;
  for (std::string line; std::getline(file, line);)
  {
    last = line.empty() ? last : line;
  }
  for (const std::string& start : { std::string(Program) + ": error: ", path + ": " })
  {
    last = last.rfind(start, 0) == 0 ? last.substr(start.size()) : last;
  }
  return last;
}

/// Finds the files that are converted, with their states. The program opens them: here they are
/// only checked, as inputs.
Status FindSource(const std::string& path, std::string& source)
{
  const std::string packets = fs::path(path).replace_extension(".wdp").string();
  source = path + " " + StampFile(path) + " " + StampFile(packets);
  const Status status = CheckInputFile(packets);
  return status.IsOk() ? Status() : Status::Error(packets + ": " + status.Message());
}

} // namespace

//------------------------------------------------------------------------------
bool IsLazFile(const std::string& path)
{
  if (!CheckInputFile(path).IsOk())
  {
    return false;
  }
  std::ifstream file(path, std::ios::binary);
  std::string header(LasHeader::Size10, '\0');
  return file.read(header.data(), static_cast<std::streamsize>(header.size())) &&
    HasCompressedPoints(header);
}

//------------------------------------------------------------------------------
LazFile::~LazFile()
{
  this->Remove();
}

//------------------------------------------------------------------------------
void LazFile::Remove()
{
  std::error_code ignored;
  if (!this->Folder.empty())
  {
    fs::remove_all(this->Folder, ignored);
  }
  this->Source.clear();
  this->Folder.clear();
  this->LasPath.clear();
}

//------------------------------------------------------------------------------
Status LazFile::Convert(const std::string& path)
{
  std::string source;
  if (const Status status = FindSource(path, source); !status.IsOk())
  {
    return status;
  }
  if (source == this->Source)
  {
    return {};
  }
  this->Remove();
  std::error_code fault;
  std::string folder = (fs::temp_directory_path(fault) / "vtkheliosXXXXXX").string();
  if (fault || !::mkdtemp(folder.data()))
  {
    return Status::Error(path + ": cannot be converted to LAS: no folder can be made in the " +
      "temporary folder; set TMPDIR to one that can be written");
  }
  this->Folder = folder;
  const std::string las = folder + "/" + fs::path(path).stem().string() + ".las";
  const std::string log = folder + "/log.txt";
  const int code = Run({ FindProgram(), "convert", path, las, "--quiet" }, log);
  if (code != 0)
  {
    const std::string text = code < 0 ? std::string() : ReadLastLine(log, path);
    this->Remove();
    return Status::Error(path + ": LAZ could not be converted to LAS: " +
      (code < 0         ? "the program vtkhelios is not in PATH; install it"
          : code >= 128 ? "vtkhelios convert was interrupted"
                        : text));
  }
  this->Source = source;
  this->LasPath = las;
  return {};
}

} // namespace helios
