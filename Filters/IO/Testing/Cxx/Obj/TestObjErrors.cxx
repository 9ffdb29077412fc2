// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Errors of the OBJ reader on bad files.
#include "heliosObjParser.h"
#include "heliosObjTestFiles.h"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdio>

#ifdef __linux__
#include <fcntl.h>
#include <filesystem>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

using helios::ObjReading;
using helios::ObjSquare;
using helios::TestFolder;

namespace
{

struct BadText
{
  const char* Text;
  const char* Message; // after the path
};

void CheckError(const std::string& text, const std::string& message)
{
  TestFolder folder;
  const std::string path = folder.Write("a.obj", text);
  ObjReading reading(path);
  INFO(text << "\nexpected: " << message);
  CHECK_FALSE(reading.Read());
  INFO("said: " << reading.Log->Errors);
  CHECK(reading.Log->HasError(path + message));
  CHECK(reading.Scene()->GetNumberOfPoints() == 0);
  CHECK(reading.TriangleCount() == 0);
}

void CheckWarning(const std::string& text, const std::string& message, vtkIdType triangleCount)
{
  TestFolder folder;
  const std::string path = folder.Write("a.obj", text);
  ObjReading reading(path);
  INFO(text << "\nexpected: " << message);
  CHECK(reading.Read());
  INFO("said: " << reading.Log->Warnings);
  CHECK(reading.Log->HasWarning(path + message));
  CHECK(reading.TriangleCount() == triangleCount);
}

#ifdef __linux__
/// Makes every later read of the open file fail.
void ReplaceByFolder(const std::string& path)
{
  const int folder = open("/", O_RDONLY);
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
  {
    std::error_code ignored;
    if (std::filesystem::read_symlink(entry.path(), ignored) == path)
    {
      dup2(folder, std::stoi(entry.path().filename().string()));
    }
  }
  close(folder);
}
#endif

} // namespace

TEST_CASE("ObjErrors: numbers", "[ObjErrors]")
{
  const BadText cases[] = {
    { "v 0 abc 0\n", ":1: \"abc\" is not a number; v needs three numbers: v x y z" },
    { "v 0 1,5 0\n", ":1: \"1,5\" is not a number; v needs three numbers" },
    { "\n\nv 0 0 1.0.0\n", ":3: \"1.0.0\" is not a number" },
    { "v 0 0 0x10\n", ":1: \"0x10\" is not a number" },
    { "v 0 0 --1\n", ":1: \"--1\" is not a number" },
    { "v 0 0 +-1\n", ":1: \"+-1\" is not a number" },
    { "v 0 0 1.#QNAN\n", ":1: \"1.#QNAN\" is not a number" },
    { "v 0 0 0 red\n", ":1: \"red\" is not a number; v needs three numbers" },
    { "v 0 0\n", ":1: too few numbers; v needs three numbers: v x y z" },
    { "v\n", ":1: too few numbers; v needs three numbers" },
    { "v 0 0 # 0\n", ":1: too few numbers" },
    { "v 0 1e400 0\n", ":1: \"1e400\" is beyond the range of double precision; correct it" },
    { "v 0 0 nan\n", ":1: vertex coordinate z is NaN; correct the vertex, or remove it" },
    { "v -nan(ind) 0 0\n", ":1: vertex coordinate x is NaN" },
    { "v 0 0 0\r\nv 0 -inf 0\r\n", ":2: vertex coordinate y is infinite; correct the vertex" },
    { "v 0 0 \\\n nan\n", ":1: vertex coordinate z is NaN" },
    { "# a \\\nv 0 \\\n 0 0\nv x 0 0\n", ":4: \"x\" is not a number" },
    { "vn 0 0\n", ":1: too few numbers; vn needs three numbers: vn x y z" },
    { "vn 0 0 up\n", ":1: \"up\" is not a number; vn needs three numbers" },
    { "vt\n", ":1: too few numbers; vt needs one to three numbers: vt u v w" },
    { "vt 0 ?\n", ":1: \"?\" is not a number; vt needs one to three numbers" },
  };
  for (const BadText& bad : cases)
  {
    CheckError(bad.Text, bad.Message);
  }
}

TEST_CASE("ObjErrors: faces", "[ObjErrors]")
{
  const BadText cases[] = {
    // lines 1 to 4 are the vertices of a square
    { "f 1 2 5\n", ":5: face refers to vertex 5, but the file has 4; correct the index" },
    { "f 1 2 3\nf 1 2 70\nf 1 2 6\n", ":6: face refers to vertex 70, but the file has 4" },
    { "f 0 1 2\n", ":5: face refers to vertex 0; indices count from 1, or backwards from -1" },
    { "f 1 2 -5\nv 1 1 1\n",
      ":5: face refers to vertex -5, but only 4 come before it; correct the index" },
    { "f 1 2 99999999999\n",
      ":5: face refers to \"99999999999\", 2^31 or more; correct the index" },
    { "f 1 2 -2147483648\n", ":5: face refers to \"-2147483648\", 2^31 or more" },
    { "f 1 2\n", ":5: face has 2 corners; it needs three or more: f 1 2 3" },
    { "f\n", ":5: face has 0 corners" },
    { "f 1 2 x\n",
      ":5: \"x\" is not the corner of a face; write it v, v/t, v//n or v/t/n, such as 1//3" },
    { "f 1 2 3.0\n", ":5: \"3.0\" is not the corner of a face" },
    { "f 1 2 3/a\n", ":5: \"3/a\" is not the corner of a face" },
    { "f 1 2 -\n", ":5: \"-\" is not the corner of a face" },
    { "f 1 2 /1\n", ":5: \"/1\" is not the corner of a face" },
    { "vt 0\nvn 0 0 1\nf 1 2 3/1/1/1\n", ":7: \"3/1/1/1\" is not the corner of a face" },
  };
  for (const BadText& bad : cases)
  {
    CheckError(ObjSquare + bad.Text, bad.Message);
  }
}

TEST_CASE("ObjErrors: a long bad word is truncated, without control characters", "[ObjErrors]")
{
  CheckError(
    "v 0 0 " + std::string(100, 'x'), ":1: \"" + std::string(60, 'x') + "...\" is not a number");
  CheckError("v 0 0 a\x01"
             "b",
    ":1: \"a?b\" is not a number");
}

TEST_CASE("ObjErrors: files", "[ObjErrors]")
{
  TestFolder folder;
  const std::string plain = folder.Write("plain.txt", "text");
  const BadText cases[] = { { "missing.obj",
                              ": cannot be read: No such file or directory; check the file name" },
    { "plain.txt/a.obj", ": cannot be read: Not a directory; check the file name" },
    { "", ": cannot be read: it is a folder; give the name of a file" } };
  for (const BadText& bad : cases)
  {
    ObjReading reading(folder.GetPath(bad.Text));
    CHECK_FALSE(reading.Read());
    INFO(reading.Log->Errors);
    CHECK(reading.Log->HasError(folder.GetPath(bad.Text) + bad.Message));
  }

  ObjReading unnamed("");
  CHECK_FALSE(unnamed.Read());
  CHECK(unnamed.Log->HasError("FileName is not set; give the OBJ file with SetFileName"));
  unnamed.Reader->SetFileName(nullptr);
  unnamed.Log->Clear();
  CHECK_FALSE(unnamed.Read());
  CHECK(unnamed.Log->HasError("FileName is not set"));
}

TEST_CASE("ObjErrors: too large for 32-bit cells", "[ObjErrors]")
{
  TestFolder folder;
  const std::string path = folder.Write("a.obj", ObjSquare + "f 1 2 3\nf 1 2 3 4\n");
  {
    helios::TextReport report;
    helios::ObjParser parser(report);
    parser.MaximumNumberOfCorners = 8;
    CHECK_FALSE(parser.Read(path));
    CHECK(
      report.Error == path + ":6: more than 2 triangles; split the file into several scene parts");
  }
  {
    helios::TextReport report;
    helios::ObjParser parser(report);
    parser.MaximumNumberOfCorners = 3;
    CHECK_FALSE(parser.Read(path));
    CHECK(
      report.Error == path + ":4: more than 3 vertices; split the file into several scene parts");
  }
}

#ifdef __linux__
TEST_CASE("ObjErrors: a disk error while reading", "[ObjErrors]")
{
  TestFolder folder;
  std::string text;
  while (text.size() < (std::size_t(3) << 20)) // more than one block
  {
    text += "v 0 0 0\n";
  }
  const std::string path = folder.Write("a.obj", text);
  helios::TextReport report;
  helios::ObjParser parser(report);
  parser.File.OnBlock = [&path](double)
  {
    ReplaceByFolder(path); // reading continues in an unreadable file
    return true;
  };
  CHECK_FALSE(parser.Read(path));
  CHECK(report.Error == path + ": cannot be read any further: Is a directory; check the disk");
}

TEST_CASE("ObjErrors: refuses paths that are not regular files", "[ObjErrors]")
{
  TestFolder folder;
  const std::string fifo = folder.Write("a.obj", "") + ".fifo";
  REQUIRE(mkfifo(fifo.c_str(), 0600) == 0);
  ObjReading first(fifo);
  CHECK_FALSE(first.Read());
  CHECK(first.Log->HasError(
    fifo + ": cannot be read: it is a FIFO, not a regular file; copy it to a file"));
  ObjReading second("/dev/zero");
  CHECK_FALSE(second.Read());
  CHECK(second.Log->HasError("/dev/zero: cannot be read: it is a character device, not a regular "
                             "file; copy what is read to a file"));
}

#ifndef __SANITIZE_ADDRESS__
TEST_CASE("ObjErrors: out of memory", "[ObjErrors]")
{
  TestFolder folder;
  std::string text;
  for (int i = 0; i < 3000000; ++i)
  {
    text += "v 0 0 0\n";
  }
  const std::string path = folder.Write("a.obj", text);
  ObjReading reading(path);

  long pages = 0;
  std::FILE* size = std::fopen("/proc/self/statm", "r");
  REQUIRE(size);
  REQUIRE(std::fscanf(size, "%ld", &pages) == 1);
  std::fclose(size);
  rlimit before;
  getrlimit(RLIMIT_AS, &before);
  rlimit tight = before;
  tight.rlim_cur = static_cast<rlim_t>(pages) * getpagesize() + (rlim_t(24) << 20);
  setrlimit(RLIMIT_AS, &tight);
  const bool good = reading.Read();
  setrlimit(RLIMIT_AS, &before);

  CHECK_FALSE(good);
  INFO(reading.Log->Errors);
  CHECK(reading.Log->HasError(path + ":"));
  CHECK(reading.Log->HasError(": not enough memory to continue; free some, or split the file"));
}
#endif
#endif

TEST_CASE("ObjErrors: triangles without area are dropped and counted", "[ObjErrors]")
{
  TestFolder folder;
  const std::string utm =
    "v 500000.1 5500000.1 0.1\nv 500000.2 5500000.2 0.2\nv 500000.3 5500000.3 0.3\n"
    "v 500000.2 5500000.2 0.200001\n";
  const std::string path = folder.Write("a.obj",
    ObjSquare + "v 0 0 0\nv 0.5 0.5 0\n" + utm +
      "f 1 2 3\n"
      "f 1 2 2\n"   // repeated corner
      "f 1 5 3\n"   // two coincident corners
      "f 1 3 6\n"   // collinear corners
      "f 7 8 9\n"   // collinear to rounding
      "f 7 10 9\n"  // height of a micrometre
      "f 1 1 2 3\n" // a triangle: a repeated corner is none
  );
  ObjReading reading(path);
  REQUIRE(reading.Read());
  INFO(reading.Log->Warnings);
  CHECK(reading.Log->HasWarning(path + ": dropped 4 of 7 triangles, which have no area"));
  CHECK(reading.TriangleCount() == 3);
  CHECK(reading.Reader->GetNumberOfDroppedTriangles() == 4);
}

TEST_CASE("ObjErrors: small and large triangles are kept", "[ObjErrors]")
{
  TestFolder folder;
  ObjReading reading(folder.Write("a.obj",
    "v 0 0 0\nv 1e-9 0 0\nv 0 1e-9 0\nv 1e6 0 0\nv 0 1e6 0\n"
    "v 5e5 5.5e6 0\nv 500000.001 5.5e6 0\nv 5e5 5500000.001 0\nf 1 2 3\nf 1 4 5\nf 6 7 8\nf 1 4 "
    "3\n"));
  REQUIRE(reading.Read());
  CHECK(reading.TriangleCount() == 4);
  CHECK(reading.Log->Warnings.empty());
}

TEST_CASE("ObjErrors: an isolated vertex is reported with the extent of the scene", "[ObjErrors]")
{
  CheckWarning(ObjSquare + "v 1e30 0 -5\nf 1 2 3\nf 1 2 5\n",
    ":5: vertex 5 (1e+30, 0, -5) lies far from the others: the scene's extent is x 0 to 1e+30, y 0 "
    "to 1, "
    "z -5 to 0 m; correct the vertex",
    2);
  CheckWarning("# unused\nv -3 -1e300 0\n" + ObjSquare + "f 2 3 4\n",
    ":2: vertex 1 (-3, -1e+300, 0) lies far from the others: the scene's extent is x -3 to 1, "
    "y -1e+300 to 1, z 0 to 0 m; it is left out, as no face uses it",
    1);

  TestFolder folder;
  ObjReading zones(folder.Write(
    "a.obj", "v 32500000 5500000 0\nv 32500001 5500000 0\nv 32500000 5500001 0\nf 1 2 3\n"));
  CHECK(zones.Read());
  CHECK(zones.Log->Warnings.empty());
}

TEST_CASE("ObjErrors: an isolated vertex is reported without its line if the file was removed",
  "[ObjErrors]")
{
  TestFolder folder;
  std::string path = folder.Write("a.obj", ObjSquare + "v 1e30 0 -5\nf 1 2 3\nf 1 2 5\n");
  ObjReading reading(path);
  vtkNew<vtkCallbackCommand> remove;
  remove->SetClientData(&path);
  remove->SetCallback(
    [](vtkObject*, unsigned long, void* name, void* progress)
    {
      if (*static_cast<double*>(progress) > 0.0) // the file is open
      {
        std::remove(static_cast<std::string*>(name)->c_str());
      }
    });
  reading.Reader->AddObserver(vtkCommand::ProgressEvent, remove);
  CHECK(reading.Read());
  CHECK(reading.Log->HasWarning(path + ":0: vertex 5 (1e+30, 0, -5) lies far from the others"));
}

TEST_CASE("ObjErrors: unknown and empty elements are reported once", "[ObjErrors]")
{
  CheckWarning(ObjSquare + "face 1 2 3\nf 1 2 3\nV 1 2 3\n",
    ":5: unknown keyword \"face\", ignored (2 such lines in this file)", 1);
  CheckWarning(ObjSquare, ": no triangles, so the scene is empty; add faces: f 1 2 3", 0);
  CheckWarning("", ": no triangles, so the scene is empty", 0);
  CheckWarning(ObjSquare + "usemtl\nf 1 2 3\nusemtl \nf 1 3 4\n",
    ":5: usemtl has no name, the default material is used; give that of a material", 2);
}

TEST_CASE("ObjErrors: UTF-16 is named, and lines may end in CR as of old Macintosh")
{
  CheckError(std::string("\xFE\xFF\0v\0 \0"
                         "0",
               7),
    ": is text of UTF-16 or UTF-32; save it as UTF-8");
  CheckError(std::string("v\0 \0"
                         "0\0 \0",
               8),
    ": is text of UTF-16 or UTF-32; save it as UTF-8");
  std::string text = ObjSquare + "f 1 2 3\nf 1 3 4\n";
  std::replace(text.begin(), text.end(), '\n', '\r');
  TestFolder folder;
  ObjReading reading(folder.Write("a.obj", text));
  REQUIRE(reading.Read());
  CHECK(reading.TriangleCount() == 2);
  CheckError(text + "f 1 2 x\r", ":7: ");
}
