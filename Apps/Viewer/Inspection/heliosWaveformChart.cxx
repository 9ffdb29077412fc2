// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosWaveformChart.h"

#include "heliosConstants.h"
#include "heliosPainter.h"
#include "heliosTheme.h"
#include "heliosTicks.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkContextActor.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkPlotPoints.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace helios::viewer
{

namespace
{

constexpr int CurvePoints = 121; // points of a Gaussian
constexpr double CurveSigmas = 4.0;
constexpr int ChartMargin = 6; // [pixels]

vtkSmartPointer<vtkTable> MakeTable(const std::vector<double>& x, const std::vector<double>& y)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  for (const auto* values : { &x, &y })
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(values == &x ? "range" : "power");
    for (const double value : *values)
    {
      column->InsertNextValue(value);
    }
    table->AddColumn(column);
  }
  return table;
}

vtkPlot* Add(vtkChartXY* chart, int type, vtkTable* table, const char* label)
{
  vtkPlot* plot = chart->AddPlot(type);
  plot->SetInputData(table, 0, 1);
  plot->SetLabel(label);
  plot->SetLegendVisibility(*label != 0);
  return plot;
}

vtkSmartPointer<vtkTable> MakeCurve(const PulseGaussian& gaussian)
{
  std::vector<double> x, y;
  for (int i = 0; i < CurvePoints; ++i)
  {
    const double s = CurveSigmas * (2.0 * i / (CurvePoints - 1) - 1.0);
    x.push_back(gaussian.Range + s * gaussian.Sigma);
    y.push_back(gaussian.Power * std::exp(-0.5 * s * s));
  }
  return MakeTable(x, y);
}

void SetPen(vtkPen* pen, const Rgb& color)
{
  pen->SetColor(color[0], color[1], color[2], 255);
}

void SetColor(vtkPlot* plot, const Rgb& color, unsigned char opacity = 255)
{
  plot->SetColor(color[0], color[1], color[2], opacity);
}

} // namespace

/// The chart background.
class ChartPanel : public vtkContextItem
{
public:
  static ChartPanel* New();
  vtkTypeMacro(ChartPanel, vtkContextItem);

  bool Paint(vtkContext2D* context) override
  {
    Painter(context, *this->Colors, 0).DrawPanel(this->Place);
    return true;
  }

  Rect Place;
  const Theme* Colors = nullptr;
};
vtkStandardNewMacro(ChartPanel);

//------------------------------------------------------------------------------
WaveformChart::WaveformChart(vtkRenderer* renderer)
  : Renderer(renderer)
  , Panel(vtkSmartPointer<ChartPanel>::New())
  , Colors(&FindTheme(""))
{
  this->Panel->Colors = this->Colors;
  this->Chart->SetAutoSize(false);
  this->Chart->SetShowLegend(true);
  for (const int side : { vtkAxis::BOTTOM, vtkAxis::LEFT, vtkAxis::TOP })
  {
    vtkAxis* axis = this->Chart->GetAxis(side);
    axis->SetBehavior(vtkAxis::FIXED);
    axis->SetVisible(true);
    axis->SetGridVisible(side != vtkAxis::TOP);
  }
  this->Actor->GetScene()->AddItem(this->Panel);
  this->Actor->GetScene()->AddItem(this->Chart);
  this->Actor->PickableOff();
  renderer->AddActor(this->Actor);
  this->Hide();
}

//------------------------------------------------------------------------------
WaveformChart::~WaveformChart()
{
  this->Renderer->RemoveActor(this->Actor);
}

//------------------------------------------------------------------------------
void WaveformChart::Show(const PulseReading& reading, int returnNumber, const std::string& title)
{
  this->Chart->ClearPlots();
  this->Chart->SetTitle(title);
  this->NumberOfSamples = this->NumberOfEchoes = this->NumberOfGaussians = 0;
  const bool hasSamples = !reading.Samples.empty();
  for (const int axis : { vtkAxis::BOTTOM, vtkAxis::LEFT, vtkAxis::TOP })
  {
    this->Chart->GetAxis(axis)->SetVisible(hasSamples);
  }
  if (hasSamples)
  {
    this->SetRanges(reading);
    this->AddPulse(reading);
    this->AddSamples(reading);
    this->AddGaussians(reading);
    this->AddEchoes(reading, returnNumber);
    this->AddTimes();
  }
  this->IsShown = true;
  this->Actor->SetVisibility(!this->Rectangle.IsEmpty());
}

//------------------------------------------------------------------------------
void WaveformChart::SetRanges(const PulseReading& reading)
{
  double high = *std::max_element(reading.Samples.begin(), reading.Samples.end());
  double low = *std::min_element(reading.Samples.begin(), reading.Samples.end());
  double first = reading.Ranges.front();
  double last = reading.Ranges.back();
  for (const PulseEcho& echo : reading.Echoes)
  {
    high = std::isnan(echo.Amplitude) ? high : std::max(high, echo.Amplitude);
    first = std::isnan(echo.Range) ? first : std::min(first, echo.Range);
    last = std::isnan(echo.Range) ? last : std::max(last, echo.Range);
  }
  const double margin = std::max(0.02 * (last - first), 1e-3);
  this->Chart->GetAxis(vtkAxis::BOTTOM)->SetRange(first - margin, last + margin);
  this->Chart->GetAxis(vtkAxis::TOP)
    ->SetRange(GetTwoWayTime(first - margin), GetTwoWayTime(last + margin));
  this->Chart->GetAxis(vtkAxis::LEFT)->SetRange(std::min(0.0, low), 1.15 * high);
  this->SetUpAxis(vtkAxis::BOTTOM, "range", "m", 7);
  this->SetUpAxis(vtkAxis::TOP, "two-way time", "ns", 7);
  this->SetUpAxis(vtkAxis::LEFT, "power", "W", 6);
}

//------------------------------------------------------------------------------
/// Ticks at round values, and a title with their unit.
void WaveformChart::SetUpAxis(
  int axis, const std::string& quantity, const std::string& unit, int maximum)
{
  vtkAxis* drawn = this->Chart->GetAxis(axis);
  const Ticks ticks = MakeTicks(drawn->GetMinimum(), drawn->GetMaximum(), maximum, unit);
  vtkNew<vtkDoubleArray> values;
  vtkNew<vtkStringArray> texts;
  for (const Tick& tick : ticks.List)
  {
    values->InsertNextValue(tick.Value);
    texts->InsertNextValue(tick.Text);
  }
  drawn->SetCustomTickPositions(values, texts);
  drawn->SetTitle(quantity + " [" + ticks.Unit + "]");
}

//------------------------------------------------------------------------------
/// Adds the axis of times; it is drawn only with a plot: an invisible line.
void WaveformChart::AddTimes()
{
  vtkAxis* times = this->Chart->GetAxis(vtkAxis::TOP);
  const auto line = MakeTable({ times->GetMinimum(), times->GetMaximum() }, { 0.0, 0.0 });
  vtkPlot* plot = Add(this->Chart, vtkChart::LINE, line, "");
  plot->SetColor(0, 0, 0, 0);
  this->Chart->SetPlotCorner(plot, 3); // left and top
}

//------------------------------------------------------------------------------
void WaveformChart::AddSamples(const PulseReading& reading)
{
  const std::vector<double> powers(reading.Samples.begin(), reading.Samples.end());
  vtkPlot* plot = Add(this->Chart, vtkChart::LINE, MakeTable(reading.Ranges, powers), "waveform");
  SetColor(plot, this->Colors->Waveform);
  plot->SetWidth(2.0F);
  this->NumberOfSamples = static_cast<vtkIdType>(powers.size());
}

//------------------------------------------------------------------------------
void WaveformChart::AddGaussians(const PulseReading& reading)
{
  for (const PulseGaussian& gaussian : reading.Gaussians)
  {
    vtkPlot* plot = Add(this->Chart, vtkChart::LINE, MakeCurve(gaussian),
      this->NumberOfGaussians == 0 ? "fitted Gaussians" : "");
    SetColor(plot, this->Colors->Fit);
    plot->SetWidth(1.5F);
    plot->GetPen()->SetLineType(vtkPen::DASH_LINE);
    ++this->NumberOfGaussians;
  }
}

//------------------------------------------------------------------------------
/// Adds a Gaussian of the emitted pulse width, at the first echo: wider echoes were spread by the
/// target.
void WaveformChart::AddPulse(const PulseReading& reading)
{
  if (!(reading.PulseLength > 0.0) || reading.Gaussians.empty())
  {
    return;
  }
  PulseGaussian sent = reading.Gaussians.front();
  sent.Sigma = 0.5 * SpeedOfLight * reading.PulseLength / FwhmPerSigma;
  char label[64];
  std::snprintf(label, sizeof(label), "emitted pulse, %.3g ns", reading.PulseLength);
  vtkPlot* plot = Add(this->Chart, vtkChart::LINE, MakeCurve(sent), label);
  SetColor(plot, this->Colors->FaintInk);
  plot->SetWidth(1.0F);
}

//------------------------------------------------------------------------------
void WaveformChart::AddEchoes(const PulseReading& reading, int returnNumber)
{
  std::vector<double> x[2], y[2]; // all, the marked one
  for (const PulseEcho& echo : reading.Echoes)
  {
    for (const int i : { 0, 1 })
    {
      if ((i == 0 || echo.ReturnNumber == returnNumber) && !std::isnan(echo.Range))
      {
        x[i].push_back(echo.Range);
        y[i].push_back(std::isnan(echo.Amplitude) ? 0.0 : echo.Amplitude);
      }
    }
  }
  this->NumberOfEchoes = static_cast<vtkIdType>(x[0].size());
  const char* const labels[2] = { "echoes", "selected return" };
  for (const int i : { 1, 0 })
  {
    if (!x[i].empty())
    {
      vtkPlot* plot = Add(this->Chart, vtkChart::POINTS, MakeTable(x[i], y[i]), labels[i]);
      auto* points = vtkPlotPoints::SafeDownCast(plot);
      points->SetMarkerStyle(i == 0 ? vtkPlotPoints::DIAMOND : vtkPlotPoints::CIRCLE);
      points->SetMarkerSize(i == 0 ? 10.0F : 20.0F);
      SetColor(plot, this->Colors->Mark, i == 0 ? 255 : 90);
    }
  }
}

//------------------------------------------------------------------------------
void WaveformChart::Hide()
{
  this->Chart->ClearPlots();
  this->NumberOfSamples = this->NumberOfEchoes = this->NumberOfGaussians = 0;
  this->IsShown = false;
  this->Actor->VisibilityOff();
}

//------------------------------------------------------------------------------
bool WaveformChart::Place(const Rect& rect, const Theme& theme, int textSize)
{
  if (rect == this->Rectangle && &theme == this->Colors && textSize == this->TextSize)
  {
    return false;
  }
  this->Rectangle = rect;
  this->Colors = &theme;
  this->TextSize = textSize;
  this->Panel->Place = rect;
  this->Panel->Colors = &theme;
  const Rect inside = rect.Shrunk(ChartMargin);
  this->Chart->SetSize(vtkRectf(static_cast<float>(inside.X), static_cast<float>(inside.Y),
    static_cast<float>(inside.Width), static_cast<float>(inside.Height)));
  this->SetColors();
  this->Actor->SetVisibility(this->IsShown && !rect.IsEmpty());
  return this->IsShown;
}

//------------------------------------------------------------------------------
/// Sets the colours of all but the curves, which keep the colours they were added with.
void WaveformChart::SetColors()
{
  const Theme& theme = *this->Colors;
  const int size = std::max(8, 9 * this->TextSize / 10);
  vtkChartLegend* legend = this->Chart->GetLegend();
  legend->GetBrush()->SetColor(theme.Panel[0], theme.Panel[1], theme.Panel[2], theme.Opacity);
  SetPen(legend->GetPen(), theme.Border);
  legend->SetLabelSize(size);
  SetUpText(legend->GetLabelProperties(), theme.Ink, size);
  SetUpText(this->Chart->GetTitleProperties(), theme.Ink, size);
  this->Chart->GetTitleProperties()->SetLineSpacing(1.2);
  for (const int side : { vtkAxis::BOTTOM, vtkAxis::LEFT, vtkAxis::TOP, vtkAxis::RIGHT })
  {
    vtkAxis* axis = this->Chart->GetAxis(side);
    SetUpText(axis->GetLabelProperties(), theme.Ink, size);
    SetUpText(axis->GetTitleProperties(), theme.Ink, size);
    SetPen(axis->GetGridPen(), theme.Border);
    SetPen(axis->GetPen(), theme.Ink);
  }
}

//------------------------------------------------------------------------------
bool WaveformChart::Contains(int x, int y) const
{
  return this->IsVisible() && this->Rectangle.Contains(x, y);
}

//------------------------------------------------------------------------------
std::string WaveformChart::GetTitle() const
{
  return this->Chart->GetTitle();
}

} // namespace helios::viewer
