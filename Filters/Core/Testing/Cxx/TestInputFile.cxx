// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosInputFile.h"

#include <catch2/catch.hpp>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>

using helios::CheckInputFile;

namespace
{

/// A folder that is removed after the test.
struct Folder
{
  Folder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "heliosXXXXXX").string();
    this->Path = mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(this->Path); }
  std::string operator/(const std::string& name) const { return this->Path + '/' + name; }
  std::string Path;
};

} // namespace

TEST_CASE("CheckInputFile: accepts regular files and links to them", "[InputFile]")
{
  const Folder folder;
  std::ofstream(folder / "a.obj") << "v 0 0 0\n";
  std::filesystem::create_symlink("a.obj", folder / "link.obj");
  CHECK(CheckInputFile(folder / "a.obj").IsOk());
  CHECK(CheckInputFile(folder / "link.obj").IsOk());
  CHECK(CheckInputFile(folder / "none.obj").IsOk()); // reported by the reader
  CHECK(CheckInputFile("").IsOk());
  CHECK(CheckInputFile(std::string("/dev/zero\0.obj", 14)).IsOk());
}

TEST_CASE("CheckInputFile: refuses all other kinds of paths", "[InputFile]")
{
  const Folder folder;
  REQUIRE(mkfifo((folder / "fifo").c_str(), 0600) == 0);
  std::filesystem::create_symlink("fifo", folder / "link");
  const int listener = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, (folder / "socket").c_str(), sizeof(address.sun_path) - 1);
  REQUIRE(bind(listener, reinterpret_cast<sockaddr*>(&address), sizeof(address)) == 0);
  close(listener);

  CHECK(CheckInputFile(folder.Path).Message() ==
    "cannot be read: it is a folder; give the name of a file");
  const std::string fifo = "cannot be read: it is a FIFO, not a regular file; copy it to a file";
  CHECK(CheckInputFile(folder / "fifo").Message() == fifo);
  CHECK(CheckInputFile(folder / "link").Message() == fifo);
  CHECK(CheckInputFile(folder / "socket").Message() ==
    "cannot be read: it is a socket, not a regular file; copy what it sends to a file");
  CHECK(CheckInputFile("/dev/zero").Message() ==
    "cannot be read: it is a character device, not a regular file; copy what is read to a file");
  CHECK(CheckInputFile("/proc/self/status").Message() ==
    "cannot be read: it is a file of the kernel (/proc, /sys), not a regular file; copy it to a "
    "file");
}
