// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosNoEchoes.h"

#include "heliosLegRunner.h"
#include "heliosMessages.h"
#include "vtkHeliosPlatform.h"

#include <vtkPolyData.h>

namespace helios
{

//------------------------------------------------------------------------------
std::string ExplainNoEchoes(const LegRunner& runner)
{
  const std::size_t leg = runner.GetPlans().empty() ? 0 : runner.GetPlans().front().Leg;
  const ScannerData& scanner = runner.GetSurvey().GetScanner(leg);
  const std::string& where = runner.GetSurvey().Legs[leg].Where;
  const ScanCounts& counts = runner.GetCounts();
  MessageBuilder text;
  text << where << (where.empty() ? "" : ": ") << "No points: ";
  if (runner.GetNumberOfPulses() == 0)
  {
    text << "no leg fires a pulse, since no leg is active and has a duration above 0; set "
            "active=\"true\" for one";
  }
  else if (counts.PulsesFired == 0 && scanner.Type == Optics::RisleyPrisms)
  {
    text << "no pulse left the scanner, since its prisms reflect all of them; check angle1_deg to "
            "angle3_deg and refrIndex1 to refrIndex3 of scanner "
         << scanner.Id;
  }
  else if (counts.PulsesFired == 0)
  {
    text
      << "no pulse left the scanner, since its mirror angle is never between verticalAngleMin_deg "
         "and verticalAngleMax_deg; check these and the scan angles";
  }
  else if (counts.PulsesHit == 0 && counts.HitsOutOfRange == 0)
  {
    const LegPlan& plan = runner.GetPlans().front();
    const Vec3 p(plan.Platform->GetOutput()->GetPoint(0));
    double b[6];
    runner.GetScene()->GetBounds(b);
    text << "none of " << counts.PulsesFired << " pulses hit the scene. It spans x " << b[0]
         << " to " << b[1] << ", y " << b[2] << " to " << b[3] << ", z " << b[4] << " to " << b[5]
         << "; leg " << plan.Leg << " starts at " << p[0] << ", " << p[1] << ", " << p[2]
         << ". Check where the legs are, the scan angles and the scanner's mount";
  }
  else if (counts.PulsesHit == 0)
  {
    text << "every surface hit is nearer than rangeMin_m=\"" << scanner.Receiver.RangeMin << "\"";
    if (scanner.Receiver.RangeMax < VTK_DOUBLE_MAX)
    {
      text << " or farther than rangeMax_m=\"" << scanner.Receiver.RangeMax << "\"";
    }
    text << " of scanner " << scanner.Id << "; check where the legs are, and the unit of the scene";
  }
  else
  {
    text << "the strongest of " << counts.PulsesHit << " returns has " << counts.LargestAmplitude
         << " W, below the detection threshold of " << scanner.Receiver.DetectionThreshold
         << " W (receivedEnergyMin_W) of scanner " << scanner.Id
         << "; check the reflectances, the range and averagePower_w";
  }
  return text.str();
}

} // namespace helios
