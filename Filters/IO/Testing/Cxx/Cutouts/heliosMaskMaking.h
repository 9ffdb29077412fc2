// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Masks with shapes of known areas, and images of them.

#ifndef heliosMaskMaking_h
#define heliosMaskMaking_h

#include "heliosContourRings.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace helios
{

/// Makes a mask from the opacity [0..1] at the centres of pixels: x right, y up [pixels].
inline MaskImage MakeMask(
  int width, int height, const std::function<double(double x, double y)>& opacity)
{
  MaskImage mask{ width, height, {} };
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      const double value = std::clamp(opacity(column + 0.5, row + 0.5), 0.0, 1.0);
      mask.Values.push_back(static_cast<unsigned char>(std::lround(255.0 * value)));
    }
  }
  return mask;
}

/// Makes a mask of a disc whose edge is smoothed over a pixel.
inline MaskImage MakeDisc(int size, double radius)
{
  const double middle = 0.5 * size;
  return MakeMask(size, size,
    [=](double x, double y) { return 0.5 + radius - std::hypot(x - middle, y - middle); });
}

/// Writes a mask as the alpha of a green image with 4 components, as grey with 1.
inline vtkSmartPointer<vtkPNGWriter> MakePng(const MaskImage& mask, int components)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(mask.Width, mask.Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  auto* to = static_cast<unsigned char*>(image->GetScalarPointer());
  for (const unsigned char value : mask.Values)
  {
    for (int i = 0; i < components; ++i)
    {
      *to++ = i == components - 1 ? value : i == 1 ? 200 : 30;
    }
  }
  auto writer = vtkSmartPointer<vtkPNGWriter>::New();
  writer->SetInputData(image);
  return writer;
}

inline void WritePng(const MaskImage& mask, int components, const std::string& path)
{
  const auto writer = MakePng(mask, components);
  writer->SetFileName(path.c_str());
  writer->Write();
}

/// Returns the bytes of a PNG file.
inline std::string FormatPng(const MaskImage& mask, int components)
{
  const auto writer = MakePng(mask, components);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return std::string(reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetNumberOfValues()));
}

} // namespace helios

#endif
