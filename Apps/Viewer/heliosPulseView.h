// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A pulse in the scene: the echo that is marked, sub-rays to what they hit, waveforms along beams.

#ifndef heliosPulseView_h
#define heliosPulseView_h

#include "heliosPulseReading.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

class vtkActor;
class vtkActor2D;
class vtkPolyData;
class vtkRenderer;
class vtkTable;

namespace helios
{

class PulseView
{
public:
  /// The renderer must outlive the view.
  explicit PulseView(vtkRenderer* renderer);
  ~PulseView();
  PulseView(const PulseView&) = delete;
  void operator=(const PulseView&) = delete;

  /// What everything is drawn less [m]; before anything else.
  void SetOrigin(const Vec3& origin) { this->Origin = origin; }

  /// A ring around a place [m], of the same size from everywhere.
  void SetMark(const Vec3& position);

  /**
   * Lines from where the pulse leaves to the hits of its sub-rays, in the colours of the parts;
   * without sub-rays the axis of the beam, to each echo.
   */
  void SetBeams(const PulseReading& reading);

  /**
   * Waveforms as curves along their beams, the highest so high [m], across the view: every nth,
   * or those of one pulse alone (0 or more). Says in words what is wrong with them.
   */
  std::string SetWaveforms(vtkTable* waveforms, double height, int everyNth, std::int64_t pulse);

  void Clear();

  /// Hides the ring where it is behind the camera; before every picture.
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
  vtkNew<vtkActor> WaveformActor; // of a line
  vtkNew<vtkActor2D> Curve;       // of one pulse, over all
  vtkNew<vtkPolyData> Beams;
  vtkNew<vtkPolyData> Hits;
  vtkNew<vtkPolyData> Waveforms;
};

} // namespace helios

#endif
