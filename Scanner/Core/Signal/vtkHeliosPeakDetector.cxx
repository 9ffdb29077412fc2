// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPeakDetector.h"

#include "heliosConstants.h"
#include "heliosPeaks.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkHeliosPeakDetector);

//------------------------------------------------------------------------------
void vtkHeliosPeakDetector::SetInstrument(const vtkHeliosInstrumentData& instrument)
{
  this->Superclass::SetInstrument(instrument);
  this->SetMinimumSeparation(instrument.PeakWindow);
}

//------------------------------------------------------------------------------
void vtkHeliosPeakDetector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FitWindow: " << this->FitWindow << " sigma\n"
     << indent << "MinimumSeparation: " << this->MinimumSeparation << " ns\n";
}

//------------------------------------------------------------------------------
void vtkHeliosPeakDetector::Detect(
  const vtkHeliosWaveform& waveform, std::vector<vtkHeliosDetectedEcho>& echoes) const
{
  static thread_local std::vector<helios::Peak> peaks;
  helios::FindPeaks(waveform, this->DetectionThreshold, this->MinimumSeparation, peaks);
  const std::size_t before = echoes.size();
  const double reach = this->FitWindow * waveform.PulseLength / helios::FwhmPerSigma;
  for (const helios::Peak& peak : peaks)
  {
    echoes.push_back(
      reach > 0.0 ? helios::FitPeak(waveform, peak, reach) : helios::FitPeak(waveform, peak));
  }
  this->RemoveDead(echoes, before);
}
