// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Coloured points in a renderer, without cells; coordinates are not copied.

#ifndef heliosPointActor_h
#define heliosPointActor_h

#include <vtkNew.h>
#include <vtkType.h>

#include <cstdint>
#include <vector>

class vtkActor;
class vtkFloatArray;
class vtkPlaneCollection;
class vtkPointGaussianMapper;
class vtkPolyData;
class vtkRenderer;
class vtkUnsignedCharArray;

namespace helios::viewer
{

class PointActor
{
public:
  explicit PointActor(vtkRenderer* renderer);
  ~PointActor();
  PointActor(const PointActor&) = delete;
  void operator=(const PointActor&) = delete;

  /// Red, green, blue, opaque for each point.
  std::vector<std::uint8_t> Rgba;

  /// Draws the first count points of xyz, which must stay in place, in their colours.
  void Show(const float* xyz, vtkIdType count);

  /// Draws selected points of xyz, copied.
  void ShowSome(const float* xyz, const std::vector<vtkIdType>& which);

  void SetVisible(bool on);
  bool IsVisible() const;
  vtkIdType GetNumberOfPoints() const { return this->Count; }
  void SetPointSize(double size);
  void SetPlanes(vtkPlaneCollection* planes);

  /// Marks the colours as changed; call it after only Rgba has changed.
  void ColorsChanged() { this->Changed = true; }

  std::size_t GetMemorySize() const;

private:
  void SetPoints(const float* xyz, const std::uint8_t* rgba, vtkIdType count);

  vtkRenderer* Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkPointGaussianMapper> Mapper;
  vtkNew<vtkPolyData> Data;
  vtkNew<vtkFloatArray> Xyz;
  vtkNew<vtkUnsignedCharArray> Colors;
  std::vector<float> SomeXyz;
  std::vector<std::uint8_t> SomeRgba;
  const float* Shown = nullptr;
  vtkIdType Count = 0;
  bool Changed = true;
};

} // namespace helios::viewer

#endif
