// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Inspector: shows the pulse of a clicked echo: waveform, echoes, Gaussians, sub-rays.

#ifndef heliosInspector_h
#define heliosInspector_h

#include "heliosPulseReading.h"
#include "heliosPulseView.h"
#include "heliosViewerTool.h"
#include "heliosWaveformChart.h"
#include "heliosWaveformSearch.h"

#include <vtkType.h>

#include <future>
#include <string>
#include <vector>

namespace helios::viewer
{

class Viewer;
struct Echo;

/**
 * Tool that shows a selected pulse. With a running survey, the pulse is run again; for a finished
 * cloud, its waveform is searched beside the file. Neither blocks: the known attributes of the echo
 * are shown at once.
 */
class Inspector : public ViewerTool
{
public:
  explicit Inspector(Viewer& viewer);
  ~Inspector() override;

  std::string GetName() const override { return "Inspector"; }
  std::vector<KeyHelp> GetKeys() const override;
  bool OnKey(const std::string& key, bool control) override;
  bool OnClick(int x, int y) override;
  void Place() override { this->PlaceChart(); }
  bool OnFrame() override;
  void OnNewSurvey() override;
  std::string GetStatus() const override;
  void Describe(Json::Value& state) const override;

  /// Shows the pulse of a cloud row.
  void Inspect(vtkIdType row);
  bool PlaceChart();
  void Close();

  /// Returns whether a result is pending.
  bool IsWaiting() const { return this->Record.valid() || this->LineRecord.valid(); }

  vtkIdType GetRow() const { return this->Row; } ///< -1: not shown
  const PulseReading& GetReading() const { return this->Reading; }
  const PulseView& GetView() const { return this->View; }
  const WaveformChart& GetChart() const { return this->Chart; }

private:
  void Toggle();
  void StepEcho(int step);
  void StepPulse(int step);
  void ShowLine();
  void ReceivePulse();
  void ReceiveLine();
  void RequestPulse(const Echo& echo);
  std::future<PulseRecord> Find(int leg, vtkIdType first, vtkIdType last, bool hasSubRays);
  void Show();
  void FindEchoes(const Echo& echo);
  vtkIdType FindLineLength(int leg) const;
  std::string DescribeEcho() const;
  std::string DescribeSurface(const Echo& echo) const;

  Viewer& Owner;
  PulseView View;
  WaveformChart Chart;
  WaveformSearch Search;
  vtkIdType Row = -1;
  PulseReading Reading;
  std::string Problem; ///< why there is no waveform
  std::future<PulseRecord> Record;
  std::future<PulseRecord> LineRecord;
};

} // namespace helios::viewer

#endif
