// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A plug-in: an echo detector that finds the first sample above the threshold. For vtkhelios run
// survey.xml --plugin libown_detector.so --detector firstSample.
#include <vtkHeliosEchoDetection.h>
#include <vtkHeliosEchoDetector.h>

#include <vtkNew.h>
#include <vtkObjectFactory.h>

#include <algorithm>

class ownDetector : public vtkHeliosEchoDetector
{
public:
  static ownDetector* New();
  vtkTypeMacro(ownDetector, vtkHeliosEchoDetector);

  void Detect(
    const vtkHeliosWaveform& waveform, std::vector<vtkHeliosDetectedEcho>& echoes) const override
  {
    const float* end = waveform.Samples + waveform.Count;
    const float* first = std::find_if(
      waveform.Samples, end, [this](float sample) { return sample > this->DetectionThreshold; });
    if (first != end)
    {
      const auto index = static_cast<double>(first - waveform.Samples);
      echoes.push_back({ index * waveform.BinSize, *first, waveform.PulseLength });
    }
  }
};

vtkStandardNewMacro(ownDetector);

extern "C" bool vtkhelios_register_plugin()
{
  return vtkHeliosEchoDetection::AddDetector("firstSample", vtkNew<ownDetector>());
}
