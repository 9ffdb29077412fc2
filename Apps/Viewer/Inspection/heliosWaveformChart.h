// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A chart of a pulse's waveform over the picture: samples, echoes, Gaussians.

#ifndef heliosWaveformChart_h
#define heliosWaveformChart_h

#include "heliosPulseReading.h"
#include "heliosRect.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>

class vtkAxis;
class vtkChartXY;
class vtkContextActor;
class vtkPlot;
class vtkRenderer;

namespace helios::viewer
{

class ChartPanel;
struct Theme;

/// Range [m] below, two-way time [ns] above, power to the left.
class WaveformChart
{
public:
  /// Draws with a renderer, which must outlive the chart.
  explicit WaveformChart(vtkRenderer* renderer);
  ~WaveformChart();
  WaveformChart(const WaveformChart&) = delete;
  void operator=(const WaveformChart&) = delete;

  /**
   * Shows a pulse, with the echo of a return number marked. Without samples: only the title, with
   * the reason.
   */
  void Show(const PulseReading& reading, int returnNumber, const std::string& title);
  void Hide();
  bool IsVisible() const { return this->IsShown; }

  /// Places the chart in a rectangle [pixels]; an empty one hides it. True: something has changed.
  bool Place(const Rect& rect, const Theme& theme, int textSize);

  /// Returns whether a window pixel belongs to the chart.
  bool Contains(int x, int y) const;

  /// @{
  /// Returns the drawn chart.
  vtkChartXY* GetChart() const { return this->Chart; }
  vtkIdType GetNumberOfSamples() const { return this->NumberOfSamples; }
  vtkIdType GetNumberOfEchoes() const { return this->NumberOfEchoes; }
  vtkIdType GetNumberOfGaussians() const { return this->NumberOfGaussians; }
  std::string GetTitle() const;
  ///@}

private:
  void SetRanges(const PulseReading& reading);
  void AddSamples(const PulseReading& reading);
  void AddGaussians(const PulseReading& reading);
  void AddPulse(const PulseReading& reading);
  void AddEchoes(const PulseReading& reading, int returnNumber);
  void AddTimes();
  void SetUpAxis(int axis, const std::string& quantity, const std::string& unit, int maximum);
  void SetColors();

  vtkRenderer* Renderer;
  vtkNew<vtkContextActor> Actor;
  vtkNew<vtkChartXY> Chart;
  vtkSmartPointer<ChartPanel> Panel;
  bool IsShown = false;
  Rect Rectangle;
  const Theme* Colors = nullptr;
  int TextSize = 0;
  vtkIdType NumberOfSamples = 0;
  vtkIdType NumberOfEchoes = 0;
  vtkIdType NumberOfGaussians = 0;
};

} // namespace helios::viewer

#endif
