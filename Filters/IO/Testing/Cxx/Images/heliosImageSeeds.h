// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Valid images of each format, by VTK's writers.

#ifndef heliosImageSeeds_h
#define heliosImageSeeds_h

#include "heliosTempFolder.h"

#include <vtkBMPWriter.h>
#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPNMWriter.h>
#include <vtkTIFFWriter.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace helios
{

/// Files by name, with their bytes; their rows begin with the lowest one in GetValue().
class ImageSeeds
{
public:
  static constexpr int Width = 13;
  static constexpr int Height = 9;

  /// Smooth, so that JPEG keeps it.
  static int GetValue(int column, int row, int component)
  {
    return component == 0 ? 10 * column + 8 * row : component == 1 ? 20 * row : 128 - 6 * column;
  }

  /// Components: 1 (grey) or 3.
  ImageSeeds(const TempFolder& folder, int components)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(Width, Height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
    for (int row = 0; row < Height; ++row)
    {
      for (int column = 0; column < Width; ++column)
      {
        for (int component = 0; component < components; ++component)
        {
          image->SetScalarComponentFromDouble(
            column, row, 0, component, GetValue(column, row, component));
        }
      }
    }
    vtkNew<vtkJPEGWriter> jpeg;
    jpeg->SetQuality(100);
    this->Add(jpeg, image, folder, "a.jpg");
    this->Add(vtkNew<vtkPNGWriter>(), image, folder, "a.png");
    this->Add(vtkNew<vtkTIFFWriter>(), image, folder, "a.tif");
    this->Add(vtkNew<vtkBMPWriter>(), image, folder, "a.bmp");
    this->Add(vtkNew<vtkPNMWriter>(), image, folder, "a.ppm");
  }

  std::map<std::string, std::string> Files;

private:
  void Add(
    vtkImageWriter* writer, vtkImageData* image, const TempFolder& folder, const std::string& name)
  {
    const std::string path = folder / name;
    writer->SetFileName(path.c_str());
    writer->SetInputData(image);
    writer->Write();
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    this->Files[name] = bytes.str();
  }
};

} // namespace helios

#endif
