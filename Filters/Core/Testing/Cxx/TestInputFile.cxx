// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosInputFile.h"

#include <catch2/catch.hpp>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

using helios::CheckInputFile;
using helios::InputFiles;
using helios::InputWatch;
using helios::StampFile;

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

TEST_CASE("InputWatch: receives the regular files that its thread checks", "[InputFile]")
{
  const Folder folder;
  const std::string path = folder / "a.obj";
  std::ofstream(path) << "v 0 0 0\n";
  InputFiles files;
  InputFiles inner;
  CHECK_FALSE(InputWatch::IsOn());
  CHECK(CheckInputFile(path).IsOk()); // nobody wants it
  {
    const InputWatch watch(files);
    CHECK(InputWatch::IsOn());
    CHECK(CheckInputFile(path).IsOk());
    CHECK(CheckInputFile(folder / "none.obj").IsOk());
    CHECK_FALSE(CheckInputFile(folder.Path).IsOk());
    const InputWatch other(inner); // in place of the first
    CHECK(CheckInputFile("/dev/../" + path).IsOk());
    std::thread([&path] { CHECK(CheckInputFile(path).IsOk()); }).join();
  }
  CHECK_FALSE(InputWatch::IsOn());
  CHECK(files == InputFiles{ { path, StampFile(path) } });
  CHECK(inner == InputFiles{ { "/dev/../" + path, StampFile(path) } });
  CHECK(helios::AreUnchanged(files));
  const InputWatch watch(files);
  std::ofstream(path) << "v 0 0 1\n";
  CHECK(CheckInputFile(path).IsOk());
  CHECK_FALSE(helios::AreUnchanged(files)); // the first state counts
}

TEST_CASE("StampFile: tells changes that keep size and time", "[InputFile]")
{
  const Folder folder;
  const std::string path = folder / "a.obj";
  CHECK(StampFile(path).empty());
  CHECK(StampFile(std::string("/dev/zero\0.obj", 14)).empty());
  std::ofstream(path) << "v 0 0 0\n";
  const auto time = std::filesystem::last_write_time(path);
  const std::string before = StampFile(path);
  CHECK(before == StampFile(path));
  CHECK(before.rfind("8 ", 0) == 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(50)); // a tick of the kernel's clock
  std::ofstream(path) << "v 0 0 1\n";
  std::filesystem::last_write_time(path, time);
  CHECK(StampFile(path) != before);
  std::ofstream(folder / "b.obj") << "v 0 0 0\n";
  std::filesystem::rename(folder / "b.obj", path);
  CHECK(StampFile(path) != before);
}

TEST_CASE("GetAge: the time since the last change, whatever the file's times say", "[InputFile]")
{
  const Folder folder;
  std::ofstream(folder / "a.obj") << "v 0 0 0\n";
  std::filesystem::last_write_time(folder / "a.obj", {});
  const double age = helios::GetAge(folder / "a.obj");
  CHECK(age > -1.0);
  CHECK(age < 600.0);
  CHECK(helios::GetAge(folder / "none.obj") == 0.0);
}
