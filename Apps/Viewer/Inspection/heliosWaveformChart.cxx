// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosWaveformChart.h"

#include "heliosConstants.h"

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

constexpr int CurvePoints = 121; // of a Gaussian
constexpr double CurveSigmas = 4.0;
const double Ink[3] = { 0.86, 0.88, 0.91 };

/// The unit in which a power is 1 to 999, and its name.
std::pair<double, const char*> FindUnit(double watts)
{
  static const std::pair<double, const char*> units[] = { { 1.0, "W" }, { 1e-3, "mW" },
    { 1e-6, "\xC2\xB5W" }, { 1e-9, "nW" }, { 1e-12, "pW" }, { 1e-15, "fW" } };
  for (const auto& unit : units)
  {
    if (std::abs(watts) >= unit.first)
    {
      return unit;
    }
  }
  return units[5];
}

void SetInk(vtkTextProperty* letters, int size)
{
  letters->SetColor(Ink[0], Ink[1], Ink[2]);
  letters->SetFontSize(size);
  letters->BoldOff();
}

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

vtkSmartPointer<vtkTable> MakeCurve(const PulseGaussian& gaussian, double unit)
{
  std::vector<double> x, y;
  for (int i = 0; i < CurvePoints; ++i)
  {
    const double s = CurveSigmas * (2.0 * i / (CurvePoints - 1) - 1.0);
    x.push_back(gaussian.Range + s * gaussian.Sigma);
    y.push_back(gaussian.Power * std::exp(-0.5 * s * s) / unit);
  }
  return MakeTable(x, y);
}

void SetUpAxis(vtkAxis* axis, bool hasGrid)
{
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetVisible(true);
  axis->SetGridVisible(hasGrid);
  axis->GetGridPen()->SetColorF(0.28, 0.31, 0.36);
  axis->GetPen()->SetColorF(Ink[0], Ink[1], Ink[2]);
}

} // namespace

/// The chart background.
class ChartPanel : public vtkContextItem
{
public:
  static ChartPanel* New();
  vtkTypeMacro(ChartPanel, vtkContextItem);

  bool Paint(vtkContext2D* painter) override
  {
    painter->GetBrush()->SetColor(14, 17, 23, 225);
    painter->GetPen()->SetColor(90, 98, 112, 255);
    painter->GetPen()->SetWidth(1.0F);
    painter->DrawRect(this->Place[0], this->Place[1], this->Place[2], this->Place[3]);
    return true;
  }

  float Place[4] = { 0.0F, 0.0F, 1.0F, 1.0F }; // x y width height [pixels]
};
vtkStandardNewMacro(ChartPanel);

//------------------------------------------------------------------------------
WaveformChart::WaveformChart(vtkRenderer* renderer)
  : Renderer(renderer)
  , Panel(vtkSmartPointer<ChartPanel>::New())
{
  this->Chart->SetAutoSize(false);
  this->Chart->SetShowLegend(true);
  this->Chart->GetLegend()->GetBrush()->SetColor(14, 17, 23, 200);
  this->Chart->GetLegend()->GetPen()->SetColor(90, 98, 112, 255);
  SetUpAxis(this->Chart->GetAxis(vtkAxis::BOTTOM), true);
  SetUpAxis(this->Chart->GetAxis(vtkAxis::LEFT), true);
  SetUpAxis(this->Chart->GetAxis(vtkAxis::TOP), false);
  this->Chart->GetAxis(vtkAxis::BOTTOM)->SetTitle("range [m]");
  this->Chart->GetAxis(vtkAxis::TOP)->SetTitle("two-way time [ns]");
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
  this->SetCovered(this->IsCovered);
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
  const auto unit = FindUnit(high);
  this->Unit = unit.first;
  this->UnitName = unit.second;
  this->Chart->GetAxis(vtkAxis::BOTTOM)->SetRange(first - margin, last + margin);
  this->Chart->GetAxis(vtkAxis::TOP)
    ->SetRange(GetTwoWayTime(first - margin), GetTwoWayTime(last + margin));
  vtkAxis* power = this->Chart->GetAxis(vtkAxis::LEFT);
  power->SetTitle("power [" + this->UnitName + "]");
  power->SetRange(std::min(0.0, low) / unit.first, 1.15 * high / unit.first);
}

//------------------------------------------------------------------------------
/// An axis is drawn only with a plot: an invisible line.
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
  std::vector<double> powers;
  for (const double sample : reading.Samples)
  {
    powers.push_back(sample / this->Unit);
  }
  vtkPlot* plot = Add(this->Chart, vtkChart::LINE, MakeTable(reading.Ranges, powers), "waveform");
  plot->SetColor(89, 217, 255, 255);
  plot->SetWidth(2.0F);
  this->NumberOfSamples = static_cast<vtkIdType>(powers.size());
}

//------------------------------------------------------------------------------
void WaveformChart::AddGaussians(const PulseReading& reading)
{
  for (const PulseGaussian& gaussian : reading.Gaussians)
  {
    vtkPlot* plot = Add(this->Chart, vtkChart::LINE, MakeCurve(gaussian, this->Unit),
      this->NumberOfGaussians == 0 ? "fitted Gaussians" : "");
    plot->SetColor(255, 115, 140, 255);
    plot->SetWidth(1.5F);
    plot->GetPen()->SetLineType(vtkPen::DASH_LINE);
    ++this->NumberOfGaussians;
  }
}

//------------------------------------------------------------------------------
/// A Gaussian of the emitted pulse width, at the first echo: wider echoes were spread by the
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
  vtkPlot* plot = Add(this->Chart, vtkChart::LINE, MakeCurve(sent, this->Unit), label);
  plot->SetColor(153, 161, 173, 255);
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
        y[i].push_back(std::isnan(echo.Amplitude) ? 0.0 : echo.Amplitude / this->Unit);
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
      i == 0 ? plot->SetColor(255, 216, 64, 255) : plot->SetColor(255, 216, 64, 90);
    }
  }
}

//------------------------------------------------------------------------------
void WaveformChart::Hide()
{
  this->Chart->ClearPlots();
  this->NumberOfSamples = this->NumberOfEchoes = this->NumberOfGaussians = 0;
  this->IsShown = false;
  this->SetCovered(this->IsCovered);
}

//------------------------------------------------------------------------------
void WaveformChart::SetCovered(bool covered)
{
  this->IsCovered = covered;
  this->Actor->SetVisibility(this->IsShown && !covered);
}

//------------------------------------------------------------------------------
bool WaveformChart::Resize(int width, int height)
{
  if (width == this->Size[0] && height == this->Size[1])
  {
    return false;
  }
  this->Size[0] = width;
  this->Size[1] = height;
  float* place = this->Panel->Place;
  place[0] = std::floor(0.012F * static_cast<float>(width));
  place[1] = std::floor(0.13F * static_cast<float>(height));
  place[2] = std::floor(0.5F * static_cast<float>(width));
  place[3] = std::floor(0.46F * static_cast<float>(height));
  this->Chart->SetSize(
    vtkRectf(place[0] + 4.0F, place[1] + 4.0F, place[2] - 12.0F, place[3] - 12.0F));
  const int size = std::clamp(std::min(width / 95, height / 60), 8, 24);
  SetInk(this->Chart->GetTitleProperties(), size + 1);
  SetInk(this->Chart->GetLegend()->GetLabelProperties(), size);
  this->Chart->GetLegend()->SetLabelSize(size);
  for (const int axis : { vtkAxis::BOTTOM, vtkAxis::LEFT, vtkAxis::TOP, vtkAxis::RIGHT })
  {
    SetInk(this->Chart->GetAxis(axis)->GetLabelProperties(), size);
    SetInk(this->Chart->GetAxis(axis)->GetTitleProperties(), size);
  }
  return true;
}

//------------------------------------------------------------------------------
bool WaveformChart::Contains(int x, int y) const
{
  const float* place = this->Panel->Place;
  const float dx = static_cast<float>(x) - place[0];
  const float dy = static_cast<float>(y) - place[1];
  return this->IsVisible() && dx >= 0.0F && dy >= 0.0F && dx < place[2] && dy < place[3];
}

//------------------------------------------------------------------------------
std::string WaveformChart::GetTitle() const
{
  return this->Chart->GetTitle();
}

//------------------------------------------------------------------------------
std::string DescribePower(double watts)
{
  const auto unit = FindUnit(watts);
  char text[64];
  std::snprintf(text, sizeof(text), "%.3g %s", watts / unit.first, unit.second);
  return text;
}

} // namespace helios::viewer
