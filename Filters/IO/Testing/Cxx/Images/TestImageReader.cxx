// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosImageSeeds.h"
#include "heliosImageTesting.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosImageReader.h"
#include "vtkHeliosMemoryLimit.h"

#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnsignedCharArray.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <sstream>

#include <sys/stat.h>

using helios::ErrorObserver;
using helios::ImageSeeds;
using helios::ReadBytesAsImage;
using helios::TempFolder;

namespace
{

/// A reader of a file, and what it says.
struct Reading
{
  explicit Reading(const std::string& path)
  {
    this->Log->Watch(this->Reader);
    this->Log->Watch(this->Reader->GetExecutive());
    this->Reader->SetFileName(path.c_str());
  }

  vtkNew<vtkHeliosImageReader> Reader;
  vtkNew<ErrorObserver> Log;
};

/// Limits the memory of this process while it exists.
struct LimitedMemory
{
  explicit LimitedMemory(double mebibytes)
  {
    vtkHeliosMemoryLimit::SetLimit(vtkHeliosMemoryLimit::GetUsed() + mebibytes);
  }
  ~LimitedMemory() { vtkHeliosMemoryLimit::SetLimit(0.0); }
};

} // namespace

TEST_CASE("ImageReader: images of VTK's writers, row 0 the lowest", "[ImageReader]")
{
  const TempFolder folder;
  const int components = GENERATE(1, 3);
  for (const auto& [name, bytes] : ImageSeeds(folder, components).Files)
  {
    INFO(name << ", " << components << " components");
    const std::string path = folder / name;
    Reading reading(path);
    reading.Reader->Update();
    REQUIRE(reading.Log->Errors.empty());
    vtkImageData* image = reading.Reader->GetOutput();
    const int* size = image->GetDimensions();
    REQUIRE(size[0] == ImageSeeds::Width);
    REQUIRE(size[1] == ImageSeeds::Height);
    auto* colors =
      vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetArray(vtkHeliosArrayNames::RGB));
    REQUIRE(colors != nullptr);
    CHECK(image->GetPointData()->GetScalars() == colors);
    double worst = 0.0;
    for (vtkIdType i = 0; i < 3 * colors->GetNumberOfTuples(); ++i)
    {
      const auto pixel = static_cast<int>(i / 3);
      const int expected = ImageSeeds::GetValue(pixel % ImageSeeds::Width,
        pixel / ImageSeeds::Width, components == 1 ? 0 : static_cast<int>(i % 3));
      worst = std::max(worst, std::abs(double(colors->GetValue(i)) - expected));
    }
    CHECK(worst <= (name == "a.jpg" ? 16.0 : 0.0));
  }
}

TEST_CASE("ImageReader: the size is known before the pixels are read", "[ImageReader]")
{
  const TempFolder folder;
  const ImageSeeds seeds(folder, 3);
  Reading reading(folder / "a.png");
  reading.Reader->UpdateInformation();
  int extent[6];
  reading.Reader->GetOutputInformation(0)->Get(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  CHECK(extent[1] == ImageSeeds::Width - 1);
  CHECK(extent[3] == ImageSeeds::Height - 1);
  CHECK(reading.Reader->GetOutput()->GetNumberOfPoints() == 0);
  std::ostringstream text;
  reading.Reader->Print(text);
  CHECK(text.str().find("FileName: " + (folder / "a.png")) != std::string::npos);
}

TEST_CASE("ImageReader: what is no image is an error with its name", "[ImageReader]")
{
  const TempFolder folder;
  std::ofstream(folder / "empty.png").flush();
  std::ofstream(folder / "text.png") << "no image";
  ::mkfifo((folder / "fifo.png").c_str(), 0600);
  const std::map<std::string, std::string> errors = {
    { folder / "none.png", " does not exist; give it" },
    { folder / "", ": cannot be read: it is a folder; give the name of a file" },
    { folder / "fifo.png",
      ": cannot be read: it is a FIFO, not a regular file; copy it to a file" },
    { "/dev/zero",
      ": cannot be read: it is a character device, not a regular file; copy what is read to a "
      "file" },
    { folder / "empty.png", " is empty; give PNG, JPEG, TIFF, BMP or PNM" },
    { folder / "text.png", " is no image that is read; give PNG, JPEG, TIFF, BMP or PNM" },
  };
  for (const auto& [path, error] : errors)
  {
    Reading reading(path);
    reading.Reader->Update();
    CHECK(reading.Log->HasError(path + error));
  }
  Reading unnamed("");
  unnamed.Reader->Update();
  CHECK(unnamed.Log->HasError("FileName is not set; give an image with SetFileName"));
}

TEST_CASE(
  "ImageReader: an image larger than the memory is an error before it is read", "[ImageReader]")
{
  const TempFolder folder;
  const std::string path = folder / "large.ppm";
  {
    std::ofstream file(path, std::ios::binary);
    file << "P6 5000 5000 255\n";
    file.seekp(75000016);
    file << '1';
  }
  const LimitedMemory limit(20.0);
  Reading reading(path);
  reading.Reader->Update();
  CHECK(
    reading.Log->HasError(path + ": 25000000 pixels of a PNM image need about 75.1 MB of memory"));
}

TEST_CASE("ImageReader: EXIF orientations are named, not applied", "[ImageReader]")
{
  const TempFolder folder;
  const std::string plain = ImageSeeds(folder, 3).Files.at("a.jpg");
  const auto [order, tag] = GENERATE(table<std::string, std::string>(
    { { "II", std::string("*\0\x8\0\0\0\x1\0\x12\x1\x3\0\x1\0\0\0\x6\0\0\0", 20) },
      { "MM", std::string("\0*\0\0\0\x8\0\x1\x1\x12\0\x3\0\0\0\x1\0\x6\0\0", 20) } }));
  const std::string exif = std::string("Exif\0\0", 6) + order + tag;
  const std::string segment =
    std::string("\xff\xe1\0", 3) + static_cast<char>(exif.size() + 2) + exif;
  const std::string bytes = plain.substr(0, 2) + segment + plain.substr(2);
  CHECK(ReadBytesAsImage(bytes) == ReadBytesAsImage(plain));
  std::ofstream(folder / "turned.jpg", std::ios::binary) << bytes;
  Reading reading(folder / "turned.jpg");
  reading.Reader->Update();
  CHECK(reading.Log->HasWarning(
    (folder / "turned.jpg") + ": EXIF orientation 6 is not applied: texture coordinates"));
  CHECK(reading.Log->Errors.empty());
}

TEST_CASE(
  "ImageReader: an image that ends too early is an error, wherever it ends", "[ImageReader]")
{
  const TempFolder folder;
  for (const auto& [name, bytes] : ImageSeeds(folder, 3).Files)
  {
    const std::string whole = ReadBytesAsImage(bytes);
    for (std::size_t size = 0; size < bytes.size(); ++size)
    {
      const std::string read = ReadBytesAsImage(bytes.substr(0, size));
      INFO(name << ", " << size << " bytes of " << bytes.size() << ": " << read.substr(0, 200));
      // The rest may be no part of the pixels.
      CHECK((read == whole || read.substr(0, 5) == "image"));
      CHECK((read != whole || size + 4 > bytes.size()));
    }
  }
}

TEST_CASE("ImageReader: a change of any byte of PNG is an error", "[ImageReader]")
{
  const TempFolder folder;
  const std::string bytes = ImageSeeds(folder, 3).Files.at("a.png");
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    INFO("byte " << i);
    CHECK(ReadBytesAsImage(damaged).substr(0, 5) == "image");
  }
  std::string promise = bytes; // 2147483632 columns, with the right checksum for them
  promise.replace(16, 8, std::string("\x7f\xff\xff\xf0\0\0\0\x1", 8));
  CHECK(ReadBytesAsImage(promise).substr(0, 38) == "image: PNG image cannot be read: IHDR:");
}
