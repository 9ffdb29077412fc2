// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A pulse in the scene: the marked echo, sub-rays to their hits, waveforms along beams.

#ifndef heliosPulseView_h
#define heliosPulseView_h

#include "heliosPulseReading.h"
#include "heliosStatus.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

class vtkActor;
class vtkActor2D;
class vtkPolyData;
class vtkRenderer;
class vtkTable;

namespace helios::viewer
{

class PulseView
{
public:
  /// Draws with a renderer, which must outlive the view.
  explicit PulseView(vtkRenderer* renderer);
  ~PulseView();
  PulseView(const PulseView&) = delete;
  void operator=(const PulseView&) = delete;

  /// Sets the origin of everything drawn [m]; set it first.
  void SetOrigin(const Vec3& origin) { this->Origin = origin; }

  /// Draws a ring around a position [m], of constant size on screen.
  void SetMark(const Vec3& position);

  /**
   * Lines from the pulse origin to the hits of its sub-rays, in the colours of the parts; without
   * sub-rays the beam axis, to each echo.
   */
  void SetBeams(const PulseReading& reading);

  /**
   * Shows waveforms as curves along their beams, the highest of a height [m], across the view:
   * every nth, or only the waveform of one pulse (0 or more).
   */
  Status SetWaveforms(vtkTable* waveforms, double height, int everyNth, std::int64_t pulse);

  void Clear();

  /// Hides the ring behind the camera; call before every frame.
  void Update();

  vtkIdType GetNumberOfBeams() const;
  vtkIdType GetNumberOfHits() const;
  vtkIdType GetNumberOfWaveforms() const;
  vtkPolyData* GetBeams() const { return this->Beams; }
  vtkPolyData* GetWaveforms() const { return this->Waveforms; }

private:
  vtkRenderer* Renderer;
  Vec3 Origin{ 0.0, 0.0, 0.0 };
  Vec3 Marked{ 0.0, 0.0, 0.0 };
  bool HasMark = false;
  vtkNew<vtkActor2D> Mark;
  vtkNew<vtkActor> BeamActor;
  vtkNew<vtkActor2D> HitActor;
  vtkNew<vtkActor> WaveformActor; // waveforms of a line
  vtkNew<vtkActor2D> Curve;       // waveform of one pulse, on top
  vtkNew<vtkPolyData> Beams;
  vtkNew<vtkPolyData> Hits;
  vtkNew<vtkPolyData> Waveforms;
};

} // namespace helios::viewer

#endif
