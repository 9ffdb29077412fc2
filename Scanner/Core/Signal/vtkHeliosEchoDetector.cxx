// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosEchoDetector.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkHeliosEchoDetector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DetectionThreshold: " << this->DetectionThreshold << " W\n"
     << indent << "DeadTime: " << this->DeadTime << " ns\n";
}

//------------------------------------------------------------------------------
void vtkHeliosEchoDetector::SetInstrument(const vtkHeliosInstrumentData& instrument)
{
  this->SetDetectionThreshold(instrument.DetectionThreshold);
  this->SetDeadTime(instrument.DeadTime);
}

//------------------------------------------------------------------------------
double vtkHeliosEchoDetector::GetCalibrationAmplitude() const
{
  return this->DetectionThreshold > 0.0 ? 1000.0 * this->DetectionThreshold : 1.0;
}

//------------------------------------------------------------------------------
bool vtkHeliosEchoDetector::DetectAll(const std::vector<vtkHeliosWaveform>& waveforms,
  std::vector<Echoes>& echoes, std::string& vtkNotUsed(error)) const
{
  for (std::size_t i = 0; i < waveforms.size(); ++i)
  {
    this->Detect(waveforms[i], echoes[i]);
  }
  return true;
}

//------------------------------------------------------------------------------
std::shared_ptr<void> vtkHeliosEchoDetector::PrepareThreads() const
{
  return nullptr;
}

//------------------------------------------------------------------------------
void vtkHeliosEchoDetector::RemoveDead(
  std::vector<vtkHeliosDetectedEcho>& echoes, std::size_t first) const
{
  if (!(this->DeadTime > 0.0))
  {
    return;
  }
  double ready = -std::numeric_limits<double>::infinity();
  const auto isDead = [this, &ready](const vtkHeliosDetectedEcho& echo)
  {
    const bool isLost = echo.Time < ready;
    ready = isLost ? ready : echo.Time + this->DeadTime;
    return isLost;
  };
  auto kept = echoes.begin() + static_cast<std::ptrdiff_t>(first);
  for (auto echo = kept; echo != echoes.end(); ++echo) // in order, unlike std::remove_if
  {
    if (!isDead(*echo))
    {
      *kept++ = *echo;
    }
  }
  echoes.erase(kept, echoes.end());
}
