// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosConstantFractionDetector.h"

#include "heliosConstants.h"
#include "heliosDiscriminator.h"

#include <vtkObjectFactory.h>

#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkHeliosConstantFractionDetector);

//------------------------------------------------------------------------------
void vtkHeliosConstantFractionDetector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Fraction: " << this->Fraction << "\n"
     << indent << "Delay: " << this->Delay << " ns\n";
}

//------------------------------------------------------------------------------
void vtkHeliosConstantFractionDetector::Detect(
  const vtkHeliosWaveform& w, std::vector<vtkHeliosDetectedEcho>& echoes) const
{
  const double delay = this->Delay > 0.0 ? this->Delay : w.PulseLength;
  const double sigma = w.PulseLength / helios::FwhmPerSigma;
  const double offset = 0.5 * delay + sigma * sigma * std::log(this->Fraction) / delay;
  const double reach = 0.5 * w.PulseLength / w.BinSize;
  double ready = -std::numeric_limits<double>::infinity();
  double before = 0.0;
  for (vtkIdType i = 0; i <= w.Count; ++i)
  {
    const double now = static_cast<double>(i) * w.BinSize;
    const double after =
      this->Fraction * helios::GetSample(w, i) - helios::Interpolate(w, now - delay);
    if (before > 0.0 && after <= 0.0)
    {
      const double crossing = now - w.BinSize * after / (after - before);
      const double time = crossing - offset;
      const double bin = time / w.BinSize;
      const vtkIdType peak = helios::FindLargest(w, static_cast<vtkIdType>(std::ceil(bin - reach)),
        static_cast<vtkIdType>(std::floor(bin + reach)));
      const double amplitude = helios::GetSample(w, peak);
      if (crossing >= ready && amplitude > 0.0 && amplitude >= this->DetectionThreshold)
      {
        echoes.push_back({ time, amplitude, helios::GetFullWidth(w, peak) });
        ready = crossing + this->DeadTime;
      }
    }
    before = after;
  }
}
