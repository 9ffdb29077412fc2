// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes, a camera of known scale and its pixels, for the viewer's tests.

#ifndef heliosViewerTest_h
#define heliosViewerTest_h

#include "heliosColorMaps.h"
#include "heliosPose.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCamera.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <vector>

namespace helios::viewer
{

inline vtkSmartPointer<vtkPolyData> MakeEchoes(const std::vector<Vec3>& places)
{
  auto echoes = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& place : places)
  {
    points->InsertNextPoint(place.GetData());
  }
  echoes->SetPoints(points);
  return echoes;
}

template <typename Array = vtkDoubleArray>
void AddColumn(vtkPolyData* echoes, const char* name, const std::vector<double>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(static_cast<typename Array::ValueType>(value));
  }
  echoes->GetPointData()->AddArray(array);
}

/// n points at pseudo-random positions in [-9, 9]^2, height 0, with pulse ids and times 0, 1, 2 ...
inline vtkSmartPointer<vtkPolyData> MakeField(vtkIdType n)
{
  std::vector<Vec3> places;
  std::vector<double> numbers;
  for (vtkIdType i = 0; i < n; ++i)
  {
    const auto at = static_cast<double>(i);
    places.emplace_back(18.0 * std::fmod(at * 0.7548776662466927, 1.0) - 9.0,
      18.0 * std::fmod(at * 0.5698402909980532, 1.0) - 9.0, 0.0);
    numbers.push_back(at);
  }
  auto field = MakeEchoes(places);
  AddColumn(field, vtkHeliosArrayNames::PulseIds, numbers);
  AddColumn(field, vtkHeliosArrayNames::GpsTime, numbers);
  return field;
}

/// Looks down on x, y in [-10, 10] at 10 pixels/m; x = y = 0 is at pixel 100, 100.
class Stage
{
public:
  Stage()
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(200, 200);
    this->Window->AddRenderer(this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(10.0);
    camera->SetPosition(0.0, 0.0, 100.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetClippingRange(1.0, 1000.0);
  }

  /// Pixel of x or y [m].
  static int ToPixel(double metres) { return static_cast<int>(100.0 + 10.0 * metres); }

  void Render()
  {
    this->Window->Render();
    this->Window->GetPixelData(0, 0, 199, 199, 0, this->Pixels.Get(), 0);
  }

  Rgb GetPixel(int x, int y) const
  {
    const unsigned char* p = this->Pixels->GetPointer(3 * (200 * y + x));
    return { p[0], p[1], p[2] };
  }

  /// The colour drawn at a position [m], at the height of the focal point.
  Rgb GetColorAt(double x, double y) const { return this->GetPixel(ToPixel(x), ToPixel(y)); }

  int CountPixels(const Rgb& color) const
  {
    int count = 0;
    for (int i = 0; i < 200 * 200; ++i)
    {
      count += this->GetPixel(i % 200, i / 200) == color;
    }
    return count;
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkUnsignedCharArray> Pixels;
};

constexpr Rgb Black = { 0, 0, 0 };

} // namespace helios::viewer

#endif
