// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosLeadingEdgeDetector.h"

#include "heliosConstants.h"
#include "heliosDiscriminator.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkHeliosLeadingEdgeDetector);

//------------------------------------------------------------------------------
void vtkHeliosLeadingEdgeDetector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Fraction: " << this->Fraction << "\n"
     << indent << "ReferenceAmplitude: " << this->ReferenceAmplitude << " W\n";
}

//------------------------------------------------------------------------------
/// Returns the amplitude without range walk.
double vtkHeliosLeadingEdgeDetector::GetCalibrationAmplitude() const
{
  const double level =
    this->DetectionThreshold > 0.0 ? this->DetectionThreshold : std::numeric_limits<float>::min();
  return this->ReferenceAmplitude > 0.0 ? this->ReferenceAmplitude
    : this->Fraction > 0.0              ? level / this->Fraction * 1000.0
                                        : 2.0 * level;
}

//------------------------------------------------------------------------------
void vtkHeliosLeadingEdgeDetector::Detect(
  const vtkHeliosWaveform& w, std::vector<vtkHeliosDetectedEcho>& echoes) const
{
  const vtkIdType largest = helios::FindLargest(w, 0, w.Count - 1);
  if (largest < 0)
  {
    return;
  }
  const double level = std::max({ this->DetectionThreshold,
    this->Fraction * helios::GetSample(w, largest), std::numeric_limits<double>::min() });
  const double ratio = this->ReferenceAmplitude > 0.0 ? this->ReferenceAmplitude / level
    : this->Fraction > 0.0                            ? 1.0 / this->Fraction
                                                      : 2.0;
  const double sigma = w.PulseLength / helios::FwhmPerSigma;
  const double delay = sigma * std::sqrt(2.0 * std::log(std::max(1.0, ratio)));
  double ready = -std::numeric_limits<double>::infinity();
  for (vtkIdType i = 0; i < w.Count; ++i)
  {
    const double before = helios::GetSample(w, i - 1);
    const double after = helios::GetSample(w, i);
    if (!(before < level && after >= level))
    {
      continue;
    }
    const double share = (level - before) / (after - before);
    const double time = w.BinSize * std::max(0.0, static_cast<double>(i - 1) + share);
    if (time >= ready)
    {
      vtkIdType end = i;
      while (helios::GetSample(w, end + 1) >= level)
      {
        ++end;
      }
      const vtkIdType peak = helios::FindLargest(w, i, end);
      echoes.push_back({ time + delay, helios::GetSample(w, peak), helios::GetFullWidth(w, peak) });
      ready = time + this->DeadTime;
    }
  }
}
